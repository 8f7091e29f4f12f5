/// @file
/// A start for the flow on surfaces that a barycentric map shrinks beyond what a flow can undo. Private to authalic/.
#pragma once

#include <functional>
#include <vector>

#include "Core/authalic/TargetMeasure.h"
#include "Core/base/Execution.h"
#include "Core/geometry/Laplacian.h"
#include "Core/mesh/DiskMesh.h"
#include "Core/numerics/SparseSolver.h"

namespace authalic {

/// Barycentric maps with the boundary of `image`, reweighted until areas no longer come nearer to their targets.
///
/// Tutte's map shrinks what lies behind a narrow neck by the exponential of its depth; triangles of 1e-7 of their share
/// pin any flow. With r = image share / target share, of the stars of vertices i, j and of the faces s, t beside an
/// edge, each round sets
///
///     w_ij ← w_ij (r_i r_j)^¼ (r_s r_t)^¼
///
/// from w_ij = 1, and solves Σ_j w_ij (x_j − x_i) = 0: edges that are too long are stiffened, as in
/// @cite yoshizawa2004. The stars even out areas at large; the faces reach into nested three-cycles, whose stars see
/// the large faces around them. Along a tube the exponent of the shrinking falls from 1 to about 1/√(2k) after k
/// rounds.
///
/// Weights stay positive and symmetric, so no face flips on a convex domain, up to rounding. The round with the
/// smallest area distortion Σ m_t (r_t + 1/r_t) among those without a fold is returned (or `image`, where none
/// is better).
/// @param goodEnough  mean |ln r| of the stars at which the rounds end
/// Complexity: one symbolic and at most 15 numeric sparse factorisations.
[[nodiscard]] Points2 balancedStart(const DiskMesh& disk, const Points2& image, const TargetMeasure& target,
                                    SolverBackend backend, double goodEnough,
                                    const Execution& execution = {});

/// The same on the flat torus or the flat cylinder.
/// @param shifts  3m×2, see BarycentricSolver: corner 3 f + k lies at x_v + shift
/// @param held    n flags: vertices that stay
[[nodiscard]] Points2 balancedPeriodicStart(const SurfaceTopology& topology, const Points2& image,
                                            const Points2& shifts, const std::vector<char>& held,
                                            const TargetMeasure& target, SolverBackend backend, double goodEnough,
                                            const Execution& execution = {});

/// A barycentric map on any domain, and the areas of its faces.
struct BarycentricImage {
  HalfEdgeWeights weights;  ///< of the first round
  std::function<void(const HalfEdgeWeights& weights, Points2& image)> solve;
  std::function<Eigen::VectorXd(const Points2& image)> areas;
};

/// The same with such maps; weights are positive and the same both ways.
[[nodiscard]] Points2 balancedStart(const SurfaceTopology& topology, const BarycentricImage& map, const Points2& image,
                                    const TargetMeasure& target, double goodEnough, const Execution& execution);

/// The same within small patches around the faces that have collapsed (less than `collapsed` of their share), the rest
/// held; every patch has its own best round.
[[nodiscard]] Points2 reviveCollapsedFaces(const DiskMesh& disk, const Points2& image, const TargetMeasure& target,
                                           SolverBackend backend, double collapsed = 1e-2);

}  // namespace authalic
