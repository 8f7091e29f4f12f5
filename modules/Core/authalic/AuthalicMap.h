/// @file
/// The exact authalic solve: maps whose vertex stars have their target areas to machine precision.
#pragma once

#include <vector>

#include "Core/authalic/TargetMeasure.h"
#include "Core/base/Execution.h"
#include "Core/base/Status.h"
#include "Core/geometry/PlanarDomain.h"
#include "Core/mesh/DiskMesh.h"
#include "Core/numerics/AnalysedSystems.h"

namespace authalic {

struct AuthalicMapOptions {
  PlanarDomain domain;             ///< unit disk; for maps of a disk only
  double tolerance = 1e-2;         ///< of the face residual (D_area − 2)^½, > 0
  double vertexTolerance = 1e-10;  ///< of max |ln r_v| over vertex stars, > 0
  int maxIterations = 300;         ///< face and vertex steps together, ≥ 0
  SolverBackend solver = SolverBackend::Automatic;

  /// @throws InvalidArgument naming the field that is outside its range.
  void validate() const;
};

/// One step of the solve.
struct AuthalicIteration {
  double residual = 0;  ///< before the step: the face residual of a face step, max |ln r_v| of a vertex step
  double step = 0;      ///< part of the Newton step that was taken; 0 = none
  bool exact = false;   ///< a vertex step
};

/// How the solve ended, on any domain.
struct AuthalicSolution {
  Status status = Status::NotRun;  ///< Converged: both residuals within their tolerances, and no fold
  int iterations = 0;              ///< steps of both kinds
  double faceResidual = 0;         ///< (D_area − 2)^½ = (Σ m_t (r_t + 1/r_t − 2))^½, r = image share / target share
  double vertexResidual = 0;       ///< max |ln r_v| of the image
  int flippedFaces = 0;
  std::vector<AuthalicIteration> history;
  double startSeconds = 0, faceSeconds = 0, vertexSeconds = 0;
};

struct AuthalicMapResult : AuthalicSolution {
  Points2 image;  ///< n×2, on the domain; vertices in the order of the input
};

/// Maps a disk to a planar domain so that every vertex star has its target area and every face nearly so.
///
/// 1. *Start*: `initial`, or rounds of the fixed point of the stretch energy @cite yueh2019 from the harmonic map,
///    with room for ears on the circle; where those fold too much or stay far from the areas, a reweighted Tutte map,
///    if that is nearer (see makeRoomOnCircle, stretchStart and balancedStart in authalic/).
/// 2. *Face steps*: damped Gauss–Newton on D_area = Σ_t m_t (r_t + 1/r_t), r the image share of a face by its
///    target m, together with the Dirichlet energy of the map at a weight that falls to nothing: of the many
///    area-preserving maps one with good angles. Inner vertices move freely, those of the boundary along it.
/// 3. *Steps on the stars*, where these are not within their tolerance: at most three face steps that obey the
///    linearised equations of the stars, see StarConstraint, so that the vertex steps hardly move a face.
/// 4. *Vertex steps*: Newton on the star areas, c_v = ⅓ Σ_{t∋v} a_t − S n_v, δ = −W⁻¹ Jᵀ (J W⁻¹ Jᵀ)⁻¹ c: the
///    step of Lie advection @cite zou2011 with the divergence that belongs to the discrete areas. 3 … 5 of them
///    reach 1e-12.
///
/// Where vertex steps would fold a face its corners are stiffened, and when that does not help the face steps go on
/// to half the residual. What does not converge from the fixed point is tried again from the reweighted Tutte map, on
/// areas alone. There are 2 n_I + n_B unknowns against 2 n_I + n_B − 3 face areas, so that exact faces are within reach
/// only where the mesh allows it: faces are matched to `tolerance`, stars exactly.
///
/// @param initial  n×2, a map to the same domain with the boundary on its boundary, or empty; folds in it are
/// unfolded first
/// @param systems  for several targets on one disk: what depends on the mesh alone is kept in it from map to map
/// @param target   shares per face, from TargetMeasure for this surface; a region's share is exact at its vertices
///
/// Guarantees: no folded face on a convex domain, whatever the status; the boundary lies on that of the domain
/// (pockets excepted, see BoundaryPlacement); when not converged, the best iterate with its residuals. Not
/// guaranteed: a bound on angle distortion (measured, it is within a few per cent of that of the fixed point).
/// Complexity: one sparse factorisation of size 2 n per face step, one of size n per vertex step, O(n^1.5) each.
/// @throws InvalidArgument from options; GeometryError when initial or target do not belong to the disk or
///         the domain; SolverError when a system cannot be factorised
[[nodiscard]] AuthalicMapResult authalicMap(const DiskMesh& disk, const TargetMeasure& target,
                                            const AuthalicMapOptions& options = {}, const Points2& initial = {},
                                            const Execution& execution = {}, AnalysedSystems* systems = nullptr);

}  // namespace authalic
