/// @file
/// The edges a flat triangulation had before it was flipped, as vectors.
#pragma once

#include <complex>
#include <vector>

#include "Core/geometry/IntrinsicTriangulation.h"

namespace authalic {

/// Vectors of half-edges, each in the coordinates of its own face.
struct DevelopedEdges {
  std::vector<std::complex<double>> vector;  ///< per half-edge, the three of a face sum to 0
  /// Per half-edge, |turn| = 1: vector(h) = −turn(h) · vector(opposite(h)); takes coordinates of the face across to
  /// those of the face.
  std::vector<std::complex<double>> turn;
};

/// Lays every face of a flat cone metric out by itself and takes the recorded flips back, last one first.
///
/// A flip taken back gives the diagonal the sum of the two sides that it closes, seen from one of its faces: the
/// straight edge of the flat metric in the homotopy class of the old one, as long as there is no cone between, also
/// where the old triangle comes out folded. So the result has the connectivity of when recordFlips() was called.
/// @param triangulation  flat at u but for its cones; all faces triangles; without boundary
/// O(m + number of flips)
[[nodiscard]] DevelopedEdges developOriginalEdges(const IntrinsicTriangulation& triangulation,
                                                  const Eigen::VectorXd& u);

}  // namespace authalic
