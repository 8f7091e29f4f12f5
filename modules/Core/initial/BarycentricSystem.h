/// @file
/// The linear systems behind barycentric maps: every free vertex at the weighted mean of its neighbours.
#pragma once

#include <vector>

#include "Core/geometry/Laplacian.h"
#include "Core/numerics/ElementAssembly.h"

namespace authalic {

/// Solves Σ_j w_ij (x_j − x_i) = 0 for the vertices that are not held; `image` holds the others and takes the result.
///
/// @param weights  per half-edge, the same both ways: a symmetric system, one Cholesky factorisation
/// @param held     n flags: vertices whose place is given
/// @throws SolverError when the system is not definite
void solveBarycentric(const Faces& faces, const HalfEdgeWeights& weights, const std::vector<char>& held,
                      SolverBackend backend, Points2& image);

/// The same for many weights on one mesh: the pattern is found and ordered once.
class BarycentricSolver {
 public:
  BarycentricSolver(const Faces& faces, const std::vector<char>& held, SolverBackend backend, int threads = 1);

  /// @param weights  per half-edge, the same both ways
  /// @param shifts   3m×2 or empty: corner 3 f + k is at x_v + shift, so that Σ_j w_ij (x_j + s_j − x_i − s_i) = 0; for
  ///                 periodic images, with the same difference of shifts on both sides of an edge
  /// @throws SolverError when the system is not definite
  void solve(const HalfEdgeWeights& weights, Points2& image, const Points2& shifts = {});

 private:
  const Faces& faces_;
  std::vector<int> vertices_;           // of each unknown
  ElementAssembly::Unknowns unknowns_;  // of each corner, −1 where held
  ElementAssembly assembly_;
  SparseSolver solver_;
};

/// The same with different weights each way @cite floater2003, rows scaled towards symmetry, solved by GMRES on both
/// coordinates with the factorised symmetric part as preconditioner, to 1e-13 of the solution; by sparse LU where
/// that stalls.
/// @param shifts  as for BarycentricSolver
void solveBarycentric(const Faces& faces, const MeanValueWeights& weights, const std::vector<char>& held,
                      SolverBackend backend, Points2& image, const Points2& shifts = {});

}  // namespace authalic
