#include <gtest/gtest.h>

#include <cmath>

#include "Core/base/Error.h"
#include "Core/distortion/Histogram.h"
#include "Core/distortion/SphericalDistortion.h"
#include "Reports/MapReport.h"
#include "support/TestMeshes.h"

using namespace authalic;
using namespace authalic::testing;

TEST(Histogram, CountsEveryValueOnce) {
  Eigen::VectorXd values(9);
  values << -0.1, 0, 0.49, 0.5, 0.99, 1, 1.01, NAN, INFINITY;
  const Histogram histogram = histogramOf(values, 0, 1, 2);
  EXPECT_EQ(histogram.edges, (std::vector<double>{0, 0.5, 1}));
  EXPECT_EQ(histogram.counts, (std::vector<std::int64_t>{2, 3}));  // the last bin holds its upper edge
  EXPECT_EQ(histogram.below, 1);
  EXPECT_EQ(histogram.above, 2);
  EXPECT_EQ(histogram.undefined, 1);
  EXPECT_EQ(histogram.total(), 9);
}

TEST(Histogram, RefusesEmptyRanges) {
  const Eigen::VectorXd values = Eigen::VectorXd::Ones(2);
  EXPECT_THROW((void)histogramOf(values, 0, 1, 0), InvalidArgument);
  EXPECT_THROW((void)histogramOf(values, 1, 1, 3), InvalidArgument);
  EXPECT_THROW((void)histogramOf(values, 0, INFINITY, 3), InvalidArgument);
}

TEST(DistortionHistograms, OfALinearMapLieInOneBinPerValue) {
  const TriangleMesh grid = gridMesh(6, 6);
  Points2 image = grid.points().leftCols<2>();
  image.col(0) *= 3;  // |μ| = ½ and r = 1 everywhere; angles of 90° stay or not, none alike
  const Distortion distortion = measureDistortion(grid, image);
  const DistortionHistograms histograms = distortionHistograms(distortion.arrays);
  EXPECT_EQ(histograms.faceLogAreaRatio.total(), grid.faceCount());
  EXPECT_EQ(histograms.faceLogAreaRatio.counts[39] + histograms.faceLogAreaRatio.counts[40], grid.faceCount());
  EXPECT_EQ(histograms.beltrami.counts[24] + histograms.beltrami.counts[25], grid.faceCount());
  EXPECT_EQ(histograms.vertexLogAreaRatio.total(), grid.vertexCount());
  EXPECT_EQ(histograms.angleError.total(), 3 * grid.faceCount());
  EXPECT_EQ(histograms.cornerLogAngleRatio.total(), 3 * grid.faceCount());
  double sum = 0;
  for (Eigen::Index k = 0; k < distortion.arrays.cornerAngleError.size(); ++k) {
    sum += std::abs(distortion.arrays.cornerAngleError.data()[k]);
  }
  EXPECT_NEAR(sum / (3 * grid.faceCount()), distortion.summary.meanAngleError, 1e-12);
}

TEST(DistortionHistograms, StandInTheReportWhenGiven) {
  const TriangleMesh sphere = sphereMesh(2);
  const SphericalDistortion distortion = measureSphericalDistortion(sphere, sphere.points());
  MapReport report;
  report.method = "sphere";
  report.metrics = distortion.summary;
  EXPECT_EQ(mapReport(report).text(false).find("histograms"), std::string::npos);
  report.histograms = distortionHistograms(distortion.arrays);
  report.more.set("sphere", sphericalDistortionReport(distortion));
  const std::string text = mapReport(report).text(false);
  EXPECT_NE(text.find("\"histograms\":{\"vertex_log_area_ratio\":{\"edges\":[-4.0,-3.9,"), std::string::npos)
      << text.substr(0, 900);
  EXPECT_NE(text.find("\"flipped_faces_by_volume\":0"), std::string::npos);
  EXPECT_LT(text.find("\"histograms\""), text.find("\"topology\""));
}
