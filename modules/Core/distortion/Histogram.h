/// @file
/// Histograms of the distortion of a map.
#pragma once

#include <Eigen/Core>

#include <cstdint>
#include <vector>

#include "Core/distortion/Distortion.h"

namespace authalic {

/// Counts of values in bins of equal width. A bin holds [edge k, edge k+1), the last one its upper edge too.
struct Histogram {
  std::vector<double> edges;         ///< bins + 1, rising
  std::vector<std::int64_t> counts;  ///< bins
  std::int64_t below = 0;            ///< values under the first edge
  std::int64_t above = 0;            ///< values over the last edge
  std::int64_t undefined = 0;        ///< NaN

  /// All values, whether they fell into a bin or not.
  [[nodiscard]] std::int64_t total() const;
};

/// @param values  any shape, NaN allowed
/// @param bins    at least 1
/// @throws InvalidArgument when there is no bin, or the limits are not finite and rising
[[nodiscard]] Histogram histogramOf(const Eigen::Ref<const Eigen::VectorXd>& values, double lower,
                                    double upper, int bins);

/// The histograms of every report, over fixed bins, so that those of different maps can be laid over each other.
struct DistortionHistograms {
  Histogram vertexLogAreaRatio;  ///< p_i, natural logarithm: [−4, 4], 80 bins
  Histogram faceLogAreaRatio;    ///< ln |r_t|: [−4, 4], 80 bins
  Histogram cornerLogAngleRatio; ///< η = ln(image angle / surface angle): [−2, 2], 80 bins
  Histogram angleError;          ///< image angle − surface angle at every corner, degrees: [−45, 45], 180 bins
  Histogram beltrami;            ///< |μ|: [0, 1], 50 bins; folded faces lie above
};

/// O(m). @cite su2019 (fig. 9 and the like: vertex area ratios), @cite nadeem2017 (corner angle ratios)
[[nodiscard]] DistortionHistograms distortionHistograms(const DistortionArrays& arrays);

}  // namespace authalic
