/// @file
/// The one place where the distortion of a map is computed, whatever its image lies on. Private to distortion/.
#pragma once

#include <vector>

#include "Core/base/Arrays.h"
#include "Core/distortion/Distortion.h"

namespace authalic {

/// What the metrics need to know of an image.
struct MeasuredImage {
  Points3 points;             ///< n×3; planar images have z = 0
  Eigen::VectorXd areas;      ///< m signed areas that are compared with the target shares
  Eigen::VectorXd flatAreas;  ///< m signed areas of the flat image triangles, from which angles are taken
  std::vector<int> originals = {};  ///< n vertices of the surface before it was cut; empty when it was not
};

/// @throws GeometryError unless there is one image point per vertex
void requireImagePerVertex(const TriangleMesh& surface, Eigen::Index imagePoints);

/// Orientation of the majority of faces, +1 or −1.
[[nodiscard]] double majoritySign(const Eigen::VectorXd& signedAreas);

/// Arrays and summary of an image; see measureDistortion for parameters and exceptions.
[[nodiscard]] Distortion measureImage(const TriangleMesh& surface, const MeasuredImage& image,
                                      const Eigen::VectorXd& target);

/// Fills angleError, quasiConformal and beltrami of the summary from the arrays.
void measureSpreads(Distortion& distortion);

}  // namespace authalic
