/// @file
/// The planar regions that a disk can be mapped to.
#pragma once

#include "Core/mesh/TriangleMesh.h"

namespace authalic {

/// The unit disk about the origin, or the region inside a simple polygon.
class PlanarDomain {
 public:
  /// The unit disk.
  PlanarDomain() = default;
  [[nodiscard]] static PlanarDomain disk() { return {}; }
  /// [0, 1] × [0, 1].
  [[nodiscard]] static PlanarDomain square() { return rectangle(1); }
  /// [0, aspect] × [0, 1]. @throws InvalidArgument unless 0.01 ≤ aspect ≤ 100.
  [[nodiscard]] static PlanarDomain rectangle(double aspect);
  /// @param corners  k×2, k ≥ 3. Made counter-clockwise; a corner with a straight angle is dropped.
  /// @throws InvalidArgument when a coordinate is not finite, corners coincide, sides cross, or there is no area.
  [[nodiscard]] static PlanarDomain polygon(const Points2& corners);

  [[nodiscard]] bool isDisk() const noexcept { return corners_.rows() == 0; }
  /// Corners, counter-clockwise; none for the disk. Side k runs from corner k to corner k+1.
  [[nodiscard]] const Points2& corners() const noexcept { return corners_; }
  /// Whether the region is convex; only then are maps with convex weights without flips.
  [[nodiscard]] bool convex() const noexcept { return convex_; }
  [[nodiscard]] double area() const;

 private:
  Points2 corners_ = Points2(0, 2);
  bool convex_ = true;
};

}  // namespace authalic
