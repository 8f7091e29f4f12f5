/// @file
/// Areas of a planar image whose boundary slides along that of its domain. Private to authalic/.
#pragma once

#include "Core/authalic/AreaFunctional.h"
#include "Core/authalic/SlidingBoundary.h"

namespace authalic {

/// Inner vertices move anywhere; those of the boundary as SlidingBoundary says.
class PlanarAreas final : public AreaFunctional {
 public:
  PlanarAreas(const Faces& faces, const SlidingBoundary& sliding, int vertexCount);

  [[nodiscard]] Eigen::VectorXd areas(const Coordinates& image) const override;
  [[nodiscard]] Frames frames(const Coordinates& image) const override;
  [[nodiscard]] Gradients gradients(const Coordinates& image, const Frames& frames) const override;
  [[nodiscard]] Coordinates moved(const Coordinates& image, const Coordinates& displacement, double t) const override;
  [[nodiscard]] double firstFlip(const Coordinates& image, const Coordinates& displacement, int face) const override;

 private:
  const SlidingBoundary& sliding_;
};

/// AreaFunctional::gradients() and firstFlip() of any planar image.
[[nodiscard]] AreaFunctional::Gradients planarGradients(const Faces& faces, const Coordinates& image,
                                                        const AreaFunctional::Frames& frames);
[[nodiscard]] double planarFirstFlip(const Faces& faces, const Coordinates& image, const Coordinates& displacement,
                                     int face);

}  // namespace authalic
