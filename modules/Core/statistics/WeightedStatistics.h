/// @file
/// Mean, standard deviation, median and range of weighted values.
#pragma once

#include <limits>
#include <vector>

namespace authalic {

struct WeightedValue {
  double value = 0.0;
  double weight = 0.0;
};

/// n/a (NaN) wherever there is nothing to say.
struct WeightedStatistics {
  int n = 0;  ///< valid values
  double mean = std::numeric_limits<double>::quiet_NaN();
  double sd = std::numeric_limits<double>::quiet_NaN();
  double median = std::numeric_limits<double>::quiet_NaN();
  double minimum = std::numeric_limits<double>::quiet_NaN();
  double maximum = std::numeric_limits<double>::quiet_NaN();
};

/// Statistics of values weighted by the area they stand for, W = Σ w.
///
///     mean = Σ w x / W,     sd = √(Σ w (x − mean)² / W)
///
/// The sd is that of the population "the field over this area": it does not depend on how densely the surface
/// is sampled, and one value has sd 0. (There is no n − 1: areas are not counts.) The median is the smallest
/// x such that values ≤ x weigh at least W/2; where they weigh exactly W/2 (to 1e-12 W), the mean of it and
/// the next value. With equal weights this is the ordinary median.
///
/// Values that are NaN, and weights that are not positive, are left out; infinite values are kept and make
/// what they touch infinite or n/a. Sums run in the order given, the median does not depend on it.
[[nodiscard]] WeightedStatistics weightedStatistics(const std::vector<WeightedValue>& values);

}  // namespace authalic
