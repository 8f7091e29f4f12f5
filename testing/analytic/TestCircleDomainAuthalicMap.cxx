/// Area-preserving maps of surfaces with holes.
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>

#include "Core/authalic/CircleDomainAuthalicMap.h"
#include "Core/base/Error.h"
#include "Core/distortion/Distortion.h"
#include "Core/geometry/Areas.h"
#include "support/HoledMeshes.h"
#include "support/OffFile.h"
#include "support/SharedData.h"

namespace {

using namespace authalic;
using authalic::testing::holedDisk;
using authalic::testing::readOff;
using authalic::testing::revolutionMesh;
using authalic::testing::sharedData;

[[maybe_unused]] double holeArea(const Points2& image, const std::vector<int>& loop) {
  double twice = 0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const auto p = image.row(loop[i]), q = image.row(loop[(i + 1) % loop.size()]);
    twice += p[0] * q[1] - p[1] * q[0];
  }
  return std::abs(twice) / 2;
}

}  // namespace

TEST(CircleDomainAuthalicMap, OfRealFacesIsExactAtVerticesAndHoles) {
  for (const char* name : {"sophie", "alex_3"}) {
    const std::string path = sharedData("meshes/poly_annulus/" + std::string(name) + ".off");
    AUTHALIC_NEEDS(path);
    const PolyAnnulusMesh surface(readOff(path));
    const TargetMeasure target(surface.mesh());
    const CircleDomainAuthalicMapResult result = circleDomainAuthalicMap(surface, target);
    EXPECT_EQ(result.status, Status::Converged);
    EXPECT_EQ(result.flippedFaces, 0);
    EXPECT_LT(result.holeResidual, 1e-9);
    const DistortionSummary summary = measureDistortion(surface.mesh(), result.image).summary;
    std::printf("%s D-2 %.2e face %.2e vertex %.2e holes %.1e angle %.2f it %d  %.2f + %.2f + %.2f s\n", name,
                summary.areaDistortion - 2, summary.faceMeanAbsLog, summary.vertexMaxAbsLog,
                result.holeResidual, summary.meanAngleError, result.iterations, result.startSeconds, result.faceSeconds,
                result.vertexSeconds);
  }
}
