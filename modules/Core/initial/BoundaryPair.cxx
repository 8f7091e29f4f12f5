#include "Core/initial/BoundaryPair.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace authalic {

std::array<int, 2> farthestBoundaryPair(const DiskMesh& disk) {
  const TriangleMesh& mesh = disk.mesh();
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (const int v : disk.boundary()) middle += mesh.point(v) / static_cast<double>(disk.boundary().size());
  std::vector<std::pair<double, int>> byRadius;
  for (const int v : disk.boundary()) byRadius.emplace_back(-(mesh.point(v) - middle).norm(), v);
  std::sort(byRadius.begin(), byRadius.end());
  double best = -1;
  std::array<int, 2> pair{byRadius[0].second, byRadius[1].second};
  for (std::size_t a = 0; a < byRadius.size(); ++a) {
    for (std::size_t b = 0; b < a && -byRadius[a].first - byRadius[b].first > best; ++b) {
      const double distance = (mesh.point(byRadius[a].second) - mesh.point(byRadius[b].second)).norm();
      if (distance <= best) continue;
      best = distance;
      pair = {byRadius[b].second, byRadius[a].second};
    }
  }
  return pair;
}

}  // namespace authalic
