/// @file
/// Locally injective maps of a disk that are as isometric as they can be: the symmetric Dirichlet energy.
#pragma once

#include <vector>

#include "Core/base/Execution.h"
#include "Core/base/Status.h"
#include "Core/mesh/DiskMesh.h"
#include "Core/numerics/SparseSolver.h"

namespace authalic {

/// What the boundary of the image may do.
enum class IsometricBoundary {
  Free,   ///< moves with the rest; the map is scaled to the surface
  Fixed,  ///< stays where the start has it
};

/// "free", "fixed".
[[nodiscard]] const char* isometricBoundaryName(IsometricBoundary boundary) noexcept;

struct SymmetricDirichletMapOptions {
  IsometricBoundary boundary = IsometricBoundary::Free;
  double tolerance = 1e-5;   ///< of the Newton decrement, √(gᵀH⁻¹g / E); E is flat to rounding below 1e-7
  int maxIterations = 100;
  SolverBackend solver = SolverBackend::Automatic;

  /// @throws InvalidArgument when a field is outside its range.
  void validate() const;
};

struct SymmetricDirichletIteration {
  double energy = 0;     ///< E before the step; 4 for an isometry
  double decrement = 0;  ///< √(gᵀH⁻¹g / E)
  double step = 0;       ///< share of the Newton step taken
};

struct SymmetricDirichletMapResult {
  Points2 image;                   ///< n×2: free: mm, centroid 0, farthest boundary pair along x; fixed: as the start
  Status status = Status::NotRun;
  int iterations = 0;
  std::vector<SymmetricDirichletIteration> history;
  double energy = 0;               ///< E of the image
  double residual = 0;             ///< the last decrement
  int flippedFaces = 0;            ///< 0: no step folds a face
  int degenerateFaces = 0;         ///< faces without area on the surface: no share in E, kept unfolded all the same
  double seconds = 0;
};

/// Minimises E = Σ_t ρ_t (σ1² + σ1⁻² + σ2² + σ2⁻²), ρ_t the face's share of the surface area, σ the singular values
/// of its Jacobian: the energy of SLIM @cite rabinovich2017. It is 4 for an isometry and infinite where a face
/// collapses.
///
/// Projected Newton in place of SLIM's reweighting: the Hessian of each face, whose four eigenpairs are known in
/// closed form @cite smith2019 (two stretches, one flip, one twist; only the twist can be negative and is then left
/// out), on a pattern ordered once. Quadratic at the end, where SLIM is linear. Steps: min(1, 0.9 of the first
/// collapse), halved until E falls enough (Armijo). With Fixed, the surface counts as scaled to the area of the
/// start.
///
/// @param start  n×2, every face counter-clockwise: barycentricMap with tutte or mean-value weights
/// Guarantees: no face of the image is folded (local injectivity), E never rises, same input same bits. Does **not**
/// guarantee that distant parts of a free boundary do not overlap.
/// Complexity: one factorisation with 2n unknowns per iteration, O(n^1.5); 10 to 60 iterations.
/// @throws InvalidArgument when an option is bad
/// @throws GeometryError   when the start has another number of points or folded faces
/// @throws SolverError     when the system cannot be factorised
[[nodiscard]] SymmetricDirichletMapResult symmetricDirichletMap(const DiskMesh& disk, const Points2& start,
                                                                const SymmetricDirichletMapOptions& options = {},
                                                                const Execution& execution = {});

}  // namespace authalic
