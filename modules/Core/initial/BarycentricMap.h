/// @file
/// Maps of a disk to a planar domain in which every inner vertex is the weighted mean of its neighbours.
#pragma once

#include <vector>

#include "Core/base/Execution.h"
#include "Core/base/Status.h"
#include "Core/geometry/Laplacian.h"
#include "Core/geometry/PlanarDomain.h"
#include "Core/initial/BoundaryPlacement.h"
#include "Core/mesh/DiskMesh.h"
#include "Core/numerics/SparseSolver.h"

namespace authalic {

/// The weights w_ij of a barycentric map.
enum class BarycentricWeights {
  Uniform,    ///< w_ij = 1: Tutte's embedding @cite tutte1963. Looks at the connectivity only; the safest start
  Harmonic,   ///< w_ij = ½(cot α + cot β): the discrete harmonic map @cite pinkall1993. Low angle distortion; may fold
  MeanValue,  ///< w_ij = (tan ½α + tan ½β)/|ij| @cite floater2003. Nearly harmonic, never folds
};

/// "tutte", "harmonic", "mean-value".
[[nodiscard]] const char* barycentricWeightsName(BarycentricWeights weights) noexcept;

/// w_ij of every half-edge seen from its tail and from its head; both are the same but for MeanValue.
[[nodiscard]] MeanValueWeights barycentricWeights(const TriangleMesh& surface, BarycentricWeights weights);

struct BarycentricMapOptions {
  BarycentricWeights weights = BarycentricWeights::MeanValue;
  PlanarDomain domain;   ///< unit disk
  int startVertex = -1;  ///< boundary vertex at angle 0 or corner 0; −1: the one with the smallest id
  SolverBackend solver = SolverBackend::Automatic;

  /// @throws InvalidArgument when a field is outside its range.
  void validate() const;
};

struct BarycentricMapResult {
  Points2 image;                    ///< n×2, counter-clockwise
  Status status = Status::NotRun;   ///< Converged when the system was solved
  int flippedFaces = 0;             ///< faces without a positive signed area
  int degenerateFaces = 0;          ///< faces without area on the surface, whose weights were clamped
  BoundaryPlacement boundary;       ///< where the boundary went, and the pockets bulged out of straight sides
  double residual = 0;              ///< max |Σ_j w_ij (x_j − x_i)| / Σ_j |w_ij| over inner vertices
  double seconds = 0;
};

/// Solves Σ_j w_ij (x_j − x_i) = 0 at every inner vertex i, with the boundary on that of the domain.
///
/// The boundary is spread by arc length (see placeBoundary); the image is positively oriented. The gauge (rotation
/// of the disk, first corner) is fixed by `startVertex`, so that a run can be repeated bit by bit.
///
/// Guarantees: with Uniform or MeanValue weights on a convex domain no face flips, up to rounding, also where ear
/// triangles lie on a straight side (they are bulged out of it, `boundary.pockets`). Harmonic weights are
/// negative across obtuse angle pairs, and on a non-convex polygon no weights help: then faces may flip
/// → `flippedFaces`. The harmonic image minimises the Dirichlet energy for its boundary. On a closed flat convex
/// patch whose boundary is given to itself all but Uniform reproduce the identity.
///
/// Complexity: one sparse factorisation, O(n^1.5); MeanValue is not symmetric and is solved by GMRES with the
/// factorised symmetric part as preconditioner, to 1e-14 of the image.
/// @throws InvalidArgument, TopologyError, GeometryError from the boundary (see placeBoundary)
/// @throws SolverError when the system cannot be factorised
/// @throws CancelledError when the caller stops before the solve
[[nodiscard]] BarycentricMapResult barycentricMap(const DiskMesh& disk, const BarycentricMapOptions& options = {},
                                                  const Execution& execution = {});

}  // namespace authalic
