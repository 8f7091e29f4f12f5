#include <gtest/gtest.h>

#include <cmath>

#include "Core/authalic/DiscreteLieFlow.h"
#include "Core/distortion/Distortion.h"
#include "Core/initial/BarycentricMap.h"
#include "support/TestMeshes.h"

using namespace authalic;
using namespace authalic::testing;

namespace {

/// A finger: a tube of radius 1 and the given length, closed by a flat cap, open at its foot.
TriangleMesh finger(int rings, double length) {
  const TriangleMesh flat = diskMesh(rings);
  Points3 points = flat.points();
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    const double radius = points.row(i).norm(), cap = 0.2;
    const double across = std::min(radius / cap, 1.0), along = std::max(radius - cap, 0.0) / (1 - cap);
    const Eigen::RowVector3d direction =
        radius > 0 ? Eigen::RowVector3d(points.row(i) / radius) : Eigen::RowVector3d::Zero();
    points.row(i) = across * direction;
    points(i, 2) = -length * along;
  }
  return TriangleMesh(points, flat.faces());
}

}  // namespace

TEST(LieFlow, MapsALongFingerWhoseTuttesMapShrinksItBeyondTheReachOfAFlow) {
  const DiskMesh disk(finger(30, 20));
  BarycentricMapOptions start;
  start.weights = BarycentricWeights::MeanValue;
  const BarycentricMapResult initial = barycentricMap(disk, start);
  ASSERT_GT(measureDistortion(disk.mesh(), initial.image).summary.vertexMaxAbsLog, 8);
  const DiscreteLieFlowResult flow = discreteLieFlow(disk, initial.image, TargetMeasure(disk.mesh()));
  EXPECT_TRUE(flow.balancedStart);
  EXPECT_EQ(flow.status, Status::Converged);
  EXPECT_EQ(flow.flippedFaces, 0);
  const DistortionSummary after = measureDistortion(disk.mesh(), flow.image).summary;
  EXPECT_LT(after.areaDistortion, 2.01);
  EXPECT_EQ(after.flippedFaces, 0);
}
