#include "Core/imaging/BrainFrame.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "Core/base/Error.h"
#include "Core/imaging/VolumeFilters.h"

namespace authalic {

namespace {

// The image averaged over blocks of about 2 mm, 0 outside the brain, with trilinear lookup in mm.
class CoarseBrain {
 public:
  CoarseBrain(const ScalarVolume& t1, const MaskVolume& mask) {
    const Eigen::Vector3d spacing = voxelSpacing(t1.voxelToWorld);
    std::array<int, 3> block{}, n{};
    Eigen::Matrix4d affine = t1.voxelToWorld;
    for (std::size_t a = 0; a < 3; ++a) {
      const auto e = static_cast<Eigen::Index>(a);
      block[a] = std::max(1, static_cast<int>(std::lround(2.0 / spacing[e])));
      n[a] = (t1.dimensions[a] + block[a] - 1) / block[a];
      affine.col(3) += affine.col(e) * (0.5 * (block[a] - 1));
    }
    for (std::size_t a = 0; a < 3; ++a) affine.col(static_cast<Eigen::Index>(a)) *= block[a];
    image_ = ScalarVolume(n, affine, 0.0f);
    const float share = 1.0f / static_cast<float>(block[0] * block[1] * block[2]);
    std::size_t v = 0;
    for (int k = 0; k < t1.dimensions[2]; ++k) {
      for (int j = 0; j < t1.dimensions[1]; ++j) {
        for (int i = 0; i < t1.dimensions[0]; ++i, ++v) {
          if (mask.values[v]) image_.at(i / block[0], j / block[1], k / block[2]) += share * t1.values[v];
        }
      }
    }
    worldToVoxel_ = image_.worldToVoxel();
    collectBrain();
  }

  [[nodiscard]] const std::vector<Eigen::Vector3d>& points() const { return points_; }
  [[nodiscard]] double meanIntensity() const { return mean_; }

  [[nodiscard]] double value(const Eigen::Vector3d& world) const {
    const Eigen::Vector3d p = (worldToVoxel_ * world.homogeneous()).head<3>();
    const Eigen::Vector3d base = p.array().floor();
    const int i = static_cast<int>(base[0]), j = static_cast<int>(base[1]), k = static_cast<int>(base[2]);
    if (!image_.contains(i, j, k) || !image_.contains(i + 1, j + 1, k + 1)) return 0;
    const Eigen::Vector3d t = p - base;
    double sum = 0;
    for (int c = 0; c < 8; ++c) {
      sum += (c & 1 ? t[0] : 1 - t[0]) * (c & 2 ? t[1] : 1 - t[1]) * (c & 4 ? t[2] : 1 - t[2]) *
             image_.at(i + (c & 1), j + (c >> 1 & 1), k + (c >> 2 & 1));
    }
    return sum;
  }

 private:
  void collectBrain() {
    double sum = 0;
    for (const float value : image_.values) sum += value;
    const double least =
        0.5 * sum /
        std::max<double>(1, static_cast<double>(std::count_if(image_.values.begin(), image_.values.end(),
                                                              [](float x) { return x > 0; })));
    for (int k = 0; k < image_.dimensions[2]; ++k) {
      for (int j = 0; j < image_.dimensions[1]; ++j) {
        for (int i = 0; i < image_.dimensions[0]; ++i) {
          if (image_.at(i, j, k) <= least) continue;
          points_.push_back(image_.world(i, j, k));
          mean_ += image_.at(i, j, k);
        }
      }
    }
    mean_ /= std::max<double>(1, static_cast<double>(points_.size()));
  }

  ScalarVolume image_;
  Eigen::Matrix4d worldToVoxel_;
  std::vector<Eigen::Vector3d> points_;
  double mean_ = 0;
};

double percentile(std::vector<double> values, double q) {
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(q * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

// Offset c (mm) and two small angles of the plane n·p = c.
using Plane = Eigen::Vector3d;

Eigen::Vector3d normalOf(const Plane& plane) {
  return Eigen::Vector3d(1.0, std::tan(plane[1]), std::tan(plane[2])).normalized();
}

double asymmetry(const CoarseBrain& brain, const Plane& plane, const Eigen::Vector3d& centre) {
  const Eigen::Vector3d n = normalOf(plane);
  double sum = 0;
  std::size_t count = 0;
  for (std::size_t s = 0; s < brain.points().size(); s += 7, ++count) {
    const Eigen::Vector3d& p = brain.points()[s];
    sum += std::abs(brain.value(p) - brain.value(p - 2 * (n.dot(p - centre) - plane[0]) * n));
  }
  return sum / (static_cast<double>(count) * brain.meanIntensity());
}

double brightness(const CoarseBrain& brain, const Plane& plane, const Eigen::Vector3d& centre) {
  const Eigen::Vector3d n = normalOf(plane), v = n.cross(Eigen::Vector3d::UnitZ()).normalized();
  const Eigen::Vector3d w = n.cross(v);
  double sum = 0;
  for (int a = -85; a <= 85; a += 2) {
    for (int b = -70; b <= 85; b += 2) sum += brain.value(centre + plane[0] * n + a * v + b * w);
  }
  return sum / (86.0 * 78.0 * brain.meanIntensity());
}

// Pattern search: halve the steps when no neighbour is better.
template <class Cost>
Plane search(Plane plane, double step, double angle, const Cost& cost) {
  double best = cost(plane);
  for (int round = 0; round < 60 && step > 0.05; ++round) {
    const Plane from = plane;
    for (int axis = 0; axis < 3; ++axis) {
      for (const double sign : {-1.0, 1.0}) {
        Plane trial = from;
        trial[axis] += sign * (axis == 0 ? step : angle);
        if (std::abs(trial[1]) > 0.35 || std::abs(trial[2]) > 0.35) continue;
        if (const double c = cost(trial); c < best) {
          best = c;
          plane = trial;
        }
      }
    }
    if (plane == from) {
      step *= 0.5;
      angle *= 0.5;
    }
  }
  return plane;
}

// The 0.5 and 99.5 percentiles of an average brain: MNI x from −65.2 to 65.2, y from −97 to 65.5, top at z
// = 76.
constexpr double kHalfWidth = 65.2, kLength = 162.5, kMiddleY = -15.75, kTop = 76.0;

void requireBrainSize(double width, double length) {
  if (width >= 70 && width <= 200 && length >= 100 && length <= 240) return;
  throw GeometryError(
      "A human brain 70 to 200 mm wide and 100 to 240 mm long is required, but the image shows something " +
      std::to_string(static_cast<int>(width)) + " mm wide and " + std::to_string(static_cast<int>(length)) +
      " mm long; check the voxel size in the header and strip the skull.");
}

}  // namespace

BrainFrame findBrainFrame(const ScalarVolume& t1, const MaskVolume& mask, const Execution& execution) {
  const CoarseBrain brain(t1, mask);
  if (brain.points().empty()) requireBrainSize(0, 0);
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& p : brain.points()) centre += p;
  centre /= static_cast<double>(brain.points().size());
  execution.throwIfCancelled();
  Plane plane = search(Plane::Zero(), 8.0, 0.1, [&](const Plane& p) { return asymmetry(brain, p, centre); });
  BrainFrame frame;
  frame.asymmetry = asymmetry(brain, plane, centre);
  execution.throwIfCancelled();
  plane = search(plane, 1.0, 0.02,
                 [&](const Plane& p) { return brightness(brain, p, centre) + asymmetry(brain, p, centre); });

  Eigen::Matrix3d axes;
  axes.row(0) = normalOf(plane).transpose();
  axes.row(1) = (Eigen::Vector3d::UnitY() - axes(0, 1) * axes.row(0).transpose()).normalized().transpose();
  axes.row(2) = Eigen::RowVector3d(axes.row(0)).cross(Eigen::RowVector3d(axes.row(1)));
  std::array<std::vector<double>, 3> along;
  for (const Eigen::Vector3d& p : brain.points()) {
    for (std::size_t a = 0; a < 3; ++a) along[a].push_back(axes.row(static_cast<Eigen::Index>(a)).dot(p));
  }
  const double middle = axes.row(0).dot(centre) + plane[0];
  const double width = percentile(along[0], 0.995) - percentile(along[0], 0.005);
  const double back = percentile(along[1], 0.005), front = percentile(along[1], 0.995);
  requireBrainSize(width, front - back);
  const double sx = 2 * kHalfWidth / width, sy = kLength / (front - back), sz = 0.5 * (sx + sy);
  const Eigen::Vector3d scale(sx, sy, sz);
  const Eigen::Vector3d shift(-sx * middle, kMiddleY - sy * 0.5 * (front + back),
                              kTop - sz * percentile(along[2], 0.995));
  frame.worldToFrame.topLeftCorner<3, 3>() = scale.asDiagonal() * axes;
  frame.worldToFrame.topRightCorner<3, 1>() = shift;
  return frame;
}

}  // namespace authalic
