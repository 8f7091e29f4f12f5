/// @file
/// Solid angles of a spherical image whose vertices move on the sphere. Private to authalic/.
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "Core/authalic/AreaFunctional.h"

namespace authalic {

/// Every vertex moves along its tangent plane and is put back on the sphere; areas are solid angles, which sum to 4π.
class SolidAngles final : public AreaFunctional {
 public:
  SolidAngles(const Faces& faces, int vertexCount);
  /// @param freedom  n values: 2, or 0 where a vertex is held
  SolidAngles(const Faces& faces, std::vector<char> freedom) : AreaFunctional(faces, std::move(freedom)) {}

  [[nodiscard]] Eigen::VectorXd areas(const Coordinates& image) const override;
  [[nodiscard]] Frames frames(const Coordinates& image) const override;
  [[nodiscard]] Gradients gradients(const Coordinates& image, const Frames& frames) const override;
  [[nodiscard]] Coordinates moved(const Coordinates& image, const Coordinates& displacement, double t) const override;
  [[nodiscard]] std::unique_ptr<AreaFunctional> inPatch(const Patch& patch, const Coordinates& image) const override;
  /// Of the signed volume, a cubic in t, for t ≤ kFarthest; its sign is that of the solid angle also after retraction.
  [[nodiscard]] double firstFlip(const Coordinates& image, const Coordinates& displacement, int face) const override;

  static constexpr double kFarthest = 4;
};

}  // namespace authalic
