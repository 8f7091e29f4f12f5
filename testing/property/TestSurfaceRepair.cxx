/// Clean meshes are damaged in known ways at random places: the repair must find exactly that, and touch nothing else.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <random>
#include <set>
#include <vector>

#include "Core/topology/SurfaceRepair.h"
#include "support/TestMeshes.h"

using namespace authalic;
using namespace authalic::testing;

namespace {

using Corners = std::array<std::array<double, 3>, 3>;

/// The coordinates of a face, from its least corner on.
Corners cornersOf(const Points3& points, const Eigen::RowVector3i& face) {
  Corners corners;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto p = points.row(face[static_cast<int>(k)]);
    corners[k] = {p[0], p[1], p[2]};
  }
  std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
  return corners;
}

/// A mesh with defects, no two of which are neighbours, and what a repair has to count.
class DamagedMesh {
 public:
  DamagedMesh(const TriangleMesh& clean, unsigned seed)
      : clean_(clean), random_(seed), used_(static_cast<std::size_t>(clean.vertexCount()), 0),
        gone_(static_cast<std::size_t>(clean.faceCount()), 0) {
    for (int v = 0; v < clean.vertexCount(); ++v) points_.emplace_back(clean.points().row(v));
    for (int f = 0; f < clean.faceCount(); ++f) faces_.emplace_back(clean.faces().row(f));
    const SurfaceTopology topology(clean.faces(), clean.vertexCount());
    for (const auto& loop : topology.boundaryLoops()) {
      for (const int v : loop) used_[at(v)] = 1;
    }
  }

  int upTo(int most) { return std::uniform_int_distribution<int>(0, most)(random_); }

  void turnFace() {
    Eigen::RowVector3i& face = faces_[at(pick())];
    std::swap(face[0], face[1]);
    ++expected[RepairKind::FlippedFace];
  }
  void doubleFace() {
    Eigen::RowVector3i face = faces_[at(pick())];
    if (upTo(1) == 1) std::swap(face[1], face[2]);
    faces_.push_back(face);
    ++expected[RepairKind::DuplicateFace];
  }
  void addFaceWithoutArea() {
    const Eigen::RowVector3i face = faces_[at(pick())];
    faces_.emplace_back(face[0], face[1], face[0]);
    ++expected[RepairKind::DegenerateFace];
  }
  void dropFace() {
    gone_[at(pick())] = 1;
    ++expected[RepairKind::Hole];
  }
  void splitOneSideOfAnEdge() {
    const int f = pick();
    const Eigen::RowVector3i face = faces_[at(f)];
    const int middle = addPoint(0.5 * (points_[at(face[0])] + points_[at(face[1])]));
    faces_[at(f)] = {face[0], middle, face[2]};
    faces_.emplace_back(middle, face[1], face[2]);
    for (int g = 0; g < clean_.faceCount(); ++g) {
      if (has(clean_.faces().row(g), face[0]) && has(clean_.faces().row(g), face[1])) touched.insert(g);
    }
    reshapes = true;
    ++expected[RepairKind::TJunction];
  }
  void cutFaceLoose() {
    Eigen::RowVector3i& face = faces_[at(pick())];
    for (int k = 0; k < 3; ++k) face[k] = addPoint(points_[at(face[k])]);
    expected[RepairKind::Seam] += 3;
  }
  void addFin() {
    const Eigen::RowVector3i face = faces_[at(pick())];
    const Eigen::RowVector3d a = points_[at(face[0])], b = points_[at(face[1])], c = points_[at(face[2])];
    const int tip = addPoint(0.5 * (a + b) + 0.3 * (b - a).cross(c - a).normalized());
    faces_.emplace_back(face[0], face[1], tip);
    ++expected[RepairKind::NonManifoldEdge];
    ++expected[RepairKind::StrayComponent];
  }
  void addIsolatedVertex() {
    addPoint(Eigen::RowVector3d(upTo(9), upTo(1) == 1 ? std::nan("") : 3.0, 0.5));
    ++expected[RepairKind::IsolatedVertex];
  }
  void addStray() {
    const TriangleMesh ball = sphereMesh(1);
    const int first = static_cast<int>(points_.size());
    const Eigen::RowVector3d centre(10 + 3 * upTo(1000), 0, 0);
    for (int v = 0; v < ball.vertexCount(); ++v) addPoint(centre + 0.1 * ball.points().row(v));
    for (int f = 0; f < ball.faceCount(); ++f) faces_.emplace_back(ball.faces().row(f).array() + first);
    ++expected[RepairKind::StrayComponent];
  }
  void weldTwoVertices() {
    const int kept = faces_[at(pick())][0], lost = faces_[at(pick())][0];
    for (int f = 0; f < clean_.faceCount(); ++f) {
      for (int k = 0; k < 3; ++k) {
        if (faces_[at(f)][k] != lost) continue;
        faces_[at(f)][k] = kept;
        touched.insert(f);
      }
    }
    reshapes = true;
    ++expected[RepairKind::NonManifoldVertex];
    ++expected[RepairKind::IsolatedVertex];
  }
  void glueHandle() {
    const int f = pick(), g = pick();
    gone_[at(f)] = gone_[at(g)] = 1;
    const Eigen::RowVector3i a = faces_[at(f)], b = faces_[at(g)];
    for (int i = 0; i < 3; ++i) {
      const int next = (i + 1) % 3, here = (3 - i) % 3, there = (2 - i) % 3;
      faces_.emplace_back(a[i], a[next], b[here]);
      faces_.emplace_back(a[next], b[there], b[here]);
    }
    reshapes = true;
    ++expected[RepairKind::Handle];
  }

  [[nodiscard]] Points3 points() const {
    Points3 matrix(static_cast<Eigen::Index>(points_.size()), 3);
    for (std::size_t i = 0; i < points_.size(); ++i) matrix.row(static_cast<Eigen::Index>(i)) = points_[i];
    return matrix;
  }
  /// @param origins  face of the clean mesh, −1 = not from there
  [[nodiscard]] Faces faces(std::vector<int>& origins) const {
    Faces matrix(static_cast<Eigen::Index>(faces_.size()), 3);
    for (std::size_t f = 0; f < faces_.size(); ++f) {
      if (f < gone_.size() && gone_[f]) continue;
      matrix.row(static_cast<Eigen::Index>(origins.size())) = faces_[f];
      origins.push_back(f < gone_.size() ? static_cast<int>(f) : -1);
    }
    return matrix.topRows(static_cast<Eigen::Index>(origins.size()));
  }
  [[nodiscard]] bool sound(int f) const { return !gone_[at(f)] && touched.count(f) == 0; }

  std::map<RepairKind, int> expected;
  std::set<int> touched;  ///< faces of the clean mesh with another shape
  bool reshapes = false;  ///< whether the surface itself becomes another one

 private:
  static std::size_t at(int index) { return static_cast<std::size_t>(index); }
  static bool has(const Eigen::RowVector3i& face, int v) { return (face.array() == v).any(); }
  int addPoint(const Eigen::RowVector3d& place) {
    points_.push_back(place);
    return static_cast<int>(points_.size()) - 1;
  }
  /// A face of the clean mesh none of whose neighbours was picked before.
  int pick() {
    for (;;) {
      const int f = upTo(clean_.faceCount() - 1);
      std::set<int> ring;
      for (int g = 0; g < clean_.faceCount(); ++g) {
        const Eigen::RowVector3i face = clean_.faces().row(g);
        for (int k = 0; k < 3; ++k) {
          if (has(clean_.faces().row(f), face[k])) ring.insert(face.data(), face.data() + 3);
        }
      }
      if (std::any_of(ring.begin(), ring.end(), [&](int v) { return used_[at(v)]; })) continue;
      for (const int v : ring) used_[at(v)] = 1;
      return f;
    }
  }

  const TriangleMesh& clean_;
  std::mt19937 random_;
  std::vector<char> used_, gone_;
  std::vector<Eigen::RowVector3d> points_;
  std::vector<Eigen::RowVector3i> faces_;
};

void damage(DamagedMesh& mesh, bool reshape) {
  const auto some = [&](auto what, int most) {
    for (int n = mesh.upTo(most); n > 0; --n) (mesh.*what)();
  };
  some(&DamagedMesh::turnFace, 3);
  some(&DamagedMesh::doubleFace, 3);
  some(&DamagedMesh::addFaceWithoutArea, 2);
  some(&DamagedMesh::dropFace, 3);
  some(&DamagedMesh::cutFaceLoose, 2);
  some(&DamagedMesh::addFin, 2);
  some(&DamagedMesh::addIsolatedVertex, 3);
  some(&DamagedMesh::addStray, 2);
  if (!reshape) return;
  some(&DamagedMesh::splitOneSideOfAnEdge, 3);
  some(&DamagedMesh::weldTwoVertices, 2);
  some(&DamagedMesh::glueHandle, 2);
}

void expectCounts(const SurfaceRepair& repair, const DamagedMesh& mesh) {
  for (int k = 0; k < kRepairKinds; ++k) {
    const auto kind = static_cast<RepairKind>(k);
    const auto found = mesh.expected.find(kind);
    EXPECT_EQ(repair.count(kind), found == mesh.expected.end() ? 0 : found->second) << repairKindName(kind);
  }
}

/// Faces that no defect touched are there once, in their order, with the coordinates that they had.
void expectSoundFacesKept(const SurfaceRepair& repair, const DamagedMesh& mesh, const std::vector<int>& origins,
                          const TriangleMesh& clean) {
  int last = -1, kept = 0, sound = 0;
  for (int f = 0; f < repair.mesh.faceCount(); ++f) {
    const int original = repair.originalFaceIds[static_cast<std::size_t>(f)];
    const int origin = original < 0 ? -1 : origins[static_cast<std::size_t>(original)];
    if (origin < 0 || !mesh.sound(origin)) continue;
    EXPECT_GT(origin, last);
    last = origin;
    ++kept;
    EXPECT_EQ(cornersOf(repair.mesh.points(), repair.mesh.faces().row(f)),
              cornersOf(clean.points(), clean.faces().row(origin)));
  }
  for (int f = 0; f < clean.faceCount(); ++f) sound += mesh.sound(f);
  EXPECT_EQ(kept, sound);
}

void expectSameSurface(const TriangleMesh& found, const TriangleMesh& clean) {
  const auto all = [](const TriangleMesh& mesh) {
    std::multiset<Corners> corners;
    for (int f = 0; f < mesh.faceCount(); ++f) corners.insert(cornersOf(mesh.points(), mesh.faces().row(f)));
    return corners;
  };
  EXPECT_EQ(all(found), all(clean));
  EXPECT_EQ(found.vertexCount(), clean.vertexCount());
}

void expectRepaired(const TriangleMesh& clean, unsigned seed, bool reshape) {
  SCOPED_TRACE("seed " + std::to_string(seed));
  DamagedMesh mesh(clean, seed);
  damage(mesh, reshape);
  std::vector<int> origins;
  const Faces faces = mesh.faces(origins);
  SurfaceRepairOptions options;
  options.largestHole = 1.0;  // the perimeter of no face, a boundary loop is longer
  const SurfaceRepair repair = repairSurface(mesh.points(), faces, options);
  const MeshReport before = inspect(clean);
  EXPECT_EQ(repair.status, Status::Converged);
  EXPECT_TRUE(repair.after.orientedManifold());
  EXPECT_TRUE(repair.remaining().empty()) << repair.remaining();
  EXPECT_EQ(repair.after.eulerCharacteristic, before.eulerCharacteristic);
  EXPECT_EQ(repair.after.loops.size(), before.loops.size());
  expectCounts(repair, mesh);
  expectSoundFacesKept(repair, mesh, origins, clean);
  if (!mesh.reshapes) expectSameSurface(repair.mesh, clean);
  EXPECT_FALSE(repairSurface(repair.mesh.points(), repair.mesh.faces(), options).changed());
}

}  // namespace

TEST(SurfaceRepair, FindsExactlyTheDamageDoneToClosedSurfaces) {
  for (unsigned seed = 0; seed < 20; ++seed) expectRepaired(wavySphere(4), seed, true);
}

TEST(SurfaceRepair, FindsExactlyTheDamageDoneToDisks) {
  for (unsigned seed = 0; seed < 20; ++seed) expectRepaired(bumpyDisk(20, 0.3), seed, true);
}

TEST(SurfaceRepair, RestoresTheSurfaceWhereNothingIsLost) {
  for (unsigned seed = 100; seed < 115; ++seed) {
    expectRepaired(wavySphere(4), seed, false);
    expectRepaired(bumpyDisk(20, 0.3), seed, false);
  }
}

TEST(SurfaceRepair, CutsAsManyHandlesAsWereGluedOn) {
  for (int handles = 1; handles <= 5; ++handles) {
    const TriangleMesh clean = sphereMesh(4);
    DamagedMesh mesh(clean, static_cast<unsigned>(handles));
    for (int k = 0; k < handles; ++k) mesh.glueHandle();
    std::vector<int> origins;
    const Faces faces = mesh.faces(origins);
    ASSERT_EQ(inspect(TriangleMesh(mesh.points(), faces)).genus, handles);
    const SurfaceRepair repair = repairSurface(mesh.points(), faces);
    expectCounts(repair, mesh);
    expectSoundFacesKept(repair, mesh, origins, clean);
    EXPECT_EQ(repair.after.eulerCharacteristic, 2);
    for (const RepairChange& change : repair.changes) EXPECT_EQ(change.ids.size(), 3u);  // an end of the tube
  }
}
