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

// A flat disk that grows `fans` times over a boundary vertex: five faces around it, of which the second and the
// fourth differ in area and carry ears that do not. With both tips in the middle of their arcs, the ears' areas fix
// the ratio of the chords, and with it that of the two faces, which stand on nearly one line: no such image is exact.
TriangleMesh diskWithFansOfEars(int fans, double ratio) {
  const TriangleMesh disk = diskMesh(20);
  std::vector<Eigen::Vector3d> points;
  std::vector<Eigen::RowVector3i> faces;
  for (int v = 0; v < disk.vertexCount(); ++v) points.push_back(disk.point(v));
  for (int f = 0; f < disk.faceCount(); ++f) faces.push_back(disk.faces().row(f));
  const auto add = [&](const Eigen::Vector3d& p) { return points.push_back(p), static_cast<int>(points.size()) - 1; };
  const std::vector<int> loop = DiskMesh(disk).boundary();
  for (int fan = 0; fan < fans; ++fan) {
    const std::size_t at = loop.size() / static_cast<std::size_t>(fans) * static_cast<std::size_t>(fan);
    const int first = loop[at], hub = loop[at + 1], last = loop[at + 2];
    const double from = std::atan2(points[static_cast<std::size_t>(first)][1],
                                   points[static_cast<std::size_t>(first)][0]),
                 step = 4 * M_PI / double(loop.size()) / 10;
    std::vector<int> rim{first};
    for (const double part : {1.0, 1.0 + 6 / (1 + ratio), 3.0 + 6 / (1 + ratio), 9.0}) {
      rim.push_back(add(1.05 * Eigen::Vector3d(std::cos(from + part * step), std::sin(from + part * step), 0)));
    }
    rim.push_back(last);
    for (std::size_t k = 0; k + 1 < rim.size(); ++k) faces.emplace_back(hub, rim[k], rim[k + 1]);
    for (const std::size_t k : {std::size_t(1), std::size_t(3)}) {
      const Eigen::Vector3d a = points[static_cast<std::size_t>(rim[k])],
                            b = points[static_cast<std::size_t>(rim[k + 1])],
                            out(b[1] - a[1], a[0] - b[0], 0);
      faces.emplace_back(rim[k + 1], rim[k], add(0.5 * (a + b) + 2e-5 / out.squaredNorm() * out));
    }
  }
  Points3 allPoints(static_cast<Eigen::Index>(points.size()), 3);
  for (std::size_t v = 0; v < points.size(); ++v) allPoints.row(static_cast<Eigen::Index>(v)) = points[v];
  Faces allFaces(static_cast<Eigen::Index>(faces.size()), 3);
  for (std::size_t f = 0; f < faces.size(); ++f) allFaces.row(static_cast<Eigen::Index>(f)) = faces[f];
  return TriangleMesh(allPoints, allFaces);
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

TEST(AuthalicMap, LetsTipsOfEarsLeaveTheMiddleWhereTheirNeighboursNeedIt) {
  for (const double ratio : {1.5, 2.0}) {
    const DiskMesh disk(diskWithFansOfEars(3, ratio));
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
