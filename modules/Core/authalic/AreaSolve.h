/// @file
/// Face steps and vertex steps in turn, on any domain. Private to authalic/.
#pragma once

#include "Core/authalic/AreaFunctional.h"
#include "Core/authalic/AuthalicMap.h"
#include "Core/authalic/FaceMatch.h"

namespace authalic {

struct AreaSolveResult : AuthalicSolution {
  Coordinates image;
};

/// @param surface  whose faces are mapped, in the order of those of `areas`
/// @param start    no face folded; stays so
/// @param shapes   what face steps look at, see FaceMatch; with First the mean |ln r| of the faces is below 0.8
///                 tolerances, else below half of one, as far as the mesh allows it
/// @param systems  kept from one solve to the next, when given
/// Status: Converged when both residuals are within their tolerances; Stalled when no step was possible any more;
/// NotConverged at the limit of iterations or rounds; Cancelled. The image is the one with the smallest vertex
/// residual within its tolerance, else the last.
[[nodiscard]] AreaSolveResult solveAreas(const AreaFunctional& areas, const TriangleMesh& surface,
                                         const TargetMeasure& target, Coordinates start,
                                         const AuthalicMapOptions& options, const Execution& execution,
                                         Shapes shapes = Shapes::Kept, AnalysedSystems* systems = nullptr);

/// Of two solves, the first not converged, gives the one that converged, or whose faces are nearer to their targets,
/// the iterations, the history and the seconds of both. @return whether that is the second
bool giveBetterTheEffortOfBoth(AuthalicSolution& first, AuthalicSolution& second);

}  // namespace authalic
