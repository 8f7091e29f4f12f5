/// @file
/// A start for the area solve with well shaped faces, where the surface allows it. Private to authalic/.
#pragma once

#include "Core/authalic/TargetMeasure.h"
#include "Core/base/Execution.h"
#include "Core/geometry/Laplacian.h"
#include "Core/mesh/SurfaceTopology.h"
#include "Core/numerics/SparseSolver.h"

namespace authalic {

/// What may move in a start, and how the corners of its faces hang together.
struct StartSetting {
  const SurfaceTopology& topology;
  std::vector<char> held;  ///< n flags
  Points2 shifts;          ///< 3m×2 or empty, see BarycentricSolver
};

struct StretchStart {
  Points2 image;
  double error = 0;  ///< mean |ln r| of the stars
  int folded = 0;    ///< faces
};

/// The harmonic map with the held vertices of `image`, and rounds of the fixed point of the stretch energy
/// @cite yueh2019 from there, until the stars are within sight of their targets.
///
/// Cotangent weights keep angles better than any positive weights do, but folds are possible, and behind deep necks the
/// rounds do not converge: see what comes back before it is used.
/// @param goodEnough  mean |ln r| of the stars at which the rounds end
/// Complexity: one symbolic and at most 8 numeric sparse factorisations.
[[nodiscard]] StretchStart stretchStart(const TriangleMesh& surface, const StartSetting& setting, const Points2& image,
                                        const TargetMeasure& target, SolverBackend backend, double goodEnough,
                                        const Execution& execution);

}  // namespace authalic
