/// @file
/// Laying a flat triangulation out in the plane.
#pragma once

#include <Eigen/Core>

#include "Core/base/Arrays.h"
#include "Core/geometry/IntrinsicTriangulation.h"

namespace authalic {

/// A flat triangulation in the plane.
struct Development {
  Points2 points;                         ///< n×2, one place per vertex
  Eigen::RowVector2d period{0, 0};        ///< T: what a path of winding number 1 adds
  /// max | |z_j + w_ij T − z_i| − l_ij | / (longest edge): 0 but for rounding and for the curvature that is left.
  /// Where it is small the holonomy of every loop is the translation by T times its winding.
  double holonomy = 0;
};

/// Unfolds face after face, along the longest edges first so that errors of short edges are not magnified.
///
/// Where the triangulation carries winding numbers (an annulus), the layout is that of its universal cover: vertex i
/// has the places z_i + m T, and an edge from i to j runs from z_i to z_j + w_ij T. Without them the triangulation
/// must be a disk.
/// @param triangulation  connected, flat at u: K = 0 at inner vertices
/// Complexity O(m log m). Vertices without a face are put at 0.
[[nodiscard]] Development develop(const IntrinsicTriangulation& triangulation, const Eigen::VectorXd& u);

}  // namespace authalic
