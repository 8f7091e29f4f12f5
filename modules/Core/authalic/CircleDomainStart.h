/// @file
/// The start of area-preserving maps of surfaces with holes, and what they measure in the end. Private to authalic/.
#pragma once

#include <vector>

#include "Core/authalic/CircleDomainAreas.h"
#include "Core/authalic/CircleDomainHoles.h"
#include "Core/authalic/TargetMeasure.h"
#include "Core/base/Execution.h"
#include "Core/numerics/SparseSolver.h"

namespace authalic {

/// Where a start comes from.
enum class HolesRoad {
  Either,     ///< the conformal map where it is near enough, else the one whose stars are nearer to their targets
  Conformal,  ///< the conformal map, circles stretched to their areas where they lie; concentric: annulusMap()
  AreasFirst  ///< filledHolesStart(); concentric: periodicRectangleAuthalicMap(), rolled up
};

struct CircleDomainStart {
  Points2 image;                    ///< n×2, no face folded; empty when cancelled
  std::vector<LoopOnCircle> loops;  ///< the outer one first, holes in the order of the surface's loops
  std::vector<double> holeAreas;    ///< as in CircleDomainHoles, none left open
  int outerLoop = 0, pockets = 0;
  HolesRoad road = HolesRoad::Conformal;
};

/// An image with holes of their areas, see circleDomainAuthalicMap().
/// @throws GeometryError when a hole does not fit between the others, or folds stay
[[nodiscard]] CircleDomainStart circleDomainStart(const PolyAnnulusMesh& surface, const TargetMeasure& target,
                                                  const CircleDomainHoles& holes, HolesRoad road,
                                                  SolverBackend backend, const Execution& execution);

/// An image with its circles and what its holes measure.
[[nodiscard]] CircleDomainImage imageOf(const CircleDomainStart& start, const Points2& image);

}  // namespace authalic
