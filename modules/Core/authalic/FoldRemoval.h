/// @file
/// Removes the folds of an image in the plane, patch by patch. Private to authalic/.
#pragma once

#include "Core/authalic/AreaFunctional.h"
#include "Core/authalic/TargetMeasure.h"
#include "Core/base/Execution.h"
#include "Core/numerics/SparseSolver.h"

namespace authalic {

/// Removes the folds of an image: foldoverFree() in patches of 4 rings around them, smaller ones where those fail, then
/// larger ones, then everywhere.
///
/// A patch may lie across seams and around cones, which stay. Around cones it can also lose its folds the wrong way: a
/// cone has a full turn too little and another vertex faces that go around it twice. Then it is left folded. Larger
/// patches leave better faces, smaller ones have fewer ways to go wrong.
/// @param areas    in the plane, every free vertex in both directions
/// @param surface  of its vertices
/// @return the number of folded faces that are left
int removeFolds(const AreaFunctional& areas, const TargetMeasure& target, const Points3& surface,
                SolverBackend backend, Coordinates& image, const Execution& execution);

}  // namespace authalic
