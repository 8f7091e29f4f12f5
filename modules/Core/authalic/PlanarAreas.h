/// @file
/// Areas of a planar image whose boundary slides along that of its domain. Private to authalic/.
#pragma once

#include <vector>

#include "Core/authalic/AreaFunctional.h"
#include "Core/authalic/SlidingBoundary.h"

namespace authalic {

/// Inner vertices move anywhere; those of the boundary as SlidingBoundary says.
///
/// The tip of an ear, a face inscribed in the circle, has no freedom of its own: it stays in the middle of its arc,
/// where the face is largest for its base. There the area does not depend on the tip to first order, and a tip that
/// may run does so at once, to no avail; the ends of the base have to give way.
class PlanarAreas final : public AreaFunctional {
 public:
  PlanarAreas(const Faces& faces, const SlidingBoundary& sliding, int vertexCount);

  [[nodiscard]] Eigen::VectorXd areas(const Coordinates& image) const override;
  [[nodiscard]] Frames frames(const Coordinates& image) const override;
  [[nodiscard]] Gradients gradients(const Coordinates& image, const Frames& frames) const override;
  [[nodiscard]] Coordinates displacement(const Frames& frames, const Eigen::VectorXd& step) const override;
  [[nodiscard]] Coordinates moved(const Coordinates& image, const Coordinates& displacement, double t) const override;
  [[nodiscard]] double firstFlip(const Coordinates& image, const Coordinates& displacement, int face) const override;

 private:
  struct Ear {
    int tip, from, to;
  };
  [[nodiscard]] static std::vector<Ear> ears(const Faces& faces, const SlidingBoundary& sliding, int vertexCount);
  [[nodiscard]] static std::vector<char> freedoms(const std::vector<Ear>& ears, const SlidingBoundary& sliding,
                                                  int vertexCount);
  PlanarAreas(const Faces& faces, const SlidingBoundary& sliding, int vertexCount, std::vector<Ear> ears);

  const SlidingBoundary& sliding_;
  std::vector<Ear> ears_;
};

/// AreaFunctional::gradients() and firstFlip() of any planar image.
[[nodiscard]] AreaFunctional::Gradients planarGradients(const Faces& faces, const Coordinates& image,
                                                        const AreaFunctional::Frames& frames);
[[nodiscard]] double planarFirstFlip(const Faces& faces, const Coordinates& image, const Coordinates& displacement,
                                     int face);

}  // namespace authalic
