#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <cmath>
#include <limits>

#include "Core/authalic/TargetMeasure.h"
#include "Core/conformal/SphericalConformalMap.h"
#include "Core/transport/OptimalTransportMap.h"
#include "Core/transport/SphericalTransportMap.h"
#include "support/OffFile.h"
#include "support/SharedData.h"

using namespace authalic;
using namespace authalic::testing;

namespace {

/// The largest error of a cell falls at every step, and none is ever empty.
void expectMonotone(const TransportSolution& solution) {
  double before = std::numeric_limits<double>::infinity();
  for (const TransportIteration& step : solution.history) {
    EXPECT_LT(step.residual, before);
    EXPECT_GT(step.smallestCell, 0);
    before = step.residual;
  }
  EXPECT_LT(solution.residual, before);
}

class TransportOnScansSlow : public ::testing::TestWithParam<const char*> {};

}  // namespace

TEST_P(TransportOnScansSlow, GivesEveryCellItsShareInFewSteps) {
  if (!PowerDiagram::available()) GTEST_SKIP() << "CGAL was not built in";
  const std::string path = sharedData(std::string("meshes/open_disk/") + GetParam() + ".off");
  AUTHALIC_NEEDS(path);
  const DiskMesh disk(readOff(path));
  const OptimalTransportMapResult map = optimalTransportMap(disk, TargetMeasure(disk.mesh()).vertices());
  EXPECT_EQ(map.status, Status::Converged) << map.residual;
  EXPECT_LE(map.residual, 1e-9);
  EXPECT_LE(map.iterations, 25);
  EXPECT_EQ(map.emptyCells, 0);
  expectMonotone(map);
}

INSTANTIATE_TEST_SUITE_P(Disk, TransportOnScansSlow,
                         ::testing::Values("chinese_lion", "human_face", "camelhead", "human_brain"),
                         [](const auto& parameter) { return std::string(parameter.param); });

TEST(CoarseToFineOnScansSlow, TakesHalfTheStepsOnACortex) {
  if (!PowerDiagram::available()) GTEST_SKIP() << "CGAL was not built in";
  const std::string path = sharedData("meshes/open_disk/human_brain.off");
  AUTHALIC_NEEDS(path);
  const DiskMesh disk(readOff(path));
  const Eigen::VectorXd shares = TargetMeasure(disk.mesh()).vertices();
  for (const PlanarDomain& domain : {PlanarDomain::disk(), PlanarDomain::square()}) {
    OptimalTransportMapOptions options;
    options.domain = domain;
    const OptimalTransportMapResult automatic = optimalTransportMap(disk, shares, options);
    options.start = TransportStart::Voronoi;
    const OptimalTransportMapResult voronoi = optimalTransportMap(disk, shares, options);
    EXPECT_EQ(automatic.status, Status::Converged);
    EXPECT_EQ(automatic.levels.size(), 2U);
    EXPECT_EQ(voronoi.levels.size(), 1U);
    EXPECT_LE(2 * automatic.iterations, voronoi.iterations);
    const double size = std::sqrt(domain.area());
    EXPECT_LT((automatic.image - voronoi.image).cwiseAbs().maxCoeff(), 1e-6 * size);
    EXPECT_NEAR(automatic.transportCost / voronoi.transportCost, 1, 1e-9);
    expectMonotone(automatic);
  }
}

class SphericalTransportOnScansSlow : public ::testing::TestWithParam<const char*> {};

TEST_P(SphericalTransportOnScansSlow, GivesEveryCellItsShareInFewSteps) {
  if (!PowerDiagram::available()) GTEST_SKIP() << "CGAL was not built in";
  const std::string path = sharedData(std::string("meshes/closed_g0/") + GetParam() + ".off");
  AUTHALIC_NEEDS(path);
  const SphereMesh sphere(readOff(path));
  const SphericalTransportMapResult map = sphericalTransportMap(sphere, TargetMeasure(sphere.mesh()).vertices());
  EXPECT_EQ(map.status, Status::Converged) << map.residual;
  EXPECT_LE(map.residual, 1e-9);
  EXPECT_LE(map.iterations, 25);
  EXPECT_EQ(map.emptyCells, 0);
  EXPECT_NEAR(map.cellAreas.sum(), 4 * M_PI, 1e-11);
  expectMonotone(map);
}

TEST_P(SphericalTransportOnScansSlow, GivesEveryCellItsShareInAStereographicPlaneFromAnyPole) {
  if (!PowerDiagram::available()) GTEST_SKIP() << "CGAL was not built in";
  const std::string path = sharedData(std::string("meshes/closed_g0/") + GetParam() + ".off");
  AUTHALIC_NEEDS(path);
  const SphereMesh sphere(readOff(path));
  const Points3 sites = sphericalConformalMap(sphere).image;
  const Eigen::Vector3d vertex = sites.row(sites.rows() / 2).transpose();
  SphericalTransportMapOptions options;
  options.formulation = SphereFormulation::Stereographic;
  for (const Eigen::Vector3d& pole : {Eigen::Vector3d(Eigen::Vector3d::Zero()), Eigen::Vector3d(0, 0, 1),
                                      Eigen::Vector3d(vertex + 2e-5 * vertex.unitOrthogonal())}) {
    options.pole = pole;
    const auto map = sphericalTransportMap(sphere, TargetMeasure(sphere.mesh()).vertices(), options, sites);
    EXPECT_EQ(map.status, Status::Converged) << map.residual;
    EXPECT_LE(map.iterations, 25);
    EXPECT_NEAR(map.cellAreas.sum(), 4 * M_PI, 1e-12);
    for (const TransportIteration& step : map.history) EXPECT_GT(step.smallestCell, 0);
  }
}

INSTANTIATE_TEST_SUITE_P(Sphere, SphericalTransportOnScansSlow, ::testing::Values("sphere_brain", "david"),
                         [](const auto& parameter) { return std::string(parameter.param); });
