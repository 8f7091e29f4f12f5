/// @file
/// CHOLMOD's supernodal L Lᵀ of one matrix. Private to numerics/.
#pragma once

#ifdef AUTHALIC_HAVE_CHOLMOD
#include <memory>
#include <vector>

#include "Core/numerics/SparseSolver.h"

namespace authalic {

/// One BLAS thread while there is any such object, the caller's setting afterwards: sums are then taken in one order
/// only, and the many small fronts of a surface mesh do not wait for threads to wake. Every thread needs its own.
class OneBlasThread {
 public:
  OneBlasThread();
  ~OneBlasThread();
  OneBlasThread(const OneBlasThread&) = delete;
  OneBlasThread& operator=(const OneBlasThread&) = delete;

 private:
  int levels_;
};

/// A = Pᵀ L Lᵀ P @cite chen2008. No two threads may use one factor at once.
class CholmodFactor {
 public:
  enum class Ordering {
    MinimumDegree,
    NestedDissection,
    AsGiven  ///< P = 1
  };
  /// What `solve` solves for x; the triangles need Ordering::AsGiven.
  enum class System {
    Whole,  ///< A x = b
    Lower,  ///< L x = b
    Upper   ///< Lᵀ x = b
  };

  explicit CholmodFactor(Ordering ordering);
  ~CholmodFactor();

  /// @throws SolverError when it does not fit into memory
  void analyze(const SparseMatrix& lower);
  /// @return false when the matrix is not definite
  [[nodiscard]] bool factorize(const SparseMatrix& lower);
  [[nodiscard]] Eigen::MatrixXd solve(const Eigen::MatrixXd& rightHandSides, System system = System::Whole) const;
  /// The last rows and columns of L (lower triangle; zero above).
  [[nodiscard]] Eigen::MatrixXd lastBlock(Eigen::Index count) const;

  /// A nested dissection of the rows: row numbers in their new order.
  [[nodiscard]] std::vector<int> dissect(const SparseMatrix& lower);
  /// 0 or 1 for the rows of two halves that no entry joins, 2 for those of the separator between; empty when none was
  /// found.
  [[nodiscard]] std::vector<int> bisect(const SparseMatrix& lower);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace authalic
#endif
