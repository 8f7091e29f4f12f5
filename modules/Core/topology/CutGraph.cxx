#include "Core/topology/CutGraph.h"

#include <limits>
#include <numeric>
#include <queue>
#include <string>
#include <utility>

#include "Core/base/Error.h"

namespace authalic {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

struct Tree {
  std::vector<double> distance;  // from the root, mm
  std::vector<char> edges;       // per half-edge: 1 in the tree
};

// Half-edges that leave each vertex, one after the other.
std::vector<std::vector<int>> leavingHalfEdges(const SurfaceTopology& topology) {
  std::vector<std::vector<int>> leaving(at(topology.vertexCount()));
  for (int h = 0; h < 3 * static_cast<int>(topology.faces().rows()); ++h) leaving[at(topology.tail(h))].push_back(h);
  return leaving;
}

double lengthOf(const TriangleMesh& mesh, const SurfaceTopology& topology, int h) {
  return (mesh.point(topology.head(h)) - mesh.point(topology.tail(h))).norm();
}

Tree shortestPaths(const TriangleMesh& mesh, const SurfaceTopology& topology, int root) {
  const std::vector<std::vector<int>> leaving = leavingHalfEdges(topology);
  Tree tree{std::vector<double>(at(mesh.vertexCount()), std::numeric_limits<double>::infinity()),
            std::vector<char>(at(3 * mesh.faceCount()), 0)};
  std::vector<int> arrival(at(mesh.vertexCount()), -1);
  using Entry = std::pair<double, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  tree.distance[at(root)] = 0;
  for (queue.push({0, root}); !queue.empty();) {
    const auto [soFar, v] = queue.top();
    queue.pop();
    if (soFar > tree.distance[at(v)]) continue;
    for (const int h : leaving[at(v)]) {
      const int w = topology.head(h);
      const double longer = soFar + lengthOf(mesh, topology, h);
      if (!(longer < tree.distance[at(w)])) continue;
      tree.distance[at(w)] = longer;
      arrival[at(w)] = h;
      queue.push({longer, w});
    }
  }
  for (const int h : arrival) {
    if (h >= 0) tree.edges[at(h)] = tree.edges[at(topology.opposite(h))] = 1;
  }
  return tree;
}

// For every face the half-edge, in the face before it, across which the cotree reaches it; −1 for face 0. Edges that
// would close long loops come first.
std::vector<int> growCotree(const TriangleMesh& mesh, const SurfaceTopology& topology, const Tree& tree) {
  std::vector<int> entry(at(mesh.faceCount()), -1);
  std::vector<char> reached(at(mesh.faceCount()), 0);
  std::priority_queue<std::pair<double, int>> queue;
  const auto reach = [&](int f) {
    reached[at(f)] = 1;
    for (int h = 3 * f; h < 3 * f + 3; ++h) {
      if (tree.edges[at(h)] || reached[at(topology.opposite(h) / 3)]) continue;
      const double loop = tree.distance[at(topology.tail(h))] + tree.distance[at(topology.head(h))] +
                          lengthOf(mesh, topology, h);
      queue.push({loop, -h});
    }
  };
  for (reach(0); !queue.empty();) {
    const int h = -queue.top().second, f = topology.opposite(h) / 3;
    queue.pop();
    if (reached[at(f)]) continue;
    entry[at(f)] = h;
    reach(f);
  }
  return entry;
}

// The closed 1-form that counts crossings of the loop of faces which crosses h and returns through the cotree.
std::vector<int> crossingForm(const SurfaceTopology& topology, const std::vector<int>& entry, int h) {
  std::vector<int> form(at(3 * static_cast<int>(topology.faces().rows())), 0);
  const auto cross = [&](int from) {
    ++form[at(from)];
    --form[at(topology.opposite(from))];
  };
  cross(h);
  for (int f = topology.opposite(h) / 3; entry[at(f)] >= 0; f = entry[at(f)] / 3)
    cross(topology.opposite(entry[at(f)]));
  for (int f = h / 3; entry[at(f)] >= 0; f = entry[at(f)] / 3) cross(entry[at(f)]);
  return form;
}

// Takes away edges of the cut that end freely, one after the other, but not where they have to end.
void prune(const SurfaceTopology& topology, const std::vector<int>& ends, std::vector<char>& onCut) {
  std::vector<int> valence(at(topology.vertexCount()), 0), free;
  const std::vector<std::vector<int>> leaving = leavingHalfEdges(topology);
  for (int h = 0; h < static_cast<int>(onCut.size()); ++h) valence[at(topology.tail(h))] += onCut[at(h)];
  for (const int v : ends) ++valence[at(v)];
  for (int v = 0; v < topology.vertexCount(); ++v) {
    if (valence[at(v)] == 1) free.push_back(v);
  }
  while (!free.empty()) {
    const int v = free.back();
    free.pop_back();
    for (const int h : leaving[at(v)]) {
      if (!onCut[at(h)]) continue;
      onCut[at(h)] = onCut[at(topology.opposite(h))] = 0;
      --valence[at(v)];
      if (--valence[at(topology.head(h))] == 1) free.push_back(topology.head(h));
    }
  }
}

// One vertex for each run of corners that no edge of the cut divides; a vertex's first run keeps its number.
void splitCorners(const SurfaceTopology& topology, CutGraph& cut) {
  const Faces& faces = topology.faces();
  cut.faces = Faces::Constant(faces.rows(), 3, -1);
  cut.originalPointIds.resize(at(topology.vertexCount()));
  std::iota(cut.originalPointIds.begin(), cut.originalPointIds.end(), 0);
  std::vector<char> used(at(topology.vertexCount()), 0);
  for (int corner = 0; corner < 3 * static_cast<int>(faces.rows()); ++corner) {
    if (cut.faces.data()[corner] >= 0) continue;
    const int v = topology.tail(corner);
    const int number = used[at(v)] ? static_cast<int>(cut.originalPointIds.size()) : v;
    if (used[at(v)]) cut.originalPointIds.push_back(v);
    used[at(v)] = 1;
    for (int h = corner; cut.faces.data()[h] < 0;) {  // counter-clockwise
      cut.faces.data()[h] = number;
      const int side = SurfaceTopology::previous(h);
      if (cut.onCut[at(side)]) break;
      h = topology.opposite(side);
    }
    for (int h = corner; !cut.onCut[at(h)];) {  // clockwise
      h = SurfaceTopology::next(topology.opposite(h));
      if (cut.faces.data()[h] >= 0) break;
      cut.faces.data()[h] = number;
    }
  }
}

// Sums the forms from corner to corner over the disk.
void integrate(const SurfaceTopology& topology, const std::vector<std::vector<int>>& forms, CutGraph& cut) {
  const int m = static_cast<int>(topology.faces().rows());
  cut.windings = Eigen::MatrixXi::Zero(3 * m, static_cast<Eigen::Index>(forms.size()));
  const auto goRound = [&](int corner) {  // from a corner whose row is known to the other two of its face
    for (int step = 0; step < 2; ++step) {
      const int next = SurfaceTopology::next(corner);
      for (std::size_t k = 0; k < forms.size(); ++k) {
        const auto column = static_cast<Eigen::Index>(k);
        cut.windings(next, column) = cut.windings(corner, column) + forms[k][at(corner)];
      }
      corner = next;
    }
  };
  std::vector<char> reached(at(m), 0);
  std::vector<int> queue{0};
  reached[0] = 1;
  goRound(0);
  for (std::size_t next = 0; next < queue.size(); ++next) {
    for (int h = 3 * queue[next]; h < 3 * queue[next] + 3; ++h) {
      const int across = topology.opposite(h), f = across / 3;
      if (cut.onCut[at(h)] || reached[at(f)]) continue;
      reached[at(f)] = 1;
      cut.windings.row(across) = cut.windings.row(SurfaceTopology::next(h));
      goRound(across);
      queue.push_back(f);
    }
  }
}

}  // namespace

CutGraph cutToFundamentalDomain(const TriangleMesh& mesh, const SurfaceTopology& topology, int root,
                                const std::vector<int>& ends) {
  if (!topology.boundaryLoops().empty() || topology.componentCount() != 1) {
    throw TopologyError("A connected surface without boundary is required, but it has " +
                        std::to_string(topology.componentCount()) + " components and " +
                        std::to_string(topology.boundaryLoops().size()) + " boundary loops.");
  }
  const Tree tree = shortestPaths(mesh, topology, root);
  const std::vector<int> entry = growCotree(mesh, topology, tree);
  std::vector<char> inCotree(at(3 * mesh.faceCount()), 0);
  for (const int h : entry) {
    if (h >= 0) inCotree[at(h)] = inCotree[at(topology.opposite(h))] = 1;
  }
  CutGraph cut;
  cut.onCut.resize(inCotree.size());
  std::vector<std::vector<int>> forms;
  for (int h = 0; h < 3 * mesh.faceCount(); ++h) {
    cut.onCut[at(h)] = !inCotree[at(h)];
    const bool generates = !inCotree[at(h)] && !tree.edges[at(h)];
    if (generates && h < topology.opposite(h)) forms.push_back(crossingForm(topology, entry, h));
  }
  cut.genus = static_cast<int>(forms.size() / 2);
  prune(topology, ends, cut.onCut);
  splitCorners(topology, cut);
  integrate(topology, forms, cut);
  return cut;
}

}  // namespace authalic
