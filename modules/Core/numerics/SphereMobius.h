/// @file
/// Möbius transformations of the unit sphere: the conformal maps of the sphere onto itself.
#pragma once

#include <Eigen/Core>

#include "Core/base/Arrays.h"
#include "Core/base/Status.h"

namespace authalic {

/// x ↦ R φ_w(x) with φ_w(x) = (1 − |w|²)(x − w)/|x − w|² − w: a translation of hyperbolic space that carries the
/// point w of the open unit ball to its centre, seen on the sphere, then a rotation R. Every conformal map of the
/// sphere that keeps orientation is of this form, in one way. Circles go to circles.
class SphereMobius {
 public:
  /// The identity.
  SphereMobius() = default;
  /// @throws GeometryError unless |centre| < 1 and the rotation is orthogonal to 1e-9 with determinant 1
  SphereMobius(const Eigen::Vector3d& centre, const Eigen::Matrix3d& rotation);

  [[nodiscard]] const Eigen::Vector3d& centre() const noexcept { return centre_; }
  [[nodiscard]] const Eigen::Matrix3d& rotation() const noexcept { return rotation_; }

  /// Image of a point of the unit sphere; of unit length.
  [[nodiscard]] Eigen::Vector3d operator()(const Eigen::Vector3d& x) const;
  /// Image of every row, n×3.
  [[nodiscard]] Points3 operator()(const Points3& points) const;
  [[nodiscard]] SphereMobius inverse() const;
  /// (this ∘ first)(x) = this(first(x)).
  [[nodiscard]] SphereMobius operator*(const SphereMobius& first) const;

 private:
  Eigen::Vector3d centre_ = Eigen::Vector3d::Zero();
  Eigen::Matrix3d rotation_ = Eigen::Matrix3d::Identity();
};

/// φ_w at a point of the closed ball: the hyperbolic translation that carries w to 0.
[[nodiscard]] Eigen::Vector3d translateBall(const Eigen::Vector3d& w, const Eigen::Vector3d& x);

/// What centreOfSphericalMassToOrigin found.
struct SphereCentring {
  SphereMobius map;                ///< without rotation
  Status status = Status::NotRun;  ///< Converged: residual ≤ tolerance; Stalled: rounding, or w runs to the sphere
  int iterations = 0;
  double residual = 0;             ///< |Σ m_i φ(x_i)| / Σ m_i
};

/// The Möbius transformation φ of the sphere, unique up to rotation, with Σ m_i φ(x_i) = 0.
///
/// φ = φ_w where w, the conformal barycentre @cite douady1986, minimises Σ m_i ln(|x_i − w|² / (1 − |w|²)): a sum of
/// Busemann functions, strictly convex along hyperbolic geodesics. Newton's method in hyperbolic space
/// @cite cantarella2022: about the last w the step solves (I − Σ m y yᵀ) s = ½ Σ m y, y = φ_w(x), Σ m = 1; it is
/// halved until the energy falls enough, so that every iteration makes progress from any start.
///
/// @param points  n×3 on the unit sphere
/// @param masses  n masses ≥ 0 with a positive sum; no point may hold half of it (then there is no minimum → Stalled)
/// @throws GeometryError when sizes differ, a mass is negative or not finite, all are zero, or a point is off the
/// sphere Complexity O(n) per iteration; 4 to 10 iterations.
[[nodiscard]] SphereCentring centreOfSphericalMassToOrigin(const Points3& points, const Eigen::VectorXd& masses,
                                                           double tolerance = 1e-13, int maxIterations = 100);

}  // namespace authalic
