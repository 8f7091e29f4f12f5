/// @file
/// Kazhdan's conformal sphere: mean curvature flow with the conformal structure of the start kept.
#pragma once

#include "Core/base/Execution.h"
#include "Core/conformal/SphericalMapResult.h"
#include "Core/mesh/SphereMesh.h"
#include "Core/numerics/SparseSolver.h"

namespace authalic {

struct ConformalizedMeanCurvatureFlowOptions {
  double timeStep = 0.3;    ///< δ, the area of the flowing surface being 4π; the unit sphere flows by |x'| = 2/|x|
  double tolerance = 1e-5;  ///< of the change of the radii in one step, root mean square over the sphere
  int maxIterations = 200;
  SolverBackend solver = SolverBackend::Automatic;

  /// @throws InvalidArgument when a field is outside its range.
  void validate() const;
};

/// Flows the surface to a sphere by (M_k + δ L_0) f_{k+1} = M_k f_k @cite kazhdan2012, L_0 the stiffness of the
/// **start**, M_k the lumped mass of the flowing surface; the area is brought back to 4π and the centroid to 0
/// after every step.
///
/// Mean curvature flow with L_k in place of L_0 forms necks; freezing the conformal structure keeps it smooth on
/// every genus-0 surface that was tried, and its limit is a conformal map to a round sphere. At the end the surface
/// is put on the unit sphere along its radii, and its centre of mass to 0 (see normaliseSphere).
///
/// Does **not** guarantee convergence, nor unfolded faces → `status`, `flippedFaces`. `history`: the
/// changes of the radii; the tangential part of a step does not vanish: a discrete flow drifts on by Möbius
/// transformations. Complexity: one factorisation per step on one symbolic analysis.
/// @throws InvalidArgument when an option is bad
/// @throws SolverError     when the surface is too degenerate to factorise
[[nodiscard]] SphericalMapResult conformalizedMeanCurvatureFlow(
    const SphereMesh& sphere, const ConformalizedMeanCurvatureFlowOptions& options = {},
    const Execution& execution = {});

}  // namespace authalic
