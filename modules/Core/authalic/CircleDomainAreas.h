/// @file
/// Areas of an image on the unit disk without round holes of prescribed areas. Private to authalic/.
#pragma once

#include <memory>
#include <vector>

#include "Core/authalic/AreaFunctional.h"

namespace authalic {

/// One boundary loop on its circle.
struct LoopOnCircle {
  Eigen::RowVector2d centre{0, 0};
  double share = 1;           ///< area of the hole's polygon by that of the outer loop's; not read for the outer loop
  std::vector<int> vertices;  ///< in order, surface to the left; without those of pockets
};

/// What the circles of holes may do besides.
struct CircleFreedom {
  bool centres = false;  ///< move; else they stay at LoopOnCircle::centre
  bool radii = false;    ///< change; else every hole keeps its share of the area

  [[nodiscard]] bool any() const noexcept { return centres || radii; }
};

/// Inner vertices move anywhere, those of loops along their circle, circles as a whole as `freedom` says.
///
/// Prescribed areas: the radius of a hole is not free. Whatever the angles θ of its vertices, ρ² ½ Σ sin Δθ =
/// share · T with T the area of the outer polygon. moved() puts it there, so that hole areas are exact to rounding in
/// every image. Free radii: the outer circle grows with the holes, so that the area of the surface stays the same;
/// ended() brings it back to the unit circle. What a step along the circles changes in radii is of second order in Δθ
/// and left out of the derivatives.
///
/// Where circles have freedoms, an image has two rows more for each hole, after the vertices: its centre, and (ln ρ, 0)
/// (which is only read where radii are free).
///
/// As long as no face is folded, no hole reaches into another or out of the disk: a point covered k times by
/// faces has k = the sum of the windings of the loops' polygons about it, 1 − the number of holes around it; where two
/// holes overlap, or a hole leaves the disk, that were −1.
class CircleDomainAreas final : public AreaFunctional {
 public:
  /// @param loops  the outer one (unit circle) first
  CircleDomainAreas(const Faces& faces, std::vector<LoopOnCircle> loops, int vertexCount, CircleFreedom freedom = {});

  [[nodiscard]] Eigen::VectorXd areas(const Coordinates& image) const override;
  [[nodiscard]] Frames frames(const Coordinates& image) const override;
  [[nodiscard]] Gradients gradients(const Coordinates& image, const Frames& frames) const override;
  [[nodiscard]] Coordinates moved(const Coordinates& image, const Coordinates& displacement, double t) const override;
  [[nodiscard]] double firstFlip(const Coordinates& image, const Coordinates& displacement, int face) const override;

  /// Centres one by one, and radii: the moves of circles with freedoms.
  [[nodiscard]] std::vector<Coordinates> jointMoves(const Coordinates& image) const override;
  [[nodiscard]] std::unique_ptr<AreaFunctional> inPatch(const Patch& patch, const Coordinates& image) const override;
  /// With circles held, faces do not arrive in fewer steps for it.
  [[nodiscard]] bool looksAtBoundaryStars() const override { return false; }
  /// A circle moves by the smallest part of its vertices.
  [[nodiscard]] Coordinates slowed(const Coordinates& image, const Coordinates& displacement,
                                   const Eigen::VectorXd& part) const override;

  /// Radius that a hole must have for the angles of `image`; the outer loop is on the unit circle already.
  [[nodiscard]] double radius(const Points2& image, std::size_t loop) const;

  /// An image with the rows of the circles.
  [[nodiscard]] Coordinates begun(const Points2& image) const;
  /// The image of the vertices, on the unit disk; circles to `loops`.
  [[nodiscard]] Points2 ended(const Coordinates& image, std::vector<LoopOnCircle>& loops) const;

 private:
  [[nodiscard]] Eigen::Index row(std::size_t hole) const {
    return vertexCount() + 2 * static_cast<Eigen::Index>(hole - 1);
  }
  [[nodiscard]] Eigen::RowVector2d centre(const Coordinates& image, std::size_t loop) const;
  [[nodiscard]] double outerRadius(const Coordinates& image, const Eigen::VectorXd& radii) const;

  std::vector<LoopOnCircle> loops_;
  CircleFreedom circles_;
};

/// Area to the left of a closed polygon through rows of `image`.
[[nodiscard]] double polygonArea(const Points2& image, const std::vector<int>& vertices);

}  // namespace authalic
