/// @file
/// The arrays that every layer hands on: points in space, points in the plane, triangles.
#pragma once

#include <Eigen/Core>

namespace authalic {

/// n×3, one point per row (mm for surfaces; unitless for images of a map).
using Points3 = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;
/// n×2, one planar point per row.
using Points2 = Eigen::Matrix<double, Eigen::Dynamic, 2, Eigen::RowMajor>;
/// m×3, vertex indices of one triangle per row, counter-clockwise seen from outside.
using Faces = Eigen::Matrix<int, Eigen::Dynamic, 3, Eigen::RowMajor>;

}  // namespace authalic
