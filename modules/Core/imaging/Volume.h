/// @file
/// A scalar or label volume and where it lies in space.
#pragma once

#include <Eigen/Core>
#include <Eigen/LU>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace authalic {

/// Voxels on a regular (possibly oblique) lattice. Voxel (i, j, k), i fastest, has its **centre** at
/// `voxelToWorld * (i, j, k, 1)` in scanner RAS mm.
template <class T>
struct VolumeOf {
  std::array<int, 3> dimensions{0, 0, 0};
  Eigen::Matrix4d voxelToWorld = Eigen::Matrix4d::Identity();
  std::vector<T> values;

  VolumeOf() = default;
  VolumeOf(const std::array<int, 3>& size, const Eigen::Matrix4d& affine, T fill = T())
      : dimensions(size),
        voxelToWorld(affine),
        values(static_cast<std::size_t>(size[0]) * size[1] * size[2], fill) {}

  [[nodiscard]] std::size_t size() const noexcept { return values.size(); }
  [[nodiscard]] std::size_t index(int i, int j, int k) const noexcept {
    return static_cast<std::size_t>(i) + static_cast<std::size_t>(dimensions[0]) *
                                             (static_cast<std::size_t>(j) +
                                              static_cast<std::size_t>(dimensions[1]) * k);
  }
  [[nodiscard]] bool contains(int i, int j, int k) const noexcept {
    return i >= 0 && j >= 0 && k >= 0 && i < dimensions[0] && j < dimensions[1] && k < dimensions[2];
  }
  [[nodiscard]] const T& at(int i, int j, int k) const noexcept { return values[index(i, j, k)]; }
  [[nodiscard]] T& at(int i, int j, int k) noexcept { return values[index(i, j, k)]; }
  [[nodiscard]] Eigen::Vector3d world(double i, double j, double k) const {
    return (voxelToWorld * Eigen::Vector4d(i, j, k, 1.0)).head<3>();
  }
  [[nodiscard]] Eigen::Matrix4d worldToVoxel() const { return voxelToWorld.inverse(); }
  /// Volume of one voxel in mm³.
  [[nodiscard]] double voxelVolume() const {
    return std::abs(voxelToWorld.topLeftCorner<3, 3>().determinant());
  }
};

using ScalarVolume = VolumeOf<float>;         ///< intensities; NaN = no data
using LabelVolume = VolumeOf<std::int32_t>;   ///< region ids; 0 = none
using MaskVolume = VolumeOf<std::uint8_t>;    ///< 0 outside, 1 inside

}  // namespace authalic
