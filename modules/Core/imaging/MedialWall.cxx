#include "Core/imaging/MedialWall.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "Core/geometry/Areas.h"
#include "Core/imaging/VolumeFilters.h"

namespace authalic {

namespace {

using Adjacency = std::vector<std::vector<int>>;

Adjacency adjacencyOf(const TriangleMesh& mesh) {
  Adjacency neighbours(static_cast<std::size_t>(mesh.vertexCount()));
  for (int f = 0; f < mesh.faceCount(); ++f) {
    for (int k = 0; k < 3; ++k) {
      neighbours[static_cast<std::size_t>(mesh.faces()(f, k))].push_back(mesh.faces()(f, (k + 1) % 3));
    }
  }
  return neighbours;
}

// Repeated averaging of the indicator, then cut at one half.
void smoothRegion(std::vector<char>& region, const Adjacency& neighbours, int rounds) {
  std::vector<float> value(region.begin(), region.end()), next(value.size());
  for (int round = 0; round < rounds; ++round) {
    for (std::size_t v = 0; v < value.size(); ++v) {
      float sum = value[v];
      for (const int n : neighbours[v]) sum += value[static_cast<std::size_t>(n)];
      next[v] = sum / static_cast<float>(neighbours[v].size() + 1);
    }
    value.swap(next);
  }
  for (std::size_t v = 0; v < value.size(); ++v) region[v] = value[v] > 0.5f;
}

// Flips every vertex of `side` that is not in the component of that side with the largest area.
void keepLargest(std::vector<char>& region, char side, const Adjacency& neighbours,
                 const Eigen::VectorXd& areas) {
  std::vector<int> component(region.size(), -1), front;
  std::vector<double> sizes;
  for (std::size_t seed = 0; seed < region.size(); ++seed) {
    if (region[seed] != side || component[seed] >= 0) continue;
    const int id = static_cast<int>(sizes.size());
    sizes.push_back(0.0);
    component[seed] = id;
    front.assign(1, static_cast<int>(seed));
    while (!front.empty()) {
      const auto v = static_cast<std::size_t>(front.back());
      front.pop_back();
      sizes.back() += areas[static_cast<Eigen::Index>(v)];
      for (const int n : neighbours[v]) {
        const auto u = static_cast<std::size_t>(n);
        if (region[u] != side || component[u] >= 0) continue;
        component[u] = id;
        front.push_back(n);
      }
    }
  }
  if (sizes.empty()) return;
  const int largest = static_cast<int>(std::max_element(sizes.begin(), sizes.end()) - sizes.begin());
  for (std::size_t v = 0; v < region.size(); ++v) {
    if (region[v] == side && component[v] != largest) region[v] = static_cast<char>(!side);
  }
}

}  // namespace

std::vector<char> findMedialWall(const TriangleMesh& mesh, const MaskVolume& sources, double reach,
                                 const Execution& execution) {
  const ScalarVolume distance = distanceTo(sources, execution);
  const Eigen::Matrix4d toVoxel = sources.worldToVoxel();
  std::vector<char> region(static_cast<std::size_t>(mesh.vertexCount()), 0);
  for (std::size_t v = 0; v < region.size(); ++v) {
    const Eigen::Vector3d p = (toVoxel * mesh.point(static_cast<int>(v)).homogeneous()).head<3>();
    const int i = static_cast<int>(std::lround(p[0])), j = static_cast<int>(std::lround(p[1])),
              k = static_cast<int>(std::lround(p[2]));
    region[v] = sources.contains(i, j, k) && distance.at(i, j, k) <= reach;
  }
  const Adjacency neighbours = adjacencyOf(mesh);
  const Eigen::VectorXd areas = vertexStars(faceAreas(mesh), mesh.faces(), mesh.vertexCount());
  smoothRegion(region, neighbours, 40);
  keepLargest(region, 1, neighbours, areas);
  keepLargest(region, 0, neighbours, areas);
  if (std::count(region.begin(), region.end(), 1) == static_cast<std::ptrdiff_t>(region.size()))
    std::fill(region.begin(), region.end(), 0);
  return region;
}

double regionArea(const TriangleMesh& mesh, const std::vector<char>& region) {
  const Eigen::VectorXd areas = vertexStars(faceAreas(mesh), mesh.faces(), mesh.vertexCount());
  double sum = 0;
  for (std::size_t v = 0; v < region.size(); ++v)
    sum += region[v] ? areas[static_cast<Eigen::Index>(v)] : 0.0;
  return sum;
}

}  // namespace authalic
