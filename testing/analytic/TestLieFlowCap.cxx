#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "Core/authalic/DiscreteLieFlow.h"
#include "Core/initial/BarycentricMap.h"
#include "support/TestMeshes.h"

using namespace authalic;
using namespace authalic::testing;

namespace {

// Deviations from Lambert's equal-area projection, r(θ) = sin(θ/2) / sin(opening/2), of a cap of 2 radians.
Eigen::ArrayXd lambertErrors(int rings, LieFlowFinish finish) {
  const double opening = 2;
  const DiskMesh disk(capMesh(rings, opening));
  BarycentricMapOptions start;
  start.weights = BarycentricWeights::Harmonic;
  DiscreteLieFlowOptions options;
  options.finish = finish;
  if (finish == LieFlowFinish::None) options.tolerance = 3e-3;
  const DiscreteLieFlowResult result =
      discreteLieFlow(disk, barycentricMap(disk, start).image, TargetMeasure(disk.mesh()), options);
  EXPECT_EQ(result.flippedFaces, 0);
  EXPECT_EQ(result.status, Status::Converged);
  Eigen::ArrayXd errors(disk.mesh().vertexCount());
  for (int v = 0; v < disk.mesh().vertexCount(); ++v) {
    const double theta = std::acos(std::clamp(disk.mesh().points()(v, 2), -1.0, 1.0));
    errors[v] = std::abs(result.image.row(v).norm() - std::sin(theta / 2) / std::sin(opening / 2));
  }
  return errors;
}

}  // namespace

TEST(DiscreteLieFlow, ConvergesToLambertsProjectionOfASphericalCap) {
  const double coarse = lambertErrors(12, LieFlowFinish::None).mean(),
               middle = lambertErrors(24, LieFlowFinish::None).mean(),
               fine = lambertErrors(48, LieFlowFinish::None).mean();
  EXPECT_GT(coarse / middle, 2.5);
  EXPECT_GT(middle / fine, 2.5);
  EXPECT_LT(fine, 5e-5);
}

TEST(DiscreteLieFlow, StaysOnLambertsProjectionWhenTheOriginalFacesAreMatched) {
  EXPECT_LT(lambertErrors(24, LieFlowFinish::Match).maxCoeff(), 2e-3);
}
