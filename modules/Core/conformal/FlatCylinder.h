/// @file
/// An annulus as a flat cylinder of circumference 2π, unrolled. Private to conformal/.
#pragma once

#include <vector>

#include "Core/base/Execution.h"
#include "Core/conformal/YamabeFlow.h"
#include "Core/geometry/Development.h"
#include "Core/topology/AnnulusCut.h"

namespace authalic {

struct FlatCylinder {
  YamabeFlowResult flow;  ///< with u that of the cylinder of circumference 2π
  AnnulusCut cut;
  /// n×2: (ξ, θ), conformal and oriented, ξ = 0 on the outer loop and −height on the inner, θ known up to 2π; an
  /// edge from i to j runs from (ξ, θ)_i to (ξ, θ)_j + (0, 2π turns · w_ij).
  Points2 strip;
  int turns = 1;            ///< ±1: θ that winding number 1 adds, over 2π
  double height = 0;        ///< ln R/r
  double holonomy = 0;      ///< of the development
  double straightness = 0;  ///< max deviation of the loops from ξ = 0 and ξ = −height, in circumferences
};

/// Flow to K̄ = 0 everywhere, cut along a shortest path between the loops, develop.
/// @param topology        of an annulus with these two loops
/// @param trackCrossings  whether the triangulation tracks the edges of the surface, for a common refinement
[[nodiscard]] FlatCylinder flatCylinder(const TriangleMesh& mesh, const SurfaceTopology& topology,
                                        const std::vector<int>& outer, const std::vector<int>& inner,
                                        const YamabeFlowOptions& options, const Execution& execution,
                                        bool trackCrossings = false);

/// e^{ξ + iθ} of every row.
[[nodiscard]] Points2 exponential(const Points2& strip);

}  // namespace authalic
