/// @file
/// Weighted means with different weights each way: the unsymmetric system and its nearly symmetric scaling.
/// Private to initial/.
#pragma once

#include "Core/geometry/Laplacian.h"
#include "Core/numerics/ElementAssembly.h"

namespace authalic {

/// D A, where (A x)_i = Σ_j w_ij (x_i − x_j) and D is a positive diagonal that leaves the solution of A x = b alone
/// and makes the scaled weights d_i w_ij as symmetric as it can: d minimises
///   Σ √(w_ij w_ji) (ln d_i w_ij − ln d_j w_ji)²,
/// to the accuracy of twenty conjugate-gradient steps. Mean-value weights @cite floater2003 come close to symmetry that
/// way, so that the symmetric part, a weighted graph Laplacian, is a good preconditioner.
class DirectedSystem {
 public:
  /// @param weights   per half-edge, seen from tail and head
  /// @param unknowns  of each corner, −1 where held
  DirectedSystem(const MeanValueWeights& weights, const ElementAssembly::Unknowns& unknowns, int unknownCount);

  /// d, n×1
  [[nodiscard]] const Eigen::VectorXd& scale() const noexcept { return scale_; }

  /// The graph Laplacian with weights ½ (d_i w_ij + d_j w_ji), n×n lower triangle; positive definite when every
  /// component of the free vertices has a held neighbour and all weights are positive.
  [[nodiscard]] SparseMatrix symmetricPart() const;

  /// D A, n×n
  [[nodiscard]] Eigen::SparseMatrix<double> matrix() const;

  /// D A x, n×k
  [[nodiscard]] Eigen::MatrixXd multiply(const Eigen::MatrixXd& x) const;

 private:
  void balance();

  SparseMatrix lower_, upper_;  // on one lower-triangular pattern: entry (i, j) is −w_ij in one, −w_ji in the other
  Eigen::VectorXd scale_;
};

}  // namespace authalic
