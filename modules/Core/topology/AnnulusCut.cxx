#include "Core/topology/AnnulusCut.h"

#include <algorithm>
#include <limits>
#include <queue>
#include <utility>

#include "Core/base/Error.h"

namespace authalic {
namespace {

// First half-edge that leaves each vertex, the boundary's one where there is one: turning from it sweeps the whole
// fan.
std::vector<int> leavingHalfEdges(const SurfaceTopology& topology) {
  std::vector<int> leaving(static_cast<std::size_t>(topology.vertexCount()), -1);
  for (int h = 0; h < static_cast<int>(3 * topology.faces().rows()); ++h) {
    int& first = leaving[static_cast<std::size_t>(topology.tail(h))];
    if (first < 0 || topology.opposite(h) < 0) first = h;
  }
  return leaving;
}

// Counter-clockwise neighbour around the tail, −1 at the boundary.
int turn(const SurfaceTopology& topology, int h) { return topology.opposite(SurfaceTopology::previous(h)); }

std::vector<int> shortestPath(const TriangleMesh& mesh, const SurfaceTopology& topology, const std::vector<int>& from,
                              const std::vector<int>& to) {
  const auto n = static_cast<std::size_t>(mesh.vertexCount());
  std::vector<double> distance(n, std::numeric_limits<double>::infinity());
  std::vector<int> before(n, -1);
  std::vector<char> target(n, 0);
  for (const int v : to) target[static_cast<std::size_t>(v)] = 1;
  using Entry = std::pair<double, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  for (const int v : from) {
    distance[static_cast<std::size_t>(v)] = 0;
    queue.push({0, v});
  }
  const std::vector<int> leaving = leavingHalfEdges(topology);
  while (!queue.empty()) {
    const auto [so_far, v] = queue.top();
    queue.pop();
    if (so_far > distance[static_cast<std::size_t>(v)]) continue;
    if (target[static_cast<std::size_t>(v)]) {
      std::vector<int> path;
      for (int at = v; at >= 0; at = before[static_cast<std::size_t>(at)]) path.push_back(at);
      std::reverse(path.begin(), path.end());
      return path;
    }
    const auto reach = [&, here = v, length = so_far](int w) {
      const double longer = length + (mesh.point(w) - mesh.point(here)).norm();
      if (!(longer < distance[static_cast<std::size_t>(w)])) return;
      distance[static_cast<std::size_t>(w)] = longer;
      before[static_cast<std::size_t>(w)] = here;
      queue.push({longer, w});
    };
    const int start = leaving[static_cast<std::size_t>(v)];
    for (int h = start; h >= 0;) {
      reach(topology.head(h));
      const int next = turn(topology, h);
      if (next < 0) reach(topology.tail(SurfaceTopology::previous(h)));  // the last edge of a boundary fan
      h = next == start ? -1 : next;
    }
  }
  throw TopologyError("Two loops of one connected surface are required, but no path of edges leads from one to the other.");
}

int halfEdgeBetween(const SurfaceTopology& topology, int start, int head) {
  for (int h = start; h >= 0;) {
    if (topology.head(h) == head) return h;
    const int next = turn(topology, h);
    h = next == start ? -1 : next;
  }
  return -1;
}

// Corners at a path vertex swept counter-clockwise from h until `end` leaves it or the boundary comes.
void sweep(const SurfaceTopology& topology, int h, int end, char value, std::vector<char>& onRight) {
  for (const int start = h; h >= 0 && topology.head(h) != end;) {
    onRight[static_cast<std::size_t>(h)] = value;
    h = turn(topology, h);
    if (h == start) break;
  }
}

}  // namespace

AnnulusCut cutAnnulus(const TriangleMesh& mesh, const SurfaceTopology& topology, const std::vector<int>& from,
                      const std::vector<int>& to) {
  AnnulusCut cut;
  cut.path = shortestPath(mesh, topology, from, to);
  const auto corners = static_cast<std::size_t>(3 * mesh.faceCount());
  cut.onRight.assign(corners, 0);
  const std::vector<int> leaving = leavingHalfEdges(topology);
  // The right side of a path vertex is swept from the edge back along the path to the edge ahead; that of the first
  // vertex starts at the boundary.
  for (std::size_t k = 0; k < cut.path.size(); ++k) {
    const int v = cut.path[k], start = leaving[static_cast<std::size_t>(v)];
    const int ahead = k + 1 < cut.path.size() ? cut.path[k + 1] : -1;
    const int h = k == 0 ? start : halfEdgeBetween(topology, start, cut.path[k - 1]);
    sweep(topology, h, ahead, 1, cut.onRight);
  }
  cut.winding.resize(corners);
  for (std::size_t h = 0; h < corners; ++h) {
    const auto next = static_cast<std::size_t>(SurfaceTopology::next(static_cast<int>(h)));
    cut.winding[h] = cut.onRight[next] - cut.onRight[h];
  }
  return cut;
}

CutFaces openAlong(const Faces& faces, int vertexCount, const AnnulusCut& cut) {
  CutFaces open{faces, {}};
  open.originalPointIds.resize(static_cast<std::size_t>(vertexCount));
  for (int v = 0; v < vertexCount; ++v) open.originalPointIds[static_cast<std::size_t>(v)] = v;
  std::vector<int> copy(static_cast<std::size_t>(vertexCount), -1);
  for (std::size_t k = 0; k < cut.path.size(); ++k) {
    copy[static_cast<std::size_t>(cut.path[k])] = vertexCount + static_cast<int>(k);
    open.originalPointIds.push_back(cut.path[k]);
  }
  for (std::size_t c = 0; c < cut.onRight.size(); ++c) {
    if (cut.onRight[c]) open.faces.data()[c] = copy[static_cast<std::size_t>(faces.data()[c])];
  }
  return open;
}

}  // namespace authalic
