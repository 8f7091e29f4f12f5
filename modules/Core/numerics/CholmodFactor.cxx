#include "Core/numerics/CholmodFactor.h"

#ifdef AUTHALIC_HAVE_CHOLMOD
#include <cholmod.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <mutex>

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

namespace authalic {
namespace {

#ifndef AUTHALIC_HAVE_OPENBLAS
void openblas_set_num_threads(int) {}
int openblas_get_num_threads() { return 1; }
#endif
#ifndef AUTHALIC_HAVE_GOMP
void omp_set_max_active_levels(int) {}
int omp_get_max_active_levels() { return 0; }
#endif

// Columns of supernodes that are merged whatever the zeros, with few, and with very few: twice CHOLMOD's, for the
// small fronts of surface meshes.
constexpr std::array<std::size_t, 3> kMerged{8, 32, 96};

// OpenBLAS has one number of threads for the whole process.
std::mutex blasSetting;
int blasUsers = 0, blasThreads = 1;

// METIS draws from the one random sequence of the C library, which it starts anew at every call.
std::mutex metisSequence;

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

cholmod_dense viewOf(const Eigen::MatrixXd& columns) {
  cholmod_dense view{};
  view.nrow = view.d = static_cast<std::size_t>(columns.rows());
  view.ncol = static_cast<std::size_t>(columns.cols());
  view.nzmax = static_cast<std::size_t>(columns.size());
  view.x = const_cast<double*>(columns.data());
  view.xtype = CHOLMOD_REAL;
  view.dtype = CHOLMOD_DOUBLE;
  return view;
}

int methodOf(CholmodFactor::Ordering ordering) {
  switch (ordering) {
    case CholmodFactor::Ordering::MinimumDegree: return CHOLMOD_AMD;
    case CholmodFactor::Ordering::NestedDissection: return CHOLMOD_METIS;
    case CholmodFactor::Ordering::AsGiven: return CHOLMOD_NATURAL;
  }
  return CHOLMOD_AMD;
}

int numberOf(CholmodFactor::System system) {
  switch (system) {
    case CholmodFactor::System::Whole: return CHOLMOD_A;
    case CholmodFactor::System::Lower: return CHOLMOD_L;
    case CholmodFactor::System::Upper: return CHOLMOD_Lt;
  }
  return CHOLMOD_A;
}

}  // namespace

OneBlasThread::OneBlasThread() : levels_(omp_get_max_active_levels()) {
  omp_set_max_active_levels(0);
  const std::lock_guard<std::mutex> lock(blasSetting);
  if (blasUsers++ > 0) return;
  blasThreads = openblas_get_num_threads();
  openblas_set_num_threads(1);
}

OneBlasThread::~OneBlasThread() {
  omp_set_max_active_levels(levels_);
  const std::lock_guard<std::mutex> lock(blasSetting);
  if (--blasUsers == 0) openblas_set_num_threads(blasThreads);
}

struct CholmodFactor::State {
  explicit State(Ordering ordering) {
    cholmod_start(&common);
    common.print = 0;
    common.try_catch = 1;
    common.supernodal = CHOLMOD_SUPERNODAL;
    common.final_ll = 1;
    common.nmethods = 1;
    common.method[0].ordering = methodOf(ordering);
    common.postorder = ordering != Ordering::AsGiven;
    std::copy(kMerged.begin(), kMerged.end(), common.nrelax);
  }
  ~State() {
    for (cholmod_dense** kept : {&solution, &work, &spare}) cholmod_free_dense(kept, &common);
    cholmod_free_factor(&factor, &common);
    cholmod_finish(&common);
  }
  State(const State&) = delete;
  State& operator=(const State&) = delete;

  cholmod_common common{};
  cholmod_factor* factor = nullptr;
  cholmod_dense *solution = nullptr, *work = nullptr, *spare = nullptr;  // kept from one solve to the next
};

CholmodFactor::CholmodFactor(Ordering ordering) : state_(std::make_unique<State>(ordering)) {}
CholmodFactor::~CholmodFactor() = default;

void CholmodFactor::analyze(const SparseMatrix& lower) {
  cholmod_free_factor(&state_->factor, &state_->common);
  cholmod_sparse view = viewOf(lower);
  std::unique_lock<std::mutex> lock(metisSequence, std::defer_lock);
  if (state_->common.method[0].ordering == CHOLMOD_METIS) lock.lock();
  state_->factor = cholmod_analyze(&view, &state_->common);
  if (!state_->factor) throw SolverError("A matrix that fits into memory is required, but its analysis failed.");
}

bool CholmodFactor::factorize(const SparseMatrix& lower) {
  const OneBlasThread one;
  cholmod_sparse view = viewOf(lower);
  return cholmod_factorize(&view, state_->factor, &state_->common) != 0 && state_->common.status == CHOLMOD_OK;
}

Eigen::MatrixXd CholmodFactor::solve(const Eigen::MatrixXd& rightHandSides, System system) const {
  const OneBlasThread one;
  State& s = *state_;
  cholmod_dense view = viewOf(rightHandSides);
  if (!cholmod_solve2(numberOf(system), s.factor, &view, nullptr, &s.solution, nullptr, &s.work, &s.spare, &s.common)) {
    throw SolverError("A solvable system is required, but CHOLMOD ran out of memory.");
  }
  return Eigen::Map<const Eigen::MatrixXd>(static_cast<const double*>(s.solution->x), rightHandSides.rows(),
                                           rightHandSides.cols());
}

Eigen::MatrixXd CholmodFactor::lastBlock(Eigen::Index count) const {
  const cholmod_factor& factor = *state_->factor;
  Eigen::MatrixXd block = Eigen::MatrixXd::Zero(count, count);
  const Eigen::Index first = static_cast<Eigen::Index>(factor.n) - count;
  const int *super = static_cast<const int*>(factor.super), *rows = static_cast<const int*>(factor.s);
  const int *rowStart = static_cast<const int*>(factor.pi), *start = static_cast<const int*>(factor.px);
  for (auto k = static_cast<std::ptrdiff_t>(factor.nsuper) - 1; k >= 0 && super[k + 1] > first; --k) {
    const int height = rowStart[k + 1] - rowStart[k];
    const double* values = static_cast<const double*>(factor.x) + start[k];
    for (Eigen::Index j = std::max<Eigen::Index>(super[k], first); j < super[k + 1]; ++j) {
      const auto column = static_cast<int>(j) - super[k];
      for (int i = column; i < height; ++i) {
        block(rows[rowStart[k] + i] - first, j - first) = values[std::ptrdiff_t{height} * column + i];
      }
    }
  }
  return block;
}

std::vector<int> CholmodFactor::dissect(const SparseMatrix& lower) {
  std::vector<int> order(static_cast<std::size_t>(lower.rows()));
  cholmod_sparse view = viewOf(lower);
  const std::lock_guard<std::mutex> lock(metisSequence);
  if (!cholmod_metis(&view, nullptr, 0, 1, order.data(), &state_->common)) {
    throw SolverError("A matrix that fits into memory is required, but its dissection failed.");
  }
  return order;
}

std::vector<int> CholmodFactor::bisect(const SparseMatrix& lower) {
  std::vector<int> part(static_cast<std::size_t>(lower.rows()));
  cholmod_sparse view = viewOf(lower);
  const std::lock_guard<std::mutex> lock(metisSequence);
  if (cholmod_bisect(&view, nullptr, 0, 1, part.data(), &state_->common) < 0) part.clear();
  return part;
}

}  // namespace authalic
#endif
