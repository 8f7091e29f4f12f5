/// @file
/// How the values of a sample spread: mean, standard deviation, percentiles.
#pragma once

#include <Eigen/Core>

#include <array>
#include <cstdint>

namespace authalic {

/// The percentiles that every report gives; the last one is the maximum.
inline constexpr std::array<int, 7> kPercentiles{5, 25, 50, 75, 95, 99, 100};

/// Unweighted numbers of one sample; all 0 when it has no value.
struct Spread {
  std::int64_t count = 0;                              ///< values, without those that are NaN
  double mean = 0;
  double standardDeviation = 0;                        ///< of the sample as the whole: divided by count
  std::array<double, kPercentiles.size()> percentiles{};  ///< of kPercentiles, between values by linear interpolation
};

/// @param values  any order; NaN is left out
/// The p-th percentile is the value at position p/100 (count − 1) of the sorted sample, as numpy's default. O(n).
[[nodiscard]] Spread spreadOf(const Eigen::Ref<const Eigen::VectorXd>& values);

}  // namespace authalic
