/// @file
/// The conformal map of a closed surface to the sphere by cutting, two Riemann maps and welding.
#pragma once

#include <array>

#include "Core/base/Execution.h"
#include "Core/conformal/ConformalWelding.h"
#include "Core/conformal/RiemannMap.h"
#include "Core/conformal/SphericalMapResult.h"
#include "Core/mesh/SphereMesh.h"
#include "Core/topology/LevelSetCut.h"

namespace authalic {

struct WeldedSphereMapOptions {
  LevelSetCutOptions cut;      ///< of the first eigenfunction, whose values are of the order 1/√area
  RiemannMapOptions riemann;   ///< of both halves; what goes to their centres does not matter
  double eigenTolerance = 1e-8;  ///< of the eigenfunction whose zero set is the seam, > 0
  bool unfold = true;          ///< re-embed patches around folded faces

  /// @throws InvalidArgument when a field is outside its range
  void validate() const;
};

/// What is known of one half.
struct WeldedHalfReport {
  double area = 0;  ///< mm²
  int vertices = 0;  ///< of the half, seam points included
  Status status = Status::NotRun;
  int iterations = 0;
  double residual = 0;   ///< max |K − K̄|, radians
  int flippedFaces = 0;  ///< faces of the half that are folded in its disk
};

/// `history`: residuals of the flow above, then below; `residual`: the larger last one; `iterations`: both together.
struct WeldedSphereMapResult : SphericalMapResult {
  double eigenvalue = 0;  ///< 1/mm²
  int seamPoints = 0;
  double seamLength = 0;  ///< mm
  int mergedPieces = 0;   ///< see LevelSetCutResult
  std::array<WeldedHalfReport, 2> halves;  ///< above, below
  WeldingAccuracy accuracy;
  int separatedVertices = 0;    ///< ends of edges without length, moved apart before anything else
};

/// Maps a closed surface conformally to the unit sphere @cite nadeem2017 (algorithm 2):
///
///   1. cut along {u = 0} of the first Laplacian eigenfunction u, through the faces;
///   2. map both halves to unit disks (riemannMap);
///   3. weld the disks along the seam (ConformalWelding) and lift the plane to the sphere;
///   4. move the centre of mass to 0 (normaliseSphere, without a rotation);
///   5. unfold the few faces that are folded, if any (unfoldOnSphere).
///
/// The image is that of the surface's own vertices and faces; seam points serve the way only. No step has a pole, a
/// starting map or a preferred vertex. The angles along the seam are as good as elsewhere: the zipper matches every
/// seam point, and its error between them is of higher order than that of the halves.
///
/// Guarantees: commutes with similarities and renumbering, up to a rotation and the tolerances; the same bits at any
/// thread count.
/// Status: Converged when both flows are. Not guaranteed: no folded face → `flippedFaces`.
/// Complexity O(n^1.5) for the flows and O(n s) for a seam of s points.
/// @throws InvalidArgument from options; SolverError; GeometryError when the surface has no area
/// @throws CancelledError when the caller stops
[[nodiscard]] WeldedSphereMapResult weldedSphereMap(const SphereMesh& sphere,
                                                    const WeldedSphereMapOptions& options = {},
                                                    const Execution& execution = {});

}  // namespace authalic
