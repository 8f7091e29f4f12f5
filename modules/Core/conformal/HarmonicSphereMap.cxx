#include "Core/conformal/HarmonicSphereMap.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <string>
#include <utility>

#include "Core/base/Error.h"
#include "Core/geometry/Areas.h"
#include "Core/geometry/SphericalAreas.h"
#include "Core/numerics/SphereMobius.h"

namespace authalic {
namespace {

Points3 tangential(const Points3& f, const Points3& v) {
  const Eigen::VectorXd normal = f.cwiseProduct(v).rowwise().sum();
  return v - normal.asDiagonal() * f;
}

// A map, its energy and the tangential part of Lf.
struct Iterate {
  Points3 map, gradient;
  double energy = 0;
};

// Conjugate gradients on the maps to the sphere.
class Descent {
 public:
  Descent(const SphereMesh& sphere, const SphereLaplacian& laplacian, const Points3& start)
      : faces_(sphere.mesh().faces()), laplacian_(laplacian),
        share_(vertexStars(faceAreas(sphere.mesh()), sphere.mesh().faces(), sphere.mesh().vertexCount())) {
    share_ /= share_.sum();
    now_ = at(start);
    degree_ = degreeOf(now_.map);
    precondition();
  }

  [[nodiscard]] double residual() const { return std::sqrt(std::max(slope_, 0.0) / (2 * now_.energy)); }
  [[nodiscard]] const Points3& map() const { return now_.map; }

  // One conjugate step. @return false when the energy cannot be lowered
  bool step() {
    chooseDirection();
    const double slope = now_.gradient.cwiseProduct(direction_).sum();
    for (int halving = 0; halving < 20; ++halving, length_ *= 0.5) {
      Iterate next = along(length_);
      if (!lowers(next, length_ * slope)) continue;
      // The place where the slope vanishes if it falls evenly.
      const double fall = 1 - next.gradient.cwiseProduct(direction_).sum() / slope;
      length_ *= std::clamp(1 / std::max(fall, 1e-3), 0.5, 2.0);
      Iterate better = along(length_);
      if (better.energy < next.energy) next = std::move(better);
      if (degreeOf(next.map) != degree_) continue;  // through a face too coarse to hold the map
      const Points3 before = std::move(now_.gradient);
      const double previous = slope_;
      now_ = std::move(next);
      precondition();
      const double mixed = -before.cwiseProduct(steepest_).sum();
      beta_ = previous > 0 ? std::max(0.0, (slope_ - mixed) / previous) : 0;  // Polak–Ribière
      return true;
    }
    length_ = 1;
    return false;
  }

 private:
  // With the centre of mass brought to 0: a change of second order along our directions.
  [[nodiscard]] Iterate at(const Points3& map) const {
    Iterate there;
    there.map = centreOfSphericalMassToOrigin(map, share_, 1e-11).map(map);
    there.energy = laplacian_.energy(there.map);
    there.gradient = tangential(there.map, laplacian_.multiply(there.map));
    return there;
  }

  // How often the image covers the sphere.
  [[nodiscard]] long degreeOf(const Points3& map) const {
    return std::lround(signedSolidAngles(map, faces_).sum() / (4 * M_PI));
  }

  [[nodiscard]] Iterate along(double length) const {
    return at((now_.map + length * direction_).rowwise().normalized());
  }

  // Enough by Armijo's rule; where the energy is flat to rounding, not to rise is enough.
  [[nodiscard]] bool lowers(const Iterate& next, double expected) const {
    const double bound = -expected > 1e-11 * now_.energy ? 1e-4 * expected : 1e-14 * now_.energy;
    return next.energy <= now_.energy + bound;
  }

  void precondition() {
    const Points3 free =
        now_.gradient - share_.asDiagonal() * boostWith(now_.gradient.colwise().sum().transpose());
    steepest_ = tangential(now_.map, -laplacian_.solve(free));
    steepest_ -= boostWith(steepest_.transpose() * share_);
    slope_ = -now_.gradient.cwiseProduct(steepest_).sum();
  }

  // The infinitesimal Möbius transformation P_i c, P_i: onto the tangent plane at i, with the given mean over the
  // surface.
  [[nodiscard]] Points3 boostWith(const Eigen::Vector3d& mean) const {
    const Eigen::Matrix3d total = Eigen::Matrix3d::Identity() - now_.map.transpose() * share_.asDiagonal() * now_.map;
    const Eigen::RowVector3d c = total.ldlt().solve(mean).transpose();
    return tangential(now_.map, c.replicate(now_.map.rows(), 1));
  }

  void chooseDirection() {
    if (direction_.size() > 0 && beta_ > 0) {
      direction_ = steepest_ + beta_ * tangential(now_.map, direction_);
      if (now_.gradient.cwiseProduct(direction_).sum() < -0.1 * slope_) return;  // else it points too far uphill
    }
    direction_ = steepest_;
  }

  const Faces& faces_;
  const SphereLaplacian& laplacian_;
  long degree_ = 1;
  Eigen::VectorXd share_;
  Iterate now_;
  Points3 steepest_, direction_;
  double slope_ = 0, beta_ = 0, length_ = 1;
};

}  // namespace

void HarmonicSphereMapOptions::validate() const {
  if (!(tolerance > 0) || maxIterations < 0) {
    throw InvalidArgument("A positive tolerance and at least 0 iterations are required, but they are " +
                          std::to_string(tolerance) + " and " + std::to_string(maxIterations) + ".");
  }
  if (!SparseSolver::available(solver)) {
    throw InvalidArgument("A solver that is part of this build is required, but " +
                          std::string(solverBackendName(solver)) + " was not built in.");
  }
}

SphericalMapResult harmonicSphereMap(const SphereMesh& sphere, const Points3& start,
                                     const HarmonicSphereMapOptions& options, const Execution& execution) {
  options.validate();
  return harmonicSphereMap(sphere, SphereLaplacian(sphere, options.solver), start, options, execution);
}

SphericalMapResult harmonicSphereMap(const SphereMesh& sphere, const SphereLaplacian& laplacian, const Points3& start,
                                     const HarmonicSphereMapOptions& options, const Execution& execution) {
  options.validate();
  const auto begin = std::chrono::steady_clock::now();
  Descent descent(sphere, laplacian, start);
  SphericalMapResult result;
  result.status = Status::NotConverged;
  for (;; ++result.iterations) {
    result.residual = descent.residual();
    result.history.push_back(result.residual);
    if (result.residual <= options.tolerance) result.status = Status::Converged;
    if (execution.cancelled()) result.status = Status::Cancelled;
    if (result.status != Status::NotConverged || result.iterations >= options.maxIterations) break;
    execution.report(double(result.iterations) / options.maxIterations, "Harmonic map");
    if (!descent.step()) result.status = Status::Stalled;
  }
  result.image = descent.map();
  result.flippedFaces = countFlippedOnSphere(result.image, sphere.mesh().faces());
  result.degenerateFaces = static_cast<int>((faceAreas(sphere.mesh()).array() <= 0).count());
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return result;
}

}  // namespace authalic
