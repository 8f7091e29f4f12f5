#include <gtest/gtest.h>

#include <algorithm>
#include <complex>
#include <numeric>

#include "Core/base/Error.h"
#include "Core/geometry/Areas.h"
#include "Core/initial/BarycentricMap.h"
#include "support/TestMeshes.h"

using namespace authalic;
using namespace authalic::testing;

namespace {

BarycentricMapOptions withWeights(BarycentricWeights weights, const PlanarDomain& domain = {}) {
  BarycentricMapOptions options;
  options.weights = weights;
  options.domain = domain;
  return options;
}

const BarycentricWeights kAllWeights[] = {BarycentricWeights::Uniform, BarycentricWeights::Harmonic,
                                          BarycentricWeights::MeanValue};

// A triangle on a straight run of the boundary whose three vertices all lie on the boundary, twice nested.
TriangleMesh gridWithPocket() {
  const TriangleMesh grid = gridMesh(4, 4);
  Points3 points(grid.vertexCount() + 2, 3);
  points.topRows(grid.vertexCount()) = grid.points();
  points.row(25) << 0.375, -0.1, 0;  // over edge 1-2
  points.row(26) << 0.44, -0.1, 0;   // over edge 25-2
  Faces faces(grid.faceCount() + 2, 3);
  faces.topRows(grid.faceCount()) = grid.faces();
  faces.row(32) << 1, 25, 2;
  faces.row(33) << 25, 26, 2;
  return TriangleMesh(points, faces);
}

double distanceToSquare(const Points2& p, int v) {
  const double x = p(v, 0), y = p(v, 1);
  return std::min({std::abs(x), std::abs(y), std::abs(1 - x), std::abs(1 - y)});
}

}  // namespace

TEST(BarycentricMap, ConvexWeightsNeverFlipAFaceOnRandomMeshes) {
  Points2 pentagon(5, 2);
  pentagon << 0, 0, 3, 0, 4, 2, 1, 4, -1, 2;
  for (unsigned seed = 0; seed < 6; ++seed) {
    const DiskMesh disk(roughDisk(8, seed));
    for (const auto& domain : {PlanarDomain::disk(), PlanarDomain::square(), PlanarDomain::rectangle(3),
                               PlanarDomain::polygon(pentagon)}) {
      for (const auto weights : {BarycentricWeights::Uniform, BarycentricWeights::MeanValue}) {
        const BarycentricMapResult map = barycentricMap(disk, withWeights(weights, domain));
        EXPECT_EQ(map.flippedFaces, 0);
        EXPECT_LT(map.residual, 1e-12);
        EXPECT_EQ(map.status, Status::Converged);
      }
    }
  }
}

TEST(HarmonicMap, ReproducesTheIdentityOnAFlatDisk) {
  const TriangleMesh flat = diskMesh(10);
  const BarycentricMapResult map = barycentricMap(DiskMesh(flat), withWeights(BarycentricWeights::Harmonic));
  EXPECT_LT((map.image - flat.points().leftCols(2)).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(MeanValueMap, ReproducesTheIdentityOnAFlatRectangle) {
  const TriangleMesh flat = gridMesh(12, 6, 2, 1);
  const BarycentricMapResult map =
      barycentricMap(DiskMesh(flat), withWeights(BarycentricWeights::MeanValue, PlanarDomain::rectangle(2)));
  EXPECT_LT((map.image - flat.points().leftCols(2)).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(BarycentricMap, DoesNotChangeWhenTheSurfaceIsMovedTurnedOrScaled) {
  const TriangleMesh mesh = bumpyDisk(8);
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  Points3 moved = 40 * mesh.points() * turn.transpose();
  moved.rowwise() += Eigen::RowVector3d(10, -20, 30);
  for (const auto weights : kAllWeights) {
    const auto a = barycentricMap(DiskMesh(mesh), withWeights(weights));
    const auto b = barycentricMap(DiskMesh(TriangleMesh(moved, mesh.faces())), withWeights(weights));
    EXPECT_LT((a.image - b.image).cwiseAbs().maxCoeff(), 1e-11);
  }
}

TEST(BarycentricMap, FollowsARenumberingOfTheVertices) {
  const TriangleMesh mesh = bumpyDisk(7);
  std::vector<int> renamed(static_cast<std::size_t>(mesh.vertexCount()));
  std::iota(renamed.begin(), renamed.end(), 0);
  std::shuffle(renamed.begin(), renamed.end(), std::mt19937(5));
  Points3 points(mesh.vertexCount(), 3);
  Faces faces = mesh.faces();
  for (int v = 0; v < mesh.vertexCount(); ++v) points.row(renamed[static_cast<std::size_t>(v)]) = mesh.points().row(v);
  for (Eigen::Index i = 0; i < faces.size(); ++i) faces.data()[i] = renamed[static_cast<std::size_t>(faces.data()[i])];
  for (const auto weights : kAllWeights) {
    BarycentricMapOptions options = withWeights(weights, PlanarDomain::square());
    options.startVertex = 130;
    const auto a = barycentricMap(DiskMesh(mesh), options);
    options.startVertex = renamed[130];
    const auto b = barycentricMap(DiskMesh(TriangleMesh(points, faces)), options);
    double worst = 0;
    for (int v = 0; v < mesh.vertexCount(); ++v) {
      worst = std::max(worst, (a.image.row(v) - b.image.row(renamed[static_cast<std::size_t>(v)])).norm());
    }
    EXPECT_LT(worst, 1e-11);
  }
}

TEST(BarycentricMap, SpreadsTheBoundaryByArcLength) {
  const DiskMesh disk(bumpyDisk(9));
  const Points2 image = barycentricMap(disk).image;
  const std::vector<int>& loop = disk.boundary();
  double length = 0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    length += (disk.mesh().point(loop[(i + 1) % loop.size()]) - disk.mesh().point(loop[i])).norm();
  }
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const int a = loop[i], b = loop[(i + 1) % loop.size()];
    const std::complex<double> za(image(a, 0), image(a, 1)), zb(image(b, 0), image(b, 1));
    EXPECT_NEAR(std::abs(za), 1, 1e-14);
    const double share = (disk.mesh().point(b) - disk.mesh().point(a)).norm() / length;
    EXPECT_NEAR(std::arg(zb / za), 2 * M_PI * share, 1e-12);
  }
}

TEST(BarycentricMap, PutsVerticesExactlyIntoTheCornersOfAPolygon) {
  const DiskMesh disk(bumpyDisk(8));
  for (const auto& domain : {PlanarDomain::square(), PlanarDomain::rectangle(0.5)}) {
    const BarycentricMapResult map = barycentricMap(disk, withWeights(BarycentricWeights::Uniform, domain));
    ASSERT_EQ(map.boundary.corners.size(), 4u);
    for (int k = 0; k < 4; ++k) {
      const int v = map.boundary.vertices[static_cast<std::size_t>(map.boundary.corners[static_cast<std::size_t>(k)])];
      EXPECT_EQ(map.image.row(v), domain.corners().row(k));
    }
  }
}

TEST(BarycentricMap, BulgesPocketsOutOfAStraightSideSoThatNoFaceLosesItsArea) {
  const DiskMesh disk(gridWithPocket());
  for (const auto weights : {BarycentricWeights::Uniform, BarycentricWeights::MeanValue}) {
    const BarycentricMapResult map = barycentricMap(disk, withWeights(weights, PlanarDomain::square()));
    ASSERT_EQ(map.boundary.pockets.size(), 1u);
    EXPECT_EQ(map.boundary.pockets[0], (std::array<int, 2>{1, 2}));
    EXPECT_EQ(map.flippedFaces, 0);
    for (const int v : disk.boundary()) {
      if (v == 25 || v == 26) {
        EXPECT_LT(map.image(v, 1), 0);
        EXPECT_GT(map.image(v, 1), -0.1);
      } else {
        EXPECT_LT(distanceToSquare(map.image, v), 1e-14);
      }
    }
  }
  EXPECT_TRUE(barycentricMap(disk).boundary.pockets.empty());  // the circle needs none
  EXPECT_EQ(barycentricMap(disk).flippedFaces, 0);
}

TEST(BarycentricMap, CountsFlipsOnANonConvexPolygonHonestly) {
  Points2 star(8, 2);
  star << 4, 0, 0.3, 0.3, 0, 4, -0.3, 0.3, -4, 0, -0.3, -0.3, 0, -4, 0.3, -0.3;
  const PlanarDomain domain = PlanarDomain::polygon(star);
  EXPECT_FALSE(domain.convex());
  const DiskMesh disk(diskMesh(8));
  const BarycentricMapResult map = barycentricMap(disk, withWeights(BarycentricWeights::Uniform, domain));
  EXPECT_GT(map.flippedFaces, 0);
  EXPECT_EQ(map.flippedFaces, countFlippedFaces(map.image, disk.mesh().faces()));
}

TEST(BarycentricMap, GivesTheSameBitsAtAnyThreadCount) {
  const DiskMesh disk(bumpyDisk(30));
  for (const auto weights : kAllWeights) {
    const auto one = barycentricMap(disk, withWeights(weights), Execution({}, {}, 1));
    const auto four = barycentricMap(disk, withWeights(weights), Execution({}, {}, 4));
    EXPECT_TRUE((one.image.array() == four.image.array()).all());
  }
}

TEST(BarycentricMap, RefusesBadStartVerticesTooFewBoundaryVerticesAndStops) {
  const DiskMesh disk(diskMesh(4));
  BarycentricMapOptions options;
  options.startVertex = 0;  // an inner vertex
  EXPECT_THROW(static_cast<void>(barycentricMap(disk, options)), InvalidArgument);
  options.startVertex = -2;
  EXPECT_THROW(static_cast<void>(barycentricMap(disk, options)), InvalidArgument);
  Points3 points(3, 3);
  points << 0, 0, 0, 1, 0, 0, 0, 1, 0;
  Faces face(1, 3);
  face << 0, 1, 2;
  const DiskMesh triangle{TriangleMesh(points, face)};
  EXPECT_THROW(
      static_cast<void>(barycentricMap(triangle, withWeights(BarycentricWeights::Uniform, PlanarDomain::square()))),
      TopologyError);
  EXPECT_EQ(barycentricMap(triangle).flippedFaces, 0);
  EXPECT_THROW(static_cast<void>(barycentricMap(disk, {}, Execution({}, [] { return true; }))), CancelledError);
}

TEST(PlanarDomain, RefusesCrossingFlatAndDegeneratePolygonsAndTurnsClockwiseOnes) {
  Points2 bow(4, 2);
  bow << 0, 0, 1, 1, 1, 0, 0, 1;
  EXPECT_THROW(static_cast<void>(PlanarDomain::polygon(bow)), InvalidArgument);
  EXPECT_THROW(static_cast<void>(PlanarDomain::polygon(bow.topRows(2))), InvalidArgument);
  Points2 line(3, 2);
  line << 0, 0, 1, 0, 2, 0;
  EXPECT_THROW(static_cast<void>(PlanarDomain::polygon(line)), InvalidArgument);
  EXPECT_THROW(static_cast<void>(PlanarDomain::rectangle(0)), InvalidArgument);
  Points2 clockwise(5, 2);
  clockwise << 0, 0, 0, 2, 2, 2, 2, 0, 1, 0;  // with one straight corner
  const PlanarDomain domain = PlanarDomain::polygon(clockwise);
  EXPECT_EQ(domain.corners().rows(), 4);
  EXPECT_DOUBLE_EQ(domain.area(), 4);
  EXPECT_TRUE(domain.convex());
  EXPECT_DOUBLE_EQ(PlanarDomain::disk().area(), M_PI);
}
