#include "Core/conformal/HarmonicSphereMap.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <string>

#include "Core/base/Error.h"
#include "Core/geometry/Areas.h"
#include "Core/geometry/SphericalAreas.h"
#include "Core/numerics/SphereMobius.h"

namespace authalic {
namespace {

constexpr double kMostDrift = 1e-3;  // of the centre of mass, before it is brought back

Eigen::MatrixXd tangential(const Eigen::MatrixXd& f, const Eigen::MatrixXd& v) {
  const Eigen::VectorXd normal = f.cwiseProduct(v).rowwise().sum();
  return v - normal.asDiagonal() * f;
}

// The descent: current map, its gradient, and the conjugate direction.
class Descent {
 public:
  Descent(const SphereMesh& sphere, const SphereLaplacian& laplacian, const Points3& start)
      : sphere_(sphere), laplacian_(laplacian),
        share_(vertexStars(faceAreas(sphere.mesh()), sphere.mesh().faces(), sphere.mesh().vertexCount())) {
    share_ /= share_.sum();
    restart(start);
  }

  // Brings the centre of mass to 0 and forgets the directions.
  void restart(const Eigen::MatrixXd& map) {
    const Points3 points = map;
    moveTo(centreOfSphericalMassToOrigin(points, share_).map(points));
    direction_.resize(0, 0);
  }

  [[nodiscard]] double residual() const { return std::sqrt(std::max(slope_, 0.0) / (2 * energy_)); }
  [[nodiscard]] double drift() const { return (share_.transpose() * map_).norm(); }
  [[nodiscard]] const Eigen::MatrixXd& map() const { return map_; }

  // One conjugate step. @return false when the energy cannot be lowered
  bool step() {
    chooseDirection();
    const Eigen::MatrixXd start = map_, image = stiff_;
    const double energy = energy_, slope = gradient_.cwiseProduct(direction_).sum();
    // Along a straight line E would be a parabola with this minimum.
    const double curvature = direction_.cwiseProduct(laplacian_.multiply(direction_)).sum();
    double length = std::min(1.0, -slope / std::max(curvature, 1e-300)) * stretch_;
    for (int halving = 0; halving < 20; ++halving, length *= 0.5) {
      const Eigen::MatrixXd next = (start + length * direction_).rowwise().normalized();
      const double there = laplacian_.energy(next);
      if (!(there <= energy + 1e-4 * length * slope)) continue;
      moveTo(next);
      return true;
    }
    map_ = start;
    stiff_ = image;
    return false;
  }

 private:
  void moveTo(const Eigen::MatrixXd& map) {
    map_ = map;
    stiff_ = laplacian_.multiply(map_);
    energy_ = 0.5 * map_.cwiseProduct(stiff_).sum();
    const Eigen::MatrixXd before = gradient_;
    gradient_ = tangential(map_, stiff_);
    const Eigen::MatrixXd free = gradient_ - boostWith(gradient_.colwise().sum().transpose());
    Eigen::MatrixXd descent = tangential(map_, -laplacian_.solve(free));
    descent -= share_.cwiseInverse().asDiagonal() * boostWith(descent.transpose() * share_);
    previousSlope_ = slope_;
    slope_ = -gradient_.cwiseProduct(descent).sum();
    mixed_ = before.size() > 0 ? -before.cwiseProduct(descent).sum() : 0;
    steepest_ = descent;
  }

  // The field share_i P_i c, P_i: onto the tangent plane at i, whose sum is the given vector: an infinitesimal Möbius
  // transformation, weighted by area.
  [[nodiscard]] Eigen::MatrixXd boostWith(const Eigen::Vector3d& sum) const {
    const Eigen::Matrix3d total = Eigen::Matrix3d::Identity() - map_.transpose() * share_.asDiagonal() * map_;
    const Eigen::RowVector3d c = total.ldlt().solve(sum).transpose();
    return share_.asDiagonal() * tangential(map_, c.replicate(map_.rows(), 1));
  }

  void chooseDirection() {
    // Polak–Ribière, restarted when it points uphill.
    const double beta = direction_.size() > 0 && previousSlope_ > 0 ? std::max(0.0, (slope_ - mixed_) / previousSlope_) : 0;
    if (beta > 0) {
      direction_ = steepest_ + beta * tangential(map_, direction_);
    } else {
      direction_ = steepest_;
    }
    if (!(gradient_.cwiseProduct(direction_).sum() < -0.1 * slope_)) direction_ = steepest_;
  }

  const SphereMesh& sphere_;
  const SphereLaplacian& laplacian_;
  Eigen::VectorXd share_;
  Eigen::MatrixXd map_, stiff_, gradient_, steepest_, direction_;
  double energy_ = 0, slope_ = 0, previousSlope_ = 0, mixed_ = 0, stretch_ = 1;
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
    if (descent.drift() > kMostDrift) descent.restart(descent.map());
    if (!descent.step()) result.status = Status::Stalled;
  }
  descent.restart(descent.map());
  result.image = descent.map();
  result.flippedFaces = countFlippedOnSphere(result.image, sphere.mesh().faces());
  result.degenerateFaces = static_cast<int>((faceAreas(sphere.mesh()).array() <= 0).count());
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return result;
}

}  // namespace authalic
