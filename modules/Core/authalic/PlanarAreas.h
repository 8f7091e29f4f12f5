/// @file
/// Areas of a planar image whose boundary slides along that of its domain. Private to authalic/.
#pragma once

#include <memory>
#include <vector>

#include "Core/authalic/AreaFunctional.h"
#include "Core/authalic/EarsOnCircle.h"
#include "Core/authalic/SlidingBoundary.h"

namespace authalic {

/// Inner vertices move anywhere; those of the boundary as SlidingBoundary says, but for the tips of ears on the circle.
class PlanarAreas final : public AreaFunctional {
 public:
  /// Tips have no freedom of their own: they stay in the middle of their arcs.
  PlanarAreas(const Faces& faces, const SlidingBoundary& sliding, int vertexCount);

  /// Tips slide like all others, and eased() puts them where their ears have their shares.
  /// @param vertexShares  n targets; kept by reference
  PlanarAreas(const Faces& faces, const SlidingBoundary& sliding, const Eigen::VectorXd& vertexShares);

  [[nodiscard]] Eigen::VectorXd areas(const Coordinates& image) const override;
  [[nodiscard]] Frames frames(const Coordinates& image) const override;
  [[nodiscard]] Gradients gradients(const Coordinates& image, const Frames& frames) const override;
  [[nodiscard]] Coordinates displacement(const Frames& frames, const Eigen::VectorXd& step) const override;
  [[nodiscard]] Coordinates moved(const Coordinates& image, const Coordinates& displacement, double t) const override;
  [[nodiscard]] Coordinates eased(Coordinates image) const override;
  [[nodiscard]] const std::vector<EarOnCircle>& slidingEars() const override;
  [[nodiscard]] std::unique_ptr<AreaFunctional> inPatch(const Patch& patch, const Coordinates& image) const override;
  [[nodiscard]] double firstFlip(const Coordinates& image, const Coordinates& displacement, int face) const override;

 private:
  PlanarAreas(const Faces& faces, const SlidingBoundary& sliding, EarsOnCircle ears, std::vector<char> freedoms,
              const Eigen::VectorXd* vertexShares);

  const SlidingBoundary& sliding_;
  EarsOnCircle ears_;
  const Eigen::VectorXd* vertexShares_;  // none: tips stay in the middle
};

/// Some vertices move anywhere, all others are held.
class PlanarPatchAreas final : public AreaFunctional {
 public:
  /// @param freedom  n values: 2, or 0 where a vertex is held
  PlanarPatchAreas(const Faces& faces, std::vector<char> freedom);

  [[nodiscard]] Eigen::VectorXd areas(const Coordinates& image) const override;
  [[nodiscard]] Frames frames(const Coordinates& image) const override;
  [[nodiscard]] Gradients gradients(const Coordinates& image, const Frames& frames) const override;
  [[nodiscard]] Coordinates moved(const Coordinates& image, const Coordinates& displacement, double t) const override;
  [[nodiscard]] std::unique_ptr<AreaFunctional> inPatch(const Patch& patch, const Coordinates& image) const override;
  [[nodiscard]] double firstFlip(const Coordinates& image, const Coordinates& displacement, int face) const override;
};

/// AreaFunctional::gradients() and firstFlip() of any planar image.
[[nodiscard]] AreaFunctional::Gradients planarGradients(const Faces& faces, const Coordinates& image,
                                                        const AreaFunctional::Frames& frames);
[[nodiscard]] double planarFirstFlip(const Faces& faces, const Coordinates& image, const Coordinates& displacement,
                                     int face);

}  // namespace authalic
