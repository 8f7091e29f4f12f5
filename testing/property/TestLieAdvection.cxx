#include <gtest/gtest.h>

#include <cmath>

#include "Core/authalic/LieAdvection.h"
#include "Core/base/Error.h"
#include "Core/geometry/Areas.h"
#include "Core/initial/BarycentricMap.h"
#include "support/TestMeshes.h"

using namespace authalic;
using namespace authalic::testing;

namespace {

Points2 start(const DiskMesh& disk, const PlanarDomain& domain = {}) {
  BarycentricMapOptions options;
  options.weights = BarycentricWeights::Harmonic;
  options.domain = domain;
  return barycentricMap(disk, options).image;
}

LieAdvectionOptions inSteps(int steps) {
  LieAdvectionOptions options;
  options.steps = steps;
  return options;
}

}  // namespace

TEST(LieAdvection, ComesCloserWithMoreSteps) {
  const DiskMesh disk(bumpyDisk(16));
  const TargetMeasure target(disk.mesh());
  double before = 1e300;
  for (const int steps : {1, 4, 16, 64}) {
    const LieAdvectionResult result = lieAdvection(disk, start(disk), target, inSteps(steps));
    EXPECT_EQ(result.iterations, steps);
    EXPECT_LT(result.residual, before) << steps;
    before = result.residual;
  }
  EXPECT_LT(before, 0.05);
}

TEST(LieAdvection, LeavesAMapThatIsAreaPreservingAlone) {
  const TriangleMesh flat = diskMesh(10);
  const DiskMesh disk(flat);
  const Points2 image = flat.points().leftCols<2>();
  const LieAdvectionResult result = lieAdvection(disk, image, TargetMeasure(flat), inSteps(10));
  EXPECT_EQ(result.status, Status::Converged);
  EXPECT_LT((result.image - image).cwiseAbs().maxCoeff(), 1e-9);
}

TEST(LieAdvection, KeepsTheBoundaryOnThatOfItsDomain) {
  const DiskMesh disk(bumpyDisk(12));
  const LieAdvectionResult round = lieAdvection(disk, start(disk), TargetMeasure(disk.mesh()), inSteps(20));
  LieAdvectionOptions options = inSteps(20);
  options.domain = PlanarDomain::square();
  const LieAdvectionResult square =
      lieAdvection(disk, start(disk, options.domain), TargetMeasure(disk.mesh()), options);
  for (const int v : disk.boundary()) {
    EXPECT_NEAR(round.image.row(v).norm(), 1, 1e-12);
    const Eigen::RowVector2d p = square.image.row(v);
    EXPECT_NEAR(std::min({p[0], p[1], 1 - p[0], 1 - p[1]}), 0, 1e-12);
  }
  EXPECT_EQ(round.flippedFaces, 0);
  EXPECT_EQ(square.flippedFaces, 0);
}

TEST(LieAdvection, GivesARegionMoreOfTheDomain) {
  const DiskMesh disk(bumpyDisk(16));
  Eigen::VectorXd density(disk.mesh().vertexCount());
  for (int v = 0; v < density.size(); ++v) density[v] = disk.mesh().point(v)[0] > 0 ? 3 : 1;
  const TargetMeasure target = TargetMeasure::fromVertexDensity(disk.mesh(), density);
  const Points2 image = lieAdvection(disk, start(disk), target, inSteps(60)).image;
  const Eigen::VectorXd areas = signedFaceAreas(image, disk.mesh().faces());
  const Eigen::VectorXd stars = vertexStars(areas / areas.sum(), disk.mesh().faces(), disk.mesh().vertexCount());
  const Eigen::VectorXd region = (density.array() > 1).cast<double>();
  EXPECT_NEAR(stars.dot(region), target.vertices().dot(region), 0.01);
}

TEST(LieAdvection, GivesTheSameBitsOnOneThreadAndTwo) {
  const DiskMesh disk(bumpyDisk(12));
  const TargetMeasure target(disk.mesh());
  EXPECT_EQ(lieAdvection(disk, start(disk), target, inSteps(5), Execution({}, {}, 1)).image,
            lieAdvection(disk, start(disk), target, inSteps(5), Execution({}, {}, 2)).image);
}

TEST(LieAdvection, StopsWhenAskedTo) {
  const DiskMesh disk(bumpyDisk(12));
  int steps = 0;
  const Execution execution([&](double, const std::string&) { ++steps; }, [&] { return steps > 5; });
  const LieAdvectionResult result = lieAdvection(disk, start(disk), TargetMeasure(disk.mesh()), inSteps(50), execution);
  EXPECT_EQ(result.status, Status::Cancelled);
  EXPECT_LT(result.iterations, 50);
}

TEST(LieAdvection, RefusesNoStepsAndForeignTargets) {
  const DiskMesh disk(bumpyDisk(6));
  EXPECT_THROW((void)lieAdvection(disk, start(disk), TargetMeasure(disk.mesh()), inSteps(0)), InvalidArgument);
  EXPECT_THROW((void)lieAdvection(disk, start(disk), TargetMeasure(diskMesh(5)), {}), GeometryError);
}
