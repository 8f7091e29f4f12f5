#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "Core/authalic/AuthalicMap.h"
#include "Core/authalic/RoomOnCircle.h"
#include "Core/geometry/Areas.h"
#include "support/TestMeshes.h"

using namespace authalic;
using namespace authalic::testing;

namespace {

// A disk with one more triangle on a boundary edge: its outer edges together are hardly longer than that edge.
DiskMesh diskWithEar() {
  const TriangleMesh mesh = diskMesh(12);
  const DiskMesh disk(mesh);
  const int a = disk.boundary()[0], b = disk.boundary()[1], n = mesh.vertexCount();
  Points3 points(n + 1, 3);
  points << mesh.points(), 1.02 * (mesh.points().row(a) + mesh.points().row(b)) / 2;
  Faces faces(mesh.faceCount() + 1, 3);
  faces << mesh.faces(), Eigen::RowVector3i(b, a, n);
  return DiskMesh(TriangleMesh(points, faces));
}

constexpr int kOnRim = 8;

// A disk with a hundredth more behind one boundary edge, a bulb of a vertex with `kOnRim` others on its rim. Those are
// the last ones, in the order of the boundary.
DiskMesh diskWithBulb() {
  const TriangleMesh mesh = diskMesh(12);
  const DiskMesh disk(mesh);
  const int a = disk.boundary()[0], b = disk.boundary()[1], n = mesh.vertexCount();
  const Eigen::RowVector3d middle = (mesh.points().row(a) + mesh.points().row(b)) / 2, centre = 1.1 * middle;
  Points3 points(n + 1 + kOnRim, 3);
  points << mesh.points(), centre, Points3::Zero(kOnRim, 3);
  Faces faces(mesh.faceCount() + kOnRim + 2, 3);
  faces.topRows(mesh.faceCount()) = mesh.faces();
  faces.bottomRows(kOnRim + 2).col(0).setConstant(n);
  const double inwards = std::atan2(-middle[1], -middle[0]);
  int last = b, f = mesh.faceCount();
  const auto add = [&](int v) {
    faces.row(f++).tail<2>() << last, v;
    last = v;
  };
  add(a);
  for (int k = 0; k < kOnRim; ++k) {
    const double angle = inwards + 2 * M_PI * (k + 1) / (kOnRim + 1);
    points.row(n + 1 + k) = centre + 0.1 * Eigen::RowVector3d(std::cos(angle), std::sin(angle), 0);
    add(n + 1 + k);
  }
  add(b);
  return DiskMesh(TriangleMesh(points, faces));
}

double turned(const BoundaryPlacement& placement, Eigen::Index i) {
  const Eigen::RowVector2d p = placement.points.row(i), q = placement.points.row((i + 1) % placement.points.rows());
  return std::atan2(p[0] * q[1] - p[1] * q[0], p.dot(q));
}

}  // namespace

TEST(RoomOnCircle, GivesAnEarArcsThatHoldItsShareAndKeepsTheOrder) {
  const DiskMesh disk = diskWithEar();
  const TargetMeasure target(disk.mesh());
  BoundaryPlacement placement = placeBoundary(disk, PlanarDomain::disk());
  makeRoomOnCircle(disk, target, placement);
  double sum = 0;
  for (Eigen::Index i = 0; i < placement.points.rows(); ++i) {
    EXPECT_GT(turned(placement, i), 0);
    EXPECT_NEAR(placement.points.row(i).norm(), 1, 1e-14);
    sum += turned(placement, i);
  }
  EXPECT_NEAR(sum, 2 * M_PI, 1e-9);
  Points2 image = Points2::Zero(disk.mesh().vertexCount(), 2);
  for (std::size_t i = 0; i < placement.vertices.size(); ++i) {
    image.row(placement.vertices[i]) = placement.points.row(static_cast<Eigen::Index>(i));
  }
  const int ear = disk.mesh().faceCount() - 1;
  const double share = signedFaceAreas(image, disk.mesh().faces())[ear] / M_PI;
  EXPECT_NEAR(share / target.faces()[ear], 1, 0.1);
}

TEST(RoomOnCircle, GivesAPieceBehindAChordASegmentThatHoldsItsShare) {
  const DiskMesh disk = diskWithBulb();
  const TargetMeasure target(disk.mesh());
  const double share = target.faces().tail(kOnRim + 2).sum();
  BoundaryPlacement placement = placeBoundary(disk, PlanarDomain::disk());
  const auto segment = [&] {  // between the two neighbours of the rim
    double angle = 0;
    for (std::size_t i = 0; i < placement.vertices.size(); ++i) {
      const int v = placement.vertices[i], next = placement.vertices[(i + 1) % placement.vertices.size()];
      if (std::max(v, next) >= disk.mesh().vertexCount() - kOnRim) angle += turned(placement, Eigen::Index(i));
    }
    return (angle - std::sin(angle)) / (2 * M_PI);
  };
  EXPECT_LT(segment(), share);
  makeRoomOnCircle(disk, target, placement);
  EXPECT_GT(segment(), share);
  EXPECT_LT(segment(), 2 * share);
}

TEST(RoomOnCircle, LeavesABoundaryWithRoomAsItIs) {
  const DiskMesh disk(diskMesh(12));
  BoundaryPlacement placement = placeBoundary(disk, PlanarDomain::disk());
  const Points2 before = placement.points;
  makeRoomOnCircle(disk, TargetMeasure(disk.mesh()), placement);
  EXPECT_EQ(placement.points, before);
}

TEST(AuthalicMap, IsExactOnADiskWithAnEar) {
  const DiskMesh disk = diskWithEar();
  AuthalicMapOptions options;
  options.tolerance = 0.03;
  const AuthalicMapResult result = authalicMap(disk, TargetMeasure(disk.mesh()), options);
  EXPECT_EQ(result.status, Status::Converged) << result.faceResidual << ' ' << result.vertexResidual;
  EXPECT_EQ(result.flippedFaces, 0);
}
