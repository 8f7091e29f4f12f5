#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <set>
#include <vector>

#include "Core/base/Error.h"
#include "Core/geometry/Areas.h"
#include "Core/geometry/Decimation.h"
#include "Core/mesh/SurfaceTopology.h"
#include "Core/topology/PruneSpikes.h"
#include "support/TestMeshes.h"

using namespace authalic;
using namespace authalic::testing;

namespace {

// Cycles of three edges that are not a face, counted over all triples of adjacent vertices.
int separatingTriangles(const TriangleMesh& mesh) {
  std::vector<std::set<int>> beside(static_cast<std::size_t>(mesh.vertexCount()));
  std::set<std::array<int, 3>> faces;
  for (int f = 0; f < mesh.faceCount(); ++f) {
    std::array<int, 3> corners{mesh.faces()(f, 0), mesh.faces()(f, 1), mesh.faces()(f, 2)};
    for (const int a : corners) beside[static_cast<std::size_t>(a)].insert(corners.begin(), corners.end());
    std::sort(corners.begin(), corners.end());
    faces.insert(corners);
  }
  int count = 0;
  for (int a = 0; a < mesh.vertexCount(); ++a) {
    for (const int b : beside[static_cast<std::size_t>(a)]) {
      for (const int c : beside[static_cast<std::size_t>(b)]) {
        count += a < b && b < c && beside[static_cast<std::size_t>(a)].count(c) && !faces.count({a, b, c});
      }
    }
  }
  return count;
}

// A spike of triangular cross-section on a face: `rings` triangles above one another, closed by a tip.
TriangleMesh withSpike(const TriangleMesh& mesh, int face, int rings, double height) {
  Points3 points = mesh.points();
  Faces faces = mesh.faces();
  const Eigen::Vector3d centre = (mesh.corner(face, 0) + mesh.corner(face, 1) + mesh.corner(face, 2)) / 3;
  const Eigen::Vector3d up =
      (mesh.corner(face, 1) - mesh.corner(face, 0)).cross(mesh.corner(face, 2) - mesh.corner(face, 0)).normalized();
  for (int ring = 1; ring <= rings; ++ring) {
    const auto n = static_cast<int>(points.rows());
    const Eigen::RowVector3i base = faces.row(face);
    points.conservativeResize(n + 3, 3);
    faces.conservativeResize(faces.rows() + 6, 3);
    for (int k = 0; k < 3; ++k) {
      const int l = (k + 1) % 3;
      points.row(n + k) = (centre + 0.6 * (mesh.corner(face, k) - centre) + ring * height * up).transpose();
      faces.row(faces.rows() - 6 + 2 * k) << base[k], base[l], n + l;
      faces.row(faces.rows() - 5 + 2 * k) << base[k], n + l, n + k;
    }
    faces.row(face) << n, n + 1, n + 2;
  }
  const auto tip = static_cast<int>(points.rows());
  const Eigen::RowVector3i base = faces.row(face);
  points.conservativeResize(tip + 1, 3);
  points.row(tip) = (centre + (rings + 1) * height * up).transpose();
  faces.conservativeResize(faces.rows() + 2, 3);
  faces.row(face) << base[0], base[1], tip;
  faces.row(faces.rows() - 2) << base[1], base[2], tip;
  faces.row(faces.rows() - 1) << base[2], base[0], tip;
  return TriangleMesh(points, faces);
}

TriangleMesh torusMesh(int around, int across) {
  Points3 points(around * across, 3);
  Faces faces(2 * around * across, 3);
  for (int i = 0, f = 0; i < around; ++i) {
    for (int j = 0; j < across; ++j, f += 2) {
      const double u = 2 * M_PI * i / around, v = 2 * M_PI * j / across;
      points.row(i * across + j) << (3 + std::cos(v)) * std::cos(u), (3 + std::cos(v)) * std::sin(u), std::sin(v);
      const int a = i * across + j, b = (i + 1) % around * across + j, c = (i + 1) % around * across + (j + 1) % across,
                d = i * across + (j + 1) % across;
      faces.row(f) << a, b, c;
      faces.row(f + 1) << a, c, d;
    }
  }
  return TriangleMesh(points, faces);
}

// The faces as cyclic triples that start with their smallest vertex, sorted.
std::vector<std::array<int, 3>> faceSet(const TriangleMesh& mesh, const std::vector<int>& ids) {
  std::vector<std::array<int, 3>> faces;
  for (int f = 0; f < mesh.faceCount(); ++f) {
    std::array<int, 3> corners{};
    for (int k = 0; k < 3; ++k) {
      const auto v = static_cast<std::size_t>(mesh.faces()(f, k));
      corners[static_cast<std::size_t>(k)] = ids.empty() ? static_cast<int>(v) : ids[v];
    }
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    faces.push_back(corners);
  }
  std::sort(faces.begin(), faces.end());
  return faces;
}

}  // namespace

TEST(PruneSpikes, TakesNestedSpikesOffAtOnceAndGivesBackTheSurfaceBelow) {
  const TriangleMesh sphere = sphereMesh(4);
  TriangleMesh spiky = sphere;
  for (const int face : {0, 57, 400, 1023, 2000}) spiky = withSpike(spiky, face, face % 7, 0.02);
  ASSERT_EQ(separatingTriangles(spiky), 0 + 57 % 7 + 400 % 7 + 1023 % 7 + 2000 % 7 + 5);
  const PrunedSurface pruned = pruneSpikes(spiky, 0.01);
  EXPECT_EQ(pruned.spikes, 5);
  EXPECT_EQ(pruned.removedFaces - pruned.spikes, spiky.faceCount() - sphere.faceCount());
  EXPECT_EQ(separatingTriangles(pruned.mesh), 0);
  EXPECT_EQ(faceSet(pruned.mesh, pruned.originalPointIds), faceSet(sphere, {}));
  EXPECT_TRUE(pruned.mesh.points() == sphere.points());
  EXPECT_NEAR(pruned.removedArea, faceAreas(spiky).sum() - faceAreas(sphere).sum(), 1e-12);
}

TEST(PruneSpikes, KeepsTopologyAndOrientationOfTorusAndDisk) {
  for (const TriangleMesh& base : {torusMesh(30, 12), bumpyDisk(12)}) {
    const TriangleMesh spiky = withSpike(withSpike(base, 3, 2, 0.05), base.faceCount() - 1, 4, 0.05);
    const PrunedSurface pruned = pruneSpikes(spiky, 0.02);
    const SurfaceTopology before(base.faces(), base.vertexCount());
    const SurfaceTopology after(pruned.mesh.faces(), pruned.mesh.vertexCount());
    EXPECT_EQ(pruned.spikes, 2);
    EXPECT_TRUE(after.manifold() && after.isolatedVertices().empty());
    EXPECT_EQ(after.eulerCharacteristic(), before.eulerCharacteristic());
    EXPECT_EQ(after.boundaryLoops(), before.boundaryLoops());
    EXPECT_EQ(faceSet(pruned.mesh, pruned.originalPointIds), faceSet(base, {}));
  }
}

TEST(PruneSpikes, LeavesTrianglesRoundATubeAlone) {
  const TriangleMesh thin = torusMesh(12, 3);  // every meridian is a triangle and no face; none cuts anything off
  ASSERT_EQ(separatingTriangles(thin), 12);
  const PrunedSurface pruned = pruneSpikes(thin, 0.49);
  EXPECT_EQ(pruned.spikes, 0);
  EXPECT_TRUE(pruned.mesh.faces() == thin.faces());
}

TEST(PruneSpikes, LeavesASurfaceWithoutSpikesUntouched) {
  for (const TriangleMesh& mesh : {sphereMesh(4), diskMesh(6)}) {
    const PrunedSurface pruned = pruneSpikes(mesh);
    EXPECT_TRUE(pruned.mesh.points() == mesh.points());
    EXPECT_TRUE(pruned.mesh.faces() == mesh.faces());
    EXPECT_EQ(pruned.spikes + pruned.removedFaces, 0);
    EXPECT_EQ(pruned.removedArea, 0);
  }
}

TEST(PruneSpikes, LeavesWhatIsTooLarge) {
  const TriangleMesh spiky = withSpike(sphereMesh(3), 100, 3, 0.5);
  const Eigen::VectorXd areas = faceAreas(spiky);
  const double share = 1 - faceAreas(sphereMesh(3)).sum() / areas.sum();  // a little less than the spike's
  EXPECT_EQ(pruneSpikes(spiky, 2 * share).spikes, 1);
  const PrunedSurface pruned = pruneSpikes(spiky, share);  // the ring above the lowest is small enough
  EXPECT_EQ(pruned.spikes, 1);
  EXPECT_EQ(separatingTriangles(pruned.mesh), 1);
  EXPECT_EQ(pruneSpikes(spiky, 0).spikes, 0);
}

TEST(PruneSpikes, ClearsADecimatedSurfaceInOnePass) {
  const TriangleMesh coarse = decimate(withSpike(sphereMesh(5), 77, 12, 0.01), 900);
  const PrunedSurface once = pruneSpikes(coarse, 0.05);
  const PrunedSurface twice = pruneSpikes(once.mesh, 0.05);
  EXPECT_GT(once.spikes, 0);
  EXPECT_EQ(separatingTriangles(once.mesh), 0);
  EXPECT_EQ(twice.spikes, 0);
  EXPECT_TRUE(twice.mesh.faces() == once.mesh.faces());
  const SurfaceTopology topology(once.mesh.faces(), once.mesh.vertexCount());
  EXPECT_TRUE(topology.manifold());
  EXPECT_EQ(topology.eulerCharacteristic(), 2);
  EXPECT_TRUE(topology.boundaryLoops().empty());
}

TEST(PruneSpikes, RefusesBadInput) {
  const TriangleMesh sphere = sphereMesh(2);
  EXPECT_THROW(static_cast<void>(pruneSpikes(sphere, 0.5)), InvalidArgument);
  EXPECT_THROW(static_cast<void>(pruneSpikes(sphere, -1)), InvalidArgument);
  Faces twisted = sphere.faces();
  std::swap(twisted(0, 0), twisted(0, 1));
  EXPECT_THROW(static_cast<void>(pruneSpikes(TriangleMesh(sphere.points(), twisted))), TopologyError);
  EXPECT_THROW(static_cast<void>(pruneSpikes(withSpike(sphere, 0, 1, 0.1), 0.1, Execution({}, [] { return true; }))),
               CancelledError);
}
