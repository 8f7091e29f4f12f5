#include "Core/statistics/WeightedStatistics.h"

#include <algorithm>
#include <cmath>

namespace authalic {

namespace {

double weightedMedian(std::vector<WeightedValue> valid, double total) {
  std::sort(valid.begin(), valid.end(), [](const WeightedValue& a, const WeightedValue& b) {
    return a.value < b.value || (a.value == b.value && a.weight < b.weight);
  });
  double below = 0.0;
  for (std::size_t i = 0; i < valid.size(); ++i) {
    below += valid[i].weight;
    if (std::abs(below - 0.5 * total) <= 1e-12 * total && i + 1 < valid.size()) {
      return 0.5 * (valid[i].value + valid[i + 1].value);
    }
    if (below >= 0.5 * total) return valid[i].value;
  }
  return valid.back().value;
}

}  // namespace

WeightedStatistics weightedStatistics(const std::vector<WeightedValue>& values) {
  std::vector<WeightedValue> valid;
  for (const WeightedValue& item : values) {
    if (!std::isnan(item.value) && item.weight > 0.0) valid.push_back(item);
  }
  WeightedStatistics result;
  if (valid.empty()) return result;
  double total = 0.0, sum = 0.0, squares = 0.0;
  result.minimum = result.maximum = valid.front().value;
  for (const WeightedValue& item : valid) {
    total += item.weight;
    sum += item.weight * item.value;
    result.minimum = std::min(result.minimum, item.value);
    result.maximum = std::max(result.maximum, item.value);
  }
  // Rounding must not carry the mean of equal values past them.
  result.mean = std::isfinite(sum) ? std::clamp(sum / total, result.minimum, result.maximum) : sum / total;
  for (const WeightedValue& item : valid) {
    squares += item.weight * (item.value - result.mean) * (item.value - result.mean);
  }
  result.n = static_cast<int>(valid.size());
  result.sd = std::sqrt(squares / total);
  result.median = weightedMedian(std::move(valid), total);
  return result;
}

}  // namespace authalic
