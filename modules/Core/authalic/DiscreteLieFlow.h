/// @file
/// Area-preserving and measure-controlled maps by the discrete Lie flow: of a disk, and what those of other surfaces
/// share.
#pragma once

#include <vector>

#include "Core/authalic/TargetMeasure.h"
#include "Core/base/Execution.h"
#include "Core/base/Status.h"
#include "Core/geometry/PlanarDomain.h"
#include "Core/mesh/DiskMesh.h"
#include "Core/numerics/SparseSolver.h"

namespace authalic {

/// What happens after the flow, on the connectivity of the input.
enum class LieFlowFinish {
  None,    ///< nothing: the flow of the paper; original faces may be folded
  Unfold,  ///< folded faces are unfolded
  Match,   ///< then least-squares Lie steps on the original faces match their areas
};

struct DiscreteLieFlowOptions {
  PlanarDomain domain;        ///< unit disk; must be the domain of the initial map; for maps of a disk only
  double tolerance = 5e-3;    ///< stop when the residual falls below it, > 0
  int maxIterations = 60;     ///< steps of the flow, ≥ 0
  double flowTolerance = 0.05;///< hand over to Match when the flow's own residual falls below it, > 0; also
                              ///< when mean |ln r| ≤ 0.6 and 5 steps lower neither error by 15 %
  double stepRatio = 0.6;     ///< μ of the adaptive step, in (0, 1)
  double fixedStep = 0;       ///< > 0: this step instead of the adaptive one (may collapse the mesh)
  bool keepInitial = false;   ///< flow from the initial map however far off it is: nearer to optimal transport, slower;
                              ///< for maps of a disk only
  LieFlowFinish finish = LieFlowFinish::Match;
  int maxFinishIterations = 40;  ///< least-squares steps of one pass, ≥ 0; further passes (3 at most) where faces had
                                 ///< collapsed
  SolverBackend solver = SolverBackend::Automatic;

  /// @throws InvalidArgument naming the field that is outside its range.
  void validate() const;
};

/// One step of the flow or of the finish.
struct LieFlowIteration {
  double residual = 0;    ///< before the step: (Σ m_v (r_v − 1)²)^½, r_v = image share / target share of a vertex star
  double meanAbsLog = 0;  ///< before the step: Σ m_v |ln r_v|
  double step = 0;        ///< λ taken
  int edgeFlips = 0;      ///< edges flipped before the step (flow only)
  bool finishing = false; ///< a step on the original connectivity
};

/// How a flow ended, on any domain.
struct LieFlowSolution {
  Status status = Status::NotRun; ///< Converged: residual ≤ tolerance on the original connectivity, and no fold
  bool balancedStart = false;     ///< the initial map was too far off and was balanced first, see discreteLieFlow
  int iterations = 0;             ///< steps of the flow
  int finishIterations = 0;       ///< steps of the finish, all passes
  double residual = 0;            ///< of `image` on the original connectivity
  bool collapsed = false;         ///< a fixed step folded the flowing mesh; the image is the one before that step
  int edgeFlips = 0;              ///< total of the flow
  int flippedBeforeFinish = 0;    ///< original faces folded when the flow ended
  bool flowUndone = false;        ///< folds stayed after the flow, or a few faces pinned it far from the target (four
                                  ///< steps below 1e-3, mean |ln r| > 0.6): the finish began at its start instead
  int flippedFaces = 0;           ///< original faces folded in `image`
  std::vector<LieFlowIteration> history;
  double startSeconds = 0, flowSeconds = 0, unfoldSeconds = 0, finishSeconds = 0;
};

struct DiscreteLieFlowResult : LieFlowSolution {
  Points2 image;  ///< n×2, on the domain; vertices in the order of the input
};

/// Flows a map of a disk until every vertex star has its target area.
///
/// Each step @cite su2019 (Algorithm 1, with its signs put right):
///   1. flip edges of the flowing mesh until it is Delaunay;
///   2. solve L h = A_Ω − A_M with natural (Neumann) boundary: L the cotangent stiffness of the flowing mesh
///      (positive semi-definite), A_Ω its vertex areas, A_M the target areas scaled to the same total;
///   3. move by λ ∇h, face gradients averaged with the incident angles, λ = min(1, μ · first flip);
///      boundary vertices slide on the circle or their side, corners stay.
/// This is a discretised Moser flow: ∇h carries the area form of the plane to the target measure.
///
/// The flow's mesh is not the input's: original faces may be folded when it ends (`flippedBeforeFinish`). The finish
/// unfolds them (patches around them are re-embedded by convex weights, growing until no fold is left; in the limit
/// the patch is the whole disk and the map Tutte's) and then takes Lie steps on the original connectivity whose
/// divergence matches the face areas in the least-squares sense,
///   min_δ Σ_t (a_t + ∇a_t·δ − S m_t)² / (S m_t) + ε Σ_{edges ij} |δ_i − δ_j|²,
/// so that the areas that are reported are those of the mesh that the user has.
///
/// Where the initial map is so far off that its smallest triangles would pin the flow (some vertex star has less than
/// e⁻⁸ or more than e⁸ of its share), and finish is Match, a reweighted barycentric map with the same boundary takes
/// its place and the flow is left out (`balancedStart`, 0 iterations): what is left to do are the least-squares Lie
/// steps. With `keepInitial` the flow goes as far as it gets instead.
///
/// On a polygon that is not convex the initial map may be folded beyond unfolding; then only its boundary is taken,
/// and the start is a map of the surface to the disk, followed by the inverse of one of the polygon (polygonStart in
/// authalic/). Where unfolding after the flow leaves folds, the finish begins at that start
/// (`flowUndone`).
///
/// @param initial  n×2, a map to the same domain, boundary on its boundary (any barycentric map); folds in it are
///                 unfolded first
/// @param target   shares per face, from TargetMeasure for this surface
///
/// Guarantees: with finish ≠ None the image has no folded face, whatever the status; it is finite;
/// the boundary lies on the boundary of the domain (pockets excepted, see BoundaryPlacement). Not guaranteed: that
/// the tolerance is reached (→ status, residual), a bound on angle distortion, the optimal-transport map.
/// Complexity: one sparse factorisation per step, O(n^1.5).
/// When cancelled, the last valid iterate is returned with Status::Cancelled.
/// @throws InvalidArgument from options; GeometryError when initial or target do not belong to the disk or the
///         domain, or no start without folds was found (polygons that are not convex only); SolverError when a system
///         cannot be factorised
[[nodiscard]] DiscreteLieFlowResult discreteLieFlow(const DiskMesh& disk, const Points2& initial,
                                                    const TargetMeasure& target,
                                                    const DiscreteLieFlowOptions& options = {},
                                                    const Execution& execution = {});

}  // namespace authalic
