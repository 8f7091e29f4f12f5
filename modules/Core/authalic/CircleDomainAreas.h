/// @file
/// Areas of an image on the unit disk without round holes of prescribed areas. Private to authalic/.
#pragma once

#include <vector>

#include "Core/authalic/AreaFunctional.h"

namespace authalic {

/// One boundary loop on its circle.
struct LoopOnCircle {
  Eigen::RowVector2d centre{0, 0};
  double share = 1;           ///< area of the hole's polygon by that of the outer loop's; not read for the outer loop
  std::vector<int> vertices;  ///< in order, surface to the left; without those of pockets
};

/// Inner vertices move anywhere, those of loops along their circle.
///
/// The radius of a hole is not free: whatever the angles θ of its vertices, ρ² ½ Σ sin Δθ = share · T with T the
/// area of the outer polygon. moved() puts it there, so that hole areas are exact to rounding in every image. What
/// a step along the circles changes in ρ is of second order in Δθ and left out of the derivatives.
class CircleDomainAreas final : public AreaFunctional {
 public:
  /// @param loops  the outer one (unit circle) first
  CircleDomainAreas(const Faces& faces, std::vector<LoopOnCircle> loops, int vertexCount);

  [[nodiscard]] Eigen::VectorXd areas(const Coordinates& image) const override;
  [[nodiscard]] Frames frames(const Coordinates& image) const override;
  [[nodiscard]] Gradients gradients(const Coordinates& image, const Frames& frames) const override;
  [[nodiscard]] Coordinates moved(const Coordinates& image, const Coordinates& displacement, double t) const override;
  [[nodiscard]] double firstFlip(const Coordinates& image, const Coordinates& displacement, int face) const override;

  /// Radius that a hole must have for the angles of `image`; the outer loop is on the unit circle already.
  [[nodiscard]] double radius(const Points2& image, std::size_t loop) const;

 private:
  std::vector<LoopOnCircle> loops_;
};

/// Area to the left of a closed polygon through rows of `image`.
[[nodiscard]] double polygonArea(const Points2& image, const std::vector<int>& vertices);

}  // namespace authalic
