#include <gtest/gtest.h>

#include <random>
#include <set>

#include "Core/authalic/AuthalicMap.h"
#include "Core/base/Error.h"
#include "Core/distortion/Distortion.h"
#include "Core/geometry/Areas.h"
#include "Core/initial/BarycentricMap.h"
#include "support/TestMeshes.h"

using namespace authalic;
using namespace authalic::testing;

namespace {

// Coarse meshes have few ways to move: their faces come less near to their targets.
AuthalicMapOptions coarse(const PlanarDomain& domain = {}) {
  AuthalicMapOptions options;
  options.domain = domain;
  options.tolerance = 0.02;
  return options;
}

AuthalicMapResult solve(const DiskMesh& disk, const AuthalicMapOptions& options = coarse()) {
  return authalicMap(disk, TargetMeasure(disk.mesh()), options);
}

void expectExact(const DiskMesh& disk, const AuthalicMapResult& result, const Eigen::VectorXd& target = {}) {
  EXPECT_EQ(result.status, Status::Converged) << result.faceResidual << ' ' << result.vertexResidual;
  const DistortionSummary summary = measureDistortion(disk.mesh(), result.image, target).summary;
  EXPECT_LT(summary.vertexMaxAbsLog, 1e-9);
  EXPECT_LT(summary.areaDistortion, 2.0004);
  EXPECT_EQ(summary.flippedFaces, 0);
}

Points2 hexagon() {
  Points2 corners(6, 2);
  for (int k = 0; k < 6; ++k) corners.row(k) << std::cos(k * M_PI / 3), std::sin(k * M_PI / 3);
  return corners;
}

// Faces whose centroid lies within 0.35 of (0.2, 0.1).
std::vector<int> regionOf(const TriangleMesh& mesh) {
  std::vector<int> region;
  for (int f = 0; f < mesh.faceCount(); ++f) {
    if (((mesh.corner(f, 0) + mesh.corner(f, 1) + mesh.corner(f, 2)) / 3 - Eigen::Vector3d(0.2, 0.1, 0))
            .head<2>()
            .norm() < 0.35) {
      region.push_back(f);
    }
  }
  return region;
}

}  // namespace

TEST(AuthalicMap, IsExactAtEveryVertexOfEveryDomain) {
  const DiskMesh disk(bumpyDisk(16, 0.8));
  for (const auto& domain : {PlanarDomain::disk(), PlanarDomain::square(), PlanarDomain::rectangle(2),
                             PlanarDomain::polygon(hexagon())}) {
    expectExact(disk, solve(disk, coarse(domain)));
  }
}

TEST(AuthalicMap, IsExactOnRoughMeshes) {
  for (unsigned seed = 1; seed <= 3; ++seed) {
    const DiskMesh disk(roughDisk(12, seed));
    expectExact(disk, solve(disk));
  }
}

TEST(AuthalicMap, GivesARegionExactlyItsShareAtVertices) {
  const DiskMesh disk(bumpyDisk(20));
  for (const double factor : {0.25, 4.0, 16.0}) {
    const TargetMeasure target = TargetMeasure::fromFaceDensity(
        disk.mesh(), regionDensity(disk.mesh().faceCount(), regionOf(disk.mesh()), factor));
    const AuthalicMapResult result = authalicMap(disk, target, coarse());
    expectExact(disk, result, target.faces());
    // The share of the vertices of the region, each with its star, is what their targets sum to.
    std::set<int> vertices;
    for (const int f : regionOf(disk.mesh())) {
      for (int k = 0; k < 3; ++k) vertices.insert(disk.mesh().faces()(f, k));
    }
    const Eigen::VectorXd areas = signedFaceAreas(result.image, disk.mesh().faces());
    const Eigen::VectorXd stars = vertexStars(areas / areas.sum(), disk.mesh().faces(), disk.mesh().vertexCount());
    double share = 0, wanted = 0;
    for (const int v : vertices) share += stars[v], wanted += target.vertices()[v];
    EXPECT_NEAR(share, wanted, 1e-9 * wanted) << factor;
  }
}

TEST(AuthalicMap, IsTheIdentityOnAFlatDiskWithItsOwnMap) {
  const TriangleMesh flat = diskMesh(10);
  const DiskMesh disk(flat);
  const AuthalicMapResult result = authalicMap(disk, TargetMeasure(flat), {}, flat.points().leftCols(2));
  EXPECT_EQ(result.status, Status::Converged);
  EXPECT_LT((result.image - flat.points().leftCols(2)).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(AuthalicMap, KeepsTheBoundaryOnTheDomain) {
  const DiskMesh disk(bumpyDisk(12));
  const Points2 image = solve(disk).image;
  for (const int v : disk.boundary()) EXPECT_NEAR(image.row(v).norm(), 1, 1e-12);
}

TEST(AuthalicMap, DoesNotDependOnScaleAndPlaceOfTheSurface) {
  const TriangleMesh mesh = bumpyDisk(12);
  const TriangleMesh moved((mesh.points() * 37.0).rowwise() + Eigen::RowVector3d(5, -80, 3), mesh.faces());
  AuthalicMapOptions options;
  options.tolerance = 0.05;  // few steps: rounding grows in each, as many maps are nearly as good
  const Points2 one = solve(DiskMesh(mesh), options).image, other = solve(DiskMesh(moved), options).image;
  EXPECT_LT((one - other).cwiseAbs().maxCoeff(), 1e-6);
}

TEST(AuthalicMap, GivesTheSameBitsOnOneThreadAndTwo) {
  const DiskMesh disk(bumpyDisk(20));
  const TargetMeasure target(disk.mesh());
  const Points2 one = authalicMap(disk, target, {}, {}, Execution({}, {}, 1)).image;
  const Points2 two = authalicMap(disk, target, {}, {}, Execution({}, {}, 2)).image;
  EXPECT_EQ(one, two);
}

TEST(AuthalicMap, SaysThatItDidNotConvergeAndStaysUnfolded) {
  const DiskMesh disk(bumpyDisk(16, 0.8));
  AuthalicMapOptions options;
  options.maxIterations = 1;
  const AuthalicMapResult result = solve(disk, options);
  EXPECT_EQ(result.status, Status::NotConverged);
  EXPECT_GT(result.vertexResidual, options.vertexTolerance);
  EXPECT_EQ(result.flippedFaces, 0);
  EXPECT_EQ(result.history.size(), 1u);
}

TEST(AuthalicMap, ReturnsTheLastIterateWhenCancelled) {
  const DiskMesh disk(bumpyDisk(16, 0.8));
  int asked = 0;
  const AuthalicMapResult result = authalicMap(disk, TargetMeasure(disk.mesh()), {}, {},
                                               Execution({}, [&] { return ++asked > 6; }));
  EXPECT_EQ(result.status, Status::Cancelled);
  EXPECT_EQ(countFlippedFaces(result.image, disk.mesh().faces()), 0);
}

TEST(AuthalicMap, RefusesWhatItCannotUse) {
  const DiskMesh disk(bumpyDisk(4));
  AuthalicMapOptions options;
  options.tolerance = 0;
  EXPECT_THROW((void)solve(disk, options), InvalidArgument);
  options = {};
  options.vertexTolerance = -1;
  EXPECT_THROW((void)solve(disk, options), InvalidArgument);
  EXPECT_THROW((void)authalicMap(disk, TargetMeasure(diskMesh(3))), GeometryError);
  EXPECT_THROW((void)authalicMap(disk, TargetMeasure(disk.mesh()), {}, Points2::Zero(disk.mesh().vertexCount(), 2)),
               GeometryError);
}
