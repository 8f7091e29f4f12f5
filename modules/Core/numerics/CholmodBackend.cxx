#include "Core/numerics/BisectedFactor.h"
#include "Core/numerics/CholmodFactor.h"
#include "Core/numerics/SparseBackend.h"

namespace authalic {

#ifdef AUTHALIC_HAVE_CHOLMOD
namespace {

constexpr Eigen::Index kLarge = 20000;  // unknowns from where two halves are worth their separator

class CholmodBackend final : public SparseSolver::Backend {
 public:
  CholmodBackend(PatternUse use, int threads)
      : use_(use), threads_(threads),
        whole_(use == PatternUse::Reused ? CholmodFactor::Ordering::NestedDissection
                                         : CholmodFactor::Ordering::MinimumDegree) {}

  void analyze(const SparseMatrix& lower) override {
    halves_.reset();
    if (use_ == PatternUse::Reused && lower.rows() >= kLarge) {
      halves_ = std::make_unique<BisectedFactor>(threads_);
      if (halves_->analyze(lower)) return;
      halves_.reset();
    }
    whole_.analyze(lower);
  }
  bool factorize(const SparseMatrix& lower) override {
    return halves_ ? halves_->factorize(lower) : whole_.factorize(lower);
  }
  Eigen::MatrixXd solve(const Eigen::MatrixXd& rightHandSides) const override {
    return halves_ ? halves_->solve(rightHandSides) : whole_.solve(rightHandSides);
  }

 private:
  PatternUse use_;
  int threads_;
  CholmodFactor whole_;
  std::unique_ptr<BisectedFactor> halves_;  // of a large system that is factorised often
};

}  // namespace

std::unique_ptr<SparseSolver::Backend> makeCholmodBackend(PatternUse use, int threads) {
  return std::make_unique<CholmodBackend>(use, threads);
}
#else
std::unique_ptr<SparseSolver::Backend> makeCholmodBackend(PatternUse, int) { return nullptr; }
#endif

}  // namespace authalic
