#include "Core/distortion/Histogram.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

#include "Core/base/Error.h"

namespace authalic {

std::int64_t Histogram::total() const {
  return std::accumulate(counts.begin(), counts.end(), below + above + undefined);
}

Histogram histogramOf(const Eigen::Ref<const Eigen::VectorXd>& values, double lower, double upper, int bins) {
  if (bins < 1 || !std::isfinite(lower) || !std::isfinite(upper) || !(lower < upper)) {
    throw InvalidArgument("At least 1 bin between rising limits is required, but there are " + std::to_string(bins) +
                          " from " + std::to_string(lower) + " to " + std::to_string(upper) + ".");
  }
  Histogram histogram;
  for (int k = 0; k <= bins; ++k) histogram.edges.push_back(lower + (upper - lower) * k / bins);
  histogram.counts.assign(static_cast<std::size_t>(bins), 0);
  for (Eigen::Index i = 0; i < values.size(); ++i) {
    const double value = values[i];
    if (std::isnan(value)) {
      ++histogram.undefined;
    } else if (value < lower) {
      ++histogram.below;
    } else if (value > upper) {
      ++histogram.above;
    } else {
      const auto next = std::upper_bound(histogram.edges.begin(), histogram.edges.end(), value);
      const auto bin = std::min<std::ptrdiff_t>(next - histogram.edges.begin(), bins) - 1;
      ++histogram.counts[static_cast<std::size_t>(bin)];
    }
  }
  return histogram;
}

DistortionHistograms distortionHistograms(const DistortionArrays& arrays) {
  const auto flat = [](const Eigen::MatrixX3d& corners) { return corners.reshaped().eval(); };
  DistortionHistograms histograms;
  histograms.vertexLogAreaRatio = histogramOf(arrays.vertexLogAreaRatio, -4, 4, 80);
  histograms.faceLogAreaRatio = histogramOf(arrays.logAreaRatio * std::log(2.0), -4, 4, 80);
  histograms.cornerLogAngleRatio = histogramOf(flat(arrays.cornerLogAngleRatio), -2, 2, 80);
  histograms.angleError = histogramOf(flat(arrays.cornerAngleError), -45, 45, 180);
  histograms.beltrami = histogramOf(arrays.beltrami.cwiseAbs(), 0, 1, 50);
  return histograms;
}

}  // namespace authalic
