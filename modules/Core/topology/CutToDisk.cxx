#include "Core/topology/CutToDisk.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "Core/base/Error.h"
#include "Core/mesh/DiskMesh.h"
#include "Core/mesh/SurfaceTopology.h"

namespace authalic {

namespace {

using Flags = std::vector<char>;

Eigen::VectorXd faceAreas(const TriangleMesh& mesh) {
  Eigen::VectorXd areas(mesh.faceCount());
  for (int f = 0; f < mesh.faceCount(); ++f) {
    const Eigen::Vector3d a = mesh.corner(f, 0);
    areas[f] = 0.5 * (mesh.corner(f, 1) - a).cross(mesh.corner(f, 2) - a).norm();
  }
  return areas;
}

void requireUsableFlags(const TriangleMesh& surface, const Flags& remove) {
  if (static_cast<int>(remove.size()) != surface.vertexCount()) {
    throw GeometryError("One removal flag per vertex is required: the surface has " +
                        std::to_string(surface.vertexCount()) + " vertices, but there are " +
                        std::to_string(remove.size()) + " flags.");
  }
  const auto marked = std::count_if(remove.begin(), remove.end(), [](char flag) { return flag != 0; });
  if (marked == 0) {
    throw GeometryError("A region to remove is required, but no vertex is marked; check the label, array or plane.");
  }
  if (marked == static_cast<std::ptrdiff_t>(remove.size())) {
    throw GeometryError("Some surface must be left, but every vertex is marked for removal; invert the region.");
  }
}

/// Averages the indicator over vertex neighbours (the vertex itself counting as much as all of them) and cuts at ½.
Flags smoothRegion(const TriangleMesh& surface, const Flags& remove, int passes) {
  const int n = surface.vertexCount();
  Eigen::VectorXd value(n), sum(n), weight(n);
  for (int i = 0; i < n; ++i) value[i] = remove[static_cast<std::size_t>(i)] ? 1.0 : 0.0;
  for (int pass = 0; pass < passes; ++pass) {
    sum.setZero();
    weight.setZero();
    for (int f = 0; f < surface.faceCount(); ++f) {
      for (int k = 0; k < 3; ++k) {
        const int a = surface.faces()(f, k), b = surface.faces()(f, (k + 1) % 3);
        sum[a] += value[b];
        sum[b] += value[a];
        weight[a] += 1;
        weight[b] += 1;
      }
    }
    for (int i = 0; i < n; ++i) {
      if (weight[i] > 0) value[i] = 0.5 * (value[i] + sum[i] / weight[i]);
    }
  }
  Flags smooth(remove.size());
  for (int i = 0; i < n; ++i) smooth[static_cast<std::size_t>(i)] = value[i] > 0.5;
  const bool survived = std::find(smooth.begin(), smooth.end(), 1) != smooth.end() &&
                        std::find(smooth.begin(), smooth.end(), 0) != smooth.end();
  return survived ? smooth : remove;
}

/// Connected pieces of the marked vertices; returns their count and numbers them in `piece` (−1 = unmarked).
int numberPieces(const TriangleMesh& surface, const Flags& marked, std::vector<int>& piece) {
  const auto n = static_cast<std::size_t>(surface.vertexCount());
  std::vector<std::vector<int>> neighbours(n);
  for (int f = 0; f < surface.faceCount(); ++f) {
    for (int k = 0; k < 3; ++k) {
      const int a = surface.faces()(f, k), b = surface.faces()(f, (k + 1) % 3);
      if (!marked[static_cast<std::size_t>(a)] || !marked[static_cast<std::size_t>(b)]) continue;
      neighbours[static_cast<std::size_t>(a)].push_back(b);
      neighbours[static_cast<std::size_t>(b)].push_back(a);
    }
  }
  piece.assign(n, -1);
  int count = 0;
  for (std::size_t seed = 0; seed < n; ++seed) {
    if (!marked[seed] || piece[seed] >= 0) continue;
    std::vector<std::size_t> front{seed};
    piece[seed] = count;
    while (!front.empty()) {
      const std::size_t at = front.back();
      front.pop_back();
      for (const int other : neighbours[at]) {
        const auto next = static_cast<std::size_t>(other);
        if (piece[next] >= 0) continue;
        piece[next] = count;
        front.push_back(next);
      }
    }
    ++count;
  }
  return count;
}

/// Unmarks all but the piece with the largest surrounding area; returns how many pieces were unmarked.
int keepLargestPiece(const TriangleMesh& surface, const Eigen::VectorXd& areas, const std::vector<int>& piece,
                     int count, Flags& marked) {
  std::vector<double> size(static_cast<std::size_t>(count), 0.0);
  for (int f = 0; f < surface.faceCount(); ++f) {
    for (int k = 0; k < 3; ++k) {
      const int id = piece[static_cast<std::size_t>(surface.faces()(f, k))];
      if (id >= 0) size[static_cast<std::size_t>(id)] += areas[f];
    }
  }
  const int largest = static_cast<int>(std::max_element(size.begin(), size.end()) - size.begin());
  for (std::size_t i = 0; i < marked.size(); ++i) marked[i] = piece[i] == largest;
  return count - 1;
}

/// Faces connected over edges, among those still kept. Keeps only the component of largest area.
/// Returns the number of components that were dropped.
int keepLargestComponent(const SurfaceTopology& topology, const Eigen::VectorXd& areas, Flags& kept) {
  std::vector<int> component(kept.size(), -1);
  std::vector<double> size;
  for (std::size_t seed = 0; seed < kept.size(); ++seed) {
    if (!kept[seed] || component[seed] >= 0) continue;
    const int id = static_cast<int>(size.size());
    size.push_back(0);
    std::vector<int> front{static_cast<int>(seed)};
    component[seed] = id;
    while (!front.empty()) {
      const int f = front.back();
      front.pop_back();
      size.back() += areas[f];
      for (int k = 0; k < 3; ++k) {
        const int across = topology.opposite(3 * f + k);
        if (across < 0) continue;
        const auto g = static_cast<std::size_t>(across / 3);
        if (!kept[g] || component[g] >= 0) continue;
        component[g] = id;
        front.push_back(across / 3);
      }
    }
  }
  if (size.empty()) return 0;
  const int largest = static_cast<int>(std::max_element(size.begin(), size.end()) - size.begin());
  for (std::size_t f = 0; f < kept.size(); ++f) kept[f] = component[f] == largest;
  return static_cast<int>(size.size()) - 1;
}

/// The kept faces around one vertex as fans (runs of faces joined over edges), found from the half-edges leaving it.
std::vector<std::vector<int>> keptFans(const SurfaceTopology& topology, const Flags& kept,
                                       const std::vector<int>& outgoing) {
  std::vector<std::vector<int>> fans;
  std::vector<int> pending;
  for (const int h : outgoing) {
    if (kept[static_cast<std::size_t>(h / 3)]) pending.push_back(h);
  }
  while (!pending.empty()) {
    std::vector<int> fan{pending.back()};
    pending.pop_back();
    for (std::size_t at = 0; at < fan.size(); ++at) {
      const int left = topology.opposite(SurfaceTopology::previous(fan[at]));
      const int across = topology.opposite(fan[at]);
      const int right = across < 0 ? -1 : SurfaceTopology::next(across);
      for (const int candidate : {left, right}) {
        const auto found = std::find(pending.begin(), pending.end(), candidate);
        if (found == pending.end()) continue;
        fan.push_back(candidate);
        pending.erase(found);
      }
    }
    fans.push_back(std::move(fan));
  }
  return fans;
}

/// Where the kept surface touches itself in a vertex, removes all fans but the largest. Returns whether any was.
bool openPinchedVertices(const SurfaceTopology& topology, Flags& kept) {
  std::vector<std::vector<int>> outgoing(static_cast<std::size_t>(topology.vertexCount()));
  for (int h = 0; h < static_cast<int>(3 * kept.size()); ++h) {
    outgoing[static_cast<std::size_t>(topology.tail(h))].push_back(h);
  }
  bool changed = false;
  for (const std::vector<int>& around : outgoing) {
    const auto fans = keptFans(topology, kept, around);
    if (fans.size() < 2) continue;
    const auto largest = std::max_element(fans.begin(), fans.end(),
                                          [](const auto& a, const auto& b) { return a.size() < b.size(); });
    for (auto fan = fans.begin(); fan != fans.end(); ++fan) {
      if (fan == largest) continue;
      for (const int h : *fan) kept[static_cast<std::size_t>(h / 3)] = 0;
      changed = true;
    }
  }
  return changed;
}

CutToDiskResult extractKept(const TriangleMesh& surface, const Eigen::VectorXd& areas, const Flags& kept) {
  CutToDiskResult result;
  std::vector<int> number(static_cast<std::size_t>(surface.vertexCount()), -1);
  for (int f = 0; f < surface.faceCount(); ++f) {
    if (!kept[static_cast<std::size_t>(f)]) {
      result.removedArea += areas[f];
      continue;
    }
    result.keptArea += areas[f];
    result.originalFaceIds.push_back(f);
    for (int k = 0; k < 3; ++k) number[static_cast<std::size_t>(surface.faces()(f, k))] = 0;
  }
  for (std::size_t i = 0; i < number.size(); ++i) {
    if (number[i] < 0) continue;
    number[i] = static_cast<int>(result.originalPointIds.size());
    result.originalPointIds.push_back(static_cast<int>(i));
  }
  Points3 points(static_cast<Eigen::Index>(result.originalPointIds.size()), 3);
  for (std::size_t i = 0; i < result.originalPointIds.size(); ++i) {
    points.row(static_cast<Eigen::Index>(i)) = surface.points().row(result.originalPointIds[i]);
  }
  Faces faces(static_cast<Eigen::Index>(result.originalFaceIds.size()), 3);
  for (std::size_t f = 0; f < result.originalFaceIds.size(); ++f) {
    for (int k = 0; k < 3; ++k) {
      faces(static_cast<Eigen::Index>(f), k) =
          number[static_cast<std::size_t>(surface.faces()(result.originalFaceIds[f], k))];
    }
  }
  result.mesh = TriangleMesh(std::move(points), std::move(faces));
  return result;
}

double loopLength(const DiskMesh& disk) {
  double length = 0;
  const std::vector<int>& loop = disk.boundary();
  for (std::size_t i = 0; i < loop.size(); ++i) {
    length += (disk.mesh().point(loop[(i + 1) % loop.size()]) - disk.mesh().point(loop[i])).norm();
  }
  return length;
}

}  // namespace

void CutToDiskOptions::validate() const {
  if (loopSmoothing < 0) {
    throw InvalidArgument("A non-negative number of loop smoothing passes is required, but it is " +
                          std::to_string(loopSmoothing) + ".");
  }
}

CutToDiskResult cutToDisk(const TriangleMesh& surface, const std::vector<char>& remove, const CutToDiskOptions& options,
                          const Execution& execution) {
  options.validate();
  requireUsableFlags(surface, remove);
  execution.report(0.0, "cut");
  const SurfaceTopology topology(surface.faces(), surface.vertexCount());
  const Eigen::VectorXd areas = faceAreas(surface);
  Flags marked = smoothRegion(surface, remove, options.loopSmoothing);
  std::vector<int> piece;
  int regions = numberPieces(surface, marked, piece), ignored = 0;
  if (options.largestRegionOnly) {
    ignored = keepLargestPiece(surface, areas, piece, regions, marked);
    regions = 1;
  }
  execution.report(0.4, "cut");
  execution.throwIfCancelled();
  Flags kept(static_cast<std::size_t>(surface.faceCount()), 1);
  for (int h = 0; h < 3 * surface.faceCount(); ++h) {
    if (marked[static_cast<std::size_t>(topology.tail(h))]) kept[static_cast<std::size_t>(h / 3)] = 0;
  }
  if (std::find(kept.begin(), kept.end(), 1) == kept.end()) {
    throw GeometryError("Some surface must be left, but every face touches the region to remove.");
  }
  int islands = 0;
  do {
    islands += keepLargestComponent(topology, areas, kept);
    execution.throwIfCancelled();
  } while (openPinchedVertices(topology, kept));
  execution.report(0.8, "cut");
  CutToDiskResult result = extractKept(surface, areas, kept);
  result.loopLength = loopLength(DiskMesh(result.mesh));
  result.removedRegions = regions;
  result.ignoredRegions = ignored;
  result.filledIslands = islands;
  execution.report(1.0, "cut");
  return result;
}

std::vector<char> verticesBeyondPlane(const TriangleMesh& surface, const Eigen::Vector3d& origin,
                                      const Eigen::Vector3d& normal) {
  if (!origin.allFinite() || !normal.allFinite() || !(normal.norm() > 0)) {
    throw InvalidArgument("A finite plane with a normal that is not zero is required.");
  }
  std::vector<char> beyond(static_cast<std::size_t>(surface.vertexCount()));
  for (int i = 0; i < surface.vertexCount(); ++i) {
    beyond[static_cast<std::size_t>(i)] = (surface.point(i) - origin).dot(normal) > 0;
  }
  return beyond;
}

}  // namespace authalic
