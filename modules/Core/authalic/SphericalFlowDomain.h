/// @file
/// A closed surface of genus 0 and the unit sphere, for the Lie flows. Private to authalic/.
#pragma once

#include "Core/authalic/LieFlowStages.h"
#include "Core/mesh/SphereMesh.h"

namespace authalic {

/// Vertices move along their tangent planes and are put back on the sphere; areas are solid angles.
class SphericalFlowDomain final : public LieFlowDomain {
 public:
  SphericalFlowDomain(const SphereMesh& sphere, const TargetMeasure& target)
      : LieFlowDomain(sphere.mesh().faces(), target), sphere_(sphere) {}

  [[nodiscard]] std::unique_ptr<AreaFunctional> areasOn(const Faces& faces, const Points2&) const override;
  [[nodiscard]] Coordinates unfolded(const Coordinates& image, UnfoldReach reach) const override;

 private:
  const SphereMesh& sphere_;
};

struct SphericalFlowStart {
  Points3 image;          ///< n×3 on the unit sphere, no face folded
  bool balanced = false;  ///< made of two balanced disks, see twoCapsStart
};

/// `initial`, or when it is empty the conformal map (stereographicSphereMap), without folds; where some star has less
/// than e⁻⁸ or more than e⁸ of its share, or folds stay, two balanced caps that only look at that image.
/// @throws GeometryError when faces stay folded
[[nodiscard]] SphericalFlowStart sphericalFlowStart(const SphereMesh& sphere, const Points3& initial,
                                                    const TargetMeasure& target, SolverBackend backend,
                                                    const Execution& execution);

}  // namespace authalic
