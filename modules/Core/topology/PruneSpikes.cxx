#include "Core/topology/PruneSpikes.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <utility>

#include "Core/base/Error.h"
#include "Core/geometry/Areas.h"
#include "Core/mesh/SurfaceTopology.h"

namespace authalic {

namespace {

std::size_t at(int index) { return static_cast<std::size_t>(index); }

using Cycle = std::array<int, 3>;

// The disk to the left of a cycle of vertices.
struct Part {
  Cycle rim{};
  std::vector<int> faces, innerVertices;
};

// The edges around every vertex: its neighbours, each with the half-edge that leads there, or -1 on the far side of
// the boundary.
class Neighbours {
 public:
  explicit Neighbours(const SurfaceTopology& topology) : of_(at(topology.vertexCount())) {
    for (int h = 0; h < 3 * static_cast<int>(topology.faces().rows()); ++h) {
      const int a = topology.tail(h), b = topology.head(h);
      of_[at(a)].push_back({b, h});
      if (topology.opposite(h) < 0) of_[at(b)].push_back({a, -1});
    }
  }
  [[nodiscard]] const std::vector<std::pair<int, int>>& of(int vertex) const { return of_[at(vertex)]; }
  [[nodiscard]] int halfEdge(int tail, int head) const {
    for (const auto& [vertex, h] : of(tail)) {
      if (vertex == head) return h;
    }
    return -1;
  }

 private:
  std::vector<std::vector<std::pair<int, int>>> of_;
};

// Cycles a < b < c of three edges that are not a face.
std::vector<Cycle> separatingTriangles(const SurfaceTopology& topology, const Neighbours& neighbours) {
  std::vector<Cycle> cycles;
  std::vector<int> besides(at(topology.vertexCount()), -1);
  const auto apex = [&](int h) { return h < 0 ? -1 : topology.head(SurfaceTopology::next(h)); };
  for (int a = 0; a < topology.vertexCount(); ++a) {
    for (const auto& edge : neighbours.of(a)) besides[at(edge.first)] = a;
    for (const auto& edge : neighbours.of(a)) {
      const int b = edge.first;
      if (b < a) continue;
      const int left = apex(edge.second), right = apex(neighbours.halfEdge(b, a));
      for (const auto& further : neighbours.of(b)) {
        const int c = further.first;
        if (c > b && besides[at(c)] == a && c != left && c != right) cycles.push_back({a, b, c});
      }
    }
  }
  return cycles;
}

// Finds the side of a cycle that has fewer faces, by growing both at the same pace.
class SmallerSide {
 public:
  SmallerSide(const SurfaceTopology& topology, const Neighbours& neighbours)
      : topology_(topology), neighbours_(neighbours), owner_(at(static_cast<int>(topology.faces().rows())), -1),
        seen_(at(topology.vertexCount()), -1) {}

  // An empty part when that side is no disk.
  [[nodiscard]] Part of(const Cycle& cycle) {
    std::array<Part, 2> sides{Part{cycle, {}, {}}, Part{{cycle[0], cycle[2], cycle[1]}, {}, {}}};
    std::array<std::size_t, 2> next{0, 0};
    for (Part& side : sides) {
      const int h = firstHalfEdge(side.rim);
      if (h < 0) return {};
      side.faces.push_back(h / 3);
      owner_[at(h / 3)] = ++mark_;
    }
    const std::array<int, 2> marks{mark_ - 1, mark_};
    for (std::size_t s = 0;; s = 1 - s) {
      if (next[s] == sides[s].faces.size()) return becomesDisk(sides[s]) ? std::move(sides[s]) : Part{};
      const int face = sides[s].faces[next[s]++];
      for (int h = 3 * face; h < 3 * face + 3; ++h) {
        const int g = topology_.opposite(h);
        if (g < 0 || onRim(cycle, h) || owner_[at(g / 3)] == marks[s]) continue;
        if (owner_[at(g / 3)] == marks[1 - s]) return {};  // round a handle to the other side
        owner_[at(g / 3)] = marks[s];
        sides[s].faces.push_back(g / 3);
      }
    }
  }

 private:
  [[nodiscard]] bool onRim(const Cycle& cycle, int h) const {
    const auto in = [&](int v) { return v == cycle[0] || v == cycle[1] || v == cycle[2]; };
    return in(topology_.tail(h)) && in(topology_.head(h));
  }

  // Of the rim, with a face to its left.
  [[nodiscard]] int firstHalfEdge(const Cycle& rim) const {
    int h = -1;
    for (std::size_t k = 0; k < 3 && h < 0; ++k) h = neighbours_.halfEdge(rim[k], rim[(k + 1) % 3]);
    return h;
  }

  // Lists the inner vertices; a disk is bounded by the rim alone and has F = 2 k + 1 faces on k of them: χ = 1.
  [[nodiscard]] bool becomesDisk(Part& part) {
    for (const int v : part.rim) seen_[at(v)] = mark_;
    int rim = 0;
    for (const int face : part.faces) {
      for (int h = 3 * face; h < 3 * face + 3; ++h) {
        const int v = topology_.tail(h);
        if (seen_[at(v)] != mark_) part.innerVertices.push_back(v);
        seen_[at(v)] = mark_;
        if (onRim(part.rim, h)) {
          ++rim;
        } else if (topology_.opposite(h) < 0) {
          return false;
        }
      }
    }
    return rim == 3 && part.faces.size() == 2 * part.innerVertices.size() + 1;
  }

  const SurfaceTopology& topology_;
  const Neighbours& neighbours_;
  std::vector<int> owner_, seen_;
  int mark_ = -1;
};

double areaOf(const Part& part, const Eigen::VectorXd& areas) {
  double area = 0;
  for (const int f : part.faces) area += areas[f];
  return area;
}

// The small parts that lie in no other, largest first. Two parts are nested or have no face in common: an edge of one
// rim cannot cross the other.
std::vector<Part> outermostParts(const TriangleMesh& surface, const SurfaceTopology& topology, double largestArea,
                                 const Eigen::VectorXd& areas, const Execution& execution) {
  const Neighbours neighbours(topology);
  SmallerSide smallerSide(topology, neighbours);
  std::vector<Part> parts;
  for (const Cycle& cycle : separatingTriangles(topology, neighbours)) {
    execution.throwIfCancelled();
    Part part = smallerSide.of(cycle);
    if (!part.faces.empty() && areaOf(part, areas) <= largestArea) parts.push_back(std::move(part));
  }
  std::stable_sort(parts.begin(), parts.end(),
                   [](const Part& a, const Part& b) { return a.faces.size() > b.faces.size(); });
  std::vector<char> taken(at(surface.faceCount()), 0);
  std::vector<Part> outermost;
  for (Part& part : parts) {
    if (taken[at(part.faces.front())]) continue;
    for (const int f : part.faces) taken[at(f)] = 1;
    outermost.push_back(std::move(part));
  }
  return outermost;
}

// The faces that stay, then one per part.
Faces closedFaces(const TriangleMesh& surface, const std::vector<Part>& parts) {
  std::vector<char> gone(at(surface.faceCount()), 0);
  for (const Part& part : parts) {
    for (const int f : part.faces) gone[at(f)] = 1;
  }
  const auto removed = std::count(gone.begin(), gone.end(), 1);
  Faces faces(surface.faceCount() - removed + static_cast<Eigen::Index>(parts.size()), 3);
  Eigen::Index row = 0;
  for (int f = 0; f < surface.faceCount(); ++f) {
    if (!gone[at(f)]) faces.row(row++) = surface.faces().row(f);
  }
  for (const Part& part : parts) faces.row(row++) << part.rim[0], part.rim[1], part.rim[2];
  return faces;
}

// Renumbers the faces for the vertices that stay, and lists those.
std::vector<int> dropInnerVertices(const std::vector<Part>& parts, int vertexCount, Faces& faces) {
  std::vector<int> id(at(vertexCount), 0), kept;
  for (const Part& part : parts) {
    for (const int v : part.innerVertices) id[at(v)] = -1;
  }
  for (int v = 0; v < vertexCount; ++v) {
    if (id[at(v)] < 0) continue;
    id[at(v)] = static_cast<int>(kept.size());
    kept.push_back(v);
  }
  for (Eigen::Index k = 0; k < faces.size(); ++k) faces.data()[k] = id[at(faces.data()[k])];
  return kept;
}

void requireManifold(const SurfaceTopology& topology) {
  if (topology.manifold()) return;
  throw TopologyError(
      "A consistently oriented manifold surface is required to prune spikes, but there are " +
      std::to_string(topology.nonManifoldEdges().size() + topology.inconsistentEdges().size()) + " bad edges and " +
      std::to_string(topology.nonManifoldVertices().size()) + " bad vertices; repair the surface first.");
}

}  // namespace

PrunedSurface pruneSpikes(const TriangleMesh& surface, double largestShare, const Execution& execution) {
  if (!(largestShare >= 0 && largestShare < 0.5)) {
    throw InvalidArgument("The largest share of a spike must lie in [0, 0.5), but it is " +
                          std::to_string(largestShare) + ".");
  }
  const SurfaceTopology topology(surface.faces(), surface.vertexCount());
  requireManifold(topology);
  const Eigen::VectorXd areas = faceAreas(surface);
  const std::vector<Part> parts =
      outermostParts(surface, topology, largestShare * areas.sum(), areas, execution);
  PrunedSurface out;
  out.spikes = static_cast<int>(parts.size());
  Faces faces = closedFaces(surface, parts);
  out.removedFaces = surface.faceCount() + out.spikes - static_cast<int>(faces.rows());
  out.originalPointIds = dropInnerVertices(parts, surface.vertexCount(), faces);
  Points3 points(static_cast<Eigen::Index>(out.originalPointIds.size()), 3);
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    points.row(i) = surface.points().row(out.originalPointIds[static_cast<std::size_t>(i)]);
  }
  out.mesh = TriangleMesh(std::move(points), std::move(faces));
  out.removedArea = areas.sum() - faceAreas(out.mesh).sum();
  return out;
}

}  // namespace authalic
