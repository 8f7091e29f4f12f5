// Steps of the repair that look at how faces hang together: sheets, components, orientation.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>

#include "Core/base/Error.h"
#include "Core/topology/RepairedFaces.h"

namespace authalic {
namespace {

std::size_t at(int index) { return static_cast<std::size_t>(index); }

/// The unit vector in a face that is perpendicular to a half-edge of it.
Eigen::Vector3d inward(const RepairedFaces& surface, int h) {
  const auto& v = surface.faces[at(h / 3)].v;
  const Eigen::Vector3d a = surface.point(v[at(h % 3)]), b = surface.point(v[at((h + 1) % 3)]);
  const Eigen::Vector3d edge = (b - a).normalized(), side = surface.point(v[at((h + 2) % 3)]) - a;
  return (side - side.dot(edge) * edge).normalized();
}

/// How little two faces go on in one another: consistently oriented ones first, then the smaller bend.
double roughness(const RepairedFaces& surface, int h, int g) {
  const bool consistent = surface.faces[at(h / 3)].v[at(h % 3)] != surface.faces[at(g / 3)].v[at(g % 3)];
  return (consistent ? 0.0 : 4.0) + inward(surface, h).dot(inward(surface, g));
}

/// Pairs the half-edges of one edge, best pair first.
std::vector<std::pair<int, int>> pairsOf(const RepairedFaces& surface, std::vector<int> halfEdges) {
  std::vector<std::pair<int, int>> pairs;
  while (halfEdges.size() > 1) {
    std::size_t first = 0, second = 1;
    double best = HUGE_VAL;
    for (std::size_t i = 0; i < halfEdges.size() && halfEdges.size() > 2; ++i) {
      for (std::size_t j = i + 1; j < halfEdges.size(); ++j) {
        const double value = roughness(surface, halfEdges[i], halfEdges[j]);
        if (!(value < best - 1e-9)) continue;
        best = value;
        first = i;
        second = j;
      }
    }
    pairs.emplace_back(halfEdges[first], halfEdges[second]);
    halfEdges.erase(halfEdges.begin() + static_cast<std::ptrdiff_t>(second));
    halfEdges.erase(halfEdges.begin() + static_cast<std::ptrdiff_t>(first));
  }
  return pairs;
}

/// The corner (3 f + k) of the face of a half-edge at vertex v.
int cornerAt(const RepairedFaces& surface, int h, int v) {
  const int f = h / 3;
  for (int k = 0; k < 3; ++k) {
    if (surface.faces[at(f)].v[at(k)] == v) return 3 * f + k;
  }
  return -1;
}

/// Fans of corners around vertices, joined over paired edges.
DisjointSets fansOf(const RepairedFaces& surface, const std::vector<EdgeFaces>& edges) {
  DisjointSets fans(3 * surface.faces.size());
  for (const EdgeFaces& edge : edges) {
    for (const auto& [h, g] : pairsOf(surface, edge.halfEdges)) {
      for (const int v : {edge.a, edge.b}) fans.join(cornerAt(surface, h, v), cornerAt(surface, g, v));
    }
  }
  return fans;
}

/// Gives every fan but the largest of each vertex a vertex of its own; lists the vertices that are on no bad edge.
void splitFans(RepairedFaces& surface, DisjointSets& fans, const std::vector<char>& onBadEdge) {
  std::vector<std::map<int, int>> sizes(surface.pointCount());  // per vertex: fan → corners
  const int corners = static_cast<int>(3 * surface.faces.size());
  for (int c = 0; c < corners; ++c) ++sizes[at(surface.faces[at(c / 3)].v[at(c % 3)])][fans.find(c)];
  std::map<int, int> vertexOf;  // fan → its new vertex
  for (int v = 0; v < static_cast<int>(sizes.size()); ++v) {
    if (sizes[at(v)].size() < 2) continue;
    if (!onBadEdge[at(v)]) surface.listVertices(RepairKind::NonManifoldVertex, {v});
    const auto largest = std::max_element(sizes[at(v)].begin(), sizes[at(v)].end(),
                                          [](const auto& a, const auto& b) { return a.second < b.second; });
    for (const auto& [fan, size] : sizes[at(v)]) {
      if (fan != largest->first) vertexOf[fan] = surface.copyOf(v);
    }
  }
  if (vertexOf.empty()) return;
  for (int c = 0; c < corners; ++c) {
    const auto found = vertexOf.find(fans.find(c));
    if (found != vertexOf.end()) surface.faces[at(c / 3)].v[at(c % 3)] = found->second;
  }
}

/// Where more than two faces still share an edge (a sheet that closes round both its ends), all but one pair go.
void removeSurplusFaces(RepairedFaces& surface) {
  std::vector<char> gone(surface.faces.size(), 0);
  for (const EdgeFaces& edge : edgesOf(surface.faces)) {
    if (edge.halfEdges.size() < 3) continue;
    const auto kept = pairsOf(surface, edge.halfEdges).front();
    for (const int h : edge.halfEdges) {
      if (h == kept.first || h == kept.second || gone[at(h / 3)]) continue;
      gone[at(h / 3)] = 1;
      surface.listVertices(RepairKind::NonManifoldEdge, {edge.a, edge.b});
    }
  }
  surface.removeFaces(gone);
}

/// Faces joined over shared vertices; valid where every vertex is one fan.
std::vector<std::vector<int>> componentsOf(const RepairedFaces& surface) {
  DisjointSets sets(surface.pointCount());
  for (const RepairedFace& face : surface.faces) {
    sets.join(face.v[0], face.v[1]);
    sets.join(face.v[0], face.v[2]);
  }
  std::map<int, std::size_t> numbers;
  std::vector<std::vector<int>> components;
  for (std::size_t f = 0; f < surface.faces.size(); ++f) {
    const auto [entry, isNew] = numbers.emplace(sets.find(surface.faces[f].v[0]), components.size());
    if (isNew) components.emplace_back();
    components[entry->second].push_back(static_cast<int>(f));
  }
  return components;
}

/// Per face whether it has to be turned so that its component agrees with the component's first face.
class Orientation {
 public:
  explicit Orientation(const RepairedFaces& surface)
      : surface_(surface), across_(3 * surface.faces.size(), -1), turned_(surface.faces.size(), -1) {
    for (const EdgeFaces& edge : edgesOf(surface.faces)) {
      if (edge.halfEdges.size() != 2) continue;
      across_[at(edge.halfEdges[0])] = edge.halfEdges[1];
      across_[at(edge.halfEdges[1])] = edge.halfEdges[0];
    }
  }

  void spreadFrom(int seed) {
    std::vector<int> queue{seed};
    turned_[at(seed)] = 0;
    for (std::size_t i = 0; i < queue.size(); ++i) {
      for (int h = 3 * queue[i]; h < 3 * queue[i] + 3; ++h) {
        const int g = across_[at(h)];
        if (g < 0) continue;
        const bool against = tail(h) != tail(g);
        const int wanted = against ? turned_[at(h / 3)] : 1 - turned_[at(h / 3)];
        if (turned_[at(g / 3)] < 0) {
          turned_[at(g / 3)] = wanted;
          queue.push_back(g / 3);
        } else if (turned_[at(g / 3)] != wanted) {
          refuse(h);
        }
      }
    }
  }
  [[nodiscard]] bool turned(int f) const { return turned_[at(f)] == 1; }
  [[nodiscard]] bool closed(const std::vector<int>& component) const {
    return std::all_of(component.begin(), component.end(), [&](int f) {
      return across_[at(3 * f)] >= 0 && across_[at(3 * f + 1)] >= 0 && across_[at(3 * f + 2)] >= 0;
    });
  }

 private:
  [[nodiscard]] int tail(int h) const { return surface_.faces[at(h / 3)].v[at(h % 3)]; }
  [[noreturn]] void refuse(int h) const {
    const Eigen::Vector3d place = surface_.centre(surface_.faces[at(h / 3)]);
    throw TopologyError("A two-sided surface is required, but this one is one-sided (a Möbius band closes near " +
                        placeWords(place) + "); cut it open there before it is repaired.");
  }

  const RepairedFaces& surface_;
  std::vector<int> across_, turned_;
};

double signedVolume(const RepairedFaces& surface, const Orientation& orientation, const std::vector<int>& component) {
  const Eigen::Vector3d origin = surface.point(surface.faces[at(component.front())].v[0]);
  double volume = 0;
  for (const int f : component) {
    const auto& v = surface.faces[at(f)].v;
    const Eigen::Vector3d a = surface.point(v[0]) - origin, b = surface.point(v[1]) - origin;
    const double part = a.dot(b.cross(surface.point(v[2]) - origin)) / 6.0;
    volume += orientation.turned(f) ? -part : part;
  }
  return volume;
}

/// Whether the other one of the two orientations is wanted: outwards, or that of the greater part of the area.
bool wantsOther(const RepairedFaces& surface, const Orientation& orientation, const std::vector<int>& component) {
  if (orientation.closed(component)) return signedVolume(surface, orientation, component) < 0;
  double turned = 0, all = 0;
  for (const int f : component) {
    const double area = surface.area(surface.faces[at(f)]);
    all += area;
    if (orientation.turned(f)) turned += area;
  }
  return turned > 0.5 * all;
}

double areaOf(const RepairedFaces& surface, const std::vector<int>& component) {
  double area = 0;
  for (const int f : component) area += surface.area(surface.faces[at(f)]);
  return area;
}

}  // namespace

void requireSheets(const RepairedFaces& surface) {
  std::vector<char> joined(surface.faces.size(), 0);
  for (const EdgeFaces& edge : edgesOf(surface.faces)) {
    if (edge.halfEdges.size() < 2) continue;
    for (const int h : edge.halfEdges) joined[at(h / 3)] = 1;
  }
  double lone = 0, all = 0;
  std::size_t count = 0, first = 0;
  for (std::size_t f = 0; f < joined.size(); ++f) {
    const double area = surface.area(surface.faces[f]);
    all += area;
    if (joined[f]) continue;
    lone += area;
    if (count++ == 0) first = f;
  }
  if (joined.size() < 2 || !(lone > 0.5 * all)) return;
  throw TopologyError("A surface of triangles that meet along edges is required, but " + std::to_string(count) +
                      " of " + std::to_string(joined.size()) + " triangles share no edge with another, the first at " +
                      placeWords(surface.centre(surface.faces[first])) +
                      "; vertices that are meant to be one must have the same coordinates, or the surface has to be "
                      "reconstructed.");
}

void separateSheets(RepairedFaces& surface) {
  const std::vector<EdgeFaces> edges = edgesOf(surface.faces);
  std::vector<char> onBadEdge(surface.pointCount(), 0);
  for (const EdgeFaces& edge : edges) {
    if (edge.halfEdges.size() < 3) continue;
    onBadEdge[at(edge.a)] = onBadEdge[at(edge.b)] = 1;
    surface.listVertices(RepairKind::NonManifoldEdge, {edge.a, edge.b});
  }
  DisjointSets fans = fansOf(surface, edges);
  splitFans(surface, fans, onBadEdge);
  removeSurplusFaces(surface);
}

void removeStrays(RepairedFaces& surface, double share) {
  const std::vector<std::vector<int>> components = componentsOf(surface);
  std::vector<double> areas;
  for (const auto& component : components) areas.push_back(areaOf(surface, component));
  const auto largest = std::max_element(areas.begin(), areas.end());
  std::vector<char> gone(surface.faces.size(), 0);
  for (std::size_t i = 0; i < components.size(); ++i) {
    if (areas.begin() + static_cast<std::ptrdiff_t>(i) == largest || !(areas[i] < share * *largest)) continue;
    surface.listFace(RepairKind::StrayComponent, surface.faces[at(components[i].front())], areas[i]);
    for (const int f : components[i]) gone[at(f)] = 1;
  }
  surface.removeFaces(gone);
}

void orient(RepairedFaces& surface) {
  Orientation orientation(surface);
  std::vector<char> turn(surface.faces.size(), 0);
  for (const std::vector<int>& component : componentsOf(surface)) {
    orientation.spreadFrom(component.front());
    const bool other = wantsOther(surface, orientation, component);
    std::size_t count = 0;
    for (const int f : component) count += turn[at(f)] = orientation.turned(f) != other;
    if (count == component.size()) {
      const RepairedFace& face = surface.faces[at(component.front())];
      surface.listFace(RepairKind::InsideOutComponent, face, areaOf(surface, component));
      continue;
    }
    for (const int f : component) {
      if (turn[at(f)]) surface.listFace(RepairKind::FlippedFace, surface.faces[at(f)]);
    }
  }
  for (std::size_t f = 0; f < turn.size(); ++f) {
    if (turn[f]) std::swap(surface.faces[f].v[1], surface.faces[f].v[2]);
  }
}

}  // namespace authalic
