#include "Core/topology/ShortestHandleLoop.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <queue>
#include <set>
#include <utility>

namespace authalic {
namespace {

std::size_t at(int index) { return static_cast<std::size_t>(index); }

struct Edge {
  int a, b;         // vertices
  int left, right;  // faces, or caps of boundary loops numbered after them
  double length;
  std::uint64_t crossings = 0;  // bit i: crossed by the i-th dual loop
  bool inTree = false;
};

using Step = std::pair<int, int>;  // neighbour, edge

/// Edges of the capped surface and what lies around every vertex.
struct Graph {
  std::vector<Edge> edges;
  std::vector<std::vector<Step>> around;
  int nodes = 0;  // faces and caps

  Graph(const TriangleMesh& mesh, const SurfaceTopology& topology) : around(at(mesh.vertexCount())) {
    std::vector<int> cap(at(mesh.vertexCount()), -1);
    nodes = mesh.faceCount();
    for (const std::vector<int>& loop : topology.boundaryLoops()) {
      for (const int v : loop) cap[at(v)] = nodes;
      ++nodes;
    }
    for (int h = 0; h < 3 * mesh.faceCount(); ++h) {
      const int g = topology.opposite(h), a = topology.tail(h), b = topology.head(h);
      if (g >= 0 && g < h) continue;
      const int id = static_cast<int>(edges.size());
      edges.push_back({a, b, h / 3, g < 0 ? cap[at(a)] : g / 3, (mesh.point(b) - mesh.point(a)).norm()});
      around[at(a)].emplace_back(b, id);
      around[at(b)].emplace_back(a, id);
    }
  }
};

/// Shortest paths from one vertex at a time, forgotten when the next starts.
class Paths {
 public:
  explicit Paths(const Graph& graph)
      : graph_(graph), distance_(graph.around.size(), HUGE_VAL), parent_(graph.around.size(), -1),
        parentEdge_(graph.around.size(), -1), crossings_(graph.around.size(), 0) {}

  /// Vertices within `radius` of the root, nearest first; those marked in `closed` are not entered.
  const std::vector<int>& grow(int root, double radius, const std::vector<char>& closed) {
    forget();
    std::priority_queue<std::pair<double, int>, std::vector<std::pair<double, int>>, std::greater<>> queue;
    distance_[at(root)] = 0;
    touched_.push_back(root);
    queue.emplace(0.0, root);
    while (!queue.empty()) {
      const auto [d, v] = queue.top();
      queue.pop();
      if (d > distance_[at(v)]) continue;
      settled_.push_back(v);
      for (const auto& [w, e] : graph_.around[at(v)]) {
        const double there = d + graph_.edges[at(e)].length;
        if (!(there < distance_[at(w)]) || there > radius || closed[at(w)]) continue;
        if (distance_[at(w)] == HUGE_VAL) touched_.push_back(w);
        distance_[at(w)] = there;
        parent_[at(w)] = v;
        parentEdge_[at(w)] = e;
        crossings_[at(w)] = crossings_[at(v)] ^ graph_.edges[at(e)].crossings;
        queue.emplace(there, w);
      }
    }
    return settled_;
  }
  [[nodiscard]] double distance(int v) const { return distance_[at(v)]; }
  [[nodiscard]] int parentEdge(int v) const { return parentEdge_[at(v)]; }
  [[nodiscard]] std::uint64_t crossings(int v) const { return crossings_[at(v)]; }

  /// The two paths from the ends of an edge to where they meet, as one cycle.
  [[nodiscard]] std::vector<int> cycle(const Edge& edge) const {
    std::vector<int> fromA = pathTo(edge.a), fromB = pathTo(edge.b);
    while (fromA.size() > 1 && fromB.size() > 1 && fromA[fromA.size() - 2] == fromB[fromB.size() - 2]) {
      fromA.pop_back();
      fromB.pop_back();
    }
    fromA.insert(fromA.end(), fromB.rbegin() + 1, fromB.rend());
    return fromA;
  }

 private:
  [[nodiscard]] std::vector<int> pathTo(int v) const {
    std::vector<int> path;
    for (; v >= 0; v = parent_[at(v)]) path.push_back(v);
    return path;
  }
  void forget() {
    for (const int v : touched_) {
      distance_[at(v)] = HUGE_VAL;
      parent_[at(v)] = parentEdge_[at(v)] = -1;
      crossings_[at(v)] = 0;
    }
    touched_.clear();
    settled_.clear();
  }

  const Graph& graph_;
  std::vector<double> distance_;
  std::vector<int> parent_, parentEdge_, touched_, settled_;
  std::vector<std::uint64_t> crossings_;
};

/// Spanning trees of the faces and caps.
class DualTree {
 public:
  explicit DualTree(int nodes) : set_(at(nodes)), around_(at(nodes)), up_(at(nodes), {-1, -1}), depth_(at(nodes), -1) {
    std::iota(set_.begin(), set_.end(), 0);
  }
  bool add(const Edge& edge, int id) {
    const int here = find(edge.left), there = find(edge.right);
    if (here == there) return false;
    set_[at(std::max(here, there))] = std::min(here, there);
    around_[at(edge.left)].emplace_back(edge.right, id);
    around_[at(edge.right)].emplace_back(edge.left, id);
    return true;
  }
  void hang() {
    for (int root = 0; root < static_cast<int>(depth_.size()); ++root) {
      if (depth_[at(root)] >= 0) continue;
      std::vector<int> queue{root};
      depth_[at(root)] = 0;
      for (std::size_t i = 0; i < queue.size(); ++i) {
        for (const auto& [next, id] : around_[at(queue[i])]) {
          if (depth_[at(next)] >= 0) continue;
          depth_[at(next)] = depth_[at(queue[i])] + 1;
          up_[at(next)] = {queue[i], id};
          queue.push_back(next);
        }
      }
    }
  }
  /// Marks what the loop through an edge and the tree crosses.
  void markLoop(int id, std::uint64_t bit, std::vector<Edge>& edges) const {
    int left = edges[at(id)].left, right = edges[at(id)].right;
    edges[at(id)].crossings ^= bit;
    while (left != right) {
      int& deeper = depth_[at(left)] > depth_[at(right)] ? left : right;
      edges[at(up_[at(deeper)].second)].crossings ^= bit;
      deeper = up_[at(deeper)].first;
    }
  }

 private:
  int find(int a) {
    while (set_[at(a)] != a) a = set_[at(a)] = set_[at(set_[at(a)])];
    return a;
  }
  std::vector<int> set_;
  std::vector<std::vector<Step>> around_;
  std::vector<Step> up_;
  std::vector<int> depth_;
};

/// Vertices of the loops that generate the homology; marks the crossings of their duals on the edges.
std::set<int> generate(Graph& graph) {
  Paths paths(graph);
  const std::vector<char> open(graph.around.size(), 0);
  std::vector<double> walk(graph.edges.size(), 0);
  std::vector<char> reached(open);
  std::vector<int> componentRoot(graph.around.size(), -1);
  for (int root = 0; root < static_cast<int>(reached.size()); ++root) {
    if (reached[at(root)] || graph.around[at(root)].empty()) continue;
    for (const int v : paths.grow(root, HUGE_VAL, open)) {
      reached[at(v)] = 1;
      componentRoot[at(v)] = root;
      if (v != root) graph.edges[at(paths.parentEdge(v))].inTree = true;
      for (const auto& step : graph.around[at(v)]) walk[at(step.second)] += paths.distance(v);
    }
  }
  std::vector<int> order;
  for (int e = 0; e < static_cast<int>(graph.edges.size()); ++e) {
    walk[at(e)] += graph.edges[at(e)].length;
    if (!graph.edges[at(e)].inTree) order.push_back(e);
  }
  std::stable_sort(order.begin(), order.end(), [&](int e, int f) { return walk[at(e)] > walk[at(f)]; });
  DualTree dual(graph.nodes);
  std::vector<int> generators;
  for (const int e : order) {
    if (!dual.add(graph.edges[at(e)], e)) generators.push_back(e);
  }
  std::reverse(generators.begin(), generators.end());  // short loops first
  dual.hang();
  std::set<int> vertices;
  int root = -1;
  for (std::size_t i = 0; i < generators.size(); ++i) {
    const Edge edge = graph.edges[at(generators[i])];
    if (i < 64) dual.markLoop(generators[i], std::uint64_t{1} << i, graph.edges);
    if (root != componentRoot[at(edge.a)]) paths.grow(root = componentRoot[at(edge.a)], HUGE_VAL, open);
    for (const int v : paths.cycle(edge)) vertices.insert(v);
  }
  return vertices;
}

double lengthOf(const TriangleMesh& mesh, const std::vector<int>& loop) {
  double length = 0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    length += (mesh.point(loop[(i + 1) % loop.size()]) - mesh.point(loop[i])).norm();
  }
  return length;
}

}  // namespace

NonSeparatingLoop shortestHandleLoop(const TriangleMesh& mesh, const SurfaceTopology& topology,
                                     const Execution& execution) {
  Graph graph(mesh, topology);
  const std::set<int> roots = generate(graph);
  const std::vector<char>& closed = topology.onBoundary();
  Paths paths(graph);
  NonSeparatingLoop best;
  best.length = HUGE_VAL;
  for (const int root : roots) {
    if (closed[at(root)]) continue;
    execution.throwIfCancelled();
    double walk = best.length;
    int closing = -1;
    for (const int v : paths.grow(root, 0.5 * best.length * (1 + 1e-12), closed)) {
      for (const auto& [w, e] : graph.around[at(v)]) {
        const Edge& edge = graph.edges[at(e)];
        const double length = paths.distance(v) + edge.length + paths.distance(w);
        if (!(length < walk) || paths.parentEdge(v) == e || paths.parentEdge(w) == e) continue;
        if ((paths.crossings(v) ^ paths.crossings(w) ^ edge.crossings) == 0) continue;
        walk = length;
        closing = e;
      }
    }
    if (closing < 0) continue;
    std::vector<int> loop = paths.cycle(graph.edges[at(closing)]);
    const double length = lengthOf(mesh, loop);
    if (length < best.length) best = {std::move(loop), length};
  }
  if (best.vertices.empty()) best.length = 0;
  return best;
}

}  // namespace authalic
