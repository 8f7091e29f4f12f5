/// @file
/// The value of a volume at a point of the world.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>

#include "Core/base/Error.h"
#include "Core/imaging/Volume.h"

namespace authalic {

enum class Interpolation {
  Trilinear,  ///< intensities
  Nearest,    ///< labels
};

/// Reads a volume at world points (scanner RAS mm) through the inverse of its voxel-to-world matrix.
///
/// With c = worldToVoxel · x in voxel units (voxel centres at integers, n voxels along the axis):
///  - **Trilinear**: the product of three linear interpolations between the 8 surrounding centres. The field
///    of view is the box of voxel centres, 0 ≤ c ≤ n − 1 on every axis; a point outside by no more than 1e-6
///    voxel counts as on the face of that box, so that rounding in the affine loses no face. A corner that is
///    not finite and has a weight above 1e-9 makes the value n/a; corners without weight do not matter.
///  - **Nearest**: the voxel ⌊c + ½⌋, so that a tie goes to the higher index. The field of view is what the
///    voxels cover, −½ ≤ c < n − ½ on every axis.
///
/// No value (std::nullopt) means: outside the field of view, or a voxel without data (NaN, infinite). It is
/// never 0. Keeps a reference to the volume. Complexity: constant per point.
///
/// @throws InvalidArgument when the matrix is not invertible or the number of values is not that of the
///         lattice.
template <class T>
class Interpolator {
 public:
  explicit Interpolator(const VolumeOf<T>& volume, Interpolation interpolation = Interpolation::Trilinear);

  /// The value at `world` (mm), or nothing.
  [[nodiscard]] std::optional<double> operator()(const Eigen::Vector3d& world) const {
    const Eigen::Vector3d voxel = rotation_ * world + translation_;
    return interpolation_ == Interpolation::Trilinear ? trilinear(voxel) : nearest(voxel);
  }
  /// The value at a point in voxel units, or nothing.
  [[nodiscard]] std::optional<double> trilinear(const Eigen::Vector3d& voxel) const;
  [[nodiscard]] std::optional<double> nearest(const Eigen::Vector3d& voxel) const;

 private:
  const VolumeOf<T>& volume_;
  Interpolation interpolation_;
  Eigen::Matrix3d rotation_;
  Eigen::Vector3d translation_;
};

template <class T>
Interpolator<T>::Interpolator(const VolumeOf<T>& volume, Interpolation interpolation)
    : volume_(volume), interpolation_(interpolation) {
  const std::array<int, 3>& n = volume.dimensions;
  const bool positive = n[0] > 0 && n[1] > 0 && n[2] > 0;
  if (!positive || volume.size() != static_cast<std::size_t>(n[0]) * static_cast<std::size_t>(n[1]) *
                                        static_cast<std::size_t>(n[2])) {
    throw InvalidArgument("A volume with one value per voxel is required, but there are " +
                          std::to_string(volume.size()) + " values for " + std::to_string(n[0]) + " x " +
                          std::to_string(n[1]) + " x " + std::to_string(n[2]) +
                          " voxels; read the file again.");
  }
  const double determinant = volume.voxelToWorld.template topLeftCorner<3, 3>().determinant();
  if (!volume.voxelToWorld.allFinite() || determinant == 0.0) {
    throw InvalidArgument("An invertible voxel-to-world matrix is required, but its determinant is " +
                          std::to_string(determinant) +
                          "; repair the orientation in the header of the volume.");
  }
  const Eigen::Matrix4d inverse = volume.worldToVoxel();
  rotation_ = inverse.topLeftCorner<3, 3>();
  translation_ = inverse.topRightCorner<3, 1>();
}

template <class T>
std::optional<double> Interpolator<T>::trilinear(const Eigen::Vector3d& voxel) const {
  constexpr double kSlack = 1e-6, kNoWeight = 1e-9;
  std::array<int, 3> low{};
  std::array<double, 3> part{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double last = volume_.dimensions[axis] - 1, c = voxel[static_cast<Eigen::Index>(axis)];
    if (!(c >= -kSlack && c <= last + kSlack)) return std::nullopt;
    const double inside = std::min(std::max(c, 0.0), last);
    low[axis] = std::min(static_cast<int>(inside), std::max(volume_.dimensions[axis] - 2, 0));
    part[axis] = inside - low[axis];
  }
  double first = 0.0, sum = 0.0;
  bool any = false;
  for (unsigned corner = 0; corner < 8; ++corner) {
    const int di = corner & 1u, dj = (corner >> 1u) & 1u, dk = (corner >> 2u) & 1u;
    const double weight =
        (di ? part[0] : 1 - part[0]) * (dj ? part[1] : 1 - part[1]) * (dk ? part[2] : 1 - part[2]);
    if (weight <= kNoWeight) continue;
    const double value = static_cast<double>(volume_.at(low[0] + di, low[1] + dj, low[2] + dk));
    if (!std::isfinite(value)) return std::nullopt;
    if (!any) first = value;
    any = true;
    sum += weight * (value - first);  // differences, so that equal voxels give exactly their value
  }
  return first + sum;
}

template <class T>
std::optional<double> Interpolator<T>::nearest(const Eigen::Vector3d& voxel) const {
  std::array<int, 3> index{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double c = voxel[static_cast<Eigen::Index>(axis)];
    if (!(c >= -0.5 && c < volume_.dimensions[axis] - 0.5)) return std::nullopt;
    index[axis] = static_cast<int>(std::floor(c + 0.5));
  }
  const double value = static_cast<double>(volume_.at(index[0], index[1], index[2]));
  if (!std::isfinite(value)) return std::nullopt;
  return value;
}

}  // namespace authalic
