/// @file
/// A start for the area solve with well shaped faces, where the surface allows it. Private to authalic/.
#pragma once

#include <array>

#include "Core/authalic/TargetMeasure.h"
#include "Core/base/Execution.h"
#include "Core/initial/Unfold.h"
#include "Core/mesh/DiskMesh.h"
#include "Core/numerics/SparseSolver.h"

namespace authalic {

/// Which rounds of the fixed point of the stretch energy a start may come from.
enum class StretchRounds {
  Bold,     ///< near its targets, though a few per mille of the faces are folded
  Careful,  ///< hardly folded
  None      ///< balancedStart() alone
};

/// From one to the next where folds stay.
inline constexpr std::array<StretchRounds, 3> kStretchRoundsInTurn{StretchRounds::Bold, StretchRounds::Careful,
                                                                   StretchRounds::None};

struct StretchStart {
  UnfoldResult opened;     ///< without narrow faces, see openNarrowFaces(); folds may stay
  bool stretched = false;  ///< from a round, else from balancedStart(): another one may lead farther
};

/// The harmonic map with the boundary of `image`, and rounds of the fixed point of the stretch energy
/// @cite yueh2019 from there, or balancedStart().
///
/// Cotangent weights keep angles better than any positive weights do, and every round leaves a third of the exponent by
/// which a limb shrinks, balancedStart() 1/√(2k) after k rounds; but folds are possible, and unfolding spoils shapes.
/// So the round is taken whose mean |ln r| of the stars, plus 1 for every per cent of the faces (Careful: for every per
/// mille) that is folded, is least; or balancedStart() where that is neither within sight nor below its own mean.
/// @param withinSight  mean |ln r| of the stars from where face steps converge
/// @param wellInSight  the same, at which the rounds end
/// Complexity: one symbolic and at most 8 numeric sparse factorisations, and those of balancedStart().
[[nodiscard]] StretchStart stretchStart(const DiskMesh& disk, const Points2& image, const TargetMeasure& target,
                                        SolverBackend backend, double withinSight, double wellInSight,
                                        StretchRounds rounds, const Execution& execution);

}  // namespace authalic
