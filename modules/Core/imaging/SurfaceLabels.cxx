#include "Core/imaging/SurfaceLabels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include <Eigen/Geometry>

#include "Core/base/Error.h"

namespace authalic {

namespace {

struct Offset {
  std::array<int, 3> step;
  double bound;  // no voxel at this offset is nearer than this to a point in the central voxel, mm
};

// Steps within reach, nearest first.
std::vector<Offset> offsetsWithin(const Eigen::Matrix3d& axes, double reach) {
  const double half = 0.5 * axes.cwiseAbs().rowwise().sum().norm();
  const Eigen::Matrix3d inverse = axes.inverse();
  std::array<int, 3> span{};
  for (std::size_t a = 0; a < 3; ++a) {
    span[a] = static_cast<int>(std::ceil((reach + half) * inverse.row(static_cast<Eigen::Index>(a)).norm()));
  }
  std::vector<Offset> offsets;
  for (int k = -span[2]; k <= span[2]; ++k) {
    for (int j = -span[1]; j <= span[1]; ++j) {
      for (int i = -span[0]; i <= span[0]; ++i) {
        const double bound = (axes * Eigen::Vector3d(i, j, k)).norm() - half;
        if (bound <= reach) offsets.push_back({{i, j, k}, bound});
      }
    }
  }
  std::stable_sort(offsets.begin(), offsets.end(),
                   [](const Offset& a, const Offset& b) { return a.bound < b.bound; });
  return offsets;
}

}  // namespace

std::vector<std::int32_t> labelsOnSurface(const TriangleMesh& mesh, const LabelVolume& labels,
                                          double maxDistance, const Execution& execution) {
  if (!(maxDistance > 0 && maxDistance <= 50)) {
    throw InvalidArgument("The reach of surface labels must lie in (0, 50] mm, but it is " +
                          std::to_string(maxDistance) + ".");
  }
  const Eigen::Matrix3d axes = labels.voxelToWorld.topLeftCorner<3, 3>();
  const Eigen::Matrix4d toVoxel = labels.worldToVoxel();
  const std::vector<Offset> offsets = offsetsWithin(axes, maxDistance);
  std::vector<std::int32_t> out(static_cast<std::size_t>(mesh.vertexCount()), 0);
  parallelFor(out.size(), execution, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      if (v % 16384 == 0) execution.throwIfCancelled();
      const Eigen::Vector3d p = (toVoxel * mesh.point(static_cast<int>(v)).homogeneous()).head<3>();
      const std::array<int, 3> base{static_cast<int>(std::lround(p[0])), static_cast<int>(std::lround(p[1])),
                                    static_cast<int>(std::lround(p[2]))};
      double nearest = maxDistance * (1 + 1e-12);
      for (const Offset& offset : offsets) {
        if (offset.bound > nearest) break;
        const int i = base[0] + offset.step[0], j = base[1] + offset.step[1], k = base[2] + offset.step[2];
        if (!labels.contains(i, j, k) || labels.at(i, j, k) == 0) continue;
        const double distance = (axes * (Eigen::Vector3d(i, j, k) - p)).norm();
        if (distance >= nearest) continue;
        nearest = distance;
        out[v] = labels.at(i, j, k);
      }
    }
  });
  return out;
}

}  // namespace authalic
