#include <gtest/gtest.h>

#include <set>
#include <string>

#include "Core/base/Error.h"
#include "Core/mesh/HandleLoop.h"
#include "Core/mesh/SphereMesh.h"
#include "support/TestMeshes.h"
#include "support/TorusMeshes.h"

using namespace authalic;
using namespace authalic::testing;

namespace {

std::vector<int> loopOf(const TriangleMesh& mesh) {
  return handleLoop(mesh, SurfaceTopology(mesh.faces(), mesh.vertexCount()));
}

/// The mesh without some faces.
TriangleMesh without(const TriangleMesh& mesh, const std::set<int>& removed) {
  std::vector<int> kept;
  for (int f = 0; f < mesh.faceCount(); ++f) {
    if (removed.count(f) == 0) kept.push_back(f);
  }
  Faces faces(static_cast<Eigen::Index>(kept.size()), 3);
  for (std::size_t i = 0; i < kept.size(); ++i) faces.row(static_cast<Eigen::Index>(i)) = mesh.faces().row(kept[i]);
  return TriangleMesh(mesh.points(), faces);
}

void expectClosedWalk(const TriangleMesh& mesh, const std::vector<int>& loop) {
  std::set<std::pair<int, int>> edges;
  for (int f = 0; f < mesh.faceCount(); ++f) {
    for (int k = 0; k < 3; ++k) {
      edges.insert({mesh.faces()(f, k), mesh.faces()(f, (k + 1) % 3)});
      edges.insert({mesh.faces()(f, (k + 1) % 3), mesh.faces()(f, k)});
    }
  }
  EXPECT_EQ(std::set<int>(loop.begin(), loop.end()).size(), loop.size());
  for (std::size_t k = 0; k < loop.size(); ++k) {
    EXPECT_EQ(edges.count({loop[k], loop[(k + 1) % loop.size()]}), 1u);
  }
}

}  // namespace

TEST(HandleLoop, OfATorusGoesOnceAroundTheTube) {
  const TriangleMesh torus = torusMesh(24, 8);
  const std::vector<int> loop = loopOf(torus);
  expectClosedWalk(torus, loop);
  EXPECT_EQ(loop.size(), 8u);
}

TEST(HandleLoop, DoesNotTakeAHoleForAHandle) {
  const TriangleMesh torus = torusMesh(24, 8);
  const std::vector<int> loop = loopOf(without(torus, {0, 100, 101}));
  EXPECT_EQ(loop.size(), 8u);
  expectClosedWalk(torus, loop);
  const TriangleMesh sphere = sphereMesh(3);
  EXPECT_TRUE(loopOf(sphere).empty());
  EXPECT_TRUE(loopOf(without(sphere, {0, 50, 90})).empty());
}

TEST(HandleLoop, StandsInTheRefusalWithItsPlace) {
  try {
    const SphereMesh mesh(torusMesh(24, 8));
    FAIL() << "a torus is no sphere";
  } catch (const TopologyError& error) {
    const std::string words = error.what();
    EXPECT_NE(words.find("handles (genus 1), one of them along a loop of 8 edges around ("),
              std::string::npos)
        << words;
    EXPECT_NE(words.find("mm; cut or repair them first"), std::string::npos) << words;
  }
}
