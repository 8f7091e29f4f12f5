/// @file
/// Least-squares conformal maps of a disk: free boundary, one sparse factorisation.
#pragma once

#include <vector>

#include "Core/base/Execution.h"
#include "Core/base/Status.h"
#include "Core/mesh/DiskMesh.h"
#include "Core/numerics/SparseSolver.h"

namespace authalic {

/// What keeps the map from shrinking to a point.
enum class ConformalPins {
  TwoVertices,  ///< two boundary vertices are held at their distance @cite levy2002: one linear solve
  Spectral,     ///< none: the boundary has mean 0 and mean square 1 @cite mullen2008: an eigenproblem
};

/// "two-vertices", "spectral".
[[nodiscard]] const char* conformalPinsName(ConformalPins pins) noexcept;

struct LeastSquaresConformalMapOptions {
  ConformalPins pins = ConformalPins::TwoVertices;
  int firstPin = -1;   ///< boundary vertex; −1 (both): the two boundary vertices farthest apart in space
  int secondPin = -1;  ///< boundary vertex. Spectral: the pins only fix the rotation
  double tolerance = 1e-9;   ///< Spectral: change of the boundary in one iteration, of its mean radius
  int maxIterations = 200;   ///< Spectral
  SolverBackend solver = SolverBackend::Automatic;

  /// @throws InvalidArgument when a field is outside its range.
  void validate() const;
};

struct LeastSquaresConformalMapResult {
  Points2 image;  ///< n×2, mm: area that of the surface, centroid 0, second pin to the right of the first
  Status status = Status::NotRun;  ///< NotConverged: the eigenvector had not settled
  int iterations = 0;              ///< Spectral
  std::vector<double> history;     ///< Spectral: change per iteration
  double conformalEnergy = 0;      ///< (E_D − A)/A of the image: 0 for a similarity on every face
  int firstPin = -1, secondPin = -1;
  int flippedFaces = 0;            ///< faces without a positive signed area
  int degenerateFaces = 0;         ///< faces without area on the surface, whose shape was clamped
  double seconds = 0;
};

/// Minimises the conformal energy E_C(x, y) = ½ Σ_t A_t |∇x − J∇y|² = E_D − A, the Dirichlet energy less the area
/// of the image; E_C = 0 exactly when every face is mapped by a similarity.
///
/// With z = x + i y, L the cotangent stiffness and S_ij = ±1 on boundary edges, E_C = ½ zᴴ M z, M = L + ½ i S:
/// interior vertices couple x and y nowhere. TwoVertices solves M z = 0 off the pins. Spectral finds the smallest λ
/// > 0 of M z = λ B z, B the boundary's lumped length, zᴴB1 = 0: subspace iteration with one factorisation of M + εB.
///
/// Where the boundary should be a circle use a harmonic or Riemann map; the boundary here takes the shape that
/// distorts angles least. Pins bend the map near them on strongly curved surfaces; Spectral has no such vertices.
///
/// Guarantees: positive semi-definite for any mesh (the shape of degenerate faces is clamped consistently); flat
/// disks are reproduced up to a similarity; same input, same bits. Does **not** guarantee unfolded faces →
/// `flippedFaces`, nor that distant parts of the boundary do not overlap. Not to be had: a map with neither; use
/// SymmetricDirichletMap to start from an unfolded one.
///
/// Complexity: one factorisation with 2n unknowns, O(n^1.5); Spectral adds one solve of 3 columns per iteration.
/// @throws InvalidArgument when a pin is not on the boundary
/// @throws GeometryError   when the two pins coincide in space, or the image has no area
/// @throws SolverError     when the system cannot be factorised
/// @throws CancelledError  when the caller stops before there is an image
[[nodiscard]] LeastSquaresConformalMapResult leastSquaresConformalMap(
    const DiskMesh& disk, const LeastSquaresConformalMapOptions& options = {}, const Execution& execution = {});

}  // namespace authalic
