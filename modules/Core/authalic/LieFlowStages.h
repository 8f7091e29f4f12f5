/// @file
/// The two stages of the discrete Lie flow. Private to authalic/.
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

/// Flows `result.image` on a mesh that flips its edges; fills iterations, history, collapsed and status.
void flowWithFlips(const DiskMesh& disk, const BoundaryPlacement& placement, const SlidingBoundary& sliding,
                   const TargetMeasure& target, const DiscreteLieFlowOptions& options, const Execution& execution,
                   DiscreteLieFlowResult& result);

/// Least-squares Lie steps on the original connectivity; the image must have no fold, and keeps none.
void matchAreas(const DiskMesh& disk, const SlidingBoundary& sliding, const TargetMeasure& target,
                const DiscreteLieFlowOptions& options, const Execution& execution, DiscreteLieFlowResult& result);

}  // namespace authalic
