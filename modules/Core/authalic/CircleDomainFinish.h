/// @file
/// The exact authalic solve from an image with holes that was found by another method.
#pragma once

#include "Core/authalic/CircleDomainAuthalicMap.h"

namespace authalic {

/// Where the holes are.
struct HolesInDisk {
  int outerLoop = 0;              ///< loop of PolyAnnulusMesh::loops() that is on the unit circle
  Points2 centres;                ///< m×2, one row per other loop, in the order of loops(); each inside its loop
  std::vector<double> areas;      ///< m, mm², > 0
  std::vector<int> pockets;       ///< vertices of inner loops that lie in the holes (ears), and move freely
};

/// Makes every vertex star, and every hole, of an image in the unit disk exactly as large as its target says, as
/// circleDomainAuthalicMap() does from the conformal map.
///
/// Each inner loop is put on the circle around its centre that has its area T H_j / (A + Σ H), the plane around it
/// following by r ↦ r + (R − ρ) e^{−(r − ρ)/R} with ρ the loop and R the circle in that direction; then folds are
/// removed (unfold, untangle). Where folds stay, as where a hole is long and its circle reaches into another or out
/// of the disk, holes are closed by cones to their centres and the disk is unfolded; circles that overlap are
/// pushed apart, loops go there as far at a time as no face folds (roundHoles in authalic/), and circles move in
/// the solve. Then face and vertex steps are taken.
///
/// @param image  n×2; outer loop on the unit circle, inner loops around their centres
/// Guarantees and complexity: as circleDomainAuthalicMap, without its start. Holes stay around the given centres
/// where the first road leads to an image without folds.
/// @throws InvalidArgument from options; GeometryError when the target, the image or the holes do not belong to the
///         surface, or folds stay; SolverError
/// @cite zou2011 @cite su2016
[[nodiscard]] CircleDomainAuthalicMapResult finishCircleDomain(const PolyAnnulusMesh& surface,
                                                               const TargetMeasure& target, const Points2& image,
                                                               const HolesInDisk& holes,
                                                               const AuthalicMapOptions& options = {},
                                                               const Execution& execution = {});

}  // namespace authalic
