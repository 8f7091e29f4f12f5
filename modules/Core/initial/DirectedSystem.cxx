#include "Core/initial/DirectedSystem.h"

#include <Eigen/IterativeLinearSolvers>

#include <cmath>
#include <vector>

namespace authalic {
namespace {

constexpr int kScaleIterations = 20;  // more save less in GMRES than they cost

// fn(i, j, entry) for every entry (i, j), i > j, of a lower-triangular pattern.
template <class Function>
void forEdges(const SparseMatrix& pattern, const Function& fn) {
  for (int j = 0; j < pattern.cols(); ++j) {
    for (int k = pattern.outerIndexPtr()[j]; k < pattern.outerIndexPtr()[j + 1]; ++k) {
      if (pattern.innerIndexPtr()[k] != j) fn(pattern.innerIndexPtr()[k], j, k);
    }
  }
}

// The diagonal entry comes first in every column of a lower triangle.
void setDiagonal(const Eigen::VectorXd& diagonal, SparseMatrix& lower) {
  for (int j = 0; j < lower.cols(); ++j) lower.valuePtr()[lower.outerIndexPtr()[j]] = diagonal[j];
}

// Element matrices whose off-diagonal entries are the weights seen from the greater unknown, or from the smaller.
std::vector<double> elementValues(const MeanValueWeights& weights, const ElementAssembly::Unknowns& unknowns,
                                  bool fromGreater) {
  static constexpr int kEntry[3] = {1, 4, 2};  // of half-edges 0→1, 1→2, 2→0 among those of ElementAssembly
  static constexpr int kDiagonal[3] = {0, 3, 5};
  std::vector<double> values(static_cast<std::size_t>(6 * unknowns.rows()), 0.0);
  for (Eigen::Index f = 0; f < unknowns.rows(); ++f) {
    double* element = values.data() + 6 * f;
    for (int k = 0; k < 3; ++k) {
      const int l = (k + 1) % 3;
      const double forward = weights.forward(f, k), backward = weights.backward(f, k);
      element[kDiagonal[k]] += forward;
      element[kDiagonal[l]] += backward;
      element[kEntry[k]] = -((unknowns(f, k) > unknowns(f, l)) == fromGreater ? forward : backward);
    }
  }
  return values;
}

}  // namespace

DirectedSystem::DirectedSystem(const MeanValueWeights& weights, const ElementAssembly::Unknowns& unknowns,
                               int unknownCount) {
  ElementAssembly assembly(unknownCount, unknowns);
  lower_ = assembly.assemble(elementValues(weights, unknowns, true));
  upper_ = assembly.assemble(elementValues(weights, unknowns, false));
  balance();
}

void DirectedSystem::balance() {
  const double *w = lower_.valuePtr(), *v = upper_.valuePtr();
  SparseMatrix stiffness = lower_;
  Eigen::VectorXd right = Eigen::VectorXd::Zero(lower_.rows()), diagonal = right;
  forEdges(lower_, [&](int i, int j, int k) {
    const double asymmetry = std::log(v[k] / w[k]);
    const double q = std::isfinite(asymmetry) ? std::sqrt(w[k] * v[k]) : 0.0;
    stiffness.valuePtr()[k] = -q;
    if (q == 0) return;
    right[i] += q * asymmetry;
    right[j] -= q * asymmetry;
    diagonal[i] += q;
    diagonal[j] += q;
  });
  setDiagonal(diagonal, stiffness);
  Eigen::ConjugateGradient<SparseMatrix, Eigen::Lower> solver(stiffness);
  solver.setMaxIterations(kScaleIterations);
  const Eigen::VectorXd logScale = solver.solve(right);
  scale_ = logScale.allFinite() ? Eigen::VectorXd(logScale.array().exp()) : Eigen::VectorXd::Ones(lower_.rows());
}

SparseMatrix DirectedSystem::symmetricPart() const {
  SparseMatrix part = lower_;
  const double *w = lower_.valuePtr(), *v = upper_.valuePtr();
  double* s = part.valuePtr();
  Eigen::VectorXd diagonal = lower_.diagonal();  // Σ_j w_ij; less the free neighbours, what the held ones give
  forEdges(lower_, [&](int i, int j, int k) {
    diagonal[i] += w[k];
    diagonal[j] += v[k];
  });
  diagonal = diagonal.cwiseMax(0.0).cwiseProduct(scale_);
  forEdges(lower_, [&](int i, int j, int k) {
    s[k] = 0.5 * (scale_[i] * w[k] + scale_[j] * v[k]);
    diagonal[i] -= s[k];
    diagonal[j] -= s[k];
  });
  setDiagonal(diagonal, part);
  return part;
}

Eigen::SparseMatrix<double> DirectedSystem::matrix() const {
  std::vector<Eigen::Triplet<double, int>> entries;
  const Eigen::VectorXd diagonal = lower_.diagonal();
  for (int i = 0; i < diagonal.size(); ++i) entries.emplace_back(i, i, scale_[i] * diagonal[i]);
  forEdges(lower_, [&](int i, int j, int k) {
    entries.emplace_back(i, j, scale_[i] * lower_.valuePtr()[k]);
    entries.emplace_back(j, i, scale_[j] * upper_.valuePtr()[k]);
  });
  Eigen::SparseMatrix<double> whole(lower_.rows(), lower_.cols());
  whole.setFromTriplets(entries.begin(), entries.end());
  return whole;
}

Eigen::MatrixXd DirectedSystem::multiply(const Eigen::MatrixXd& x) const {
  const double *w = lower_.valuePtr(), *v = upper_.valuePtr();
  const Eigen::VectorXd diagonal = lower_.diagonal();
  Eigen::MatrixXd product(x.rows(), x.cols());
  for (Eigen::Index c = 0; c < x.cols(); ++c) {
    product.col(c) = diagonal.cwiseProduct(x.col(c));
    const double* in = x.col(c).data();
    double* out = product.col(c).data();
    forEdges(lower_, [&](int i, int j, int k) {
      out[i] += w[k] * in[j];
      out[j] += v[k] * in[i];
    });
  }
  return scale_.asDiagonal() * product;
}

}  // namespace authalic
