/// @file
/// The cotangent stiffness of a closed surface, factorised once, with its kernel of constants left out.
#pragma once

#include <vector>

#include "Core/mesh/SphereMesh.h"
#include "Core/numerics/SparseSolver.h"

namespace authalic {

/// L of a closed connected surface, with the shape of degenerate faces clamped (see shapeWeights).
class SphereLaplacian {
 public:
  /// @throws SolverError when the surface is too degenerate to factorise
  explicit SphereLaplacian(const SphereMesh& sphere, SolverBackend backend = SolverBackend::Automatic);

  /// L f, summed over edges as Σ_j w_ij (f_i − f_j): exact to rounding of the *differences* also at huge weights.
  [[nodiscard]] Points3 multiply(const Points3& f) const;
  /// ½ Σ_ij w_ij |f_i − f_j|²: the Dirichlet energy.
  [[nodiscard]] double energy(const Points3& f) const;
  /// L, lower triangle.
  [[nodiscard]] const SparseMatrix& stiffness() const noexcept { return lower_; }
  /// A solution of L x = b; b's columns sum to 0 (what they exceed it by is dropped at one vertex). x is 0 at vertex 0.
  [[nodiscard]] Eigen::MatrixXd solve(const Eigen::MatrixXd& b) const;

 private:
  struct Edge {
    int from, to;
    double weight;
  };
  SparseMatrix lower_;
  std::vector<Edge> edges_;
  SparseSolver solver_;
};

}  // namespace authalic
