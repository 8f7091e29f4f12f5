/// @file
/// The exact authalic solve for surfaces with holes.
#pragma once

#include "Core/authalic/AuthalicMap.h"
#include "Core/authalic/CircleDomainHoles.h"

namespace authalic {

struct CircleDomainAuthalicMapOptions : CircleDomainHoles {
  AuthalicMapOptions solve;  ///< its domain is not read
  bool holdCentres = false;  ///< holes stay where the conformal map has them; a concentric one stays in any case
  bool freeRadii = false;    ///< radii are unknowns too; holeAreas must be empty, and are those that came out


  /// @throws as CircleDomainHoles::validate and AuthalicMapOptions::validate; InvalidArgument when there are areas for
  ///         holes with free radii
  void validate(const PolyAnnulusMesh& surface) const;
};

struct CircleDomainAuthalicMapResult : AuthalicSolution, CircleDomainImage {};

/// Maps a surface of genus 0 with k ≥ 1 loops to the unit disk without k − 1 round holes of prescribed areas so that
/// every vertex star has its target area, as authalicMap().
///
/// With A the area of the surface, H_j those of the holes and T the area of the outer polygon, the
/// polygon of hole j has the area T H_j / (A + Σ H) in every iterate (CircleDomainAreas): hole areas are exact, radii
/// follow from them. Centres of the circles, and with `freeRadii` ln ρ_j, are unknowns of the face steps, which border
/// their system by a dense column each: of the maps with their target areas one is sought with good angles, so that
/// holes go where the surface wants them. The start is the conformal map (circleDomainMap), a radial map around every
/// hole bringing it to its area, where that is near its target (mean |ln r| of the stars below 0.5); else, and where
/// holes have no room there, the map of the surface with its holes closed, holes made round (filledHolesStart()),
/// whichever is nearer. Where the first does not converge within half of the iterations, the other has the rest.
/// With `concentric` the start is annulusMap, whose circles around the middle get the radii at which as
/// much area lies inside as on the surface, or periodicRectangleAuthalicMap() rolled up; the hole stays in the middle.
///
/// Guarantees: loops on their circles to 1e-14, but for vertices of ears on inner loops, which lie in the hole
/// (`pockets`); hole areas to 1e-12; when not converged, the best iterate with its residuals. No folded face when the
/// start could be unfolded (→ flippedFaces); then no two holes overlap, and none leaves the disk.
/// Not guaranteed: that the centres of the holes are the best ones: they are a local optimum near the start; that holes
/// which would fit find their places.
/// Complexity: that of circleDomainMap and authalicMap, and 3 (k − 1) more right-hand sides per face step. When
/// cancelled in the start, the image is empty.
/// @throws InvalidArgument from options; GeometryError when the target does not belong to the surface, a hole does not
///         fit between the others, or the start cannot be unfolded; SolverError
/// @cite zou2011 @cite su2016
[[nodiscard]] CircleDomainAuthalicMapResult circleDomainAuthalicMap(
    const PolyAnnulusMesh& surface, const TargetMeasure& target, const CircleDomainAuthalicMapOptions& options = {},
    const Execution& execution = {});

}  // namespace authalic
