/// @file
/// Sparse symmetric systems, factorised once and solved often, whatever library does the work.
#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <memory>

namespace authalic {

/// Symmetric matrices are passed by their lower triangle; entries above the diagonal are never read.
using SparseMatrix = Eigen::SparseMatrix<double, Eigen::ColMajor, int>;

/// Which library factorises.
enum class SolverBackend {
  Automatic,  ///< CHOLMOD when it was built in, else Eigen's LDLT
  EigenLDLT,  ///< L D Lᵀ, up-looking; also for indefinite matrices that need no pivoting
  EigenLLT,   ///< L Lᵀ, up-looking; positive definite only
  Cholmod,    ///< L Lᵀ, supernodal, dense kernels by BLAS; positive definite only @cite chen2008
};

/// How the fill-reducing ordering is chosen.
enum class PatternUse {
  Once,    ///< minimum degree (AMD): cheap to find, for one or two factorisations
  Reused,  ///< nested dissection (METIS) where CHOLMOD has it: dearer to find, less fill in every factorisation
};

/// Direct solver of A x = b with A sparse, symmetric and definite: `analyze` the pattern, `factorize` the
/// numbers, `solve` for any number of right-hand sides. A pattern analysed once serves every later matrix with
/// the same pattern; only `factorize` is then paid.
///
/// Complexity for a planar mesh of n vertices: O(n^1.5) to factorise, O(n log n) per right-hand side.
/// Large systems of a reused pattern are bisected, and both halves factorised and solved side by side.
/// Guarantees: the dense kernels run on one thread and halves do not depend on the other's, hence the same bits
/// whatever the thread count.
/// Does not pivot and does not estimate the condition number.
class SparseSolver {
 public:
  /// @param threads  that may work side by side: two for large systems of a reused pattern, where CHOLMOD is
  explicit SparseSolver(SolverBackend backend = SolverBackend::Automatic, PatternUse use = PatternUse::Once,
                        int threads = 1);
  ~SparseSolver();
  SparseSolver(SparseSolver&&) noexcept;
  SparseSolver& operator=(SparseSolver&&) noexcept;

  /// Order and analyse the pattern of a compressed n×n matrix (lower triangle).
  /// @throws InvalidArgument when the matrix is not square.
  void analyze(const SparseMatrix& lower);

  /// Factorise a matrix whose pattern was analysed.
  /// @throws SolverError when nothing was analysed, the pattern differs, or the matrix is not definite.
  void factorize(const SparseMatrix& lower);

  /// analyze and factorize.
  void compute(const SparseMatrix& lower);

  /// @param rightHandSides  n×k
  /// @return n×k solutions
  /// @throws SolverError when nothing is factorised, the row count differs, or a solution is not finite.
  [[nodiscard]] Eigen::MatrixXd solve(const Eigen::MatrixXd& rightHandSides) const;

  /// The library that does the work (never Automatic).
  [[nodiscard]] SolverBackend backend() const noexcept;

  /// Whether this build contains the backend.
  [[nodiscard]] static bool available(SolverBackend backend) noexcept;

  /// The seam behind which the libraries live.
  class Backend;

 private:
  std::unique_ptr<Backend> backend_;
  SolverBackend kind_;
  Eigen::Index size_ = 0, nonZeros_ = -1;
  bool factorized_ = false;
};

/// "eigen-ldlt", "eigen-llt", "cholmod"; "automatic".
[[nodiscard]] const char* solverBackendName(SolverBackend backend) noexcept;

}  // namespace authalic
