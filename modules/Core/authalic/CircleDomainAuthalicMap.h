/// @file
/// The exact authalic solve for surfaces with holes.
#pragma once

#include "Core/authalic/AuthalicMap.h"
#include "Core/authalic/CircleDomainHoles.h"

namespace authalic {

struct CircleDomainAuthalicMapOptions : CircleDomainHoles {
  AuthalicMapOptions solve;  ///< its domain is not read
  bool holdCentres = false;  ///< where the conformal map has them; concentric ones stay in any case
  bool freeRadii = false;    ///< radii are unknowns too; hole areas must be empty

  /// @throws as CircleDomainHoles::validate and AuthalicMapOptions::validate
  void validate(const PolyAnnulusMesh& surface) const;
};

struct CircleDomainAuthalicMapResult : AuthalicSolution, CircleDomainImage {};

/// Maps a surface of genus 0 with k ≥ 1 loops to the unit disk without k − 1 round holes of prescribed areas so that
/// every vertex star has its target area, as authalicMap().
///
/// With A the area of the surface, H_j those of the holes and T the area of the outer polygon, the
/// polygon of hole j has the area T H_j / (A + Σ H) in every iterate (CircleDomainAreas): hole areas are exact, radii
/// follow from them. The start is the conformal map (circleDomainMap); a radial map around every hole brings it to its
/// area there. With `concentric` the start is annulusMap, whose circles around the middle get the radii at which as
/// much area lies inside as on the surface: a long tube, too, has a hole of the right size.
///
/// Guarantees: loops on their circles to 1e-14, but for vertices of ears on inner loops, which lie in the hole
/// (`pockets`); hole areas to 1e-12; when not converged, the best iterate with its residuals. No folded face when the
/// start could be unfolded (→ flippedFaces).
/// Not guaranteed: that the centres of the holes are the best ones: they stay where the conformal map has them.
/// Complexity: that of circleDomainMap and authalicMap. When cancelled in the start, the image is empty.
/// @throws InvalidArgument from options; GeometryError when the target does not belong to the surface, a hole does not
///         fit between the others, or the start cannot be unfolded; SolverError
/// @cite zou2011 @cite su2016
[[nodiscard]] CircleDomainAuthalicMapResult circleDomainAuthalicMap(
    const PolyAnnulusMesh& surface, const TargetMeasure& target, const CircleDomainAuthalicMapOptions& options = {},
    const Execution& execution = {});

}  // namespace authalic
