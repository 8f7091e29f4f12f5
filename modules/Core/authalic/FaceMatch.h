/// @file
/// Damped Gauss–Newton steps that bring every face to its target area. Private to authalic/.
#pragma once

#include <algorithm>
#include <memory>

#include "Core/authalic/BoundaryStars.h"
#include "Core/authalic/ShapeEnergy.h"
#include "Core/authalic/StarConstraint.h"
#include "Core/base/Execution.h"
#include "Core/numerics/AnalysedSystems.h"

namespace authalic {

/// What face steps look at besides areas.
enum class Shapes {
  Kept,   ///< good angles while areas are matched, small faces included
  First,  ///< better angles, with areas just within the tolerance
  Free    ///< areas alone: nearer to the targets on coarse meshes, with more shear
};

/// Brings F = Σ_t m_t (r_t + 1/r_t − 2) = D_area − 2 down, r = q / m, q = a / Σ a the image shares and m the targets,
/// and of the images that are near their targets takes one with good shapes: it minimises
///
///     Φ = ½ S [Σ_t ω_t m_t (r_t + 1/r_t − 2) + B(a)] + τ E(x),   S = Σ a,
///
/// with the importance ω of faces and the Dirichlet energy E of the map, see ShapeEnergy, and the same sum B over the
/// stars on a boundary, see BoundaryStars, for τ that falls from step to step. One step solves (Levenberg–Marquardt)
///
///     min_δ ½ Σ_t ω_t (a_t + ∇a_t·δ − S m_t)² / (S m_t φ_t) + τ E(x + δ) + ½ ε Σ_{edges ij} |δ_i − δ_j|²
///
/// and the same of B, with φ_t = 2 r_t² / (1 + r_t) of the image before the step, so that the right-hand side is the
/// exact gradient of Φ; moves by the part of δ that folds no face and lowers Φ (1/r is a barrier); and adapts ε: ×¼
/// after a long step, ×4 after a short one, ×10 after none. Where faces would collapse on the way, ε is multiplied for
/// their edges in the steps to come: a triangle that moves rigidly stays.
///
/// What 20 steps have not done is held up by a few faces that the model wants much of, p_t = ω_t (S m_t − a_t) /
/// (S m_t φ_t), while their areas bend: from there on each adds |p_t| / 17, |p_t| ≤ 10, to the ε of its edges, a tenth
/// of what bounds the curvature p_t ∂²a_t that the model leaves out.
class FaceMatch {
 public:
  /// @param targets     m shares > 0, sum 1
  /// @param cotangents  of the surface
  /// @param systems     where the pattern and its analysis are kept; their threads work here too
  FaceMatch(const AreaFunctional& areas, const Eigen::VectorXd& targets, const HalfEdgeWeights& cotangents,
            SolverBackend backend, Shapes shapes, AnalysedSystems& systems);

  /// One step; `image` has no folded face and keeps none.
  /// @return the part of δ taken, in (0, 1]; 0 when none lowered Φ
  double advance(Coordinates& image);

  /// The same step among those that bring the stars to their targets, J δ = e, without a search for a part that
  /// lowers Φ: ε is raised until the stars come at least twice as near and faces do not go astray, farther than
  /// twice what they are or may be. They hardly notice what vertex steps do afterwards.
  /// @param tolerance  what the residual may be
  /// @return the part of δ taken; 0 when no ε served, and the image is as it was
  double advanceOnStars(StarConstraint& stars, double tolerance, Coordinates& image);

  /// (Σ m_t (r_t + 1/r_t − 2))^½ = (D_area − 2)^½ of an image; +infinity when a face is folded.
  [[nodiscard]] double residual(const Coordinates& image) const;

  /// Mean |ln r_t| of an image without folds, every face counting the same.
  [[nodiscard]] double meanAbsLog(const Coordinates& image) const;

  /// Five steps in a row were 0.
  [[nodiscard]] bool stalled() const noexcept { return failures_ > 4; }
  /// @param goal  residual to come: τ stops falling where it would matter no more, and does not rise again
  void restart(double goal) noexcept;
  /// Allows smaller ε and τ than so far: slides along curves of equal area, which buy the last errors with shear.
  void relax() noexcept;
  /// From now on areas alone, every face as important as its target is large.
  void freeShapes() noexcept;

 private:
  static constexpr double kFirstDamping = 0.02, kUsualDamping = 1e-4, kLeastDamping = 1e-8,
                          kFirstDampingOnStars = 1e-2, kMostDampingOnStars = 10;
  [[nodiscard]] Eigen::ArrayXd faceErrors(const Eigen::VectorXd& areas) const;
  [[nodiscard]] double objective(const Coordinates& image) const;
  void linearise(const Coordinates& image);
  [[nodiscard]] bool factorise(double damping);
  [[nodiscard]] Coordinates step(const Coordinates& image);
  void fillElement(Eigen::Index face, double rigidity);
  [[nodiscard]] double rigidity(Eigen::Index face, double damping) const;  // its ε
  [[nodiscard]] double edgeStiffness(Eigen::Index face, double rigidity, int k, int l) const;
  // Steps along joint moves of the domain, see AreaFunctional::jointMoves(); in FaceMatchJointly.cxx.
  [[nodiscard]] Coordinates jointStep(const Coordinates& image, const std::vector<Coordinates>& moves) const;
  [[nodiscard]] Coordinates answer(const AreaFunctional::Gradients& slopes, const Coordinates& displacement) const;
  [[nodiscard]] Coordinates descent(const AreaFunctional::Gradients& slopes, const Coordinates& image) const;
  [[nodiscard]] Eigen::VectorXd onUnknowns(const Coordinates& forces) const;
  // Steps along parameters of the domain, see AreaFunctional::parameters(); in FaceMatchWithParameters.cxx.
  struct PlanarModel {
    Eigen::Matrix<double, 6, 6> second;  // by the corners of one face
    Eigen::Matrix<double, 6, 1> down;    // −∂Φ
  };
  [[nodiscard]] PlanarModel planarModel(const AreaFunctional::Corners& corners, Eigen::Index face,
                                        double lacking) const;
  [[nodiscard]] Coordinates stepWithParameters(const Coordinates& image, const CornerMoves& parameters) const;
  [[nodiscard]] Eigen::ArrayXd flips(const Coordinates& image, const Coordinates& displacement) const;
  [[nodiscard]] Coordinates slowedWhereFacesCollapse(const Coordinates& image, Coordinates displacement,
                                                     Eigen::ArrayXd& flips) const;
  void stiffen(const Eigen::ArrayXd& flips);
  void adapt(double step);

  const AreaFunctional& areas_;
  const Eigen::VectorXd& targets_;
  Execution workers_;  // silent
  Eigen::VectorXd importance_;
  ShapeEnergy shape_;
  BoundaryStars stars_;
  std::shared_ptr<AssembledSystem> system_;
  std::vector<double> values_;  // of the elements of the faces, then of the stars
  AreaFunctional::Frames frames_;
  AreaFunctional::Gradients gradients_;
  Eigen::VectorXd weights_, pulls_, right_, stiffness_;  // pulls: by area of a face, down Φ without E
  double damping_ = kFirstDamping, leastDamping_ = kUsualDamping, dampingOnStars_ = kFirstDampingOnStars;
  double pull_, leastPull_ = 1, endPull_ = 0;  // τ
  double pullFalls_;                           // factor per step
  double usualPull_;                           // leastPull_ by the square of the goal
  int failures_ = 0, steps_ = 0;
};

}  // namespace authalic
