#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numeric>
#include <random>

#include "Core/base/Error.h"
#include "Core/distortion/Distortion.h"
#include "Core/geometry/Areas.h"
#include "Core/initial/BarycentricMap.h"
#include "Core/initial/SymmetricDirichletMap.h"
#include "support/TestMeshes.h"

using namespace authalic;
using namespace authalic::testing;

namespace {

Points2 startOf(const DiskMesh& disk, BarycentricWeights weights = BarycentricWeights::Uniform) {
  BarycentricMapOptions options;
  options.weights = weights;
  return barycentricMap(disk, options).image;
}

SymmetricDirichletMapOptions with(IsometricBoundary boundary) {
  SymmetricDirichletMapOptions options;
  options.boundary = boundary;
  return options;
}

const IsometricBoundary kBoth[] = {IsometricBoundary::Free, IsometricBoundary::Fixed};

}  // namespace

TEST(SymmetricDirichletMap, NeverFoldsAndNeverRaisesItsEnergy) {
  const DiskMesh disk(bumpyDisk(12, 1.5));
  for (const IsometricBoundary boundary : kBoth) {
    for (int most = 0; most < 8; ++most) {
      SymmetricDirichletMapOptions options = with(boundary);
      options.maxIterations = most;
      const SymmetricDirichletMapResult result = symmetricDirichletMap(disk, startOf(disk), options);
      EXPECT_EQ(countFlippedFaces(result.image, disk.mesh().faces()), 0) << most;
      for (std::size_t k = 1; k < result.history.size(); ++k) {
        EXPECT_LE(result.history[k].energy, result.history[k - 1].energy);
      }
    }
  }
}

TEST(SymmetricDirichletMap, EnergyIsThatOfTheDistortionReport) {
  const DiskMesh disk(bumpyDisk(8, 1.0));
  const SymmetricDirichletMapResult fixed = symmetricDirichletMap(disk, startOf(disk), with(IsometricBoundary::Fixed));
  EXPECT_NEAR(measureDistortion(disk.mesh(), fixed.image).summary.symmetricDirichlet, fixed.energy, 1e-9);
}

TEST(SymmetricDirichletMap, EndsAtTheSameMapFromTutteAndMeanValueStarts) {
  const DiskMesh disk(bumpyDisk(10, 1.0));
  for (const IsometricBoundary boundary : kBoth) {
    const SymmetricDirichletMapResult one = symmetricDirichletMap(disk, startOf(disk), with(boundary));
    const SymmetricDirichletMapResult two =
        symmetricDirichletMap(disk, startOf(disk, BarycentricWeights::MeanValue), with(boundary));
    EXPECT_EQ(one.status, Status::Converged);
    EXPECT_NEAR(one.energy, two.energy, 1e-9) << isometricBoundaryName(boundary);
    EXPECT_LT((one.image - two.image).rowwise().norm().maxCoeff(), 1e-4) << isometricBoundaryName(boundary);
  }
}

TEST(SymmetricDirichletMap, KeepsAFixedBoundaryWhereItIs) {
  const DiskMesh disk(bumpyDisk(8, 1.0));
  const Points2 start = startOf(disk);
  const Points2 image = symmetricDirichletMap(disk, start, with(IsometricBoundary::Fixed)).image;
  for (const int v : disk.boundary()) EXPECT_LT((image.row(v) - start.row(v)).norm(), 1e-14);
  EXPECT_GT((image - start).norm(), 0.01);
}

TEST(SymmetricDirichletMap, AFreeBoundaryDistortsLess) {
  const DiskMesh disk(bumpyDisk(8, 1.0));
  EXPECT_LT(symmetricDirichletMap(disk, startOf(disk)).energy,
            symmetricDirichletMap(disk, startOf(disk), with(IsometricBoundary::Fixed)).energy);
}

TEST(SymmetricDirichletMap, CommutesWithSimilaritiesAndRenumbering) {
  const TriangleMesh mesh = bumpyDisk(7, 0.8);
  std::vector<int> order(static_cast<std::size_t>(mesh.vertexCount()));
  std::iota(order.begin(), order.end(), 0);
  std::shuffle(order.begin(), order.end(), std::mt19937(2));
  Points3 points(mesh.vertexCount(), 3);
  const Points2 start = startOf(DiskMesh(mesh));
  Points2 moved(start.rows(), 2);
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  for (int v = 0; v < mesh.vertexCount(); ++v) {
    points.row(order[static_cast<std::size_t>(v)]) = 40 * (turn * mesh.point(v)).transpose();
    moved.row(order[static_cast<std::size_t>(v)]) = start.row(v);
  }
  Faces faces = mesh.faces();
  for (Eigen::Index k = 0; k < faces.size(); ++k) faces.data()[k] = order[static_cast<std::size_t>(faces.data()[k])];
  for (const IsometricBoundary boundary : kBoth) {
    const Points2 before = symmetricDirichletMap(DiskMesh(mesh), start, with(boundary)).image;
    const Points2 after = symmetricDirichletMap(DiskMesh(TriangleMesh(points, faces)), moved, with(boundary)).image;
    const double unit = boundary == IsometricBoundary::Free ? 40 : 1;
    for (int v = 0; v < mesh.vertexCount(); ++v) {
      EXPECT_LT((after.row(order[static_cast<std::size_t>(v)]) - unit * before.row(v)).norm(), 1e-5 * unit);
    }
  }
}

TEST(SymmetricDirichletMap, GivesTheSameBitsOnOneThreadAndTwo) {
  const DiskMesh disk(bumpyDisk(24, 1.0));
  const Points2 start = startOf(disk);
  const Points2 one = symmetricDirichletMap(disk, start, {}, Execution({}, {}, 1)).image;
  EXPECT_TRUE(symmetricDirichletMap(disk, start, {}, Execution({}, {}, 2)).image == one);
}

TEST(SymmetricDirichletMap, KeepsFacesWithoutSurfaceAreaUnfolded) {
  const TriangleMesh mesh = bumpyDisk(6, 0.5);
  Points3 points = mesh.points();
  points.row(3) = points.row(2);  // an edge of no length
  points.row(9) = 0.5 * (points.row(8) + points.row(20));
  const DiskMesh disk(TriangleMesh(points, mesh.faces()));
  const SymmetricDirichletMapResult result = symmetricDirichletMap(disk, startOf(disk));
  EXPECT_GT(result.degenerateFaces, 0);
  EXPECT_EQ(result.flippedFaces, 0);
  EXPECT_LT(result.energy, 8);
}

TEST(SymmetricDirichletMap, SaysWhenItHasNotConvergedOrWasStopped) {
  const DiskMesh disk(bumpyDisk(8, 1.0));
  SymmetricDirichletMapOptions options;
  options.maxIterations = 2;
  const SymmetricDirichletMapResult result = symmetricDirichletMap(disk, startOf(disk), options);
  EXPECT_EQ(result.status, Status::NotConverged);
  EXPECT_EQ(result.iterations, 2);
  EXPECT_EQ(result.history.size(), 3u);
  const Execution stopping({}, [] { return true; });
  EXPECT_EQ(symmetricDirichletMap(disk, startOf(disk), {}, stopping).status, Status::Cancelled);
}

TEST(SymmetricDirichletMap, RefusesFoldedStartsAndBadOptions) {
  const DiskMesh disk(bumpyDisk(4));
  Points2 folded = startOf(disk);
  folded.row(0) << 0.9, 0.1;
  EXPECT_THROW((void)symmetricDirichletMap(disk, folded), GeometryError);
  EXPECT_THROW((void)symmetricDirichletMap(disk, Points2::Zero(3, 2)), GeometryError);
  SymmetricDirichletMapOptions options;
  options.tolerance = 0;
  EXPECT_THROW((void)symmetricDirichletMap(disk, startOf(disk), options), InvalidArgument);
  options = {};
  options.maxIterations = -1;
  EXPECT_THROW((void)symmetricDirichletMap(disk, startOf(disk), options), InvalidArgument);
}
