/// @file
/// Steps that obey the linearised equations of the vertex stars. Private to authalic/.
#pragma once

#include <memory>

#include "Core/authalic/AreaFunctional.h"
#include "Core/numerics/AnalysedSystems.h"

namespace authalic {

/// max |ln r_v|, r_v = (star area of v / Σ a) / n_v with a the face areas of an image; +infinity when a face is folded.
/// @param targets  n shares; vertices with target 0 (no face) are left out
[[nodiscard]] double starResidual(const AreaFunctional& areas, const Eigen::VectorXd& targets,
                                  const Coordinates& image);

/// Minimises a quadratic form of a step under J δ = e, J = ∂(star areas)/∂x, e what the stars lack of their targets:
///
///     H δ = g + Jᵀ λ,   J H⁻¹ Jᵀ λ = e − J H⁻¹ g,
///
/// the second by conjugate gradients. With J = B G, B = ⅓ of the incidence of vertices and faces and G = ∂a/∂x, and
/// H = Gᵀ W G + a little, B W⁻¹ Bᵀ is nearly J H⁻¹ Jᵀ and serves as preconditioner.
class StarConstraint {
 public:
  /// @param targets  n shares, sum 1; kept by reference, as `areas` is
  /// @param systems  where the pattern of the preconditioner and its analysis are kept; by reference
  StarConstraint(const AreaFunctional& areas, const Eigen::VectorXd& targets, SolverBackend backend,
                 AnalysedSystems& systems);

  /// @param faceAreas  m, of the image
  /// @param gradients  G there; kept by reference
  /// @param weights    m values W > 0
  void linearise(const Eigen::VectorXd& faceAreas, const AreaFunctional::Gradients& gradients,
                 const Eigen::VectorXd& weights);

  /// @param system  H, factorised
  /// @param right   g
  /// @return δ with |J δ − e|∞ a fiftieth of what H⁻¹ g leaves, relative to the targets, or the best of 100 iterations
  [[nodiscard]] Eigen::VectorXd solve(const SparseSolver& system, const Eigen::VectorXd& right) const;

  [[nodiscard]] double residual(const Coordinates& image) const { return starResidual(areas_, targets_, image); }

 private:
  [[nodiscard]] Eigen::VectorXd starChanges(const Eigen::VectorXd& step) const;       // J δ
  [[nodiscard]] Eigen::VectorXd pull(const Eigen::VectorXd& multipliers) const;       // Jᵀ λ
  [[nodiscard]] double farthest(const Eigen::VectorXd& errors) const;                 // relative to the targets

  const AreaFunctional& areas_;
  const Eigen::VectorXd& targets_;
  SolverBackend backend_;
  AnalysedSystems& systems_;
  std::shared_ptr<AssembledSystem> preconditioner_;  // found when first needed
  const AreaFunctional::Gradients* gradients_ = nullptr;
  Eigen::VectorXd lacking_;  // e
  double total_ = 1;         // area of the image
};

}  // namespace authalic
