/// @file
/// Face steps and vertex steps in turn, on any domain. Private to authalic/.
#pragma once

#include "Core/authalic/AreaFunctional.h"
#include "Core/authalic/AuthalicMap.h"

namespace authalic {

struct AreaSolveResult : AuthalicSolution {
  Coordinates image;
};

/// @param start  no face folded; stays so
/// Status: Converged when both residuals are within their tolerances; Stalled when no step was possible any more;
/// NotConverged at the limit of iterations or rounds; Cancelled. The image is the one with the smallest vertex residual
/// within its tolerance, else the last.
[[nodiscard]] AreaSolveResult solveAreas(const AreaFunctional& areas, const TargetMeasure& target, Coordinates start,
                                         const AuthalicMapOptions& options, const Execution& execution);

}  // namespace authalic
