#include "Core/mesh/HandleLoop.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

namespace authalic {
namespace {

struct Edge {
  int a, b;             // a < b
  int left, right;      // faces or caps, -1 until found
  int walk = 0;         // edges of the walk root – a – b – root
};

/// Every edge with the two faces beside it; beyond a boundary edge lies the cap of its loop, numbered after the
/// faces.
std::vector<Edge> edgesWithSides(const TriangleMesh& mesh, const SurfaceTopology& topology) {
  std::vector<int> cap(static_cast<std::size_t>(mesh.vertexCount()), -1);
  for (std::size_t k = 0; k < topology.boundaryLoops().size(); ++k) {
    for (const int v : topology.boundaryLoops()[k]) {
      cap[static_cast<std::size_t>(v)] = mesh.faceCount() + static_cast<int>(k);
    }
  }
  std::map<std::pair<int, int>, std::pair<int, int>> sides;
  for (int f = 0; f < mesh.faceCount(); ++f) {
    for (int k = 0; k < 3; ++k) {
      const auto key = std::minmax({mesh.faces()(f, k), mesh.faces()(f, (k + 1) % 3)});
      const auto [entry, isNew] = sides.emplace(key, std::pair(f, -1));
      if (!isNew) entry->second.second = f;
    }
  }
  std::vector<Edge> edges;
  for (const auto& [ends, faces] : sides) {
    const int right = faces.second < 0 ? cap[static_cast<std::size_t>(ends.first)] : faces.second;
    edges.push_back({ends.first, ends.second, faces.first, right});
  }
  return edges;
}

/// Breadth-first tree of the vertices from vertex 0.
struct Tree {
  std::vector<int> parent, depth;

  Tree(const std::vector<Edge>& edges, int vertices)
      : parent(static_cast<std::size_t>(vertices), -1), depth(static_cast<std::size_t>(vertices), -1) {
    std::vector<std::vector<int>> neighbours(static_cast<std::size_t>(vertices));
    for (const Edge& edge : edges) {
      neighbours[static_cast<std::size_t>(edge.a)].push_back(edge.b);
      neighbours[static_cast<std::size_t>(edge.b)].push_back(edge.a);
    }
    std::vector<int> queue{0};
    depth[0] = 0;
    for (std::size_t at = 0; at < queue.size(); ++at) {
      for (const int next : neighbours[static_cast<std::size_t>(queue[at])]) {
        if (depth[static_cast<std::size_t>(next)] >= 0) continue;
        depth[static_cast<std::size_t>(next)] = depth[static_cast<std::size_t>(queue[at])] + 1;
        parent[static_cast<std::size_t>(next)] = queue[at];
        queue.push_back(next);
      }
    }
  }

  [[nodiscard]] int depthOf(int v) const { return depth[static_cast<std::size_t>(v)]; }
  [[nodiscard]] int parentOf(int v) const { return parent[static_cast<std::size_t>(v)]; }
  [[nodiscard]] bool has(const Edge& edge) const { return parentOf(edge.a) == edge.b || parentOf(edge.b) == edge.a; }

  /// The walk along the tree from b to a, which the edge closes.
  [[nodiscard]] std::vector<int> loopOf(const Edge& edge) const {
    std::vector<int> fromB{edge.b}, toA{edge.a};
    while (fromB.back() != toA.back()) {
      std::vector<int>& deeper = depthOf(fromB.back()) > depthOf(toA.back()) ? fromB : toA;
      deeper.push_back(parentOf(deeper.back()));
    }
    fromB.insert(fromB.end(), toA.rbegin() + 1, toA.rend());
    return fromB;
  }
};

/// Disjoint sets of faces and caps.
class Sets {
 public:
  explicit Sets(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0); }
  /// Whether the two were apart.
  bool join(int a, int b) {
    const int here = find(a), there = find(b);
    parent_[static_cast<std::size_t>(here)] = there;
    return here != there;
  }

 private:
  int find(int a) {
    while (parent_[static_cast<std::size_t>(a)] != a) {
      int& up = parent_[static_cast<std::size_t>(a)];
      up = parent_[static_cast<std::size_t>(up)];
      a = up;
    }
    return a;
  }
  std::vector<int> parent_;
};

}  // namespace

std::vector<int> handleLoop(const TriangleMesh& mesh, const SurfaceTopology& topology) {
  std::vector<Edge> edges = edgesWithSides(mesh, topology);
  const Tree tree(edges, mesh.vertexCount());
  edges.erase(std::remove_if(edges.begin(), edges.end(), [&](const Edge& edge) { return tree.has(edge); }),
              edges.end());
  for (Edge& edge : edges) edge.walk = tree.depthOf(edge.a) + tree.depthOf(edge.b) + 1;
  std::stable_sort(edges.begin(), edges.end(), [](const Edge& e, const Edge& f) { return e.walk > f.walk; });
  Sets sets(static_cast<std::size_t>(mesh.faceCount()) + topology.boundaryLoops().size());
  std::vector<int> shortest;
  for (const Edge& edge : edges) {  // long walks go into the tree of the faces; what it does not take generates
    if (sets.join(edge.left, edge.right)) continue;
    std::vector<int> loop = tree.loopOf(edge);
    if (shortest.empty() || loop.size() < shortest.size()) shortest = std::move(loop);
  }
  return shortest;
}

}  // namespace authalic
