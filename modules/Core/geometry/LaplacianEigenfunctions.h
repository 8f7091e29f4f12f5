/// @file
/// The lowest vibrations of a closed surface: eigenfunctions of its Laplace-Beltrami operator.
#pragma once

#include <Eigen/Core>

#include "Core/base/Execution.h"
#include "Core/base/Status.h"
#include "Core/mesh/TriangleMesh.h"
#include "Core/numerics/SparseSolver.h"

namespace authalic {

struct LaplacianEigenfunctionsOptions {
  int count = 1;            ///< how many, without the constant one; at least 1
  double tolerance = 1e-8;  ///< of the relative residual, > 0
  int maxSolves = 400;      ///< right-hand sides solved at most; at least 1
  SolverBackend solver = SolverBackend::Automatic;

  /// @throws InvalidArgument when a field is outside its range
  void validate() const;
};

struct LaplacianEigenfunctionsResult {
  Eigen::VectorXd values;         ///< count eigenvalues, ascending, 1/mm²
  Eigen::MatrixXd functions;      ///< n×count, 1/mm: Σ m_i u_i v_i is 1 or 0, Σ m_i u_i = 0
  Status status = Status::NotRun;  ///< Converged, or NotConverged when maxSolves was reached
  /// max over the pairs of ‖θ⁻¹ (L + σM)⁻¹ M u − u‖, θ = 1/(λ + σ), norm √(Σ m_i r_i²): a bound on the relative error
  /// of λ + σ that does not suffer from large cotangents
  double residual = 0;
  int solves = 0;                 ///< right-hand sides solved
  int multiplicity = 1;           ///< eigenvalues that equal the last one to 1e-6, itself included
};

/// Solves L u = λ M u for the smallest λ > 0, with L the cotangent stiffness and M the lumped mass (a third of the
/// areas around each vertex). @cite pinkall1993
///
/// Block Lanczos on (L + σM)⁻¹ M with full orthogonalisation, one factorisation, started from the coordinates of the
/// points (close to the answer for a closed surface) and a seeded random function. @cite golub1977
///
/// Gauge: equal eigenvalues (to 1e-6) share a space; its basis is the coordinates x, y, z in this order, projected onto
/// it and orthonormalised, so that every function has a positive product with the first coordinate that it is not
/// orthogonal to. Same input, same bits.
///
/// Guarantees: with Converged, residual ≤ tolerance. On a connected surface λ_1 > 0. The discrete nodal domains of u_1
/// need not be two where cotangent weights are negative (see levelSetCut).
/// Complexity: one factorisation, O(n^1.5), and about 20 to 40 solves for count = 1.
/// @param surface  connected, closed or with boundary (natural boundary conditions)
/// @throws InvalidArgument, SolverError, CancelledError; GeometryError when the surface has no area or fewer vertices
///         than functions are asked for
[[nodiscard]] LaplacianEigenfunctionsResult laplacianEigenfunctions(const TriangleMesh& surface,
                                                                    const LaplacianEigenfunctionsOptions& options = {},
                                                                    const Execution& execution = {});

}  // namespace authalic
