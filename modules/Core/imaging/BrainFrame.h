/// @file
/// A coordinate frame of the brain, found from the image alone: mid-sagittal plane and extents.
#pragma once

#include <Eigen/Geometry>

#include "Core/base/Execution.h"
#include "Core/imaging/Volume.h"

namespace authalic {

/// Maps scanner RAS mm to *frame* coordinates: x = signed distance from the mid-sagittal plane (negative =
/// left), y towards the front, z upwards, scaled to the extents of an average brain, with the origin near the
/// anterior commissure; so that anatomical landmarks can be named by coordinates. For a brain in MNI space it
/// is nearly the identity.
struct BrainFrame {
  Eigen::Matrix4d worldToFrame = Eigen::Matrix4d::Identity();
  double asymmetry =
      0;  ///< mean |T(p) − T(mirrored p)| over the sampled brain voxels, relative to their mean intensity

  [[nodiscard]] Eigen::Vector3d operator()(const Eigen::Vector3d& world) const {
    return (worldToFrame * world.homogeneous()).head<3>();
  }
  /// mm per frame unit along the left–right axis.
  [[nodiscard]] double lateralScale() const { return 1.0 / worldToFrame.row(0).head<3>().norm(); }
};

/// Finds the frame.
///
/// The mid-sagittal plane n·p = c minimises first the asymmetry of the image under reflection and then,
/// nearby, the mean intensity on the plane itself (the fissure is darker than brain), by a deterministic
/// pattern search over the offset and two angles, at most 20° from the scanner's x axis. The extents are the
/// 0.5 and 99.5 percentiles of the brain's coordinates. Not found: a pitch (nodding) of the head; the y axis
/// is the scanner's, made perpendicular to n.
///
/// @param t1    skull-stripped, or masked
/// @param mask  1 = brain
/// @throws GeometryError when the extents are not those of a human brain (70–200 mm wide, 100–240 mm long)
/// @cite ardekani1997
[[nodiscard]] BrainFrame findBrainFrame(const ScalarVolume& t1, const MaskVolume& mask,
                                        const Execution& execution = {});

}  // namespace authalic
