#include "Core/authalic/LevelShares.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace authalic {

LevelShares::LevelShares(const Eigen::VectorXd& levels, const Eigen::VectorXd& target) {
  std::vector<int> order(static_cast<std::size_t>(levels.size()));
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return levels[a] < levels[b]; });
  const auto stride = static_cast<std::size_t>(std::sqrt(static_cast<double>(order.size())));
  double below = 0;
  for (std::size_t i = 0, next = 0; i < order.size();) {
    std::size_t end = i;
    double same = 0;
    for (; end < order.size() && levels[order[end]] <= levels[order[i]] + 1e-9; ++end) same += target[order[end]];
    const bool first = i == 0, last = end == order.size();
    if (first || last || i >= next) {
      knots_.push_back(levels[order[i]]);
      shares_.push_back(first ? 0 : last ? 1 : below + 0.5 * same);
      next = i + stride;
    }
    below += same;
    i = end;
  }
}

double LevelShares::at(double level) const {
  const auto above = std::upper_bound(knots_.begin() + 1, knots_.end() - 1, level) - knots_.begin();
  const auto k = static_cast<std::size_t>(above);
  const double t = (level - knots_[k - 1]) / (knots_[k] - knots_[k - 1]);
  return shares_[k - 1] + std::min(std::max(t, 0.0), 1.0) * (shares_[k] - shares_[k - 1]);
}

}  // namespace authalic
