/// @file
/// How much of a target lies below the levels of a function. Private to authalic/.
#pragma once

#include <vector>

#include "Core/base/Arrays.h"

namespace authalic {

/// Share of the target at vertices with a level below x, as a piecewise linear function of x between about √n knots;
/// vertices of one level (to 1e-9) are below it by half.
class LevelShares {
 public:
  /// @param levels  n numbers, not all the same
  /// @param target  n shares, sum 1
  LevelShares(const Eigen::VectorXd& levels, const Eigen::VectorXd& target);

  /// 0 at the lowest level and below, 1 at the highest and above.
  [[nodiscard]] double at(double level) const;

 private:
  std::vector<double> knots_, shares_;
};

}  // namespace authalic
