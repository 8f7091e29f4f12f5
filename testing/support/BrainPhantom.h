/// @file
/// A brain of ellipsoids with the parts that segmentation must tell apart.
#pragma once

#include <Eigen/Core>
#include <cmath>

#include "Core/imaging/Volume.h"

namespace authalic::testing {

/// Tissue of the phantom at a point in mm: 10 fluid, 80 grey, 110 white, 0 outside. Two hemispheres with
/// rippled cortex, joined by a callosum; lateral ventricles; a brainstem and a cerebellum with a white core
/// joined to it.
inline float phantomIntensity(const Eigen::Vector3d& p) {
  constexpr float outside = 0, fluid = 10, grey = 80, white = 110;
  const double x = std::abs(p[0]), y = p[1], z = p[2];
  const auto ellipsoid = [](const Eigen::Vector3d& q, const Eigen::Vector3d& c, const Eigen::Vector3d& r) {
    return (q - c).cwiseQuotient(r).norm();
  };
  const Eigen::Vector3d folded(x, y, z);
  if (ellipsoid(folded, {10, 0, 18}, {6, 22, 7}) < 1) return fluid;
  const bool deep = y > -30 && y < 26 && z > -6 && z < 27;  // callosum and diencephalon, across the midline
  if (std::hypot(p[0], y + 22) < 11 && z > -62 && z <= -4) return white;
  const double r = ellipsoid(folded, {0, -16, 18}, {65, 81, 58});
  if (r < 1 && z > -16) {
    const bool fissure = x < 1.5 && !deep;
    const bool medialCortex = x < 5 && !deep;
    const double depth = 0.93 + 0.015 * std::sin(y / 4) * std::sin(z / 4);
    return fissure                                                                   ? fluid
           : medialCortex || r > depth || (z < -11 && x > 12) || (z < -11 && y > -8) ? grey
                                                                                     : white;
  }
  const double cerebellum = ellipsoid(folded, {0, -58, -42}, {48, 28, 20});
  if (cerebellum < 0.6 || (x < 8 && y > -60 && y < -20 && std::abs(z + 42) < 6)) return white;
  return cerebellum < 1 ? grey : outside;
}

/// The phantom on a lattice of steps of `spacing` mm that covers it; `orientation` turns and moves the head
/// (world = orientation · mm).
inline ScalarVolume brainPhantom(double spacing,
                                 const Eigen::Matrix4d& orientation = Eigen::Matrix4d::Identity()) {
  const std::array<int, 3> n{static_cast<int>(150 / spacing), static_cast<int>(190 / spacing),
                             static_cast<int>(156 / spacing)};
  Eigen::Matrix4d affine = Eigen::Matrix4d::Identity();
  affine.diagonal().head<3>().setConstant(spacing);
  affine.topRightCorner<3, 1>() << 0.5 * spacing * (1 - n[0]), -111, -70;
  ScalarVolume volume(n, affine);
  for (int k = 0; k < n[2]; ++k) {
    for (int j = 0; j < n[1]; ++j) {
      for (int i = 0; i < n[0]; ++i) volume.at(i, j, k) = phantomIntensity(volume.world(i, j, k));
    }
  }
  volume.voxelToWorld = orientation * affine;
  return volume;
}

}  // namespace authalic::testing
