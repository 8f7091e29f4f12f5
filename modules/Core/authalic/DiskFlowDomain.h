/// @file
/// A disk and a planar domain, for the Lie flows. Private to authalic/.
#pragma once

#include "Core/authalic/LieFlowStages.h"
#include "Core/authalic/SlidingBoundary.h"
#include "Core/mesh/DiskMesh.h"

namespace authalic {

/// Boundary vertices slide on the circle or on their side; pockets are frozen and ride on their chords.
class DiskFlowDomain final : public LieFlowDomain {
 public:
  /// @param image  n×2, see SlidingBoundary
  DiskFlowDomain(const DiskMesh& disk, const PlanarDomain& domain, const BoundaryPlacement& placement,
                 const Points2& image, const TargetMeasure& target, SolverBackend backend);

  [[nodiscard]] std::unique_ptr<AreaFunctional> areasOn(const Faces& faces, const Points2&) const override;
  [[nodiscard]] Coordinates unfolded(const Coordinates& image, UnfoldReach reach) const override;
  [[nodiscard]] Coordinates revived(const Coordinates& image) const override;
  void carryFrozen(Coordinates& image) const override;

 private:
  const DiskMesh& disk_;
  SlidingBoundary sliding_;
  SolverBackend backend_;
  bool convex_;
};

/// An image without folds with the boundary of `placement`: `image` unfolded, or, where it stays folded on a polygon
/// that is not convex, polygonStart().
/// @throws GeometryError when faces stay folded
[[nodiscard]] Points2 unfoldedStart(const DiskMesh& disk, const PlanarDomain& domain,
                                    const BoundaryPlacement& placement, Points2 image, const TargetMeasure& target,
                                    SolverBackend backend, const Execution& execution);

}  // namespace authalic
