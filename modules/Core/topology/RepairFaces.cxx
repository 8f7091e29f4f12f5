// Steps of the repair that look at single faces and boundary edges.
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <utility>

#include "Core/topology/RepairedFaces.h"

namespace authalic {
namespace {

std::size_t at(int index) { return static_cast<std::size_t>(index); }

/// As in MeshReport: faces below this fraction of their longest edge squared have no usable normal.
constexpr double kDegenerate = 1e-12;
/// A degenerate face with a shorter edge than this fraction of its longest is a needle, else it is flat.
constexpr double kNeedle = 1e-5;

double longestSquared(const RepairedFaces& surface, const RepairedFace& face) {
  double longest = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    longest = std::max(longest, (surface.point(face.v[(k + 1) % 3]) - surface.point(face.v[k])).squaredNorm());
  }
  return longest;
}

/// Area over longest edge squared: 0.43 for an equilateral triangle, 0 for a degenerate one.
double roundness(const RepairedFaces& surface, const RepairedFace& face) {
  const double longest = longestSquared(surface, face);
  return longest > 0 ? surface.area(face) / longest : 0.0;
}

bool repeatsVertex(const RepairedFace& face) {
  return face.v[0] == face.v[1] || face.v[1] == face.v[2] || face.v[2] == face.v[0];
}

/// Boundary edges as half-edges, in the order of their ends.
std::vector<int> boundaryHalfEdges(const RepairedFaces& surface) {
  std::vector<int> boundary;
  for (const EdgeFaces& edge : edgesOf(surface.faces)) {
    if (edge.halfEdges.size() == 1) boundary.push_back(edge.halfEdges.front());
  }
  return boundary;
}

int tail(const RepairedFaces& surface, int h) { return surface.faces[at(h / 3)].v[at(h % 3)]; }
int head(const RepairedFaces& surface, int h) { return surface.faces[at(h / 3)].v[at((h + 1) % 3)]; }

/// Numbers of points by their place, for vertices of the half-edges.
std::map<int, int> placesOf(const RepairedFaces& surface, const std::vector<int>& halfEdges) {
  std::map<std::array<double, 3>, int> numbers;
  std::map<int, int> places;
  for (const int h : halfEdges) {
    for (const int v : {tail(surface, h), head(surface, h)}) {
      const Eigen::Vector3d& p = surface.point(v);
      const std::array<double, 3> key{p[0] + 0.0, p[1] + 0.0, p[2] + 0.0};
      places[v] = numbers.emplace(key, static_cast<int>(numbers.size())).first->second;
    }
  }
  return places;
}

/// Vertices on a boundary, sorted along x.
class BoundaryVertices {
 public:
  BoundaryVertices(const RepairedFaces& surface, const std::vector<int>& halfEdges) : surface_(surface) {
    std::set<int> vertices;
    for (const int h : halfEdges) vertices.insert({tail(surface, h), head(surface, h)});
    for (const int v : vertices) sorted_.emplace_back(surface.point(v)[0], v);
    std::sort(sorted_.begin(), sorted_.end());
  }

  /// (parameter, vertex) of those in the open edge of a half-edge.
  [[nodiscard]] std::vector<std::pair<double, int>> on(int h, double tolerance) const {
    const RepairedFace& face = surface_.faces[at(h / 3)];
    const Eigen::Vector3d &a = surface_.point(tail(surface_, h)), &b = surface_.point(head(surface_, h));
    const double length = (b - a).norm(), reach = tolerance * length;
    std::vector<std::pair<double, int>> found;
    const double from = std::min(a[0], b[0]) - reach, to = std::max(a[0], b[0]) + reach;
    for (auto it = std::lower_bound(sorted_.begin(), sorted_.end(), std::pair(from, -1));
         it != sorted_.end() && it->first <= to; ++it) {
      if (std::find(face.v.begin(), face.v.end(), it->second) != face.v.end()) continue;
      const Eigen::Vector3d& p = surface_.point(it->second);
      const double t = (p - a).dot(b - a) / (length * length);
      if (!(t > margin(tolerance) && t < 1 - margin(tolerance)) || (a + t * (b - a) - p).norm() > reach) continue;
      found.emplace_back(t, it->second);
    }
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end(),  // soups: one of several vertices in the same place
                            [&](const auto& x, const auto& y) { return y.first - x.first <= margin(tolerance); }),
                found.end());
    return found;
  }

 private:
  static double margin(double tolerance) { return std::max(tolerance, 1e-9); }

  const RepairedFaces& surface_;
  std::vector<std::pair<double, int>> sorted_;
};

/// Edges of a boundary by the names of their ends.
using NamedEdges = std::set<std::pair<int, int>>;

/// Of vertices on an edge between `ends`, in order, those that have a boundary edge to another of them or to an
/// end: the others only touch the edge.
std::vector<int> joining(const std::vector<std::pair<double, int>>& found, std::pair<int, int> ends,
                         const NamedEdges& edges, std::map<int, int>& names) {
  std::vector<int> all{ends.first, ends.second}, kept;
  for (const auto& entry : found) all.push_back(entry.second);
  for (const auto& [t, v] : found) {
    const int name = names[v];
    const bool joins = std::any_of(all.begin(), all.end(), [&](int w) {
      return names[w] != name && edges.count(std::minmax({name, names[w]})) > 0;
    });
    if (joins) kept.push_back(v);
  }
  return kept;
}

/// Takes one degenerate face after the other away, by collapses and flips around it.
class Degenerate {
 public:
  explicit Degenerate(RepairedFaces& surface) : surface_(surface), around_(facesAround(surface)) {}

  void removeAll() {
    gone_.assign(surface_.faces.size(), 0);
    for (int f = 0; f < static_cast<int>(surface_.faces.size()); ++f) {
      const RepairedFace face = surface_.faces[at(f)];
      if (gone_[at(f)] || roundness(surface_, face) > kDegenerate) continue;
      if (isNeedle(face) ? collapse(f) : flatten(f)) surface_.listFace(RepairKind::DegenerateFace, face);
    }
    surface_.removeFaces(gone_);
  }

 private:
  [[nodiscard]] double length(const RepairedFace& face, std::size_t k) const {
    return (surface_.point(face.v[(k + 1) % 3]) - surface_.point(face.v[k])).norm();
  }
  [[nodiscard]] std::size_t shortest(const RepairedFace& face) const {
    std::size_t best = 0;
    for (std::size_t k = 1; k < 3; ++k) {
      if (length(face, k) < length(face, best)) best = k;
    }
    return best;
  }
  [[nodiscard]] std::size_t longest(const RepairedFace& face) const {
    std::size_t best = 0;
    for (std::size_t k = 1; k < 3; ++k) {
      if (length(face, k) > length(face, best)) best = k;
    }
    return best;
  }
  [[nodiscard]] bool isNeedle(const RepairedFace& face) const {
    return length(face, shortest(face)) <= kNeedle * length(face, longest(face));
  }

  [[nodiscard]] std::vector<int> facesOn(int a, int b) const {
    std::vector<int> found;
    for (const int f : around_[at(a)]) {
      const auto& v = surface_.faces[at(f)].v;
      if (!gone_[at(f)] && std::find(v.begin(), v.end(), b) != v.end()) found.push_back(f);
    }
    return found;
  }
  [[nodiscard]] std::set<int> neighbours(int a) const {
    std::set<int> found;
    for (const int f : around_[at(a)]) {
      if (!gone_[at(f)]) found.insert(surface_.faces[at(f)].v.begin(), surface_.faces[at(f)].v.end());
    }
    found.erase(a);
    return found;
  }

  /// Merges the ends of the shortest edge where that keeps the surface a manifold (link condition).
  bool collapse(int f) {
    const RepairedFace face = surface_.faces[at(f)];
    const std::size_t k = shortest(face);
    const auto [a, b] = std::minmax(face.v[k], face.v[(k + 1) % 3]);
    const std::vector<int> beside = facesOn(a, b);
    const std::set<int> ofA = neighbours(a), ofB = neighbours(b);
    const auto common = std::count_if(ofA.begin(), ofA.end(), [&](int v) { return ofB.count(v) > 0; });
    const bool bothOnRim = onRim(a) && onRim(b) && beside.size() == 2;
    if (common != static_cast<std::ptrdiff_t>(beside.size()) || ofA.size() + ofB.size() < 7 || bothOnRim) return false;
    for (const int g : beside) gone_[at(g)] = 1;
    for (const int g : around_[at(b)]) {
      if (gone_[at(g)]) continue;
      for (int& v : surface_.faces[at(g)].v) {
        if (v == b) v = a;
      }
      around_[at(a)].push_back(g);
    }
    around_[at(b)].clear();
    return true;
  }
  [[nodiscard]] bool onRim(int a) const {
    const std::set<int> all = neighbours(a);
    return std::any_of(all.begin(), all.end(), [&](int b) { return facesOn(a, b).size() == 1; });
  }

  /// A face whose third corner lies on its longest edge: flips that edge, or removes the face on a boundary.
  bool flatten(int f) {
    const RepairedFace face = surface_.faces[at(f)];
    const std::size_t k = longest(face);
    const int a = face.v[k], b = face.v[(k + 1) % 3], c = face.v[(k + 2) % 3];
    const std::vector<int> beside = facesOn(a, b);
    if (beside.size() == 1) gone_[at(f)] = 1;
    if (beside.size() != 2) return beside.size() == 1;
    const int g = beside[0] == f ? beside[1] : beside[0];
    RepairedFace left = face, right = surface_.faces[at(g)];
    int d = -1;
    for (const int v : right.v) d = v == a || v == b ? d : v;
    if (d < 0 || d == c || !facesOn(c, d).empty()) return false;
    left.v = {a, d, c};
    right.v = {d, b, c};
    if (std::min(roundness(surface_, left), roundness(surface_, right)) <= kDegenerate) return false;
    surface_.faces[at(f)] = left;
    surface_.faces[at(g)] = right;
    drop(b, f);
    drop(a, g);
    around_[at(d)].push_back(f);
    around_[at(c)].push_back(g);
    return true;
  }
  void drop(int v, int f) {
    auto& list = around_[at(v)];
    list.erase(std::remove(list.begin(), list.end(), f), list.end());
  }

  RepairedFaces& surface_;
  FacesAround around_;
  std::vector<char> gone_;
};

}  // namespace

void removeRepeatedVertices(RepairedFaces& surface) {
  std::vector<char> gone(surface.faces.size(), 0);
  for (std::size_t f = 0; f < gone.size(); ++f) {
    if (!repeatsVertex(surface.faces[f])) continue;
    gone[f] = 1;
    surface.listFace(RepairKind::DegenerateFace, surface.faces[f]);
  }
  surface.removeFaces(gone);
}

void removeDuplicates(RepairedFaces& surface) {
  std::vector<std::pair<std::array<int, 3>, std::size_t>> keyed;
  for (std::size_t f = 0; f < surface.faces.size(); ++f) {
    std::array<int, 3> key = surface.faces[f].v;
    std::sort(key.begin(), key.end());
    keyed.emplace_back(key, f);
  }
  std::sort(keyed.begin(), keyed.end());
  std::vector<char> gone(surface.faces.size(), 0);
  for (std::size_t i = 1; i < keyed.size(); ++i) gone[keyed[i].second] = keyed[i].first == keyed[i - 1].first;
  for (std::size_t f = 0; f < gone.size(); ++f) {
    if (gone[f]) surface.listFace(RepairKind::DuplicateFace, surface.faces[f]);
  }
  surface.removeFaces(gone);
}

void sewSeams(RepairedFaces& surface) {
  const std::vector<int> boundary = boundaryHalfEdges(surface);
  std::map<int, int> places = placesOf(surface, boundary);
  std::map<std::pair<int, int>, std::vector<int>> byPlace;
  for (const int h : boundary) {
    const auto key = std::minmax({places[tail(surface, h)], places[head(surface, h)]});
    if (key.first != key.second) byPlace[key].push_back(h);
  }
  DisjointSets sets(surface.pointCount());
  for (const auto& [key, halfEdges] : byPlace) {
    if (halfEdges.size() != 2) continue;
    const int h = halfEdges[0], g = halfEdges[1];
    const bool against = places[tail(surface, h)] == places[head(surface, g)];
    const int a = tail(surface, g), b = head(surface, g);
    sets.join(tail(surface, h), against ? b : a);
    sets.join(head(surface, h), against ? a : b);
    surface.listVertices(RepairKind::Seam, {tail(surface, h), head(surface, h)});
  }
  for (RepairedFace& face : surface.faces) {
    for (int& v : face.v) v = sets.find(v);
  }
}

void splitAtJunctions(RepairedFaces& surface, double tolerance, bool byPlace) {
  const std::vector<int> boundary = boundaryHalfEdges(surface);
  std::map<int, int> names = byPlace ? placesOf(surface, boundary) : std::map<int, int>();
  NamedEdges edges;
  for (const int h : boundary) {
    const int a = tail(surface, h), b = head(surface, h);
    if (!byPlace) names[a] = a, names[b] = b;
    edges.insert(std::minmax({names[a], names[b]}));
  }
  const BoundaryVertices vertices(surface, boundary);
  std::map<int, std::pair<int, std::vector<int>>> splits;  // face → corner, vertices in order
  for (const int h : boundary) {
    if (splits.count(h / 3) > 0) continue;  // its other edges: next round
    const auto found = vertices.on(h, tolerance);
    const auto kept = joining(found, {tail(surface, h), head(surface, h)}, edges, names);
    if (!kept.empty()) splits[h / 3] = {h % 3, kept};
  }
  for (const auto& [f, split] : splits) {
    const RepairedFace face = surface.faces[at(f)];
    const std::size_t k = at(split.first);
    const int apex = face.v[(k + 2) % 3];
    int from = face.v[k];
    for (const int v : split.second) {
      surface.listVertices(RepairKind::TJunction, {v});
      surface.faces.push_back({{from, v, apex}, face.original, face.source});
      from = v;
    }
    surface.faces[at(f)].v = {from, face.v[(k + 1) % 3], apex};
  }
}

void removeDegenerate(RepairedFaces& surface) { Degenerate(surface).removeAll(); }

}  // namespace authalic
