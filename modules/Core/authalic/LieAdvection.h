/// @file
/// Area-preserving maps by Lie advection in a given number of steps: of a disk, and what those of other surfaces
/// share.
#pragma once

#include <vector>

#include "Core/authalic/DiscreteLieFlow.h"

namespace authalic {

struct LieAdvectionOptions {
  PlanarDomain domain;  ///< unit disk; must be the domain of the initial map; for maps of a disk only
  int steps = 50;       ///< K, ≥ 1; the paper's choice
  bool unfold = true;   ///< unfold original faces that are folded at the end
  SolverBackend solver = SolverBackend::Automatic;

  /// @throws InvalidArgument naming the field that is outside its range.
  void validate() const;
};

/// How an advection ended, on any domain.
struct LieAdvectionSolution {
  Status status = Status::NotRun;  ///< Converged: all K steps were taken in full; NotConverged: some were cut short
  int iterations = 0;              ///< steps taken
  int slowedVertices = 0;          ///< most vertices that were slowed in one step, lest a face folds
  int shortenedSteps = 0;          ///< steps that would have folded a face of the flowing mesh and were cut short
  double residual = 0;             ///< as LieFlowIteration::residual, of `image` on the original connectivity
  int edgeFlips = 0;
  int flippedBeforeUnfolding = 0;  ///< original faces folded after the last step
  int flippedFaces = 0;            ///< original faces folded in `image`
  double startSeconds = 0, advectionSeconds = 0, unfoldSeconds = 0;
  std::vector<LieFlowIteration> history;  ///< one entry per step; `step` = part of the displacement that was taken
};

struct LieAdvectionResult : LieAdvectionSolution {
  Points2 image;  ///< n×2, on the domain; vertices in the order of the input
};

/// Advects the area form of the plane to that of the surface in K steps @cite zou2011 (Algorithm 1).
///
/// Step k = 1 … K: flip edges of the flowing mesh until it is Delaunay; λ_v = target / image area of the star of v;
///
///     h = 1 + (λ − 1)/(K − k + 1),    Δg = h − 1,    x += (ln h)/(h − 1) ∇g
///
/// with natural boundary, the right side made to sum to 0, g by symmetric stiffness (L g = −A_Ω (h − 1)), and vertex
/// gradients weighted by angles; (ln h)/(h − 1) integrates the velocity ∇g/((1 − t) + t h) over t ∈ [0, 1]. Boundary
/// vertices slide on the circle or their side, corners stay. The last step aims at what is left
/// (docs/methods/lie-advection.md has the error against K).
///
/// Corners of faces that would fold on the way take the mean displacement of their neighbours, then are slowed by
/// themselves (`slowedVertices`); where that does not suffice the step is halved, and counted. The schedule makes
/// up for it later. λ is kept within e^±3 in one step.
///
/// @param initial  n×2, a map to the same domain, boundary on its boundary; folds in it are unfolded first; on a
///                 polygon that is not convex as in discreteLieFlow()
/// Guarantees: with `unfold`, no folded face on a convex domain; finite; the boundary on that of the domain (pockets
/// excepted). Not guaranteed: exact areas (→ residual); see authalicMap() for those. Complexity: K sparse
/// factorisations, O(K n^1.5). When cancelled, the last iterate is returned with Status::Cancelled.
/// @throws InvalidArgument from options; GeometryError when initial or target do not belong to the disk or
///         the domain; SolverError when a system cannot be factorised
[[nodiscard]] LieAdvectionResult lieAdvection(const DiskMesh& disk, const Points2& initial,
                                              const TargetMeasure& target, const LieAdvectionOptions& options = {},
                                              const Execution& execution = {});

}  // namespace authalic
