#include <gtest/gtest.h>

#include "Core/authalic/DiscreteLieFlow.h"
#include "Core/distortion/Distortion.h"
#include "Core/initial/BarycentricMap.h"
#include "support/OffFile.h"
#include "support/SharedData.h"

using namespace authalic;
using namespace authalic::testing;

namespace {

void expectAreaPreserving(const std::string& path, const PlanarDomain& domain) {
  const DiskMesh disk(readOff(path));
  BarycentricMapOptions start;
  start.domain = domain;
  DiscreteLieFlowOptions options;
  options.domain = domain;
  const DiscreteLieFlowResult result =
      discreteLieFlow(disk, barycentricMap(disk, start).image, TargetMeasure(disk.mesh()), options);
  EXPECT_EQ(result.status, Status::Converged) << result.residual;
  const DistortionSummary summary = measureDistortion(disk.mesh(), result.image).summary;
  EXPECT_EQ(summary.flippedFaces, 0);
  EXPECT_LT(summary.areaDistortion, 2.005);
}

class LieFlowOnScansSlow : public ::testing::TestWithParam<const char*> {};

}  // namespace

TEST_P(LieFlowOnScansSlow, PreservesAreasWithoutFlips) {
  const std::string path = sharedData(std::string("meshes/open_disk/") + GetParam() + ".off");
  AUTHALIC_NEEDS(path);
  expectAreaPreserving(path, PlanarDomain::disk());
}

INSTANTIATE_TEST_SUITE_P(Disk, LieFlowOnScansSlow,
                         ::testing::Values("chinese_lion", "human_face", "camelhead", "human_brain"),
                         [](const auto& parameter) { return std::string(parameter.param); });

TEST(LieFlowOnASquareSlow, PreservesAreasWithoutFlips) {
  const std::string path = sharedData("meshes/open_disk/chinese_lion.off");
  AUTHALIC_NEEDS(path);
  expectAreaPreserving(path, PlanarDomain::square());
}
