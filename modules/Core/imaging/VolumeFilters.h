/// @file
/// Distances, blurring, flooding and cropping of volumes: the tools of segmentation.
#pragma once

#include <array>

#include "Core/base/Execution.h"
#include "Core/imaging/Volume.h"

namespace authalic {

/// Length in mm of one step along each axis of the lattice.
[[nodiscard]] Eigen::Vector3d voxelSpacing(const Eigen::Matrix4d& voxelToWorld);

/// Distance in mm from every voxel centre to the nearest centre with mask ≠ 0 (0 there; +infinity when there
/// is none).
///
/// Exact Euclidean distance by lower envelopes of parabolas, one axis at a time; the lattice axes are taken
/// as perpendicular. O(voxels). @cite felzenszwalb2012
[[nodiscard]] ScalarVolume distanceTo(const MaskVolume& mask, const Execution& execution = {});

/// Convolution with a Gaussian of standard deviation `sigma` mm, cut at 3 sigma, borders repeated. O(voxels ·
/// sigma).
[[nodiscard]] ScalarVolume gaussianBlur(ScalarVolume volume, double sigma, const Execution& execution = {});

/// Marker-controlled flood (watershed): regions grow from the markers over the voxels with `priority > 0`,
/// through the 14 neighbours of SimplePoint.h, always at the highest priority on any front; where two meet,
/// they stop.
///
/// @param regions   marker ids ≥ 1; 0 = to be flooded or never reached. Markers outside priority > 0 stay
/// alone.
/// @param priority  0 = never, else 1…32767
/// @return regions, flooded. The outermost layer of the volume is never entered.
/// @cite meyer1994
[[nodiscard]] MaskVolume floodFromMarkers(MaskVolume regions, const VolumeOf<std::int16_t>& priority,
                                          const Execution& execution = {});

/// Sets every voxel of `mask` that cannot be reached from the border of the volume over zeros (14-adjacency)
/// to 1; returns how many there were.
std::size_t fillCavities(MaskVolume& mask);

/// Keeps the largest 14-connected component of `mask` (the first in scan order among equals).
/// @return voxels removed
std::size_t keepLargestComponent(MaskVolume& mask);

/// The voxels lower ≤ (i, j, k) < upper; parts outside the volume read `fill`. The affine moves along.
template <class T>
[[nodiscard]] VolumeOf<T> cropVolume(const VolumeOf<T>& volume, const std::array<int, 3>& lower,
                                     const std::array<int, 3>& upper, T fill) {
  Eigen::Matrix4d affine = volume.voxelToWorld;
  affine.topRightCorner<3, 1>() = volume.world(lower[0], lower[1], lower[2]);
  VolumeOf<T> out({upper[0] - lower[0], upper[1] - lower[1], upper[2] - lower[2]}, affine, fill);
  for (int k = 0; k < out.dimensions[2]; ++k) {
    for (int j = 0; j < out.dimensions[1]; ++j) {
      for (int i = 0; i < out.dimensions[0]; ++i) {
        const int x = i + lower[0], y = j + lower[1], z = k + lower[2];
        if (volume.contains(x, y, z)) out.at(i, j, k) = volume.at(x, y, z);
      }
    }
  }
  return out;
}

}  // namespace authalic
