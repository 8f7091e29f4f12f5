#include "Core/numerics/Mobius.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "Core/base/Error.h"

namespace authalic {
namespace {

using Complex = Mobius::Complex;

Complex pointOf(const Points2& points, Eigen::Index i) { return {points(i, 0), points(i, 1)}; }

// The transformation that carries three points to 0, 1, ∞.
Mobius toZeroOneInfinity(const std::array<Complex, 3>& z) {
  if (z[0] == z[1] || z[1] == z[2] || z[2] == z[0]) {
    throw GeometryError("Three different points are required to fix a Möbius transformation, but two of them are equal.");
  }
  return {z[1] - z[2], -z[0] * (z[1] - z[2]), z[1] - z[0], -z[2] * (z[1] - z[0])};
}

void requireMassesInDisk(const Points2& points, const Eigen::VectorXd& masses) {
  if (points.rows() != masses.size()) {
    throw GeometryError("One mass per point is required: there are " + std::to_string(points.rows()) +
                        " points, but " + std::to_string(masses.size()) + " masses.");
  }
  if (!masses.allFinite() || masses.size() == 0 || masses.minCoeff() < 0 || !(masses.sum() > 0)) {
    throw GeometryError("Finite masses that are not negative and not all zero are required.");
  }
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    if (!(points.row(i).squaredNorm() <= 1 + 1e-9)) {
      throw GeometryError("Points in the closed unit disk are required, but point " + std::to_string(i) + " is (" +
                          std::to_string(points(i, 0)) + ", " + std::to_string(points(i, 1)) + ").");
    }
  }
}

// Mean of ln(|1 − w̄ z|² / (1 − |w|²)): 0 at w = 0, convex along geodesics.
double energyAt(const Points2& points, const Eigen::VectorXd& masses, Complex w) {
  double energy = 0;
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    if (masses[i] > 0) energy += masses[i] * std::log(std::norm(1.0 - std::conj(w) * pointOf(points, i)));
  }
  return energy / masses.sum() - std::log1p(-std::norm(w));
}

// The Newton step from 0, shortened until it stays inside the disk and lowers the energy.
Complex centringStep(const Points2& points, const Eigen::VectorXd& masses, Complex centre) {
  Complex second = 0;
  for (Eigen::Index i = 0; i < points.rows(); ++i) second += masses[i] * pointOf(points, i) * pointOf(points, i);
  second /= masses.sum();
  Complex w = (centre + second * std::conj(centre)) / std::max(1 - std::norm(second), 1e-12);
  if (std::abs(w) > 0.9) w *= 0.9 / std::abs(w);
  const double slope = -2 * (w * std::conj(centre)).real();
  double step = 1;
  // Near the minimum the energy is all rounding: there the full step is right.
  if (std::abs(slope) > 1e-12) {
    while (step > 1e-6 && energyAt(points, masses, step * w) > 1e-4 * step * slope) step *= 0.5;
  }
  return step * w;
}

Complex massCentre(const Points2& points, const Eigen::VectorXd& masses) {
  const Eigen::RowVector2d centre = masses.transpose() * points / masses.sum();
  return {centre[0], centre[1]};
}

}  // namespace

Mobius::Mobius(Complex a, Complex b, Complex c, Complex d) : a_(a), b_(b), c_(c), d_(d) {
  const Complex determinant = a * d - b * c;
  const double size = std::norm(a) + std::norm(b) + std::norm(c) + std::norm(d);
  if (!std::isfinite(size) || !(std::abs(determinant) > 1e-300)) {
    throw GeometryError("A Möbius transformation with a d - b c other than zero is required; this one is constant or "
                        "not finite.");
  }
  const Complex root = std::sqrt(determinant);
  a_ /= root;
  b_ /= root;
  c_ /= root;
  d_ /= root;
}

Mobius Mobius::rotation(double angle) { return {std::polar(1.0, angle), 0, 0, 1}; }

Mobius Mobius::similarity(Complex scale, Complex shift) { return {scale, shift, 0, 1}; }

Mobius Mobius::diskToOrigin(Complex p) {
  if (!(std::norm(p) < 1)) {
    throw GeometryError("A point inside the unit disk is required to go to the centre, but its modulus is " +
                        std::to_string(std::abs(p)) + ".");
  }
  return {1, -p, -std::conj(p), 1};
}

Mobius Mobius::throughThreePoints(const std::array<Complex, 3>& from, const std::array<Complex, 3>& to) {
  return toZeroOneInfinity(to).inverse() * toZeroOneInfinity(from);
}

Complex Mobius::derivative(Complex z) const { return 1.0 / ((c_ * z + d_) * (c_ * z + d_)); }

Points2 Mobius::operator()(const Points2& points) const {
  Points2 image(points.rows(), 2);
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    const Complex z = (*this)(pointOf(points, i));
    image.row(i) << z.real(), z.imag();
  }
  return image;
}

Mobius Mobius::inverse() const { return {d_, -b_, -c_, a_}; }

Mobius Mobius::operator*(const Mobius& first) const {
  return {a_ * first.a_ + b_ * first.c_, a_ * first.b_ + b_ * first.d_, c_ * first.a_ + d_ * first.c_,
          c_ * first.b_ + d_ * first.d_};
}

DiskCentring centreOfMassToOrigin(const Points2& points, const Eigen::VectorXd& masses, double tolerance,
                                  int maxIterations) {
  requireMassesInDisk(points, masses);
  DiskCentring centring;
  Points2 moved = points;
  for (;; ++centring.iterations) {
    const Complex centre = massCentre(moved, masses);
    centring.residual = std::abs(centre);
    const double rounding = 16 * std::numeric_limits<double>::epsilon() * std::abs(centring.map.a()) *
                            std::abs(centring.map.a());  // points near the circle are known to 1e-16, magnified
    if (centring.residual <= std::max(tolerance, rounding)) centring.status = Status::Converged;
    if (centring.status == Status::Converged || centring.iterations >= maxIterations) break;
    // What goes to 0 next; diskToOrigin of it is the composition without the rotation that it has picked up.
    const Complex next = centring.map.inverse()(centringStep(moved, masses, centre));
    if (!(std::norm(next) < 1 - 1e-14)) break;  // the minimum lies on the circle: an atom there
    centring.map = Mobius::diskToOrigin(next);
    moved = centring.map(points);
  }
  if (centring.status != Status::Converged) {
    centring.status = centring.iterations < maxIterations ? Status::Stalled : Status::NotConverged;
  }
  return centring;
}

}  // namespace authalic
