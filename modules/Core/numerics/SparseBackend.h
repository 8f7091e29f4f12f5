/// @file
/// The seam between SparseSolver and the libraries that factorise. Private to numerics/.
#pragma once

#include "Core/numerics/SparseSolver.h"

namespace authalic {

/// One library. `factorize` and `solve` are called only after SparseSolver has checked the order of calls.
class SparseSolver::Backend {
 public:
  virtual ~Backend() = default;
  virtual void analyze(const SparseMatrix& lower) = 0;
  /// @return false when the matrix is not definite
  [[nodiscard]] virtual bool factorize(const SparseMatrix& lower) = 0;
  [[nodiscard]] virtual Eigen::MatrixXd solve(const Eigen::MatrixXd& rightHandSides) const = 0;
};

/// CHOLMOD's supernodal LLᵀ, or null when it was not built in.
[[nodiscard]] std::unique_ptr<SparseSolver::Backend> makeCholmodBackend(PatternUse use, int threads);

}  // namespace authalic
