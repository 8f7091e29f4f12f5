/// @file
/// The discrete Lie flow for surfaces with holes.
#pragma once

#include "Core/authalic/CircleDomainHoles.h"
#include "Core/authalic/DiscreteLieFlow.h"

namespace authalic {

struct CircleDomainLieFlowOptions : CircleDomainHoles {
  DiscreteLieFlowOptions flow;  ///< its domain is not read

  /// @throws as CircleDomainHoles::validate and DiscreteLieFlowOptions::validate
  void validate(const PolyAnnulusMesh& surface) const;
};

struct CircleDomainLieFlowResult : LieFlowSolution, CircleDomainImage {};

/// Flows a surface of genus 0 with k ≥ 1 loops onto the unit disk without k − 1 round holes of prescribed areas until
/// every vertex star has its target area.
///
/// As discreteLieFlow() @cite su2019: the vertices of every loop slide on its circle, ∇h along the loop being what is
/// left of the natural boundary condition. The radii of the holes follow from their areas in every iterate
/// (CircleDomainAreas in authalic/), centres stay where the start has them. The start is that of
/// circleDomainAuthalicMap().
///
/// Guarantees: with finish ≠ None no folded face, whatever the status; loops on their circles to 1e-14 but for ears on
/// inner loops (`pockets`); hole areas to 1e-12. Not guaranteed: that the tolerance is reached (→ status, residual).
/// Complexity: that of circleDomainMap and discreteLieFlow. When cancelled in the start, the image is empty.
/// @throws InvalidArgument from options; GeometryError when the target does not belong to the surface, a hole does not
///         fit between the others, or the start cannot be unfolded; SolverError
[[nodiscard]] CircleDomainLieFlowResult circleDomainLieFlow(const PolyAnnulusMesh& surface,
                                                            const TargetMeasure& target,
                                                            const CircleDomainLieFlowOptions& options = {},
                                                            const Execution& execution = {});

}  // namespace authalic
