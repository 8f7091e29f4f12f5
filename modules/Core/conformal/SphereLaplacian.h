/// @file
/// The cotangent stiffness of a closed surface, factorised once, with its kernel of constants left out.
#pragma once

#include "Core/mesh/SphereMesh.h"
#include "Core/numerics/SparseSolver.h"

namespace authalic {

/// L of a closed connected surface, with the shape of degenerate faces clamped (see shapeWeights).
class SphereLaplacian {
 public:
  /// @throws SolverError when the surface is too degenerate to factorise
  explicit SphereLaplacian(const SphereMesh& sphere, SolverBackend backend = SolverBackend::Automatic);

  /// L x, column by column.
  [[nodiscard]] Eigen::MatrixXd multiply(const Eigen::MatrixXd& x) const;
  /// The same matrix, lower triangle.
  [[nodiscard]] const SparseMatrix& stiffness() const noexcept { return lower_; }
  /// A solution of L x = b; b's columns sum to 0 (what they exceed it by is dropped at one vertex). x is 0 at vertex 0.
  [[nodiscard]] Eigen::MatrixXd solve(const Eigen::MatrixXd& b) const;
  /// ½ tr(xᵀ L x): the Dirichlet energy.
  [[nodiscard]] double energy(const Eigen::MatrixXd& x) const;

 private:
  SparseMatrix lower_, full_;
  SparseSolver solver_;
};

}  // namespace authalic
