/// @file
/// Areas of an image on the flat torus or the flat cylinder. Private to authalic/.
#pragma once

#include <memory>
#include <vector>

#include "Core/authalic/AreaFunctional.h"

namespace authalic {

/// Corners lie at x_v + a shift of the lattice, so that there is no seam: every star is whole.
class PeriodicAreas final : public AreaFunctional {
 public:
  /// @param shifts   3m×2, see periodicFaceAreas(); kept by reference
  /// @param freedom  n values: 2 = moves anywhere, 1 = along x, 0 = stays; one that stays fixes the translation
  PeriodicAreas(const Faces& faces, const Points2& shifts, std::vector<char> freedom);

  [[nodiscard]] const Points2& shifts() const override { return shifts_; }
  [[nodiscard]] Eigen::VectorXd areas(const Coordinates& image) const override;
  [[nodiscard]] Frames frames(const Coordinates& image) const override;
  [[nodiscard]] Gradients gradients(const Coordinates& image, const Frames& frames) const override;
  [[nodiscard]] Corners corners(const Coordinates& image, int face) const override;
  [[nodiscard]] Coordinates moved(const Coordinates& image, const Coordinates& displacement, double t) const override;
  [[nodiscard]] double firstFlip(const Coordinates& image, const Coordinates& displacement, int face) const override;
  [[nodiscard]] std::unique_ptr<AreaFunctional> inPatch(const Patch& patch, const Coordinates& image) const override;

 private:
  [[nodiscard]] Eigen::Vector2d corner(const Coordinates& image, int face, int k) const {
    return (image.row(faces()(face, k)) + shifts_.row(3 * face + k)).transpose();
  }

  const Points2& shifts_;
};

}  // namespace authalic
