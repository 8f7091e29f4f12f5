#include "Core/numerics/BisectedFactor.h"

#ifdef AUTHALIC_HAVE_CHOLMOD
#include <algorithm>
#include <utility>

#include "Core/base/Execution.h"

extern "C" {
void dtrmm_(const char* side, const char* triangle, const char* transposed, const char* unit, const int* rows,
            const int* columns, const double* factor, const double* a, const int* lda, double* b, const int* ldb);
void dpotrf_(const char* triangle, const int* size, double* a, const int* lda, int* info);
void dpotrs_(const char* triangle, const int* size, const int* columns, const double* a, const int* lda, double* b,
             const int* ldb, int* info);
}

namespace authalic {
namespace {

constexpr double kSmallSeparator = 0.1;  // of the unknowns: more has left the plane

// Numbers of the listed rows, −1 for others.
std::vector<int> numbersOf(const std::vector<int>& rows, Eigen::Index count) {
  std::vector<int> number(static_cast<std::size_t>(count), -1);
  for (std::size_t k = 0; k < rows.size(); ++k) number[static_cast<std::size_t>(rows[k])] = static_cast<int>(k);
  return number;
}

// visit(place in the values, row, column) for the entries among the numbered rows, the row not before the column.
template <class Visit>
void forEntriesAmong(const std::vector<int>& number, const SparseMatrix& lower, const Visit& visit) {
  for (int column = 0; column < lower.cols(); ++column) {
    const int j = number[static_cast<std::size_t>(column)];
    if (j < 0) continue;
    for (int p = lower.outerIndexPtr()[column]; p < lower.outerIndexPtr()[column + 1]; ++p) {
      const int i = number[static_cast<std::size_t>(lower.innerIndexPtr()[p])];
      if (i >= 0) visit(p, std::max(i, j), std::min(i, j));
    }
  }
}

// Among the numbered rows, and the last `full` of them all with each other. Zeros.
SparseMatrix patternAmong(const std::vector<int>& number, int count, int full, const SparseMatrix& lower) {
  std::vector<Eigen::Triplet<double, int>> entries;
  forEntriesAmong(number, lower, [&](int, int i, int j) { entries.emplace_back(i, j, 0.0); });
  for (int j = count - full; j < count; ++j) {
    for (int i = j; i < count; ++i) entries.emplace_back(i, j, 0.0);
  }
  SparseMatrix pattern(count, count);
  pattern.setFromTriplets(entries.begin(), entries.end());
  return pattern;
}

int placeOf(const SparseMatrix& matrix, int row, int column) {
  const int *begin = matrix.innerIndexPtr() + matrix.outerIndexPtr()[column],
            *end = matrix.innerIndexPtr() + matrix.outerIndexPtr()[column + 1];
  return static_cast<int>(std::lower_bound(begin, end, row) - matrix.innerIndexPtr());
}

// L Lᵀ of a lower triangular matrix.
Eigen::MatrixXd timesTransposed(const Eigen::MatrixXd& triangle) {
  const OneBlasThread one;
  Eigen::MatrixXd product = triangle.transpose();
  const int size = static_cast<int>(triangle.rows());
  const double factor = 1;
  if (size > 0) {
    dtrmm_("L", "L", "N", "N", &size, &size, &factor, triangle.data(), &size, product.data(), &size);
  }
  return product;
}

}  // namespace

void BisectedHalf::order(const SparseMatrix& lower, const std::vector<int>& own) {
  own_ = static_cast<Eigen::Index>(own.size());
  unknowns_.clear();
  const SparseMatrix inner = patternAmong(numbersOf(own, lower.rows()), static_cast<int>(own_), 0, lower);
  for (const int k : factor_.dissect(inner)) unknowns_.push_back(own[static_cast<std::size_t>(k)]);
}

void BisectedHalf::analyze(const SparseMatrix& lower, const std::vector<int>& separator) {
  unknowns_.insert(unknowns_.end(), separator.begin(), separator.end());
  const std::vector<int> number = numbersOf(unknowns_, lower.rows());
  half_ = patternAmong(number, static_cast<int>(unknowns_.size()), static_cast<int>(separator.size()), lower);
  places_.clear();
  forEntriesAmong(number, lower, [&](int p, int i, int j) { places_.push_back({p, placeOf(half_, i, j)}); });
  factor_.analyze(half_);
}

bool BisectedHalf::factorize(const SparseMatrix& lower) {
  half_.coeffs().setZero();
  for (const Place& place : places_) half_.valuePtr()[place.half] = lower.valuePtr()[place.whole];
  if (!factor_.factorize(half_)) return false;
  corner_ = factor_.lastBlock(half_.rows() - own_);
  complement_ = timesTransposed(corner_);
  return true;
}

Eigen::MatrixXd BisectedHalf::forward(const Eigen::MatrixXd& b) {
  solution_ = Eigen::MatrixXd::Zero(half_.rows(), b.cols());
  for (Eigen::Index k = 0; k < own_; ++k) solution_.row(k) = b.row(unknowns_[static_cast<std::size_t>(k)]);
  solution_ = factor_.solve(solution_, CholmodFactor::System::Lower);
  return corner_.triangularView<Eigen::Lower>() * solution_.bottomRows(corner_.rows());
}

void BisectedHalf::backward(const Eigen::MatrixXd& onSeparator, Eigen::MatrixXd& x) const {
  Eigen::MatrixXd right = solution_;
  right.bottomRows(corner_.rows()) = corner_.transpose().triangularView<Eigen::Upper>() * onSeparator;
  const Eigen::MatrixXd solved = factor_.solve(right, CholmodFactor::System::Upper);
  for (Eigen::Index k = 0; k < own_; ++k) x.row(unknowns_[static_cast<std::size_t>(k)]) = solved.row(k);
}

template <class Work>
void BisectedFactor::onBoth(const Work& work) {
  const auto run = [&](std::size_t begin, std::size_t end) {
    for (std::size_t h = begin; h < end; ++h) work(h);
  };
  parallelFor(halves_.size(), Execution({}, {}, threads_), run, 1);
}

bool BisectedFactor::analyze(const SparseMatrix& lower) {
  const std::vector<int> part = CholmodFactor(CholmodFactor::Ordering::AsGiven).bisect(lower);
  std::array<std::vector<int>, 3> members;
  for (std::size_t k = 0; k < part.size(); ++k) {
    members[static_cast<std::size_t>(part[k])].push_back(static_cast<int>(k));
  }
  separator_ = std::move(members[2]);
  if (members[0].empty() || members[1].empty() ||
      static_cast<double>(separator_.size()) > kSmallSeparator * static_cast<double>(lower.rows())) {
    return false;
  }
  onBoth([&](std::size_t h) {
    halves_[h].order(lower, members[h]);
    halves_[h].analyze(lower, separator_);
  });
  const std::vector<int> number = numbersOf(separator_, lower.rows());
  kept_ = patternAmong(number, static_cast<int>(separator_.size()), 0, lower);
  keptPlaces_.resize(static_cast<std::size_t>(kept_.nonZeros()));
  forEntriesAmong(number, lower, [&](int p, int i, int j) {
    keptPlaces_[static_cast<std::size_t>(placeOf(kept_, i, j))] = p;
  });
  return true;
}

bool BisectedFactor::factorize(const SparseMatrix& lower) {
  const OneBlasThread one;
  std::array<bool, 2> definite{};
  onBoth([&](std::size_t h) { definite[h] = halves_[h].factorize(lower); });
  if (!definite[0] || !definite[1]) return false;
  for (Eigen::Index k = 0; k < kept_.nonZeros(); ++k) {
    kept_.valuePtr()[k] = lower.valuePtr()[keptPlaces_[static_cast<std::size_t>(k)]];
  }
  complement_ = halves_[0].complement() + halves_[1].complement();
  complement_ -= kept_;
  const int size = static_cast<int>(separator_.size());
  int info = 0;
  if (size > 0) dpotrf_("L", &size, complement_.data(), &size, &info);
  return info == 0;
}

Eigen::MatrixXd BisectedFactor::solve(const Eigen::MatrixXd& rightHandSides) {
  const OneBlasThread one;
  std::array<Eigen::MatrixXd, 2> pulls;
  onBoth([&](std::size_t h) { pulls[h] = halves_[h].forward(rightHandSides); });
  Eigen::MatrixXd onSeparator = pulls[0] + pulls[1] + rightHandSides(separator_, Eigen::all);
  const int size = static_cast<int>(separator_.size()), columns = static_cast<int>(rightHandSides.cols());
  if (size > 0) {
    int info = 0;
    dpotrs_("L", &size, &columns, complement_.data(), &size, onSeparator.data(), &size, &info);
  }
  Eigen::MatrixXd x(rightHandSides.rows(), rightHandSides.cols());
  x(separator_, Eigen::all) = onSeparator;
  onBoth([&](std::size_t h) { halves_[h].backward(onSeparator, x); });
  return x;
}

}  // namespace authalic
#endif
