#include <gtest/gtest.h>

#include "Core/conformal/WeldedSphereMap.h"
#include "Core/distortion/SphericalDistortion.h"
#include "support/OffFile.h"
#include "support/SharedData.h"

using namespace authalic;
using namespace authalic::testing;

namespace {

void expectConformal(const std::string& name, double angleError) {
  const std::string path = sharedData("meshes/closed_g0/" + name + ".off");
  AUTHALIC_NEEDS(path);
  const SphereMesh surface(readOff(path));
  const WeldedSphereMapResult result = weldedSphereMap(surface);
  EXPECT_EQ(result.status, Status::Converged) << result.residual;
  EXPECT_EQ(result.flippedFaces, 0);
  EXPECT_LT(result.accuracy.boundaryMismatch, 1e-10);
  EXPECT_LT(measureSphericalDistortion(surface.mesh(), result.image).summary.meanAngleError, angleError);
}

}  // namespace

TEST(WeldedSphereOnScans, KeepsTheAnglesOfDavid) { expectConformal("david", 0.9); }

TEST(WeldedSphereOnScansSlow, KeepsTheAnglesOfABrain) { expectConformal("sphere_brain", 1.21); }
