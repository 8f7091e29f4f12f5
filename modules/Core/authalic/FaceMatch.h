/// @file
/// Damped Gauss–Newton steps that bring every face to its target area. Private to authalic/.
#pragma once

#include <algorithm>

#include "Core/authalic/AreaFunctional.h"
#include "Core/numerics/ElementAssembly.h"

namespace authalic {

/// Minimises E = Σ_t m_t (r_t + 1/r_t − 2) = D_area − 2, r = q / m, q = a / Σ a the image shares and m the targets.
///
/// One step solves (Levenberg–Marquardt)
///
///     min_δ Σ_t (a_t + ∇a_t·δ − S m_t)² / (S m_t φ_t) + ε Σ_{edges ij} |δ_i − δ_j|²,   S = Σ a,
///
/// with φ_t = 2 r_t² / (1 + r_t) of the image before the step, so that the right-hand side is the exact gradient of
/// E; moves by the part of δ that folds no face and lowers E (1/r is a barrier); and adapts ε: ×¼ after a long step,
/// ×4 after a short one, ×10 after none. Where faces would collapse on the way, ε is multiplied for their edges in
/// the steps to come: a triangle that moves rigidly stays.
class FaceMatch {
 public:
  /// @param targets  m shares > 0, sum 1
  FaceMatch(const AreaFunctional& areas, const Eigen::VectorXd& targets, SolverBackend backend);

  /// One step; `image` has no folded face and keeps none.
  /// @return the part of δ taken, in (0, 1]; 0 when none lowered the energy
  double advance(Coordinates& image);

  /// (Σ m_t (r_t + 1/r_t − 2))^½ = (D_area − 2)^½ of an image; +infinity when a face is folded.
  [[nodiscard]] double residual(const Coordinates& image) const;

  /// Mean |ln r_t| of an image without folds, every face counting the same.
  [[nodiscard]] double meanAbsLog(const Coordinates& image) const;

  /// Five steps in a row were 0.
  [[nodiscard]] bool stalled() const noexcept { return failures_ > 4; }
  void restart() noexcept { failures_ = 0, damping_ = kFirstDamping; }
  /// Allows smaller ε than so far: slides along curves of equal area, which buy the last errors with shear.
  void relax() noexcept { leastDamping_ = std::max(0.3 * leastDamping_, kLeastDamping); }

 private:
  static constexpr double kFirstDamping = 0.02, kUsualDamping = 3e-4, kLeastDamping = 1e-8;
  [[nodiscard]] double energy(const Coordinates& image) const;
  void linearise(const Coordinates& image);
  [[nodiscard]] Coordinates step();
  void fillElement(Eigen::Index face);
  [[nodiscard]] Coordinates slowedWhereFacesCollapse(const Coordinates& image, Coordinates displacement) const;
  void stiffen(const Coordinates& image, const Coordinates& displacement);
  void adapt(double step);

  const AreaFunctional& areas_;
  const Eigen::VectorXd& targets_;
  ElementAssembly assembly_;
  SparseSolver solver_;
  std::vector<double> values_;
  AreaFunctional::Frames frames_;
  AreaFunctional::Gradients gradients_;
  Eigen::VectorXd weights_, right_, stiffness_;
  double damping_ = kFirstDamping, leastDamping_ = kUsualDamping;
  int failures_ = 0;
};

}  // namespace authalic
