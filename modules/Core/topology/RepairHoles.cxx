// Steps of the repair that close loops: small holes, and the two sides of a cut through a handle.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>

#include "Core/base/Error.h"
#include "Core/topology/LoopLength.h"
#include "Core/topology/RepairedFaces.h"
#include "Core/topology/ShortestHandleLoop.h"

namespace authalic {
namespace {

std::size_t at(int index) { return static_cast<std::size_t>(index); }

/// Longer loops get a fan at once: the triangulation costs k³.
constexpr std::size_t kLongestTriangulated = 1000;

/// The triangulation of a loop of least weight that adds no edge twice @cite barequet1995.
class LoopTriangulation {
 public:
  LoopTriangulation(const RepairedFaces& surface, const FacesAround& around, const std::vector<int>& loop)
      : surface_(surface), around_(around), loop_(loop), weight_(loop.size() * loop.size(), 0.0),
        middle_(loop.size() * loop.size(), -1) {
    const std::size_t n = loop.size();
    double perimeter = 0;
    for (std::size_t i = 0; i < n; ++i) perimeter += (place((i + 1) % n) - place(i)).norm();
    penalty_ = perimeter * perimeter;
    for (std::size_t gap = 2; gap < n; ++gap) {
      for (std::size_t i = 0; i + gap < n; ++i) fill(i, i + gap);
    }
  }
  [[nodiscard]] bool possible() const { return weight_[loop_.size() - 1] < HUGE_VAL; }
  /// Triangles as positions i < m < j in the loop.
  [[nodiscard]] std::vector<std::array<std::size_t, 3>> triangles() const {
    std::vector<std::array<std::size_t, 3>> found;
    std::vector<std::pair<std::size_t, std::size_t>> open{{0, loop_.size() - 1}};
    while (!open.empty()) {
      const auto [i, j] = open.back();
      open.pop_back();
      if (j - i < 2) continue;
      const std::size_t m = at(middle_[i * loop_.size() + j]);
      found.push_back({i, m, j});
      open.emplace_back(m, j);
      open.emplace_back(i, m);
    }
    return found;
  }

 private:
  [[nodiscard]] const Eigen::Vector3d& place(std::size_t i) const { return surface_.point(loop_[i]); }

  void fill(std::size_t i, std::size_t j) {
    const std::size_t n = loop_.size();
    double best = HUGE_VAL;
    if (!(i == 0 && j == n - 1) && joined(loop_[i], loop_[j])) {
      weight_[i * n + j] = HUGE_VAL;
      return;
    }
    for (std::size_t m = i + 1; m < j; ++m) {
      const double value = weight_[i * n + m] + weight_[m * n + j] + weightOf(i, m, j);
      if (!(value < best)) continue;
      best = value;
      middle_[i * n + j] = static_cast<int>(m);
    }
    weight_[i * n + j] = best;
  }
  [[nodiscard]] bool joined(int a, int b) const {
    return std::any_of(around_[at(a)].begin(), around_[at(a)].end(), [&](int f) {
      const auto& v = surface_.faces[at(f)].v;
      return std::find(v.begin(), v.end(), b) != v.end();
    });
  }
  /// (a² + b² + c²)/(4√3): the area of an equilateral triangle, more than that of others.
  [[nodiscard]] double weightOf(std::size_t i, std::size_t m, std::size_t j) const {
    const Eigen::Vector3d a = place(m) - place(i), b = place(j) - place(m), c = place(i) - place(j);
    const double squares = a.squaredNorm() + b.squaredNorm() + c.squaredNorm();
    const bool flat = a.cross(c).norm() <= 1e-9 * squares;
    return squares / (4 * std::sqrt(3.0)) + (flat ? penalty_ : 0.0);
  }

  const RepairedFaces& surface_;
  const FacesAround& around_;
  const std::vector<int>& loop_;
  std::vector<double> weight_;
  std::vector<int> middle_;
  double penalty_ = 0;
};

void addFace(RepairedFaces& surface, FacesAround& around, const std::array<int, 3>& v, int source) {
  for (const int corner : v) around[at(corner)].push_back(static_cast<int>(surface.faces.size()));
  surface.faces.push_back({v, -1, source});
}

void addFan(RepairedFaces& surface, FacesAround& around, const std::vector<int>& loop, int source) {
  const int centre = surface.copyOf(loop.front());
  surface.originalPoint[at(centre)] = -1;
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const int v : loop) mean += surface.point(v) / static_cast<double>(loop.size());
  surface.points[at(centre)] = mean;
  around.emplace_back();
  for (std::size_t i = 0; i < loop.size(); ++i) {
    addFace(surface, around, {loop[i], loop[(i + 1) % loop.size()], centre}, source);
  }
}

/// Per corner whether it lies to the left of the loop; corners off the loop are not looked at.
std::vector<char> leftOf(const SurfaceTopology& topology, const std::vector<int>& loop) {
  std::map<int, std::size_t> position;
  for (std::size_t i = 0; i < loop.size(); ++i) position[loop[i]] = i;
  std::vector<char> left(at(static_cast<int>(3 * topology.faces().rows())), 0);
  for (int h = 0; h < static_cast<int>(left.size()); ++h) {
    const auto found = position.find(topology.tail(h));
    if (found == position.end()) continue;
    const std::size_t n = loop.size(), i = found->second;
    if (topology.head(h) != loop[(i + 1) % n]) continue;
    for (int g = h; topology.head(g) != loop[(i + n - 1) % n]; g = topology.opposite(SurfaceTopology::previous(g))) {
      left[at(g)] = 1;
    }
  }
  return left;
}

/// Cuts along a loop of inner vertices; the faces to its right get copies of them, which are returned in its order.
std::vector<int> cutAlong(RepairedFaces& surface, const SurfaceTopology& topology, const std::vector<int>& loop) {
  const std::vector<char> left = leftOf(topology, loop);
  std::map<int, int> copies;
  std::vector<int> right;
  for (const int v : loop) right.push_back(copies[v] = surface.copyOf(v));
  for (std::size_t c = 0; c < left.size(); ++c) {
    int& v = surface.faces[c / 3].v[c % 3];
    const auto found = copies.find(v);
    if (found != copies.end() && !left[c]) v = found->second;
  }
  return right;
}

bool clean(const SurfaceTopology& topology) { return topology.manifold(); }

double totalArea(const RepairedFaces& surface) {
  double area = 0;
  for (const RepairedFace& face : surface.faces) area += surface.area(face);
  return area;
}

}  // namespace

bool fillLoop(RepairedFaces& surface, FacesAround& around, const std::vector<int>& loop) {
  const int source = surface.faces[at(around[at(loop.front())].front())].source;
  if (loop.size() == 3) {
    const auto& first = around[at(loop[0])];
    const bool there = std::any_of(first.begin(), first.end(), [&](int f) {
      const auto& v = surface.faces[at(f)].v;
      return std::is_permutation(v.begin(), v.end(), loop.begin());
    });
    if (there) return false;
    addFace(surface, around, {loop[0], loop[1], loop[2]}, source);
    return true;
  }
  if (loop.size() > kLongestTriangulated) {
    addFan(surface, around, loop, source);
    return true;
  }
  const LoopTriangulation triangulation(surface, around, loop);
  if (!triangulation.possible()) {
    addFan(surface, around, loop, source);
    return true;
  }
  for (const auto& [i, m, j] : triangulation.triangles()) {
    const int beside = surface.faces[at(around[at(loop[m])].front())].source;
    addFace(surface, around, {loop[i], loop[m], loop[j]}, beside);
  }
  return true;
}

void fillHoles(RepairedFaces& surface, double largest) {
  const SurfaceTopology topology(surface.faceMatrix(), static_cast<int>(surface.pointCount()));
  if (!clean(topology) || topology.boundaryLoops().empty()) return;
  const double limit = largest < 0 ? 0.1 * std::sqrt(totalArea(surface)) : largest;
  FacesAround around = facesAround(surface);
  for (const std::vector<int>& loop : topology.boundaryLoops()) {
    double length = 0;
    for (std::size_t i = 0; i < loop.size(); ++i) {
      length += (surface.point(loop[(i + 1) % loop.size()]) - surface.point(loop[i])).norm();
    }
    if (!(length <= limit)) continue;
    if (!fillLoop(surface, around, std::vector<int>(loop.rbegin(), loop.rend()))) continue;
    surface.listVertices(RepairKind::Hole, loop, length);
    if (surface.changes.back().ids.size() > 1) surface.changes.back().ids.resize(1);
  }
}

void cutHandles(RepairedFaces& surface, double largest, const Execution& execution) {
  if (largest == 0) return;
  for (;;) {
    const TriangleMesh mesh(surface.pointMatrix(), surface.faceMatrix());
    const SurfaceTopology topology(mesh.faces(), mesh.vertexCount());
    if (!clean(topology)) return;
    const int caps = topology.componentCount() * 2 - static_cast<int>(topology.boundaryLoops().size());
    if (caps - topology.eulerCharacteristic() <= 0) return;
    const NonSeparatingLoop loop = shortestHandleLoop(mesh, topology, execution);
    if (loop.vertices.empty() || (largest > 0 && loop.length > largest)) return;
    surface.listVertices(RepairKind::Handle, loop.vertices, loop.length);
    const std::vector<int> right = cutAlong(surface, topology, loop.vertices);
    FacesAround around = facesAround(surface);
    fillLoop(surface, around, std::vector<int>(loop.vertices.rbegin(), loop.vertices.rend()));
    fillLoop(surface, around, right);
  }
}

}  // namespace authalic
