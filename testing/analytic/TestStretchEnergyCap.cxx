#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "Core/authalic/StretchEnergyMap.h"
#include "Core/initial/BarycentricMap.h"
#include "support/TestMeshes.h"

using namespace authalic;
using namespace authalic::testing;

namespace {

// Deviation from Lambert's equal-area projection, r(θ) = sin(θ/2) / sin(opening/2), of a cap of 2 radians.
double lambertError(int rings) {
  const double opening = 2;
  const DiskMesh disk(capMesh(rings, opening));
  BarycentricMapOptions start;
  start.weights = BarycentricWeights::Harmonic;
  StretchEnergyMapOptions options;
  options.tolerance = 1e-3;
  const StretchEnergyMapResult result =
      stretchEnergyMap(disk, barycentricMap(disk, start).image, TargetMeasure(disk.mesh()), options);
  EXPECT_EQ(result.flippedFaces, 0);
  EXPECT_EQ(result.status, Status::Converged);
  double sum = 0;
  for (int v = 0; v < disk.mesh().vertexCount(); ++v) {
    const double theta = std::acos(std::clamp(disk.mesh().points()(v, 2), -1.0, 1.0));
    sum += std::abs(result.image.row(v).norm() - std::sin(theta / 2) / std::sin(opening / 2));
  }
  return sum / disk.mesh().vertexCount();
}

}  // namespace

TEST(StretchEnergyMap, ConvergesToLambertsProjectionOfASphericalCap) {
  const double coarse = lambertError(12), middle = lambertError(24), fine = lambertError(48);
  EXPECT_GT(coarse / middle, 2.5) << coarse << ' ' << middle;
  EXPECT_GT(middle / fine, 2.5) << middle << ' ' << fine;
  EXPECT_LT(fine, 2e-3);
}
