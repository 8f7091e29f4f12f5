#include <gtest/gtest.h>

#include <cmath>

#include "Core/base/Error.h"
#include "Core/conformal/CircleDomainMap.h"
#include "Core/conformal/RiemannMap.h"
#include "Core/geometry/Areas.h"
#include "Core/geometry/CommonRefinement.h"
#include "Core/mesh/DiskMesh.h"
#include "support/HoledMeshes.h"

using namespace authalic;
using namespace authalic::testing;

namespace {

// Every face of the surface is the sum of its parts, the refinement has the surface's topology, and no part
// is folded.
void expectRefines(const TriangleMesh& surface, const CommonRefinement& refinement) {
  const Eigen::VectorXd areas = faceAreas(surface), parts = faceAreas(refinement.mesh);
  Eigen::VectorXd sums = Eigen::VectorXd::Zero(areas.size());
  ASSERT_EQ(refinement.originalFaceIds.size(), static_cast<std::size_t>(parts.size()));
  for (std::size_t f = 0; f < refinement.originalFaceIds.size(); ++f) {
    ASSERT_GE(refinement.originalFaceIds[f], 0);
    sums[refinement.originalFaceIds[f]] += parts[static_cast<Eigen::Index>(f)];
  }
  EXPECT_LT((sums - areas).cwiseAbs().maxCoeff(), 1e-12 * areas.sum());
  const SurfaceTopology coarse(surface.faces(), surface.vertexCount()),
      fine(refinement.mesh.faces(), refinement.mesh.vertexCount());
  EXPECT_TRUE(fine.manifold());
  EXPECT_TRUE(fine.isolatedVertices().empty());
  EXPECT_EQ(fine.eulerCharacteristic(), coarse.eulerCharacteristic());
  EXPECT_EQ(fine.boundaryLoops(), coarse.boundaryLoops());
  EXPECT_GT(parts.minCoeff(), 0);
  EXPECT_EQ(refinement.flippedFaces, 0);
  for (int v = 0; v < surface.vertexCount(); ++v)
    EXPECT_EQ(refinement.originalPointIds[static_cast<std::size_t>(v)], v);
}

}  // namespace

TEST(CommonRefinement, OfFlatMeshesThatWereFlippedToDelaunayIsTheOverlayOfBoth) {
  for (const double squeeze : {0.5, 0.2, 0.05}) {
    Points3 points = diskMesh(12).points();
    points.col(1) *= squeeze;
    points.col(0) += 0.7 * points.col(1);
    const TriangleMesh flat(points, diskMesh(12).faces());
    const Points2 plane = points.leftCols(2);
    ASSERT_EQ(countFlippedFaces(plane, flat.faces()), 0);
    const SurfaceTopology topology(flat.faces(), flat.vertexCount());
    IntrinsicTriangulation t(flat, topology);
    t.trackCrossings();
    ASSERT_GT(t.makeDelaunay(Eigen::VectorXd::Zero(flat.vertexCount()), FlipRule::Euclidean), 20);
    const CommonRefinement refinement = commonRefinement(flat, topology, t, plane);
    expectRefines(flat, refinement);
    // Straight edges cross where they cross: surface and image are the same here.
    EXPECT_LT((refinement.mesh.points().leftCols(2) - refinement.image).cwiseAbs().maxCoeff(), 1e-12);
  }
}

TEST(CommonRefinement, OfATriangulationWithoutFlipsIsTheSurface) {
  const TriangleMesh mesh = bumpyDisk(3);
  const SurfaceTopology topology(mesh.faces(), mesh.vertexCount());
  IntrinsicTriangulation t(mesh, topology);
  t.trackCrossings();
  const CommonRefinement refinement = commonRefinement(mesh, topology, t, mesh.points().leftCols(2));
  EXPECT_EQ(refinement.mesh.faces(), mesh.faces());
  EXPECT_EQ(refinement.mesh.points(), mesh.points());
}

TEST(CommonRefinement, CrossingsComeBackToNoneWhenFlipsAreUndone) {
  const TriangleMesh mesh = sphereMesh(3);
  IntrinsicTriangulation t(mesh, SurfaceTopology(mesh.faces(), mesh.vertexCount()));
  t.trackCrossings();
  Eigen::VectorXd u(mesh.vertexCount());
  for (int v = 0; v < mesh.vertexCount(); ++v) u[v] = 2 * std::sin(37.0 * v);
  ASSERT_GT(t.makeDelaunay(u), 100);
  int crossed = 0;
  for (int h = 0; h < t.halfEdgeCount(); ++h) crossed += t.crossings(h) > 0;
  EXPECT_GT(crossed, 100);
  t.makeDelaunay(Eigen::VectorXd::Zero(mesh.vertexCount()));
  for (int h = 0; h < t.halfEdgeCount(); ++h) EXPECT_EQ(t.crossings(h), -1);
}

TEST(CommonRefinement, OfARiemannMapHasNoFoldsWhereTheSurfaceHasSome) {
  // Inner corners moved close to the middle of the opposite edge: faces with angles near π.
  const TriangleMesh nice = bumpyDisk(14);
  Points3 points = nice.points();
  const int inner = nice.vertexCount() - 2 * 6 * 14;
  for (int f = 0; f < nice.faceCount(); f += 7) {
    const Eigen::RowVector3i face = nice.faces().row(f);
    if (face.maxCoeff() >= inner) continue;
    points.row(face[0]) = 0.02 * points.row(face[0]) + 0.49 * (points.row(face[1]) + points.row(face[2]));
  }
  const DiskMesh disk(TriangleMesh(points, nice.faces()));
  RiemannMapOptions options;
  options.refine = true;
  const RiemannMapResult result = riemannMap(disk, options);
  ASSERT_EQ(result.status, Status::Converged);
  EXPECT_GT(result.flippedBeforeUnfolding, 0);
  ASSERT_TRUE(result.refinement.has_value());
  expectRefines(disk.mesh(), *result.refinement);
}

TEST(CommonRefinement, OfACircleDomainHasNoFolds) {
  const TriangleMesh domain = holedDisk(14, {{{0.35, 0.2}, 0.21}, {{-0.3, -0.35}, 0.17}});
  Points3 points = domain.points();
  for (Eigen::Index v = 0; v < points.rows(); ++v) points(v, 2) = 0.5 * std::sin(5 * points(v, 0));
  const PolyAnnulusMesh surface(TriangleMesh(points, domain.faces()));
  CircleDomainOptions options;
  options.refine = true;
  const CircleDomainResult result = circleDomainMap(surface, options);
  ASSERT_EQ(result.status, Status::Converged);
  ASSERT_TRUE(result.refinement.has_value());
  expectRefines(surface.mesh(), *result.refinement);
}

TEST(CommonRefinement, RefusesTriangulationsThatDoNotTrackTheSurface) {
  const TriangleMesh mesh = bumpyDisk(6);
  const SurfaceTopology topology(mesh.faces(), mesh.vertexCount());
  IntrinsicTriangulation t(mesh, topology);
  Eigen::VectorXd u(mesh.vertexCount());
  for (int v = 0; v < mesh.vertexCount(); ++v) u[v] = std::sin(37.0 * v);
  ASSERT_GT(t.makeDelaunay(u), 0);
  const Points2 plane = mesh.points().leftCols(2);
  EXPECT_THROW(static_cast<void>(commonRefinement(mesh, topology, t, plane)), InvalidArgument);
  RiemannMapOptions riemann;
  riemann.refine = true;
  riemann.road = RiemannRoad::Puncture;
  EXPECT_THROW(static_cast<void>(riemannMap(DiskMesh(mesh), riemann)), InvalidArgument);
  CircleDomainOptions circles;
  circles.refine = true;
  circles.road = CircleDomainRoad::Koebe;
  EXPECT_THROW(static_cast<void>(circleDomainMap(PolyAnnulusMesh(mesh), circles)), InvalidArgument);
}
