#include <gtest/gtest.h>

#include "Core/base/Error.h"
#include "Core/mesh/TorusMesh.h"
#include "Core/topology/CutGraph.h"
#include "support/TestMeshes.h"
#include "support/TorusMeshes.h"

using namespace authalic;
using namespace authalic::testing;

namespace {

int halfEdges(const CutGraph& cut) { return static_cast<int>(cut.windings.rows()); }

// ω_k along half-edge h.
int along(const CutGraph& cut, int h, int k) {
  return cut.windings(SurfaceTopology::next(h), k) - cut.windings(h, k);
}

void expectDisk(const CutGraph& cut, int genus) {
  EXPECT_EQ(cut.genus, genus);
  const SurfaceTopology disk(cut.faces, static_cast<int>(cut.originalPointIds.size()));
  EXPECT_TRUE(disk.manifold());
  EXPECT_EQ(disk.eulerCharacteristic(), 1);
  EXPECT_EQ(disk.boundaryLoops().size(), 1U);
}

}  // namespace

TEST(CutGraph, OpensATorusAndADoubleTorusToOneDisk) {
  for (const TriangleMesh& mesh : {torusMesh(24, 12), torusMesh(3, 3), doubleTorusMesh(12)}) {
    const SurfaceTopology topology(mesh.faces(), mesh.vertexCount());
    expectDisk(cutToFundamentalDomain(mesh, topology), (2 - topology.eulerCharacteristic()) / 2);
  }
}

TEST(CutGraph, KeepsFacesAndPointsButForCopies) {
  const TriangleMesh mesh = torusMesh(24, 12);
  const CutGraph cut = cutToFundamentalDomain(mesh, SurfaceTopology(mesh.faces(), mesh.vertexCount()));
  for (Eigen::Index c = 0; c < cut.faces.size(); ++c) {
    EXPECT_EQ(cut.originalPointIds[static_cast<std::size_t>(cut.faces.data()[c])], mesh.faces().data()[c]);
  }
  for (int v = 0; v < mesh.vertexCount(); ++v) EXPECT_EQ(cut.originalPointIds[static_cast<std::size_t>(v)], v);
}

TEST(CutGraph, HasClosedFormsThatAgreeOnBothSidesOfEveryEdge) {
  const TriangleMesh mesh = doubleTorusMesh(10);
  const SurfaceTopology topology(mesh.faces(), mesh.vertexCount());
  const CutGraph cut = cutToFundamentalDomain(mesh, topology);
  ASSERT_EQ(cut.windings.cols(), 4);
  int nonZero = 0;
  for (int h = 0; h < halfEdges(cut); ++h) {
    for (int k = 0; k < 4; ++k) {
      EXPECT_EQ(along(cut, h, k) + along(cut, topology.opposite(h), k), 0);
      nonZero += along(cut, h, k) != 0;
    }
  }
  EXPECT_GT(nonZero, 0);
}

TEST(CutGraph, HasFormsThatSpanTheIntegerCohomology) {
  // The integrals of ω_j ∧ ω_k are a unimodular antisymmetric matrix for a basis over the integers.
  for (const TriangleMesh& mesh : {torusMesh(24, 12), doubleTorusMesh(12)}) {
    const CutGraph cut = cutToFundamentalDomain(mesh, SurfaceTopology(mesh.faces(), mesh.vertexCount()));
    Eigen::MatrixXd intersections = Eigen::MatrixXd::Zero(2 * cut.genus, 2 * cut.genus);
    for (int f = 0; f < mesh.faceCount(); ++f) {
      for (int j = 0; j < 2 * cut.genus; ++j) {
        for (int k = 0; k < 2 * cut.genus; ++k) {
          intersections(j, k) += 0.5 * (along(cut, 3 * f, j) * along(cut, 3 * f + 1, k) -
                                        along(cut, 3 * f, k) * along(cut, 3 * f + 1, j));
        }
      }
    }
    EXPECT_NEAR(std::abs(intersections.determinant()), 1, 1e-9);
  }
}

TEST(CutGraph, OfATorusOfRevolutionIsOneTubeAndOneRing) {
  // 40 × 12: no shorter pair of generators has fewer than 12 + 40 edges; a cut graph may share some of them.
  const TriangleMesh mesh = torusMesh(40, 12);
  const CutGraph cut = cutToFundamentalDomain(mesh, SurfaceTopology(mesh.faces(), mesh.vertexCount()));
  int edges = 0;
  for (const char on : cut.onCut) edges += on;
  EXPECT_LE(edges / 2, 12 + 40);
}

TEST(CutGraph, ReachesTheVerticesThatItShallEndAt) {
  const TriangleMesh mesh = doubleTorusMesh(12);
  const SurfaceTopology topology(mesh.faces(), mesh.vertexCount());
  const std::vector<int> ends{5, 77, 300};
  const CutGraph cut = cutToFundamentalDomain(mesh, topology, ends.front(), ends);
  expectDisk(cut, 2);
  for (const int v : ends) {
    bool reached = false;
    for (int h = 0; h < halfEdges(cut); ++h) {
      reached = reached || (cut.onCut[static_cast<std::size_t>(h)] && topology.tail(h) == v);
    }
    EXPECT_TRUE(reached) << v;
  }
}

TEST(CutGraph, RefusesABoundary) {
  const TriangleMesh disk = diskMesh(3);
  EXPECT_THROW((void)cutToFundamentalDomain(disk, SurfaceTopology(disk.faces(), disk.vertexCount())), TopologyError);
}

TEST(TorusMesh, RefusesSpheresDisksAndTwoHandlesInWords) {
  const auto refusal = [](const TriangleMesh& mesh) {
    try {
      const TorusMesh torus(mesh);
    } catch (const TopologyError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_NE(refusal(sphereMesh(1)).find("too few handles (genus 0)"), std::string::npos) << refusal(sphereMesh(1));
  EXPECT_NE(refusal(diskMesh(3)).find("a boundary loop too many"), std::string::npos) << refusal(diskMesh(3));
  EXPECT_NE(refusal(doubleTorusMesh(10)).find("handles (genus 2)"), std::string::npos);
  EXPECT_EQ(refusal(torusMesh(5, 5)), "");
}
