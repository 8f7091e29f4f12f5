/// @file
/// A start for surfaces with holes from the map of the surface without them. Private to authalic/.
#pragma once

#include <vector>

#include "Core/authalic/RoundHoles.h"
#include "Core/authalic/TargetMeasure.h"
#include "Core/base/Execution.h"

namespace authalic {

/// The surface with a cone on every hole: a disk. Tips, in the means of their loops, follow the vertices, and cones the
/// faces, in the order of the loops.
/// @param outer  number of the loop that stays open
[[nodiscard]] TriangleMesh closedByCones(const PolyAnnulusMesh& surface, int outer);

/// Closes every hole by a cone that is to have its area, maps the disk that results with areas near their targets
/// (authalicMap(), a few face steps), takes the cones away again and makes the holes round (roundHoles()).
///
/// Holes come to lie where an area-preserving map has them: behind necks and far from the outer loop, where the
/// conformal map shrinks whole regions with their holes to points, this start is by far the nearer one.
/// @param holeAreas  mm², in the order of the loops, the outer one left out
/// @param outer      number of the outer loop
/// Complexity: that of a few steps of authalicMap, and of roundHoles.
/// @throws GeometryError when the disk cannot be mapped; SolverError
[[nodiscard]] RoundedHoles filledHolesStart(const PolyAnnulusMesh& surface, const TargetMeasure& target,
                                            const std::vector<double>& holeAreas, int outer, SolverBackend backend,
                                            const Execution& execution);

}  // namespace authalic
