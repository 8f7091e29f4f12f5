#include <gtest/gtest.h>

#include <cmath>

#include "Core/base/Error.h"
#include "Core/distortion/SphericalDistortion.h"
#include "Core/distortion/Spread.h"
#include "support/TestMeshes.h"

using namespace authalic;
using namespace authalic::testing;

TEST(Spread, OfTheFirstHundredNumbersAndOneIsTheClosedForm) {
  Eigen::VectorXd values(102);
  for (int i = 0; i <= 100; ++i) values[i] = (37 * i) % 101;  // 0 … 100, shuffled
  values[101] = NAN;
  const Spread spread = spreadOf(values);
  EXPECT_EQ(spread.count, 101);
  EXPECT_NEAR(spread.mean, 50, 1e-12);
  EXPECT_NEAR(spread.standardDeviation, std::sqrt((101.0 * 101 - 1) / 12), 1e-12);
  for (std::size_t k = 0; k < kPercentiles.size(); ++k) EXPECT_NEAR(spread.percentiles[k], kPercentiles[k], 1e-12);
}

TEST(Spread, InterpolatesBetweenValues) {
  const Spread spread = spreadOf(Eigen::Vector2d(3, 1));
  EXPECT_DOUBLE_EQ(spread.percentiles[0], 1.1);
  EXPECT_DOUBLE_EQ(spread.percentiles[2], 2);
  EXPECT_DOUBLE_EQ(spread.percentiles[6], 3);
  EXPECT_DOUBLE_EQ(spread.standardDeviation, 1);
}

TEST(Spread, OfNothingIsZero) {
  EXPECT_EQ(spreadOf(Eigen::VectorXd()).count, 0);
  EXPECT_EQ(spreadOf(Eigen::Vector2d(NAN, NAN)).percentiles[6], 0);
}

TEST(DistortionSpreads, OfALinearMapAreOneValueAndAgreeWithTheMeans) {
  const TriangleMesh grid = gridMesh(6, 6);
  Points2 image = grid.points().leftCols<2>();
  image.col(0) *= 3;
  const DistortionSummary summary = measureDistortion(grid, image).summary;
  for (const double dilatation : summary.quasiConformal.percentiles) EXPECT_NEAR(dilatation, 3, 1e-12);
  for (const double modulus : summary.beltrami.percentiles) EXPECT_NEAR(modulus, 0.5, 1e-12);
  EXPECT_NEAR(summary.quasiConformal.standardDeviation, 0, 1e-12);
  EXPECT_NEAR(summary.angleError.mean, summary.meanAngleError, 1e-12);
  // A right isosceles triangle with its legs 3 : 1 loses 45° − arctan ⅓ at one end, gains it at the other.
  EXPECT_NEAR(summary.angleError.percentiles[6], 45 - std::atan(1.0 / 3) * 180 / M_PI, 1e-10);
}

TEST(DistortionSpreads, OfTheIdentityOfTheSphereAreZeroAndOne) {
  const TriangleMesh sphere = sphereMesh(3);
  const SphericalDistortion distortion = measureSphericalDistortion(sphere, sphere.points());
  EXPECT_EQ(distortion.summary.angleError.count, 3 * sphere.faceCount());
  EXPECT_NEAR(distortion.summary.angleError.percentiles[6], 0, 1e-10);
  EXPECT_NEAR(distortion.summary.quasiConformal.mean, 1, 1e-12);
  EXPECT_NEAR(distortion.flatSummary.beltrami.percentiles[6], 0, 1e-12);
}

TEST(OntoUnitSphere, TakesAnyRadiusAndRefusesWhatIsNoSphereAroundZero) {
  const Points3 points = sphereMesh(2).points();
  Points3 large = 100 * points;
  large.row(3) *= 1.0001;
  EXPECT_LT((ontoUnitSphere(large) - points).cwiseAbs().maxCoeff(), 1e-15);
  EXPECT_THROW((void)ontoUnitSphere(points.rowwise() + Eigen::RowVector3d(0.1, 0, 0)), GeometryError);
  EXPECT_THROW((void)ontoUnitSphere(Points3::Zero(4, 3)), GeometryError);
  large(7, 0) = NAN;
  EXPECT_THROW((void)ontoUnitSphere(large), GeometryError);
}
