#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "Core/base/Error.h"
#include "Core/topology/ShortestHandleLoop.h"
#include "Core/topology/SurfaceRepair.h"
#include "support/HighGenusMeshes.h"
#include "support/TestMeshes.h"
#include "support/TorusMeshes.h"

using namespace authalic;
using namespace authalic::testing;

namespace {

/// Points and faces that need not make a mesh.
struct Soup {
  std::vector<Eigen::RowVector3d> points;
  std::vector<Eigen::RowVector3i> faces;

  Soup() = default;
  explicit Soup(const TriangleMesh& mesh) { add(mesh); }
  void add(const TriangleMesh& mesh, const Eigen::RowVector3d& shift = {0, 0, 0}) {
    const int first = static_cast<int>(points.size());
    for (int v = 0; v < mesh.vertexCount(); ++v) points.emplace_back(mesh.points().row(v) + shift);
    for (int f = 0; f < mesh.faceCount(); ++f) faces.emplace_back(mesh.faces().row(f).array() + first);
  }
  [[nodiscard]] Points3 pointMatrix() const {
    Points3 matrix(static_cast<Eigen::Index>(points.size()), 3);
    for (std::size_t i = 0; i < points.size(); ++i) matrix.row(static_cast<Eigen::Index>(i)) = points[i];
    return matrix;
  }
  [[nodiscard]] Faces faceMatrix() const {
    Faces matrix(static_cast<Eigen::Index>(faces.size()), 3);
    for (std::size_t i = 0; i < faces.size(); ++i) matrix.row(static_cast<Eigen::Index>(i)) = faces[i];
    return matrix;
  }
  void drop(std::size_t face) { faces.erase(faces.begin() + static_cast<std::ptrdiff_t>(face)); }
};

SurfaceRepair repaired(const Soup& soup, const SurfaceRepairOptions& options = {}) {
  return repairSurface(soup.pointMatrix(), soup.faceMatrix(), options);
}

/// What every repair promises, whatever the defect.
void expectKeptPromises(const Soup& soup, const SurfaceRepairOptions& options = {}) {
  const SurfaceRepair once = repaired(soup, options);
  EXPECT_EQ(once.status, Status::Converged);
  EXPECT_TRUE(once.after.orientedManifold());
  EXPECT_TRUE(once.after.isolatedVertices.empty());
  EXPECT_TRUE(once.after.duplicateFaces.empty());
  for (int v = 0; v < once.mesh.vertexCount(); ++v) {
    const int original = once.originalPointIds[static_cast<std::size_t>(v)];
    if (original < 0) continue;
    EXPECT_EQ(once.mesh.points().row(v), soup.points[static_cast<std::size_t>(original)]);
  }
  const SurfaceRepair twice = repairSurface(once.mesh.points(), once.mesh.faces(), options);
  EXPECT_FALSE(twice.changed());
  EXPECT_EQ(twice.passes, 1);
  EXPECT_EQ(twice.mesh.points(), once.mesh.points());
  EXPECT_EQ(twice.mesh.faces(), once.mesh.faces());
}

int onlyKind(const SurfaceRepair& repair, RepairKind kind) {
  for (const RepairChange& change : repair.changes) EXPECT_EQ(change.kind, kind) << repairKindName(change.kind);
  return repair.count(kind);
}

/// The Möbius band of `n` quads.
Soup moebius(int n) {
  Soup soup;
  for (int i = 0; i < n; ++i) {
    const double t = 2 * M_PI * i / n;
    for (const double w : {-0.3, 0.3}) {
      const double r = 1 + w * std::cos(t / 2);
      soup.points.emplace_back(r * std::cos(t), r * std::sin(t), w * std::sin(t / 2));
    }
  }
  for (int i = 0; i < n; ++i) {
    const int a = 2 * i, b = 2 * i + 1;
    const int c = i + 1 < n ? a + 2 : 1, d = i + 1 < n ? b + 2 : 0;
    soup.faces.emplace_back(a, c, b);
    soup.faces.emplace_back(b, c, d);
  }
  return soup;
}

}  // namespace

TEST(SurfaceRepair, LeavesCleanSurfacesAsTheyAre) {
  for (const TriangleMesh& mesh : {sphereMesh(3), diskMesh(8), gridMesh(6, 5), bumpyDisk(6)}) {
    const SurfaceRepair repair = repairSurface(mesh.points(), mesh.faces());
    EXPECT_FALSE(repair.changed());
    EXPECT_EQ(repair.status, Status::Converged);
    EXPECT_EQ(repair.mesh.points(), mesh.points());
    EXPECT_EQ(repair.mesh.faces(), mesh.faces());
    EXPECT_TRUE(repair.remaining().empty());
  }
}

TEST(SurfaceRepair, RemovesIsolatedVerticesEvenWithoutAPlace) {
  Soup soup(sphereMesh(2));
  soup.points.emplace_back(1, 2, 3);
  soup.points.emplace_back(std::numeric_limits<double>::quiet_NaN(), 0, 0);
  const SurfaceRepair repair = repaired(soup);
  EXPECT_EQ(onlyKind(repair, RepairKind::IsolatedVertex), 2);
  EXPECT_EQ(repair.changes.front().place, Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(repair.changes.front().ids, std::vector<int>{static_cast<int>(soup.points.size()) - 2});
  EXPECT_EQ(repair.mesh.faces(), sphereMesh(2).faces());
}

TEST(SurfaceRepair, RemovesFacesThatAreThereTwiceOrNameAVertexTwice) {
  Soup soup(sphereMesh(2));
  const Eigen::RowVector3i face = soup.faces[7];
  soup.faces.emplace_back(face[1], face[0], face[2]);
  soup.faces.emplace_back(face[0], face[0], face[2]);
  const SurfaceRepair repair = repaired(soup);
  EXPECT_EQ(repair.count(RepairKind::DuplicateFace), 1);
  EXPECT_EQ(repair.count(RepairKind::DegenerateFace), 1);
  EXPECT_EQ(repair.changes.size(), 2u);
  EXPECT_EQ(repair.mesh.faces(), sphereMesh(2).faces());
  expectKeptPromises(soup);
}

TEST(SurfaceRepair, FlipsFlatFacesAndCollapsesNeedles) {
  Soup flat(gridMesh(4, 4));
  const Eigen::RowVector3i face = flat.faces[9];  // split at the middle of its first edge, on its side only
  flat.points.emplace_back(0.5 * (flat.points[static_cast<std::size_t>(face[0])] +
                                  flat.points[static_cast<std::size_t>(face[1])]));
  const int middle = static_cast<int>(flat.points.size()) - 1;
  flat.faces[9] = {face[0], middle, face[2]};
  flat.faces.emplace_back(middle, face[1], face[2]);
  flat.faces.emplace_back(face[0], face[1], middle);  // without area, fills the gap
  const SurfaceRepair repair = repaired(flat);
  EXPECT_EQ(onlyKind(repair, RepairKind::DegenerateFace), 1);
  EXPECT_NEAR(repair.after.area, 1.0, 1e-12);
  EXPECT_TRUE(repair.after.degenerateFaces.empty());
  EXPECT_EQ(repair.after.eulerCharacteristic, 1);
  expectKeptPromises(flat);

  Soup needle(sphereMesh(2));  // an edge without length
  const Eigen::RowVector3i around = needle.faces[20];
  needle.points[static_cast<std::size_t>(around[0])] = needle.points[static_cast<std::size_t>(around[1])];
  const SurfaceRepair collapsed = repaired(needle);
  EXPECT_EQ(collapsed.mesh.vertexCount(), sphereMesh(2).vertexCount() - 1);
  EXPECT_EQ(collapsed.after.eulerCharacteristic, 2);
  EXPECT_TRUE(collapsed.after.degenerateFaces.empty());
  expectKeptPromises(needle);
}

TEST(SurfaceRepair, SewsASoupOfTrianglesToTheSurfaceItWas) {
  const TriangleMesh sphere = sphereMesh(2);
  Soup soup;
  for (int f = 0; f < sphere.faceCount(); ++f) {
    for (int k = 0; k < 3; ++k) soup.points.emplace_back(sphere.corner(f, k).transpose());
    soup.faces.emplace_back(3 * f, 3 * f + 1, 3 * f + 2);
  }
  const SurfaceRepair repair = repaired(soup);
  EXPECT_EQ(onlyKind(repair, RepairKind::Seam), 3 * sphere.faceCount() / 2);
  EXPECT_EQ(repair.mesh.vertexCount(), sphere.vertexCount());
  EXPECT_EQ(repair.after.eulerCharacteristic, 2);
  expectKeptPromises(soup);
  SurfaceRepairOptions open;
  open.sewSeams = false;
  EXPECT_THROW((void)repaired(soup, open), TopologyError);
}

TEST(SurfaceRepair, RefusesTrianglesThatDoNotMeet) {
  const TriangleMesh sphere = sphereMesh(1);
  Soup soup;
  for (int f = 0; f < sphere.faceCount(); ++f) {
    for (int k = 0; k < 3; ++k) soup.points.emplace_back((1 + 0.01 * f) * sphere.corner(f, k).transpose());
    soup.faces.emplace_back(3 * f, 3 * f + 1, 3 * f + 2);
  }
  try {
    (void)repaired(soup);
    FAIL() << "not refused";
  } catch (const TopologyError& error) {
    EXPECT_NE(std::string(error.what()).find("32 of 32 triangles share no edge"), std::string::npos) << error.what();
  }
  soup.add(sphereMesh(2), {9, 0, 0});  // more area than half meets
  soup.add(sphereMesh(2), {18, 0, 0});
  EXPECT_EQ(repaired(soup).count(RepairKind::StrayComponent), sphere.faceCount());
}

TEST(SurfaceRepair, LeavesVerticesAloneThatOnlyTouchAnEdge) {
  Soup soup;  // a second triangle stands on the edge of the first with one corner
  soup.points = {{0, 0, 0}, {3, 0, 0}, {1.5, 2, 0}, {1, 0, 0}, {2, -2, 0}, {0, -2, 0}};
  soup.faces = {{0, 1, 2}, {3, 5, 4}};
  soup.add(gridMesh(2, 2), {0, 10, 0});
  soup.add(gridMesh(2, 2), {0, 20, 0});
  for (auto& p : soup.points) p[1] *= p[1] > 5 ? 5 : 1;
  SurfaceRepairOptions options;
  options.strayShare = 0;
  EXPECT_FALSE(repaired(soup, options).changed());
}

TEST(SurfaceRepair, SplitsFacesAtTJunctions) {
  Soup soup;  // two triangles above an edge, three below it, which share only its ends
  soup.points = {{0, 0, 0}, {3, 0, 0}, {1.5, 2, 0}, {1.5, -2, 0}, {1, 0, 0}, {2, 0, 0}};
  soup.faces = {{0, 1, 2}, {0, 3, 4}, {4, 3, 5}, {5, 3, 1}};
  const SurfaceRepair repair = repaired(soup);
  EXPECT_EQ(onlyKind(repair, RepairKind::TJunction), 2);
  EXPECT_EQ(repair.mesh.faceCount(), 6);
  EXPECT_EQ(repair.after.loops.size(), 1u);
  EXPECT_EQ(repair.after.loops[0].vertexCount, 4);
  EXPECT_NEAR(repair.after.area, 6.0, 1e-12);
  EXPECT_EQ(std::count(repair.originalFaceIds.begin(), repair.originalFaceIds.end(), 0), 3);
  expectKeptPromises(soup);
}

TEST(SurfaceRepair, TakesAFinOffAnEdge) {
  Soup soup(gridMesh(4, 4));
  const Eigen::RowVector3i face = soup.faces[12];
  const Eigen::RowVector3d middle = 0.5 * (soup.points[static_cast<std::size_t>(face[0])] +
                                           soup.points[static_cast<std::size_t>(face[1])]);
  soup.points.emplace_back(middle + Eigen::RowVector3d(0, 0, 0.2));
  soup.faces.emplace_back(face[0], face[1], static_cast<int>(soup.points.size()) - 1);
  const SurfaceRepair repair = repaired(soup);
  EXPECT_EQ(repair.count(RepairKind::NonManifoldEdge), 1);
  EXPECT_EQ(repair.count(RepairKind::StrayComponent), 1);
  EXPECT_EQ(repair.changes.size(), 2u);
  EXPECT_EQ(repair.mesh.faces(), gridMesh(4, 4).faces());
  EXPECT_NEAR((repair.changes[0].place - middle.transpose()).norm(), 0, 1e-15);
  expectKeptPromises(soup);
}

TEST(SurfaceRepair, TakesTwoBodiesApartThatShareAnEdgeOrAVertex) {
  Soup soup(sphereMesh(2));
  const int n = static_cast<int>(soup.points.size());
  soup.add(sphereMesh(2), {2.5, 0, 0});
  const Eigen::RowVector3i face = soup.faces[30];
  for (Eigen::RowVector3i& other : soup.faces) {  // the second body uses a vertex of the first
    for (int k = 0; k < 3; ++k) other[k] = other[k] == face[0] + n ? face[0] : other[k];
  }
  const SurfaceRepair repair = repaired(soup);
  EXPECT_EQ(repair.count(RepairKind::NonManifoldVertex), 1);
  EXPECT_EQ(repair.count(RepairKind::IsolatedVertex), 1);
  EXPECT_EQ(repair.changes.size(), 2u);
  EXPECT_EQ(repair.after.components.size(), 2u);
  EXPECT_EQ(repair.after.genus, 0);
  EXPECT_EQ(std::count(repair.originalPointIds.begin(), repair.originalPointIds.end(), face[0]), 2);
  expectKeptPromises(soup);

  for (Eigen::RowVector3i& other : soup.faces) {
    for (int k = 0; k < 3; ++k) other[k] = other[k] == face[1] + n ? face[1] : other[k];
  }
  const SurfaceRepair edge = repaired(soup);
  EXPECT_EQ(edge.count(RepairKind::NonManifoldEdge), 1);
  EXPECT_EQ(edge.after.components.size(), 2u);
  EXPECT_EQ(edge.after.eulerCharacteristic, 4);
  expectKeptPromises(soup);
}

TEST(SurfaceRepair, RemovesStraysOnlyBelowTheirShare) {
  Soup soup(sphereMesh(3));
  Soup small(sphereMesh(1));
  for (auto& p : small.points) p = 0.2 * p + Eigen::RowVector3d(5, 0, 0);
  soup.add(TriangleMesh(small.pointMatrix(), small.faceMatrix()));
  const SurfaceRepair repair = repaired(soup);
  EXPECT_EQ(onlyKind(repair, RepairKind::StrayComponent), 1);
  EXPECT_NEAR(repair.changes[0].size, repairSurface(small.pointMatrix(), small.faceMatrix()).after.area, 1e-12);
  EXPECT_EQ(repair.mesh.points(), sphereMesh(3).points());
  SurfaceRepairOptions all;
  all.strayShare = 0;
  EXPECT_EQ(repaired(soup, all).after.components.size(), 2u);
}

TEST(SurfaceRepair, TurnsFacesToTheMajorityAndClosedSurfacesOutwards) {
  Soup disk(diskMesh(6));
  for (const std::size_t f : {3u, 4u, 50u}) std::swap(disk.faces[f][0], disk.faces[f][1]);
  const SurfaceRepair repair = repaired(disk);
  EXPECT_EQ(onlyKind(repair, RepairKind::FlippedFace), 3);
  EXPECT_EQ(repair.changes[0].ids, std::vector<int>{3});
  expectKeptPromises(disk);

  Soup sphere(sphereMesh(2));
  for (auto& face : sphere.faces) std::swap(face[0], face[1]);
  const SurfaceRepair outwards = repaired(sphere);
  EXPECT_EQ(onlyKind(outwards, RepairKind::InsideOutComponent), 1);
  EXPECT_GT(outwards.after.volume, 0);
  expectKeptPromises(sphere);
}

TEST(SurfaceRepair, FillsHolesUpToALength) {
  Soup soup(sphereMesh(3));
  soup.drop(400);
  soup.drop(100);
  const SurfaceRepair repair = repaired(soup);  // 0.1 √(4π) mm = 0.35 mm: the loops are longer
  EXPECT_FALSE(repair.changed());
  SurfaceRepairOptions options;
  options.largestHole = 1.0;
  const SurfaceRepair filled = repaired(soup, options);
  EXPECT_EQ(onlyKind(filled, RepairKind::Hole), 2);
  EXPECT_EQ(filled.after.eulerCharacteristic, 2);
  EXPECT_NEAR(filled.after.area, repaired(Soup(sphereMesh(3))).after.area, 1e-12);
  EXPECT_EQ(std::count(filled.originalFaceIds.begin(), filled.originalFaceIds.end(), -1), 2);
  EXPECT_EQ(std::count(filled.faceSources.begin(), filled.faceSources.end(), -1), 0);
  expectKeptPromises(soup, options);
}

TEST(SurfaceRepair, FillsAFlatHoleWithItsOwnArea) {
  const TriangleMesh grid = gridMesh(12, 12);
  Soup soup;
  soup.add(grid);
  soup.faces.clear();
  for (int f = 0; f < grid.faceCount(); ++f) {  // an L of several cells is missing
    const Eigen::Vector3d c = (grid.corner(f, 0) + grid.corner(f, 1) + grid.corner(f, 2)) / 3;
    const bool inL = c.x() > 0.25 && c.x() < 0.75 && c.y() > 0.25 && c.y() < 0.75 && !(c.x() > 0.5 && c.y() > 0.5);
    if (!inL) soup.faces.emplace_back(grid.faces().row(f));
  }
  SurfaceRepairOptions options;
  options.largestHole = 2.5;
  const SurfaceRepair repair = repaired(soup, options);
  EXPECT_EQ(repair.count(RepairKind::Hole), 1);
  EXPECT_EQ(repair.after.eulerCharacteristic, 1);
  EXPECT_TRUE(repair.after.degenerateFaces.empty());
  EXPECT_NEAR(repair.after.area, 1.0, 1e-12);
  expectKeptPromises(soup, options);
}

TEST(SurfaceRepair, CutsEveryHandleAndSaysWhere) {
  Soup soup(torusMesh(24, 8));
  const SurfaceRepair repair = repaired(soup);
  EXPECT_EQ(onlyKind(repair, RepairKind::Handle), 1);
  EXPECT_EQ(repair.after.genus, 0);
  EXPECT_EQ(repair.after.eulerCharacteristic, 2);
  EXPECT_EQ(repair.changes[0].ids.size(), 8u);
  EXPECT_EQ(repair.mesh.vertexCount(), 24 * 8 + 8);
  EXPECT_EQ(repair.mesh.faceCount(), 2 * 24 * 8 + 2 * 6);
  expectKeptPromises(soup);
  for (int holes = 2; holes < 5; ++holes) {
    Soup slab(slabMesh(holes, 6));
    const SurfaceRepair cut = repaired(slab);
    EXPECT_EQ(cut.count(RepairKind::Handle), holes);
    EXPECT_EQ(cut.after.genus, 0);
    EXPECT_EQ(cut.after.components.size(), 1u);
    expectKeptPromises(slab);
  }
}

TEST(SurfaceRepair, LeavesHandlesLongerThanAsked) {
  const TriangleMesh torus = torusMesh(24, 8);
  const double length = shortestHandleLoop(torus, SurfaceTopology(torus.faces(), torus.vertexCount())).length;
  SurfaceRepairOptions options;
  options.largestHandle = 0.99 * length;
  EXPECT_EQ(repaired(Soup(torus), options).remaining(), "genus 1");
  options.largestHandle = 0;
  EXPECT_FALSE(repaired(Soup(torus), options).changed());
  options.largestHandle = 1.01 * length;
  EXPECT_EQ(repaired(Soup(torus), options).count(RepairKind::Handle), 1);
}

TEST(SurfaceRepair, KeepsTheBoundaryOfASurfaceWithHandles) {
  Soup soup(doubleTorusMesh(12));
  soup.drop(0);
  const SurfaceRepair repair = repaired(soup);
  EXPECT_EQ(repair.count(RepairKind::Handle), 2);
  EXPECT_EQ(repair.after.genus, 0);
  EXPECT_EQ(repair.after.loops.size(), 1u);
  expectKeptPromises(soup);
}

TEST(SurfaceRepair, RepairsEverythingAtOnce) {
  Soup soup(doubleTorusMesh(12));
  soup.add(sphereMesh(0), {40, 0, 0});
  std::swap(soup.faces[5][0], soup.faces[5][1]);
  soup.faces.push_back(soup.faces[9]);
  soup.points.emplace_back(1, 1, 1);
  soup.faces.emplace_back(soup.faces[14][0], soup.faces[14][1], static_cast<int>(soup.points.size()) - 1);
  soup.drop(20);
  SurfaceRepairOptions options;
  options.largestHole = 1e3;
  options.strayShare = 0.5;
  const SurfaceRepair repair = repaired(soup, options);
  EXPECT_EQ(repair.after.eulerCharacteristic, 2);
  EXPECT_TRUE(repair.remaining().empty()) << repair.remaining();
  expectKeptPromises(soup, options);
}

TEST(SurfaceRepair, RefusesWhatItCannotRepairInWords) {
  const auto words = [](const Soup& soup) {
    try {
      (void)repaired(soup);
    } catch (const Error& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_THROW((void)repaired(moebius(12)), TopologyError);
  EXPECT_NE(words(moebius(12)).find("one-sided"), std::string::npos);
  Soup soup(sphereMesh(1));
  soup.points[3][1] = std::numeric_limits<double>::infinity();
  EXPECT_THROW((void)repaired(soup), GeometryError);
  EXPECT_NE(words(soup).find("vertex 3"), std::string::npos);
  soup = Soup(sphereMesh(1));
  soup.faces[2][0] = 1000;
  EXPECT_NE(words(soup).find("face 2 names 1000"), std::string::npos);
  soup.faces = {{0, 0, 1}, {2, 1, 2}};
  EXPECT_THROW((void)repaired(soup), GeometryError);
  soup.faces.clear();
  EXPECT_THROW((void)repaired(soup), GeometryError);
}

TEST(SurfaceRepair, RefusesBadOptions) {
  const Soup soup(sphereMesh(0));
  const auto refuses = [&](auto change) {
    SurfaceRepairOptions options;
    change(options);
    EXPECT_THROW((void)repaired(soup, options), InvalidArgument);
  };
  refuses([](auto& o) { o.junctionTolerance = 0.2; });
  refuses([](auto& o) { o.junctionTolerance = std::nan(""); });
  refuses([](auto& o) { o.strayShare = 1.5; });
  refuses([](auto& o) { o.largestHole = HUGE_VAL; });
  refuses([](auto& o) { o.largestHandle = std::nan(""); });
}

TEST(SurfaceRepair, CanBeCancelled) {
  const TriangleMesh mesh = torusMesh(24, 8);
  const Execution cancelled({}, [] { return true; });
  EXPECT_THROW((void)repairSurface(mesh.points(), mesh.faces(), {}, cancelled), CancelledError);
}

TEST(ShortestHandleLoop, IsTheShortOfTheTwoWaysRoundATorus) {
  for (const int ring : {24, 48, 96}) {
    const TriangleMesh torus = torusMesh(ring, ring / 3);
    const NonSeparatingLoop loop = shortestHandleLoop(torus, SurfaceTopology(torus.faces(), torus.vertexCount()));
    ASSERT_EQ(loop.vertices.size(), static_cast<std::size_t>(ring / 3));  // a regular polygon on the tube
    const double edge = (torus.point(loop.vertices[1]) - torus.point(loop.vertices[0])).norm();
    EXPECT_NEAR(loop.length, edge * ring / 3, 1e-9);
  }
}

TEST(ShortestHandleLoop, IsAsShortAsFromEveryVertex) {
  const TriangleMesh slab = slabMesh(3, 5);
  const SurfaceTopology topology(slab.faces(), slab.vertexCount());
  const double length = shortestHandleLoop(slab, topology).length;
  const auto renumbered = [&](int shift) {  // other trees, the same loop
    Points3 points(slab.points());
    Faces faces(slab.faces());
    const int n = slab.vertexCount();
    for (int v = 0; v < n; ++v) points.row((v + shift) % n) = slab.points().row(v);
    for (Eigen::Index k = 0; k < faces.size(); ++k) faces.data()[k] = (faces.data()[k] + shift) % n;
    const TriangleMesh mesh(points, faces);
    return shortestHandleLoop(mesh, SurfaceTopology(faces, n)).length;
  };
  for (const int shift : {1, 17, 40, 77, 103}) EXPECT_NEAR(renumbered(shift), length, 1e-12 * length);
}

TEST(ShortestHandleLoop, IsEmptyWhereThereIsNoHandle) {
  for (const TriangleMesh& mesh : {sphereMesh(2), diskMesh(5)}) {
    EXPECT_TRUE(shortestHandleLoop(mesh, SurfaceTopology(mesh.faces(), mesh.vertexCount())).vertices.empty());
  }
}
