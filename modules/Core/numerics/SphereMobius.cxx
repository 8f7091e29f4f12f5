#include "Core/numerics/SphereMobius.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <Eigen/SVD>

#include <algorithm>
#include <cmath>
#include <string>

#include "Core/base/Error.h"

namespace authalic {
namespace {

constexpr double kLongestStep = 3;  // hyperbolic; a Newton step far from the minimum may be any length

double energyAt(const Points3& points, const Eigen::VectorXd& masses, const Eigen::Vector3d& w) {
  double sum = 0;
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    if (masses[i] > 0) sum += masses[i] * std::log((points.row(i).transpose() - w).squaredNorm());
  }
  return sum - std::log(1 - w.squaredNorm());
}

struct Moments {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();
};

Moments momentsAbout(const Points3& points, const Eigen::VectorXd& masses, const Eigen::Vector3d& w) {
  Moments moments;
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    if (!(masses[i] > 0)) continue;
    const Eigen::Vector3d y = translateBall(w, points.row(i));
    moments.mean += masses[i] * y;
    moments.second += masses[i] * y * y.transpose();
  }
  return moments;
}

// The Newton step as a point of the ball about the current origin.
Eigen::Vector3d newtonStep(const Moments& moments) {
  const Eigen::Matrix3d hessian = Eigen::Matrix3d::Identity() * (1 + 1e-12) - moments.second;
  return 0.5 * hessian.ldlt().solve(moments.mean);
}

void requireMasses(const Points3& points, const Eigen::VectorXd& masses) {
  if (points.rows() != masses.size()) {
    throw GeometryError("One mass per point is required: there are " + std::to_string(points.rows()) + " points and " +
                        std::to_string(masses.size()) + " masses.");
  }
  if (!masses.allFinite() || masses.size() == 0 || masses.minCoeff() < 0 || !(masses.sum() > 0)) {
    throw GeometryError("Finite masses, none negative and not all zero, are required.");
  }
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    if (std::abs(points.row(i).norm() - 1) <= 1e-6) continue;
    throw GeometryError("Points on the unit sphere are required, but point " + std::to_string(i) +
                        " lies at distance " + std::to_string(points.row(i).norm()) +
                        " from the origin; divide by the radius first.");
  }
}

// The rotation that takes two independent vectors to two others of the same lengths and angle.
Eigen::Matrix3d nearestRotation(const Eigen::Matrix3d& m) {
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(m, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Eigen::Matrix3d u = svd.matrixU();
  if ((u * svd.matrixV().transpose()).determinant() < 0) u.col(2) *= -1;
  return u * svd.matrixV().transpose();
}

}  // namespace

Eigen::Vector3d translateBall(const Eigen::Vector3d& w, const Eigen::Vector3d& x) {
  const Eigen::Vector3d d = x - w;
  const double squared = d.squaredNorm(), rest = 1 - w.squaredNorm();
  // |x|² enters through 1 − 2 x·w + |x|²|w|² = |x − w|² + (1 − |x|²)(1 − |w|²).
  const double denominator = squared + (1 - x.squaredNorm()) * rest;
  return (rest * d - squared * w) / denominator;
}

SphereMobius::SphereMobius(const Eigen::Vector3d& centre, const Eigen::Matrix3d& rotation)
    : centre_(centre), rotation_(rotation) {
  if (!(centre.norm() < 1)) {
    throw GeometryError("A centre inside the unit ball is required, but it lies at distance " +
                        std::to_string(centre.norm()) + " from the origin.");
  }
  const bool orthogonal = (rotation * rotation.transpose() - Eigen::Matrix3d::Identity()).norm() < 1e-9;
  if (!orthogonal || !(rotation.determinant() > 0)) {
    throw GeometryError(
        "A rotation (orthogonal, determinant 1) is required for a Möbius transformation of the sphere.");
  }
}

Eigen::Vector3d SphereMobius::operator()(const Eigen::Vector3d& x) const {
  return (rotation_ * translateBall(centre_, x)).normalized();
}

Points3 SphereMobius::operator()(const Points3& points) const {
  Points3 image(points.rows(), 3);
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    image.row(i) = (*this)(Eigen::Vector3d(points.row(i).transpose())).transpose();
  }
  return image;
}

SphereMobius SphereMobius::inverse() const {
  // φ_{−w} Rᵀ = Rᵀ φ_{−R w}
  return {-(rotation_ * centre_), rotation_.transpose()};
}

SphereMobius SphereMobius::operator*(const SphereMobius& first) const {
  // What goes to the origin: the point that `first` takes to our centre. The rest is a rotation, read off three
  // points.
  const Eigen::Vector3d centre = translateBall(-first.centre_, first.rotation_.transpose() * centre_);
  Eigen::Matrix3d from, to;
  for (int k = 0; k < 3; ++k) {
    // Points that the translation spreads evenly, whatever its length.
    from.col(k) = Eigen::Vector3d::Unit(k);
    to.col(k) = (*this)(first(translateBall(-centre, from.col(k)).normalized()));
  }
  return {centre, nearestRotation(to * from.transpose())};
}

SphereCentring centreOfSphericalMassToOrigin(const Points3& points, const Eigen::VectorXd& masses, double tolerance,
                                             int maxIterations) {
  requireMasses(points, masses);
  const Eigen::VectorXd share = masses / masses.sum();
  SphereCentring result;
  Eigen::Vector3d w = Eigen::Vector3d::Zero();
  double energy = energyAt(points, share, w);
  for (result.status = Status::NotConverged;; ++result.iterations) {
    const Moments moments = momentsAbout(points, share, w);
    result.residual = moments.mean.norm();
    if (result.residual <= tolerance) result.status = Status::Converged;
    if (result.status != Status::NotConverged || result.iterations >= maxIterations) break;
    const Eigen::Vector3d newton = newtonStep(moments);
    const double slope = -2 * newton.dot(moments.mean);
    double step = std::min(1.0, kLongestStep / newton.norm());
    bool moved = false;
    for (int halving = 0; halving < 50 && !moved; ++halving, step *= 0.5) {
      const double length = (step * newton).norm();
      const Eigen::Vector3d next = translateBall(-w, newton * (step * std::tanh(length) / length));
      if (!(next.norm() < 1)) continue;
      const double there = energyAt(points, share, next);
      // Near the minimum the energy is flat to rounding; there the residual decides.
      const bool flat = std::abs(slope) < 1e-13 && momentsAbout(points, share, next).mean.norm() < result.residual;
      if (!flat && !(there <= energy + 1e-4 * step * slope)) continue;
      w = next;
      energy = there;
      moved = true;
    }
    if (!moved) result.status = Status::Stalled;
  }
  result.map = SphereMobius(w, Eigen::Matrix3d::Identity());
  return result;
}

}  // namespace authalic
