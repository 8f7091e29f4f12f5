#include <gtest/gtest.h>

#include <cmath>

#include "Core/authalic/DiscreteLieFlow.h"
#include "Core/distortion/Distortion.h"
#include "Core/initial/BarycentricMap.h"
#include "Core/transport/OptimalTransportMap.h"
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

/// The flat disk with a steep hill off its middle.
TriangleMesh hill(int rings, double height) {
  const TriangleMesh flat = diskMesh(rings);
  Points3 points = flat.points();
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    const double x = points(i, 0) - 0.4, y = points(i, 1);
    points(i, 2) = height * std::exp(-20 * (x * x + 2 * y * y));
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

TEST(LieFlow, FromAFarStartThatItKeepsIsNearlyOptimalTransport) {
  if (!PowerDiagram::available()) GTEST_SKIP() << "CGAL was not built in";
  const DiskMesh disk(hill(40, 3));
  BarycentricMapOptions start;
  start.weights = BarycentricWeights::Harmonic;
  const Points2 initial = barycentricMap(disk, start).image;
  const TargetMeasure target(disk.mesh());
  const OptimalTransportMapResult moved = optimalTransportMap(disk, target.vertices(), {}, initial);
  const double least = displacementCost(moved.masses, moved.sites, moved.image);
  DiscreteLieFlowOptions options;
  const DiscreteLieFlowResult balanced = discreteLieFlow(disk, initial, target, options);
  options.keepInitial = true;
  const DiscreteLieFlowResult kept = discreteLieFlow(disk, initial, target, options);
  EXPECT_TRUE(balanced.balancedStart);
  EXPECT_FALSE(kept.balancedStart);
  EXPECT_GT(kept.iterations, 0);
  EXPECT_EQ(kept.status, Status::Converged);
  EXPECT_EQ(kept.flippedFaces, 0);
  const double cost = displacementCost(moved.masses, moved.sites, kept.image);
  EXPECT_LT(cost, 1.02 * least) << least;
  EXPECT_GT(displacementCost(moved.masses, moved.sites, balanced.image), 1.02 * least) << least;
}
