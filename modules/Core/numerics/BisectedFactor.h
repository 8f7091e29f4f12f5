/// @file
/// A sparse Cholesky factorisation in two halves side by side. Private to numerics/.
#pragma once

#ifdef AUTHALIC_HAVE_CHOLMOD
#include <array>
#include <vector>

#include "Core/numerics/CholmodFactor.h"

namespace authalic {

/// The half of a bisected matrix K that belongs to the unknowns I of one side and those S of the separator:
///
///     [K_II K_IS; K_SI K_SS] = L Lᵀ,   L = [L_II 0; L_SI C],   C Cᵀ = K_SS − K_SI K_II⁻¹ K_IS.
class BisectedHalf {
 public:
  /// Orders the side's own unknowns.
  void order(const SparseMatrix& lower, const std::vector<int>& own);
  /// Analyses the half, its separator last.
  void analyze(const SparseMatrix& lower, const std::vector<int>& separator);
  /// @return false when it is not definite
  [[nodiscard]] bool factorize(const SparseMatrix& lower);
  /// C Cᵀ, lower triangle.
  [[nodiscard]] const Eigen::MatrixXd& complement() const noexcept { return complement_; }
  /// @return −K_SI K_II⁻¹ b_I; L_II⁻¹ b_I is kept
  [[nodiscard]] Eigen::MatrixXd forward(const Eigen::MatrixXd& b);
  /// Puts x_I = K_II⁻¹ (b_I − K_IS x_S) into its rows of x.
  void backward(const Eigen::MatrixXd& onSeparator, Eigen::MatrixXd& x) const;

 private:
  struct Place {
    int whole, half;  // of one entry, in the values of K and of this half
  };
  CholmodFactor factor_{CholmodFactor::Ordering::AsGiven};
  std::vector<int> unknowns_;  // of K: own ones as ordered, then the separator
  Eigen::Index own_ = 0;
  SparseMatrix half_;          // the separator full, so that its columns stay together
  std::vector<Place> places_;
  Eigen::MatrixXd corner_, complement_, solution_;  // C, C Cᵀ, L⁻¹ b
};

/// L Lᵀ of K by its first bisection, whose halves are factorised and solved side by side on two threads; what joins
/// them is dense,
///
///     Σ = C₀ C₀ᵀ + C₁ C₁ᵀ − K_SS = K_SS − Σ_h K_SI K_II⁻¹ K_IS.
///
/// Same bits on one thread as on two.
class BisectedFactor {
 public:
  /// @param threads  1: one half after the other
  explicit BisectedFactor(int threads) : threads_(threads) {}

  /// @return false when the pattern has no small separator; nothing is analysed then
  [[nodiscard]] bool analyze(const SparseMatrix& lower);
  /// @return false when the matrix is not definite
  [[nodiscard]] bool factorize(const SparseMatrix& lower);
  [[nodiscard]] Eigen::MatrixXd solve(const Eigen::MatrixXd& rightHandSides);

 private:
  template <class Work>
  void onBoth(const Work& work);

  int threads_;
  std::array<BisectedHalf, 2> halves_;
  std::vector<int> separator_;
  SparseMatrix kept_;             // K_SS
  std::vector<int> keptPlaces_;   // of its values, in those of K
  Eigen::MatrixXd complement_;    // Σ, then its factor
};

}  // namespace authalic
#endif
