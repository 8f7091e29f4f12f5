#include "Core/numerics/SparseBackend.h"

#ifdef AUTHALIC_HAVE_CHOLMOD
#include <cholmod.h>

#include <algorithm>

#include "Core/base/Error.h"

extern "C" {
#ifdef AUTHALIC_HAVE_OPENBLAS
void openblas_set_num_threads(int);
int openblas_get_num_threads(void);
#endif
#ifdef AUTHALIC_HAVE_GOMP
void omp_set_max_active_levels(int);
int omp_get_max_active_levels(void);
#endif
}
#endif

namespace authalic {

#ifdef AUTHALIC_HAVE_CHOLMOD
namespace {

#ifndef AUTHALIC_HAVE_OPENBLAS
void openblas_set_num_threads(int) {}
int openblas_get_num_threads() { return 1; }
#endif
#ifndef AUTHALIC_HAVE_GOMP
void omp_set_max_active_levels(int) {}
int omp_get_max_active_levels() { return 0; }
#endif

// One thread inside, the caller's setting outside: sums are then taken in one order only, and the many small
// fronts of a surface mesh do not wait for threads to wake.
class SingleThread {
 public:
  SingleThread() : blasThreads_(openblas_get_num_threads()), levels_(omp_get_max_active_levels()) {
    if (blasThreads_ != 1) openblas_set_num_threads(1);
    omp_set_max_active_levels(0);
  }
  ~SingleThread() {
    if (blasThreads_ != 1) openblas_set_num_threads(blasThreads_);
    omp_set_max_active_levels(levels_);
  }
  SingleThread(const SingleThread&) = delete;
  SingleThread& operator=(const SingleThread&) = delete;

 private:
  int blasThreads_, levels_;
};

// CHOLMOD's C structures do not know const; it reads the matrix only.
cholmod_sparse viewOf(const SparseMatrix& lower) {
  cholmod_sparse view{};
  view.nrow = view.ncol = static_cast<std::size_t>(lower.rows());
  view.nzmax = static_cast<std::size_t>(lower.nonZeros());
  view.p = const_cast<int*>(lower.outerIndexPtr());
  view.i = const_cast<int*>(lower.innerIndexPtr());
  view.x = const_cast<double*>(lower.valuePtr());
  view.stype = -1;
  view.itype = CHOLMOD_INT;
  view.xtype = CHOLMOD_REAL;
  view.dtype = CHOLMOD_DOUBLE;
  view.sorted = view.packed = 1;
  return view;
}

class CholmodBackend final : public SparseSolver::Backend {
 public:
  explicit CholmodBackend(PatternUse use) {
    cholmod_start(&common_);
    common_.print = 0;
    common_.try_catch = 1;
    common_.supernodal = CHOLMOD_SUPERNODAL;
    common_.final_ll = 1;
    common_.nmethods = 1;
    common_.method[0].ordering = use == PatternUse::Reused ? CHOLMOD_METIS : CHOLMOD_AMD;
    common_.postorder = 1;
  }
  ~CholmodBackend() override {
    for (cholmod_dense** kept : {&solution_, &work_, &spare_}) cholmod_free_dense(kept, &common_);
    cholmod_free_factor(&factor_, &common_);
    cholmod_finish(&common_);
  }
  CholmodBackend(const CholmodBackend&) = delete;
  CholmodBackend& operator=(const CholmodBackend&) = delete;

  void analyze(const SparseMatrix& lower) override {
    cholmod_free_factor(&factor_, &common_);
    cholmod_sparse view = viewOf(lower);
    factor_ = cholmod_analyze(&view, &common_);
    if (!factor_) throw SolverError("A matrix that fits into memory is required, but its analysis failed.");
  }

  bool factorize(const SparseMatrix& lower) override {
    const SingleThread single;
    cholmod_sparse view = viewOf(lower);
    return cholmod_factorize(&view, factor_, &common_) != 0 && common_.status == CHOLMOD_OK;
  }

  Eigen::MatrixXd solve(const Eigen::MatrixXd& rightHandSides) const override {
    const SingleThread single;
    cholmod_dense view{};
    view.nrow = view.d = static_cast<std::size_t>(rightHandSides.rows());
    view.ncol = static_cast<std::size_t>(rightHandSides.cols());
    view.nzmax = static_cast<std::size_t>(rightHandSides.size());
    view.x = const_cast<double*>(rightHandSides.data());
    view.xtype = CHOLMOD_REAL;
    view.dtype = CHOLMOD_DOUBLE;
    if (!cholmod_solve2(CHOLMOD_A, factor_, &view, nullptr, &solution_, nullptr, &work_, &spare_, &common_)) {
      throw SolverError("A solvable system is required, but CHOLMOD ran out of memory.");
    }
    return Eigen::Map<const Eigen::MatrixXd>(static_cast<const double*>(solution_->x), rightHandSides.rows(),
                                             rightHandSides.cols());
  }

 private:
  mutable cholmod_common common_;  // workspace: solve needs it, and keeps these three
  mutable cholmod_dense *solution_ = nullptr, *work_ = nullptr, *spare_ = nullptr;
  cholmod_factor* factor_ = nullptr;
};

}  // namespace

std::unique_ptr<SparseSolver::Backend> makeCholmodBackend(PatternUse use) {
  return std::make_unique<CholmodBackend>(use);
}
#else
std::unique_ptr<SparseSolver::Backend> makeCholmodBackend(PatternUse) { return nullptr; }
#endif

}  // namespace authalic
