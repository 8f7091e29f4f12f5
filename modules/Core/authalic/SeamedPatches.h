/// @file
/// Opens what is folded or much too small in an image on a flat cone surface, patch by patch. Private to authalic/.
#pragma once

#include "Core/authalic/SeamedAreas.h"
#include "Core/authalic/TargetMeasure.h"
#include "Core/base/Execution.h"
#include "Core/mesh/HighGenusMesh.h"
#include "Core/numerics/SparseSolver.h"

namespace authalic {

/// Removes the folds of an image: foldoverFree() in patches of 4, 8, 16 and 32 rings around them, then everywhere.
///
/// Corners of a patch keep their motions, so that a patch needs no chart of its own and may lie across seams and around
/// cones, which stay.
/// @param image  n×2, in the charts
/// @return the number of folded faces that are left
int removeFolds(const HighGenusMesh& surface, const SeamedAreas& areas,
                const TargetMeasure& target, SolverBackend backend, Points2& image, const Execution& execution);

/// Opens faces with less than a tenth of their share in patches of 4, 8 and 16 rings, as openNarrowFaces() does.
/// @param image  n×2, in the charts, no face folded; stays so
void openNarrowFaces(const HighGenusMesh& surface, const SeamedAreas& areas,
                     const TargetMeasure& target, SolverBackend backend, Points2& image, const Execution& execution);

}  // namespace authalic
