/// Folds removed by minimisation, the rim held.
#include <gtest/gtest.h>

#include <random>

#include "Core/authalic/SeamedAreas.h"
#include "Core/authalic/FoldoverFree.h"
#include "Core/geometry/Areas.h"
#include "Core/mesh/DiskMesh.h"
#include "support/TestMeshes.h"

using namespace authalic;
using authalic::testing::gridMesh;

namespace {

// A square of n×n cells in the plane, its rim held, with inner vertices that lie anywhere.
struct Tangle {
  explicit Tangle(int n, unsigned seed) : mesh(gridMesh(n, n)), places(mesh.points().leftCols(2)) {
    const std::vector<char> rim = DiskMesh(mesh).topology().onBoundary();
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> uniform(0, 1);
    const Eigen::RowVector2d lowest = places.colwise().minCoeff(), extent = places.colwise().maxCoeff() - lowest;
    for (Eigen::Index v = 0; v < places.rows(); ++v) {
      freedom.push_back(rim[static_cast<std::size_t>(v)] ? 0 : 2);
      if (freedom.back() == 0) continue;
      places(v, 0) = lowest[0] + extent[0] * uniform(random);
      places(v, 1) = lowest[1] + extent[1] * uniform(random);
    }
    motions.resize(static_cast<std::size_t>(3 * mesh.faceCount()));
  }

  [[nodiscard]] int freed(int steps) {
    const SeamedAreas areas(mesh.faces(), freedom, motions);
    return foldoverFree(areas, faceAreas(mesh), mesh.points(), steps, SolverBackend::Automatic, places);
  }

  TriangleMesh mesh;
  Coordinates places;
  std::vector<char> freedom;
  std::vector<RigidMotion> motions;  // none moves
};

}  // namespace

TEST(FoldoverFree, GivesBackAFlatSurfaceFromVerticesAtRandomPlaces) {
  for (const unsigned seed : {1U, 2U, 3U}) {
    Tangle tangle(12, seed);
    ASSERT_GT(countFlippedFaces(tangle.places, tangle.mesh.faces()), 50);
    EXPECT_EQ(tangle.freed(200), 0);
    EXPECT_EQ(countFlippedFaces(tangle.places, tangle.mesh.faces()), 0);
    EXPECT_LT((tangle.places - tangle.mesh.points().leftCols(2)).cwiseAbs().maxCoeff(), 0.02);
  }
}

TEST(FoldoverFree, CountsTheFoldsThatAreLeft) {
  Tangle tangle(12, 1);
  const int before = countFlippedFaces(tangle.places, tangle.mesh.faces());
  EXPECT_EQ(tangle.freed(0), before);
  EXPECT_EQ(countFlippedFaces(tangle.places, tangle.mesh.faces()), before);
}

TEST(FoldoverFree, LeavesARimThatFoldsAsItIs) {
  Tangle tangle(6, 1);
  tangle.places.row(0).swap(tangle.places.row(6));  // two held corners
  const Coordinates before = tangle.places;
  EXPECT_GT(tangle.freed(50), 0);
  EXPECT_EQ(tangle.places.row(0), before.row(0));
  EXPECT_EQ(tangle.places.row(6), before.row(6));
}
