/// @file
/// The stages of the Lie flows, and the steps that they share. Private to authalic/.
#pragma once

#include <functional>

#include "Core/authalic/DiscreteLieFlow.h"
#include "Core/authalic/SlidingBoundary.h"
#include "Core/mesh/SurfaceTopology.h"

namespace authalic {

/// Residual and mean |ln r| of the vertex stars, see LieFlowIteration.
/// @param areas    image areas of the vertex stars, any scale
/// @param targets  target shares; vertices with target 0 are left out
[[nodiscard]] LieFlowIteration measureStars(const Eigen::VectorXd& areas, const Eigen::VectorXd& targets);

/// h with L h = rightHandSide (whose sum is 0) and natural boundary, L the cotangent stiffness; h = 0 at the first
/// vertex of face 0 and at those that no face uses.
/// @throws SolverError when the matrix cannot be factorised
[[nodiscard]] Eigen::VectorXd solvePoisson(const Points2& points, const Faces& faces,
                                           const Eigen::VectorXd& rightHandSide, SolverBackend backend);

/// Target shares of the vertices outside the pockets, summing to 1; 0 elsewhere.
[[nodiscard]] Eigen::VectorXd flowingTargets(const DiskMesh& disk, const BoundaryPlacement& placement,
                                             const TargetMeasure& target);

/// A triangle that moves rigidly cannot collapse: where a few triangles would pin the whole flow (they collapse
/// before the wanted part of the step), their corners take the mean velocity of their neighbours instead, a few
/// times over.
void relaxPinned(const Points2& points, const Faces& faces, const SlidingBoundary& sliding, double wanted,
                 Points2& velocity);

/// Flows `result.image` on a mesh that flips its edges; fills iterations, history, collapsed and status.
void flowWithFlips(const DiskMesh& disk, const BoundaryPlacement& placement, const SlidingBoundary& sliding,
                   const TargetMeasure& target, const DiscreteLieFlowOptions& options, const Execution& execution,
                   DiscreteLieFlowResult& result);

/// Least-squares Lie steps on the original connectivity; the image must have no fold, and keeps none.
void matchAreas(const DiskMesh& disk, const SlidingBoundary& sliding, const TargetMeasure& target,
                const DiscreteLieFlowOptions& options, const Execution& execution, DiscreteLieFlowResult& result);

}  // namespace authalic
