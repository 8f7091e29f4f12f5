/// @file
/// Removes the folds of an image in the plane, patch by patch. Private to authalic/.
#pragma once

#include "Core/authalic/AreaFunctional.h"
#include "Core/authalic/TargetMeasure.h"
#include "Core/base/Execution.h"
#include "Core/numerics/SparseSolver.h"

namespace authalic {

/// Removes the folds of an image: foldoverFree() in patches of 4, 8, 16 and 32 rings around them, then everywhere.
///
/// A patch may lie across seams and around cones, which stay.
/// @param areas    in the plane, every free vertex in both directions
/// @param surface  of its vertices
/// @return the number of folded faces that are left
int removeFolds(const AreaFunctional& areas, const TargetMeasure& target, const Points3& surface,
                SolverBackend backend, Coordinates& image, const Execution& execution);

}  // namespace authalic
