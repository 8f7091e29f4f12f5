/// @file
/// Areas of an image on a flat cone surface. Private to authalic/.
#pragma once

#include <memory>
#include <vector>

#include "Core/authalic/AreaFunctional.h"
#include "Core/conformal/FlatConeSurface.h"

namespace authalic {

/// Every vertex moves anywhere in its chart but the cones, which stay where the surface has them. A corner lies where
/// its rigid motion takes the place of its vertex, so that the sides of a seam share their unknowns and every star is
/// whole. The translations and the places of the cones may be free as well: then an image has the parameters of the
/// holonomy as its last rows, its area stays as it is, and the rows of cones are without meaning.
class SeamedAreas final : public AreaFunctional {
 public:
  /// @param flat  kept by reference
  SeamedAreas(const Faces& faces, const FlatConeSurface& flat);
  /// With free parameters.
  SeamedAreas(const Faces& faces, const FlatConeSurface& flat, CornerMoves parameters);
  /// Of a patch, which needs no chart of its own.
  /// @param freedom  2 or 0 (held)
  /// @param motions  of the corners; a turn of 0 holds a corner where it is shifted to
  SeamedAreas(const Faces& faces, std::vector<char> freedom, std::vector<RigidMotion> motions);
  SeamedAreas(const SeamedAreas&) = delete;
  SeamedAreas& operator=(const SeamedAreas&) = delete;

  [[nodiscard]] Eigen::VectorXd areas(const Coordinates& image) const override;
  [[nodiscard]] Frames frames(const Coordinates& image) const override;
  [[nodiscard]] Gradients gradients(const Coordinates& image, const Frames& frames) const override;
  [[nodiscard]] Corners corners(const Coordinates& image, int face) const override;
  [[nodiscard]] Directions directions(const Frames& frames, int face) const override;
  [[nodiscard]] Coordinates moved(const Coordinates& image, const Coordinates& displacement, double t) const override;
  [[nodiscard]] double firstFlip(const Coordinates& image, const Coordinates& displacement, int face) const override;
  [[nodiscard]] std::unique_ptr<AreaFunctional> inPatch(const Patch& patch, const Coordinates& image) const override;

  [[nodiscard]] const CornerMoves* parameters() const override { return moves_.row.empty() ? nullptr : &moves_; }

  [[nodiscard]] const RigidMotion& motion(int face, int k) const {
    return motions_[static_cast<std::size_t>(3 * face + k)];
  }
  /// Where corner k of a face lies in the plane.
  [[nodiscard]] std::complex<double> corner(const Coordinates& image, int face, int k) const {
    const int v = faces()(face, k);
    if (moves_.row.empty()) return motion(face, k)({image(v, 0), image(v, 1)});
    return change(image, face, k);
  }

 private:
  [[nodiscard]] std::complex<double> shift(const Coordinates& rows, int face, int k) const;
  [[nodiscard]] std::complex<double> change(const Coordinates& rows, int face, int k) const;

  std::vector<RigidMotion> own_;  // of a patch
  const std::vector<RigidMotion>& motions_;
  CornerMoves moves_;
};

/// How the parameters of the holonomy move the corners of a flat surface.
[[nodiscard]] CornerMoves cornerMoves(const SurfaceTopology& topology, const FlatConeSurface& flat);

}  // namespace authalic
