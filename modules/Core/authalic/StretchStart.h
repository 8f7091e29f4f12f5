/// @file
/// A start for the area solve with well shaped faces, where the surface allows it. Private to authalic/.
#pragma once

#include "Core/authalic/TargetMeasure.h"
#include "Core/base/Execution.h"
#include "Core/mesh/DiskMesh.h"
#include "Core/numerics/SparseSolver.h"

namespace authalic {

struct StretchStart {
  Points2 image;
  double error = 0;  ///< mean |ln r| of the stars
  int folded = 0;    ///< faces

  /// Within sight of its targets, and with so few folds (2 per mille of the faces) that unfolding is worth a try.
  [[nodiscard]] bool usable(double withinSight, int faceCount) const noexcept {
    return error <= withinSight && folded <= 0.002 * faceCount;
  }
};

/// The harmonic map with the boundary of `image`, and rounds of the fixed point of the stretch energy
/// @cite yueh2019 from there, until the stars are within sight of their targets.
///
/// Cotangent weights keep angles better than any positive weights do, but folds are possible, and behind deep necks
/// the rounds do not converge: see what comes back before it is used.
/// @param goodEnough  mean |ln r| of the stars at which the rounds end
/// Complexity: one symbolic and at most 8 numeric sparse factorisations.
[[nodiscard]] StretchStart stretchStart(const DiskMesh& disk, const Points2& image, const TargetMeasure& target,
                                        SolverBackend backend, double goodEnough, const Execution& execution);

}  // namespace authalic
