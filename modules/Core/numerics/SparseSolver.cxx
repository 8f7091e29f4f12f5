#include "Core/numerics/SparseSolver.h"

#include <Eigen/SparseCholesky>

#include <string>

#include "Core/base/Error.h"
#include "Core/numerics/SparseBackend.h"

namespace authalic {
namespace {

template <class Factorization>
class EigenBackend final : public SparseSolver::Backend {
 public:
  void analyze(const SparseMatrix& lower) override { factorization_.analyzePattern(lower); }
  bool factorize(const SparseMatrix& lower) override {
    factorization_.factorize(lower);
    return factorization_.info() == Eigen::Success;
  }
  Eigen::MatrixXd solve(const Eigen::MatrixXd& rightHandSides) const override {
    return factorization_.solve(rightHandSides);
  }

 private:
  Factorization factorization_;
};

std::unique_ptr<SparseSolver::Backend> makeBackend(SolverBackend kind, PatternUse use, int threads) {
  switch (kind) {
    case SolverBackend::Cholmod: return makeCholmodBackend(use, threads);
    case SolverBackend::EigenLLT:
      return std::make_unique<EigenBackend<Eigen::SimplicialLLT<SparseMatrix, Eigen::Lower>>>();
    default: return std::make_unique<EigenBackend<Eigen::SimplicialLDLT<SparseMatrix, Eigen::Lower>>>();
  }
}

}  // namespace

const char* solverBackendName(SolverBackend backend) noexcept {
  switch (backend) {
    case SolverBackend::Automatic: return "automatic";
    case SolverBackend::EigenLDLT: return "eigen-ldlt";
    case SolverBackend::EigenLLT: return "eigen-llt";
    case SolverBackend::Cholmod: return "cholmod";
  }
  return "automatic";
}

bool SparseSolver::available(SolverBackend backend) noexcept {
#ifdef AUTHALIC_HAVE_CHOLMOD
  static_cast<void>(backend);
  return true;
#else
  return backend != SolverBackend::Cholmod;
#endif
}

SparseSolver::SparseSolver(SolverBackend backend, PatternUse use, int threads) : kind_(backend) {
  if (kind_ == SolverBackend::Automatic) {
    kind_ = available(SolverBackend::Cholmod) ? SolverBackend::Cholmod : SolverBackend::EigenLDLT;
  }
  backend_ = makeBackend(kind_, use, threads);
  if (!backend_) {
    throw InvalidArgument("A solver that is part of this build is required, but " +
                          std::string(solverBackendName(kind_)) + " was not built in; use eigen-ldlt.");
  }
}

SparseSolver::~SparseSolver() = default;
SparseSolver::SparseSolver(SparseSolver&&) noexcept = default;
SparseSolver& SparseSolver::operator=(SparseSolver&&) noexcept = default;

SolverBackend SparseSolver::backend() const noexcept { return kind_; }

void SparseSolver::analyze(const SparseMatrix& lower) {
  if (lower.rows() != lower.cols() || !lower.isCompressed()) {
    throw InvalidArgument("A square compressed matrix is required, but it has " + std::to_string(lower.rows()) +
                          " rows and " + std::to_string(lower.cols()) + " columns.");
  }
  size_ = lower.rows();
  nonZeros_ = lower.nonZeros();
  factorized_ = false;
  if (size_ > 0) backend_->analyze(lower);
}

void SparseSolver::factorize(const SparseMatrix& lower) {
  if (lower.rows() != size_ || lower.nonZeros() != nonZeros_) {
    throw SolverError("The analysed pattern (" + std::to_string(size_) + " unknowns, " +
                      std::to_string(nonZeros_) + " entries) is required, but the matrix has " +
                      std::to_string(lower.rows()) + " and " + std::to_string(lower.nonZeros()) +
                      "; analyse the new pattern first.");
  }
  factorized_ = size_ == 0 || backend_->factorize(lower);
  if (!factorized_) {
    throw SolverError("A positive definite matrix is required, but the factorisation (" +
                      std::string(solverBackendName(kind_)) + ", " + std::to_string(size_) +
                      " unknowns) met a zero or negative pivot; look for degenerate triangles.");
  }
}

void SparseSolver::compute(const SparseMatrix& lower) {
  analyze(lower);
  factorize(lower);
}

Eigen::MatrixXd SparseSolver::solve(const Eigen::MatrixXd& rightHandSides) const {
  if (!factorized_) throw SolverError("A factorised matrix is required before solving; call factorize first.");
  if (rightHandSides.rows() != size_) {
    throw SolverError("A right-hand side of " + std::to_string(size_) + " rows is required, but it has " +
                      std::to_string(rightHandSides.rows()) + ".");
  }
  if (size_ == 0) return rightHandSides;
  Eigen::MatrixXd solution = backend_->solve(rightHandSides);
  if (!solution.allFinite()) {
    throw SolverError("A finite solution is required, but the system of " + std::to_string(size_) +
                      " unknowns is numerically singular; look for degenerate triangles.");
  }
  return solution;
}

}  // namespace authalic
