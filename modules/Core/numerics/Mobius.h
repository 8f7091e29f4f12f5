/// @file
/// Möbius transformations of the plane and the automorphisms of the unit disk.
#pragma once

#include <Eigen/Core>

#include <array>
#include <complex>

#include "Core/base/Arrays.h"
#include "Core/base/Status.h"

namespace authalic {

/// z ↦ (a z + b) / (c z + d) with a d − b c ≠ 0: the conformal maps of the plane with ∞ onto itself; circles and
/// lines go to circles and lines. Value type; kept with a d − b c = 1.
class Mobius {
 public:
  using Complex = std::complex<double>;

  /// The identity.
  Mobius() = default;
  /// @throws GeometryError when the coefficients are not finite or a d − b c vanishes: then the map is constant.
  Mobius(Complex a, Complex b, Complex c, Complex d);

  /// e^{iθ} z.
  [[nodiscard]] static Mobius rotation(double angle);
  /// s z + t. @throws GeometryError when s is 0
  [[nodiscard]] static Mobius similarity(Complex scale, Complex shift);
  /// (z − p) / (1 − p̄ z): the automorphism of the unit disk that carries p to 0 and moves along the diameter
  /// through p. @throws GeometryError unless |p| < 1
  [[nodiscard]] static Mobius diskToOrigin(Complex p);
  /// The one transformation that carries three points to three points (cross-ratio).
  /// @throws GeometryError when two points of a triple are equal
  [[nodiscard]] static Mobius throughThreePoints(const std::array<Complex, 3>& from, const std::array<Complex, 3>& to);

  [[nodiscard]] Complex a() const noexcept { return a_; }
  [[nodiscard]] Complex b() const noexcept { return b_; }
  [[nodiscard]] Complex c() const noexcept { return c_; }
  [[nodiscard]] Complex d() const noexcept { return d_; }

  /// Image of a point; not finite at the pole −d/c.
  [[nodiscard]] Complex operator()(Complex z) const { return (a_ * z + b_) / (c_ * z + d_); }
  /// 1 / (c z + d)².
  [[nodiscard]] Complex derivative(Complex z) const;
  /// Image of every row, n×2.
  [[nodiscard]] Points2 operator()(const Points2& points) const;
  [[nodiscard]] Mobius inverse() const;
  /// (this ∘ first)(z) = this(first(z)).
  [[nodiscard]] Mobius operator*(const Mobius& first) const;

 private:
  Complex a_{1}, b_{0}, c_{0}, d_{1};
};

/// What centreOfMassToOrigin found.
struct DiskCentring {
  Mobius map;                      ///< the automorphism of the unit disk; carries no rotation: its derivative at the
                                   ///< point that goes to 0 is positive
  Status status = Status::NotRun;  ///< Converged: residual ≤ tolerance, or ≤ 4e-15 / (1 − |w|²), the
                                   ///< rounding of the points; Stalled: w runs to the circle
  int iterations = 0;
  double residual = 0;             ///< |Σ m_i φ(z_i)| / Σ m_i
};

/// The automorphism φ of the unit disk, unique up to rotation, with Σ m_i φ(z_i) = 0.
///
/// φ = diskToOrigin(w) where w minimises Σ m_i ln(|1 − w̄ z_i|² / (1 − |w|²)), which is strictly convex along
/// hyperbolic geodesics (on the circle: the conformal barycentre of @cite douady1986). Newton's method from
/// wherever the last step went to 0: w − S w̄ = c with c, S the mass means of z and z², halved until the energy
/// falls.
///
/// @param points  n×2 in the closed unit disk
/// @param masses  n masses ≥ 0 with a positive sum; no point of the circle may hold half of it
/// @throws GeometryError when sizes differ, a mass is negative or not finite, all are zero, or a point lies outside
/// Complexity O(n) per iteration; 4 to 10 iterations.
[[nodiscard]] DiskCentring centreOfMassToOrigin(const Points2& points, const Eigen::VectorXd& masses,
                                                double tolerance = 1e-13, int maxIterations = 100);

}  // namespace authalic
