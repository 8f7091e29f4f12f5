/// @file
/// Opens the few faces of a start that are much too small, patch by patch. Private to authalic/.
#pragma once

#include "Core/authalic/TargetMeasure.h"
#include "Core/mesh/DiskMesh.h"
#include "Core/numerics/SparseSolver.h"

namespace authalic {

/// Matches areas in patches around the faces that have less than a tenth of their share, everything else held.
///
/// Behind a neck of a few edges, or in needles, a harmonic map leaves faces of 1e-3 of their share and less. They are
/// few, but every step of a match of all faces ends where the first of them would collapse. In a patch of a few rings
/// around them the same steps cost next to nothing, and only the patch waits for them: the elimination of what is
/// strongly nonlinear before a global step.
///
/// The patches have 4, 8 and 16 rings; in each, FaceMatch brings the faces to their part of the area that the patch
/// has. A patch ends when each of its faces has a third of that, or when nothing moves.
/// @param image  n×2 without folds; has none afterwards
[[nodiscard]] Points2 openNarrowFaces(const DiskMesh& disk, const Points2& image, const TargetMeasure& target,
                                      SolverBackend backend);

}  // namespace authalic
