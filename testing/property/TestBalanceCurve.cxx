/// Maps between conformal and area-preserving, and the curve of their distortions, on disk and sphere.
#include <gtest/gtest.h>

#include <limits>
#include <utility>
#include <vector>

#include "Core/authalic/BalanceCurve.h"
#include "Core/authalic/SphericalAuthalicMap.h"
#include "Core/base/Error.h"
#include "Core/conformal/RiemannMap.h"
#include "Core/conformal/SphericalConformalMap.h"
#include "Core/distortion/SphericalDistortion.h"
#include "Core/geometry/Areas.h"
#include "Core/geometry/SphericalAreas.h"
#include "Core/transport/OptimalTransportMap.h"
#include "Core/transport/SphericalTransportMap.h"
#include "support/TestMeshes.h"

using namespace authalic;
using namespace authalic::testing;

namespace {

class BalanceCurveOf : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!PowerDiagram::available()) GTEST_SKIP() << "CGAL was not built in";
  }
};

BalanceCurveOptions at(std::vector<double> balances) {
  BalanceCurveOptions options;
  options.balances = std::move(balances);
  return options;
}

SphereMesh stretchedSphere(int levels) {
  const TriangleMesh round = sphereMesh(levels);
  return SphereMesh(TriangleMesh(round.points() * Eigen::Vector3d(1, 1.5, 2.2).asDiagonal(), round.faces()));
}

void expectTradeOff(const BalanceCurve& curve, const std::vector<double>& balances) {
  EXPECT_EQ(curve.status, Status::Converged);
  ASSERT_EQ(curve.points.size(), balances.size());
  for (std::size_t k = 0; k < balances.size(); ++k) {
    const BalancePoint& point = curve.points[k];
    EXPECT_EQ(point.balance, balances[k]);
    EXPECT_EQ(point.status, Status::Converged) << balances[k];
    EXPECT_EQ(point.metrics.flippedFaces, 0) << balances[k];
    if (k == 0) continue;
    EXPECT_LT(point.metrics.areaDistortion, curve.points[k - 1].metrics.areaDistortion) << balances[k];
    EXPECT_GT(point.metrics.angleDistortion, curve.points[k - 1].metrics.angleDistortion) << balances[k];
  }
}

/// max |star area of an image / its target share − 1|.
double starError(const DiskMesh& disk, const Points2& image, const TargetMeasure& wanted) {
  const Eigen::VectorXd areas = signedFaceAreas(image, disk.mesh().faces());
  Eigen::VectorXd stars = Eigen::VectorXd::Zero(disk.mesh().vertexCount());
  for (int f = 0; f < disk.mesh().faceCount(); ++f) {
    for (int c = 0; c < 3; ++c) stars[disk.mesh().faces()(f, c)] += areas[f] / 3;
  }
  return ((stars / areas.sum()).cwiseQuotient(wanted.vertices()).array() - 1).abs().maxCoeff();
}

}  // namespace

TEST_F(BalanceCurveOf, ADiskTradesAnglesForAreasAtEveryStep) {
  const DiskMesh disk(bumpyDisk(20));
  const TargetMeasure target(disk.mesh());
  const BalanceCurveOptions options;
  const BalanceCurve curve = balanceCurve(disk, target, options);
  expectTradeOff(curve, options.balances);
  EXPECT_LT(curve.points.back().metrics.areaDistortion, 2.001);
  EXPECT_LT(curve.points.back().metrics.areaDistortion, curve.points.back().transport.areaDistortion);
}

TEST_F(BalanceCurveOf, AClosedSurfaceTradesAnglesForAreasAtEveryStep) {
  const SphereMesh sphere = stretchedSphere(4);
  const BalanceCurveOptions options = at({0, 0.25, 0.5, 0.75, 1});
  const BalanceCurve curve = balanceCurve(sphere, TargetMeasure(sphere.mesh()), options);
  expectTradeOff(curve, options.balances);
  EXPECT_LT(curve.points.back().metrics.areaDistortion, 2.001);
}

TEST_F(BalanceCurveOf, StartsAtTheConformalMap) {
  const DiskMesh disk(bumpyDisk(20));
  const BalanceCurve curve = balanceCurve(disk, TargetMeasure(disk.mesh()), at({0}));
  const DistortionSummary conformal = measureDistortion(disk.mesh(), riemannMap(disk).image).summary;
  EXPECT_NEAR(curve.points[0].metrics.angleDistortion, conformal.angleDistortion, 1e-12);
  EXPECT_NEAR(curve.points[0].metrics.areaDistortion, conformal.areaDistortion, 1e-12 * conformal.areaDistortion);
  const SphereMesh sphere = stretchedSphere(4);
  const BalanceCurve round = balanceCurve(sphere, TargetMeasure(sphere.mesh()), at({0}));
  const DistortionSummary there =
      measureSphericalDistortion(sphere.mesh(), sphericalConformalMap(sphere).image).summary;
  EXPECT_NEAR(round.points[0].metrics.angleDistortion, there.angleDistortion, 1e-12);
  EXPECT_NEAR(round.points[0].metrics.areaDistortion, there.areaDistortion, 1e-12 * there.areaDistortion);
}

TEST_F(BalanceCurveOf, DoesNotDependOnTheBalancesBeforeBeyondItsTolerance) {
  const DiskMesh disk(bumpyDisk(16));
  const TargetMeasure target(disk.mesh());
  const BalancePoint alone = balanceCurve(disk, target, at({0.6})).points[0];
  const BalancePoint third = balanceCurve(disk, target, at({0.1, 0.9, 0.6})).points[2];
  EXPECT_NEAR(alone.metrics.areaDistortion, third.metrics.areaDistortion, 1e-4);
  EXPECT_NEAR(alone.metrics.angleDistortion, third.metrics.angleDistortion, 1e-3);
  EXPECT_NEAR(alone.transport.areaDistortion, third.transport.areaDistortion, 1e-4);
}

TEST_F(BalanceCurveOf, KeepsWhatDependsOnTheMeshAloneWithoutChangingABit) {
  const DiskMesh disk(bumpyDisk(12));
  const TargetMeasure plain(disk.mesh());
  const TargetMeasure dense =
      TargetMeasure::fromVertexDensity(disk.mesh(), (disk.mesh().points().col(0).array() + 2).matrix());
  AnalysedSystems systems;
  for (const TargetMeasure& target : {plain, dense, plain}) {
    EXPECT_EQ(authalicMap(disk, target, {}, {}, {}, &systems).image, authalicMap(disk, target).image);
  }
  const SphereMesh sphere = stretchedSphere(3);
  const TargetMeasure round(sphere.mesh());
  for (int repeat = 0; repeat < 2; ++repeat) {
    EXPECT_EQ(sphericalAuthalicMap(sphere, round, {}, {}, {}, &systems).image,
              sphericalAuthalicMap(sphere, round).image);
  }
}

TEST_F(BalanceCurveOf, GoesToTheMeasureThatIsAskedFor) {
  const DiskMesh disk(bumpyDisk(16));
  Eigen::VectorXd density = Eigen::VectorXd::Ones(disk.mesh().vertexCount());
  density.head(37).setConstant(4);
  const TargetMeasure target = TargetMeasure::fromVertexDensity(disk.mesh(), density);
  const BalanceCurve curve = balanceCurve(disk, target, at({1}));
  EXPECT_LT(curve.points[0].metrics.areaDistortion, 2.001);
}

TEST_F(BalanceCurveOf, RefusesBalancesAndTolerancesOutsideTheirRange) {
  const DiskMesh disk(bumpyDisk(5));
  const TargetMeasure target(disk.mesh());
  for (const std::vector<double>& balances :
       {std::vector<double>{}, {-0.1}, {0.5, 1.1}, {std::numeric_limits<double>::quiet_NaN()}}) {
    EXPECT_THROW((void)balanceCurve(disk, target, at(balances)), InvalidArgument);
  }
  for (double BalanceCurveOptions::*field :
       {&BalanceCurveOptions::tolerance, &BalanceCurveOptions::vertexTolerance, &BalanceCurveOptions::cellTolerance}) {
    BalanceCurveOptions options;
    options.*field = 0;
    EXPECT_THROW((void)balanceCurve(disk, target, options), InvalidArgument);
  }
  EXPECT_THROW((void)balanceCurve(disk, TargetMeasure(bumpyDisk(4))), GeometryError);
}

TEST_F(BalanceCurveOf, StopsWhenAskedTo) {
  const DiskMesh disk(bumpyDisk(10));
  int asked = 0;
  const Execution execution({}, [&] { return ++asked > 12; });
  const BalanceCurve curve = balanceCurve(disk, TargetMeasure(disk.mesh()), {}, execution);
  EXPECT_EQ(curve.status, Status::Cancelled);
  EXPECT_LT(curve.points.size(), BalanceCurveOptions().balances.size());
}

TEST_F(BalanceCurveOf, TheMeasureOfTheConformalImageLeavesItsSitesInTheirCells) {
  const DiskMesh disk(bumpyDisk(20));
  const Points2 conformal = riemannMap(disk).image;
  const Eigen::VectorXd areas = signedFaceAreas(conformal, disk.mesh().faces());
  const TargetMeasure wanted = TargetMeasure(disk.mesh()).blended(disk.mesh(), areas, 0.0);
  EXPECT_LT(starError(disk, conformal, wanted), 1e-9);
  const AuthalicMapResult finished = authalicMap(disk, wanted, {}, conformal);
  EXPECT_LT((finished.image - conformal).rowwise().norm().maxCoeff(), 1e-9);  // it is there already
}

TEST_F(BalanceCurveOf, StartsOfTransportDoNotChangeItsResult) {
  const DiskMesh disk(bumpyDisk(16));
  const Points2 sites = riemannMap(disk).image;
  const Eigen::VectorXd areas = signedFaceAreas(sites, disk.mesh().faces());
  const TargetMeasure target(disk.mesh());
  const auto shares = [&](double t) { return target.blended(disk.mesh(), areas, t).vertices(); };
  const OptimalTransportMapResult before = optimalTransportMap(disk, shares(0.8), {}, sites);
  const OptimalTransportMapResult cold = optimalTransportMap(disk, shares(0.9), {}, sites);
  const OptimalTransportMapResult warm = optimalTransportMap(disk, shares(0.9), {}, sites, {}, before.heights);
  EXPECT_EQ(warm.status, Status::Converged);
  EXPECT_LT((warm.image - cold.image).cwiseAbs().maxCoeff(), 1e-8);
  EXPECT_LT(warm.iterations, cold.iterations);
}
