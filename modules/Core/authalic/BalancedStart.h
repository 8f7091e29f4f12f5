/// @file
/// A start for the flow on surfaces that a barycentric map shrinks beyond what a flow can undo. Private to authalic/.
#pragma once

#include "Core/authalic/TargetMeasure.h"
#include "Core/base/Execution.h"
#include "Core/mesh/DiskMesh.h"
#include "Core/numerics/SparseSolver.h"

namespace authalic {

/// Barycentric maps with the boundary of `image`, reweighted until areas no longer come nearer to their targets.
///
/// Tutte's map shrinks what lies behind a narrow neck by the exponential of its depth; triangles of 1e-7 of their share
/// pin any flow. With r_i = image share / target share of a vertex star, each round sets
///
///     w_ij ← w_ij (r_i r_j)^(s/2),  s = 0.35,
///
/// from w_ij = 1, and solves Σ_j w_ij (x_j − x_i) = 0: edges that are too long are stiffened, as in @cite yoshizawa2004.
/// Weights stay positive and symmetric, so no face flips on a convex domain. The round with the smallest area
/// distortion Σ m_t (r_t + 1/r_t) is returned, or `image` where no round is better.
/// Complexity: one sparse factorisation per round, at most 20.
[[nodiscard]] Points2 balancedStart(const DiskMesh& disk, const Points2& image, const TargetMeasure& target,
                                    SolverBackend backend, const Execution& execution = {});

}  // namespace authalic
