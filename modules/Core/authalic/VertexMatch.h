/// @file
/// Newton steps that bring every vertex star to its target area, to machine precision. Private to authalic/.
#pragma once

#include <memory>

#include "Core/authalic/AreaFunctional.h"
#include "Core/numerics/AnalysedSystems.h"

namespace authalic {

/// Solves c(x) = 0, c_v = ⅓ Σ_{t∋v} a_t − S n_v, S = Σ a, n the target shares of the vertices.
///
/// There are about half as many equations as unknowns; a step is the shortest displacement that solves the
/// linearised ones,
///
///     δ = −W⁻¹ Jᵀ (J W⁻¹ Jᵀ)⁻¹ c,   J = ∂c/∂x,   W = target areas of the vertices:
///
/// the step of Lie advection @cite zou2011 with the discrete divergence that belongs to the areas, hence quadratic.
/// The equations depend on each other (they sum to 0; on three-colourable meshes there are two more dependencies):
/// the matrix is regularised by 1e-12 of its diagonal. The tip of an ear on the circle has its place between the ends
/// of its base for unknown, not its place on the circle: the shortest displacement takes it along.
class VertexMatch {
 public:
  /// @param targets  n shares, sum 1; vertices with target 0 (no face) are left out
  /// @param systems  where the pattern and its analysis are kept
  VertexMatch(const AreaFunctional& areas, const Eigen::VectorXd& targets, SolverBackend backend,
              AnalysedSystems& systems);

  /// One step, as long as no face folds.
  /// @return the part of δ taken, in (0, 1]
  double advance(Coordinates& image);

  /// Takes W from an image and forgets which corners were made stiffer; to be called before the first step.
  void restart(const Coordinates& image);

  /// max |ln r_v| of an image; +infinity when a face is folded.
  [[nodiscard]] double residual(const Coordinates& image) const;

 private:
  void findStars();
  void letTipsRide();
  void fillJacobian(const Coordinates& image);
  [[nodiscard]] Eigen::VectorXd error(const Coordinates& image) const;
  [[nodiscard]] Coordinates step(const Eigen::VectorXd& error);
  double flipFree(const Coordinates& image, const Coordinates& displacement);

  const AreaFunctional& areas_;
  const Eigen::VectorXd& targets_;
  std::vector<int> starts_, stars_;    // vertices whose star areas depend on vertex w: stars_[starts_[w]] …
  std::vector<int> place_;             // 9 per face: place in the star of corner k of corner l
  std::vector<double> jacobian_;       // 2 per entry of stars_
  std::vector<double> values_;
  std::shared_ptr<AssembledSystem> system_;
  AreaFunctional::Frames frames_;
  Eigen::VectorXd mobility_;           // 1 / W
};

}  // namespace authalic
