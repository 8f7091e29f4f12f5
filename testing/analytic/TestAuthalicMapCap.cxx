#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "Core/authalic/AuthalicMap.h"
#include "Core/authalic/DiscreteLieFlow.h"
#include "Core/initial/BarycentricMap.h"
#include "support/TestMeshes.h"

using namespace authalic;
using namespace authalic::testing;

namespace {

// Deviations from Lambert's equal-area projection, r(θ) = sin(θ/2) / sin(opening/2), of a cap of 2 radians. Area-
// preserving maps are not unique: the start is the projection up to the error of the harmonic map's flow.
Eigen::ArrayXd lambertErrors(int rings) {
  const double opening = 2;
  const DiskMesh disk(capMesh(rings, opening));
  const TargetMeasure target(disk.mesh());
  BarycentricMapOptions start;
  start.weights = BarycentricWeights::Harmonic;
  DiscreteLieFlowOptions flow;
  flow.finish = LieFlowFinish::None;
  flow.tolerance = 3e-3;
  const Points2 near = discreteLieFlow(disk, barycentricMap(disk, start).image, target, flow).image;
  const AuthalicMapResult result = authalicMap(disk, target, {}, near);
  EXPECT_EQ(result.status, Status::Converged);
  EXPECT_EQ(result.flippedFaces, 0);
  EXPECT_LT(result.vertexResidual, 1e-10);
  Eigen::ArrayXd errors(disk.mesh().vertexCount());
  for (int v = 0; v < disk.mesh().vertexCount(); ++v) {
    const double theta = std::acos(std::clamp(disk.mesh().points()(v, 2), -1.0, 1.0));
    errors[v] = std::abs(result.image.row(v).norm() - std::sin(theta / 2) / std::sin(opening / 2));
  }
  return errors;
}

}  // namespace

TEST(AuthalicMapOfACap, ConvergesToLambertsProjection) {
  const double coarse = lambertErrors(12).mean(), middle = lambertErrors(24).mean(), fine = lambertErrors(48).mean();
  EXPECT_GT(coarse / middle, 2.5);
  EXPECT_GT(middle / fine, 2.5);
  EXPECT_LT(fine, 1e-4);
}
