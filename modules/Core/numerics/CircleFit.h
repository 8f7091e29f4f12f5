/// @file
/// The circle through points that lie on one but for rounding.
#pragma once

#include <vector>

#include "Core/base/Arrays.h"

namespace authalic {

struct FittedCircle {
  Eigen::RowVector2d centre{0, 0};
  double radius = 0;
  double deviation = 0;  ///< max | |p − centre| − radius | / radius
};

/// Least-squares circle |p|² = 2 c·p + d of the rows `vertices` of `points` @cite kasa1976: exact for points on a
/// circle.
/// @throws GeometryError when there are fewer than three points or they lie on a line
[[nodiscard]] FittedCircle fitCircle(const Points2& points, const std::vector<int>& vertices);

}  // namespace authalic
