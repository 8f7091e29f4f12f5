#include "Core/distortion/Spread.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace authalic {

Spread spreadOf(const Eigen::Ref<const Eigen::VectorXd>& values) {
  std::vector<double> sample;
  sample.reserve(static_cast<std::size_t>(values.size()));
  for (Eigen::Index i = 0; i < values.size(); ++i) {
    if (!std::isnan(values[i])) sample.push_back(values[i]);
  }
  Spread spread;
  spread.count = static_cast<std::int64_t>(sample.size());
  if (sample.empty()) return spread;
  const double count = static_cast<double>(sample.size());
  for (const double value : sample) spread.mean += value / count;
  double variance = 0;
  for (const double value : sample) variance += (value - spread.mean) * (value - spread.mean) / count;
  spread.standardDeviation = std::sqrt(variance);
  auto begin = sample.begin();  // everything before it is sorted away
  for (std::size_t k = 0; k < kPercentiles.size(); ++k) {
    const double position = kPercentiles[k] / 100.0 * (count - 1);
    const auto at = sample.begin() + static_cast<std::ptrdiff_t>(position);
    std::nth_element(begin, at, sample.end());
    const double fraction = position - std::floor(position);
    const double next = fraction > 0 ? *std::min_element(at + 1, sample.end()) : *at;
    spread.percentiles[k] = *at + fraction * (next - *at);
    begin = at;
  }
  return spread;
}

}  // namespace authalic
