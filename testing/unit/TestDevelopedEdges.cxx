#include <gtest/gtest.h>

#include <cmath>

#include "Core/geometry/DevelopedEdges.h"
#include "support/TorusMeshes.h"

using namespace authalic;
using namespace authalic::testing;

namespace {

// A flat torus of long thin triangles: the periods of its grid enclose an angle of 15 degrees.
struct ShearedTorus {
  TriangleMesh mesh = torusMesh(8, 6);
  SurfaceTopology topology{mesh.faces(), mesh.vertexCount()};
  FaceLengths lengths;
  Eigen::VectorXd flat = Eigen::VectorXd::Zero(mesh.vertexCount());

  ShearedTorus() : lengths(mesh.faceCount(), 3) {
    const Eigen::Vector2d a(1, 0), b(2.3, 0.6);
    for (int f = 0; f < mesh.faceCount(); f += 2) {
      lengths.row(f) << a.norm(), b.norm(), (a + b).norm();
      lengths.row(f + 1) << (a + b).norm(), a.norm(), b.norm();
    }
  }
};

}  // namespace

TEST(DevelopedEdges, AreThoseFromBeforeTheFlips) {
  const ShearedTorus torus;
  IntrinsicTriangulation triangulation(torus.topology, torus.lengths);
  triangulation.recordFlips();
  const int flips = triangulation.makeDelaunay(torus.flat, FlipRule::Euclidean);
  EXPECT_GT(flips, torus.mesh.vertexCount());
  EXPECT_EQ(static_cast<int>(triangulation.recordedFlips().size()), flips);
  const DevelopedEdges edges = developOriginalEdges(triangulation, torus.flat);
  for (int h = 0; h < 3 * torus.mesh.faceCount(); ++h) {
    const auto i = static_cast<std::size_t>(h), next = static_cast<std::size_t>(SurfaceTopology::next(h)),
               previous = static_cast<std::size_t>(SurfaceTopology::previous(h)),
               opposite = static_cast<std::size_t>(torus.topology.opposite(h));
    EXPECT_NEAR(std::abs(edges.vector[i]), torus.lengths(h / 3, h % 3), 1e-12);
    EXPECT_LT(std::abs(edges.vector[i] + edges.vector[next] + edges.vector[previous]), 1e-12);
    EXPECT_LT(std::abs(edges.vector[i] + edges.turn[i] * edges.vector[opposite]), 1e-12);
    EXPECT_GT((std::conj(edges.vector[i]) * edges.vector[next]).imag(), 0);
  }
}

TEST(DevelopedEdges, WithoutFlipsAreTheSidesOfTheFaces) {
  const ShearedTorus torus;
  IntrinsicTriangulation triangulation(torus.topology, torus.lengths);
  triangulation.recordFlips();
  const DevelopedEdges edges = developOriginalEdges(triangulation, torus.flat);
  for (int h = 0; h < 3 * torus.mesh.faceCount(); ++h) {
    EXPECT_NEAR(std::abs(edges.vector[static_cast<std::size_t>(h)]), torus.lengths(h / 3, h % 3), 1e-13);
  }
}
