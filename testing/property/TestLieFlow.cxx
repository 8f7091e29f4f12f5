#include <gtest/gtest.h>

#include <atomic>
#include <random>

#include "Core/authalic/DiscreteLieFlow.h"
#include "Core/authalic/FlowingMesh.h"
#include "Core/base/Error.h"
#include "Core/distortion/Distortion.h"
#include "Core/geometry/Areas.h"
#include "Core/geometry/Laplacian.h"
#include "Core/initial/BarycentricMap.h"
#include "Core/initial/Unfold.h"
#include "support/TestMeshes.h"

using namespace authalic;
using namespace authalic::testing;

namespace {

Points2 startOf(const DiskMesh& disk, const PlanarDomain& domain = {}) {
  BarycentricMapOptions options;
  options.domain = domain;
  return barycentricMap(disk, options).image;
}

DiscreteLieFlowResult flow(const DiskMesh& disk, DiscreteLieFlowOptions options = {}, const Execution& execution = {}) {
  return discreteLieFlow(disk, startOf(disk, options.domain), TargetMeasure(disk.mesh()), options, execution);
}

}  // namespace

TEST(DiscreteLieFlow, IsTheIdentityOnAFlatDiskWithItsOwnArea) {
  const TriangleMesh flat = diskMesh(10);
  const DiscreteLieFlowResult result = flow(DiskMesh(flat));
  EXPECT_EQ(result.status, Status::Converged);
  EXPECT_EQ(result.iterations, 0);
  EXPECT_LT((result.image - flat.points().leftCols(2)).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(DiscreteLieFlow, PreservesAreasOnEveryDomainWithoutFlips) {
  const DiskMesh disk(bumpyDisk(16, 0.8));
  Points2 hexagon(6, 2);
  for (int k = 0; k < 6; ++k) hexagon.row(k) << std::cos(k * M_PI / 3), std::sin(k * M_PI / 3);
  for (const auto& domain : {PlanarDomain::disk(), PlanarDomain::square(), PlanarDomain::rectangle(2),
                             PlanarDomain::polygon(hexagon)}) {
    DiscreteLieFlowOptions options;
    options.domain = domain;
    const DiscreteLieFlowResult result = flow(disk, options);
    EXPECT_EQ(result.status, Status::Converged) << result.residual;
    EXPECT_LE(result.residual, options.tolerance);
    EXPECT_EQ(result.flippedFaces, 0);
    EXPECT_EQ(countFlippedFaces(result.image, disk.mesh().faces()), 0);
    EXPECT_LT(measureDistortion(disk.mesh(), result.image).summary.areaDistortion, 2.005);
  }
}

TEST(DiscreteLieFlow, KeepsTheBoundaryOnTheDomain) {
  const DiskMesh disk(bumpyDisk(12));
  const Points2 onDisk = flow(disk).image;
  for (const int v : disk.boundary()) EXPECT_NEAR(onDisk.row(v).norm(), 1, 1e-12);
  DiscreteLieFlowOptions options;
  options.domain = PlanarDomain::square();
  const Points2 onSquare = flow(disk, options).image;
  int corners = 0;
  for (const int v : disk.boundary()) {
    const double x = onSquare(v, 0), y = onSquare(v, 1);
    EXPECT_LT(std::min({std::abs(x), std::abs(1 - x), std::abs(y), std::abs(1 - y)}), 1e-12);
    corners += std::min(std::abs(x), std::abs(1 - x)) + std::min(std::abs(y), std::abs(1 - y)) < 1e-12;
  }
  EXPECT_EQ(corners, 4);
}

TEST(DiscreteLieFlow, GivesARegionOfFourfoldDensityItsShare) {
  const DiskMesh disk(bumpyDisk(16));
  std::vector<int> region;
  const TriangleMesh& mesh = disk.mesh();
  for (int f = 0; f < mesh.faceCount(); ++f) {
    if ((mesh.corner(f, 0).head<2>() - Eigen::Vector2d(0.2, 0.1)).norm() < 0.35) region.push_back(f);
  }
  const TargetMeasure target = TargetMeasure::fromFaceDensity(mesh, regionDensity(mesh.faceCount(), region, 4));
  const DiscreteLieFlowResult result = discreteLieFlow(disk, startOf(disk), target);
  EXPECT_EQ(result.flippedFaces, 0);
  const Eigen::VectorXd areas = signedFaceAreas(result.image, mesh.faces());
  double share = 0, wanted = 0;
  for (const int f : region) share += areas[f] / areas.sum(), wanted += target.faces()[f];
  EXPECT_GT(wanted, 0.3);
  EXPECT_NEAR(share / wanted, 1, 0.01);
}

TEST(DiscreteLieFlow, TurnsWithItsInitialMap) {
  const DiskMesh disk(bumpyDisk(10));
  const Points2 start = startOf(disk);
  const Eigen::Rotation2Dd turn(0.4);
  const Points2 turned = start * turn.toRotationMatrix().transpose();
  const TargetMeasure target(disk.mesh());
  const Points2 a = discreteLieFlow(disk, start, target).image;
  const Points2 b = discreteLieFlow(disk, turned, target).image;
  EXPECT_LT((a * turn.toRotationMatrix().transpose() - b).cwiseAbs().maxCoeff(), 1e-6);
}

TEST(DiscreteLieFlow, GivesTheSameBitsAtAnyThreadCountAndEveryTime) {
  const DiskMesh disk(bumpyDisk(20));
  const DiscreteLieFlowResult one = flow(disk, {}, Execution({}, {}, 1));
  const DiscreteLieFlowResult four = flow(disk, {}, Execution({}, {}, 4));
  EXPECT_TRUE((one.image.array() == four.image.array()).all());
  EXPECT_EQ(one.history.size(), four.history.size());
}

TEST(DiscreteLieFlow, ReportsThePapersFlowOnTheOriginalFacesHonestly) {
  const DiskMesh disk(bumpyDisk(24, 2.5));
  DiscreteLieFlowOptions options;
  options.finish = LieFlowFinish::None;
  const DiscreteLieFlowResult bare = flow(disk, options);
  EXPECT_EQ(bare.flippedFaces, countFlippedFaces(bare.image, disk.mesh().faces()));
  EXPECT_EQ(bare.flippedFaces, bare.flippedBeforeFinish);
  EXPECT_GT(bare.edgeFlips, 0);
  EXPECT_EQ(bare.finishIterations, 0);
  options.finish = LieFlowFinish::Unfold;
  EXPECT_EQ(flow(disk, options).flippedFaces, 0);
}

TEST(DiscreteLieFlow, NeedsMoreStepsWhenTheyAreFixedAndSmall) {
  const DiskMesh disk(bumpyDisk(10, 0.8));
  DiscreteLieFlowOptions options;
  options.finish = LieFlowFinish::None;
  options.tolerance = 0.15;
  options.maxIterations = 2000;
  const DiscreteLieFlowResult adaptive = flow(disk, options);
  options.fixedStep = 0.01;
  const DiscreteLieFlowResult fixed = flow(disk, options);
  EXPECT_EQ(adaptive.status, Status::Converged);
  EXPECT_EQ(fixed.status, Status::Converged);
  EXPECT_GT(fixed.iterations, 5 * adaptive.iterations);
}

TEST(DiscreteLieFlow, SaysSoWhenTheIterationLimitComesFirst) {
  DiscreteLieFlowOptions options;
  options.maxIterations = 1;
  options.maxFinishIterations = 1;
  options.tolerance = 1e-12;
  const DiscreteLieFlowResult result = flow(DiskMesh(bumpyDisk(10, 1.5)), options);
  EXPECT_EQ(result.status, Status::NotConverged);
  EXPECT_GT(result.residual, options.tolerance);
  EXPECT_EQ(result.flippedFaces, 0);
}

TEST(DiscreteLieFlow, ReturnsTheLastValidIterateWhenCancelled) {
  const DiskMesh disk(bumpyDisk(12, 1.5));
  std::atomic<int> asked{0};
  DiscreteLieFlowOptions options;
  options.flowTolerance = 1e-6;
  const DiscreteLieFlowResult result = flow(disk, options, Execution({}, [&] { return ++asked > 4; }));
  EXPECT_EQ(result.status, Status::Cancelled);
  EXPECT_TRUE(result.image.allFinite());
  EXPECT_LT(result.iterations, 10);
}

TEST(DiscreteLieFlow, ReportsProgressThatNeverFalls) {
  double last = 0;
  bool falls = false;
  static_cast<void>(flow(DiskMesh(bumpyDisk(10)), {}, Execution([&](double fraction, const std::string&) {
    falls = falls || fraction < last;
    last = fraction;
  })));
  EXPECT_FALSE(falls);
  EXPECT_EQ(last, 1);
}

TEST(DiscreteLieFlow, RefusesOptionsStartsAndTargetsThatDoNotFit) {
  const DiskMesh disk(bumpyDisk(5)), other(bumpyDisk(6));
  const Points2 start = startOf(disk);
  const TargetMeasure target(disk.mesh());
  DiscreteLieFlowOptions options;
  options.stepRatio = 1.5;
  EXPECT_THROW(static_cast<void>(discreteLieFlow(disk, start, target, options)), InvalidArgument);
  options = {};
  options.tolerance = 0;
  EXPECT_THROW(static_cast<void>(discreteLieFlow(disk, start, target, options)), InvalidArgument);
  EXPECT_THROW(static_cast<void>(discreteLieFlow(disk, start, TargetMeasure(other.mesh()))), GeometryError);
  EXPECT_THROW(static_cast<void>(discreteLieFlow(disk, startOf(other), target)), GeometryError);
  EXPECT_THROW(static_cast<void>(discreteLieFlow(disk, 2 * start, target)), GeometryError);  // not on the unit circle
  options = {};
  options.domain = PlanarDomain::square();
  EXPECT_THROW(static_cast<void>(discreteLieFlow(disk, start, target, options)), GeometryError);
}

TEST(FlowingMesh, IsDelaunayAfterItsFlipsAndCoversTheSameArea) {
  const TriangleMesh flat = diskMesh(12);
  Points2 points = flat.points().leftCols(2);
  for (Eigen::Index i = 0; i < points.rows(); ++i) points(i, 0) += 0.8 * std::sin(2 * points(i, 1));  // shear
  FlowingMesh mesh(flat.faces(), flat.vertexCount());
  EXPECT_GT(mesh.makeDelaunay(points), 0);
  EXPECT_EQ(mesh.makeDelaunay(points), 0);
  EXPECT_EQ(countFlippedFaces(points, mesh.faces()), 0);
  EXPECT_NEAR(signedFaceAreas(points, mesh.faces()).sum(), signedFaceAreas(points, flat.faces()).sum(), 1e-12);
  const SparseMatrix stiffness = cotangentStiffness(points, mesh.faces());
  const SurfaceTopology topology(mesh.faces(), flat.vertexCount());
  EXPECT_TRUE(topology.manifold());
  for (int k = 0; k < stiffness.outerSize(); ++k) {
    for (SparseMatrix::InnerIterator entry(stiffness, k); entry; ++entry) {
      const bool inner = !topology.onBoundary()[static_cast<std::size_t>(entry.row())] ||
                         !topology.onBoundary()[static_cast<std::size_t>(entry.col())];
      if (entry.row() != entry.col() && inner) {
        EXPECT_LT(entry.value(), 1e-9);
      }
    }
  }
}

TEST(Unfold, RemovesFoldsAndLeavesTheRestAlone) {
  const TriangleMesh flat = diskMesh(20);
  Points2 image = flat.points().leftCols(2);
  image.row(0) << 0.2, 0.1;  // the centre vertex thrown over its neighbours
  ASSERT_GT(countFlippedFaces(image, flat.faces()), 0);
  const UnfoldResult result = unfold(SurfaceTopology(flat.faces(), flat.vertexCount()), image);
  EXPECT_EQ(result.flippedFaces, 0);
  EXPECT_LT(result.movedVertices, flat.vertexCount() / 2);
  const Eigen::Index far = flat.vertexCount() - 6 * 20 - 6 * 19;
  EXPECT_LT((result.image - image).bottomRows(flat.vertexCount() - far).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(Unfold, RecoversFromAnArbitrarilyCrumpledInterior) {
  const TriangleMesh flat = diskMesh(12);
  std::mt19937 random(11);
  std::uniform_real_distribution<double> uniform(-1, 1);
  Points2 image = flat.points().leftCols(2);
  for (Eigen::Index i = 0; i < image.rows() - 72; ++i) image.row(i) << uniform(random), uniform(random);
  EXPECT_EQ(unfold(SurfaceTopology(flat.faces(), flat.vertexCount()), image).flippedFaces, 0);
}
