#include <gtest/gtest.h>

#include <cmath>

#include "Core/authalic/TargetMeasure.h"
#include "Core/transport/OptimalTransportMap.h"
#include "Core/transport/SphericalTransportMap.h"
#include "support/OffFile.h"
#include "support/SharedData.h"

using namespace authalic;
using namespace authalic::testing;

namespace {

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
  for (const TransportIteration& step : map.history) EXPECT_GT(step.smallestCell, 0);
}

INSTANTIATE_TEST_SUITE_P(Disk, TransportOnScansSlow,
                         ::testing::Values("chinese_lion", "human_face", "camelhead", "human_brain"),
                         [](const auto& parameter) { return std::string(parameter.param); });

TEST(SphericalTransportOnScansSlow, GivesEveryCellItsShareInFewSteps) {
  if (!PowerDiagram::available()) GTEST_SKIP() << "CGAL was not built in";
  const std::string path = sharedData("meshes/closed_g0/sphere_brain.off");
  AUTHALIC_NEEDS(path);
  const SphereMesh sphere(readOff(path));
  const SphericalTransportMapResult map = sphericalTransportMap(sphere, TargetMeasure(sphere.mesh()).vertices());
  EXPECT_EQ(map.status, Status::Converged) << map.residual;
  EXPECT_LE(map.residual, 1e-9);
  EXPECT_LE(map.iterations, 25);
  EXPECT_EQ(map.emptyCells, 0);
  EXPECT_NEAR(map.cellAreas.sum(), 4 * M_PI, 1e-11);
}
