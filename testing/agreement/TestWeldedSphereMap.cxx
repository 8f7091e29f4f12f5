#include <gtest/gtest.h>

#include <cmath>

#include "Core/conformal/HarmonicSphereMap.h"
#include "Core/conformal/SphereNormalisation.h"
#include "Core/conformal/StereographicSphereMap.h"
#include "Core/conformal/WeldedSphereMap.h"
#include "support/TestMeshes.h"

using namespace authalic;
using namespace authalic::testing;

TEST(WeldedSphereMap, AgreesWithTheHarmonicRoadAtSecondOrder) {
  const auto difference = [](int level) {
    const SphereMesh surface(wavySphere(level));
    const Points3 welded = normaliseSphere(surface.mesh(), weldedSphereMap(surface).image).image;
    const Points3 start = stereographicSphereMap(surface).image;
    const Points3 harmonic = normaliseSphere(surface.mesh(), harmonicSphereMap(surface, start).image).image;
    return std::sqrt((welded - harmonic).rowwise().squaredNorm().mean());
  };
  const double coarse = difference(3), fine = difference(5);
  EXPECT_LT(fine, 5e-4) << coarse;
  EXPECT_GT(coarse / fine, 14);
}
