#include "HistogramArrays.h"

#include <limits>
#include <utility>

#include "FieldArrays.h"

namespace authalic {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

struct NamedHistogram {
  const char* name;
  Histogram DistortionHistograms::*member;
};
constexpr NamedHistogram kNamed[] = {{"VertexAreaHistogram", &DistortionHistograms::vertexLogAreaRatio},
                                     {"FaceAreaHistogram", &DistortionHistograms::faceLogAreaRatio},
                                     {"AngleRatioHistogram", &DistortionHistograms::cornerLogAngleRatio},
                                     {"AngleErrorHistogram", &DistortionHistograms::angleError},
                                     {"BeltramiHistogram", &DistortionHistograms::beltrami}};

Eigen::MatrixXd toRows(const Histogram& histogram) {
  const auto bins = static_cast<Eigen::Index>(histogram.counts.size());
  Eigen::MatrixXd rows(bins + 3, 3);
  for (Eigen::Index k = 0; k < bins; ++k) {
    const auto i = static_cast<std::size_t>(k);
    rows.row(k) << histogram.edges[i], histogram.edges[i + 1], static_cast<double>(histogram.counts[i]);
  }
  rows.row(bins) << -kInfinity, histogram.edges.front(), static_cast<double>(histogram.below);
  rows.row(bins + 1) << histogram.edges.back(), kInfinity, static_cast<double>(histogram.above);
  rows.row(bins + 2) << kNaN, kNaN, static_cast<double>(histogram.undefined);
  return rows;
}

std::optional<Histogram> fromRows(const Eigen::MatrixXd& rows) {
  if (rows.rows() < 4 || rows.cols() != 3) return {};
  const Eigen::Index bins = rows.rows() - 3;
  Histogram histogram;
  for (Eigen::Index k = 0; k < bins; ++k) {
    histogram.edges.push_back(rows(k, 0));
    histogram.counts.push_back(static_cast<std::int64_t>(rows(k, 2)));
  }
  histogram.edges.push_back(rows(bins - 1, 1));
  histogram.below = static_cast<std::int64_t>(rows(bins, 2));
  histogram.above = static_cast<std::int64_t>(rows(bins + 1, 2));
  histogram.undefined = static_cast<std::int64_t>(rows(bins + 2, 2));
  return histogram;
}

}  // namespace

void addHistograms(vtkDataObject* map, const DistortionHistograms& histograms) {
  for (const auto& [name, member] : kNamed) addField(map, name, toRows(histograms.*member));
}

std::optional<DistortionHistograms> histogramsOf(vtkDataObject* map) {
  DistortionHistograms histograms;
  for (const auto& [name, member] : kNamed) {
    std::optional<Histogram> histogram = fromRows(matrixField(map, name));
    if (!histogram) return {};
    histograms.*member = std::move(*histogram);
  }
  return histograms;
}

}  // namespace authalic
