#include "Core/conformal/YamabeFlow.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>
#include <string>
#include <utility>

#include "Core/base/Error.h"
#include "Core/conformal/CirclePacking.h"
#include "Core/conformal/MovingMetric.h"

namespace authalic {
namespace {

constexpr double kRecordFactor = 0.9;
constexpr double kSmallestStep = 1e-9;
constexpr double kLongestChange =
    8;  // of u in one step: e^8 in length, far beyond where Newton's model holds

void requireAdmissible(const IntrinsicTriangulation& triangulation, const Eigen::VectorXd& target) {
  const int n = triangulation.vertexCount();
  if (target.size() != n || !target.allFinite()) {
    throw GeometryError("One finite target curvature per vertex is required: there are " + std::to_string(n) +
                        " vertices and " + std::to_string(target.size()) + " targets.");
  }
  for (int v = 0; v < n; ++v) {
    const bool boundary = triangulation.onBoundary()[static_cast<std::size_t>(v)];
    if (target[v] >= (boundary ? M_PI : 2 * M_PI)) {
      throw InvalidArgument(std::string("A target curvature below ") +
                            (boundary ? "π on the boundary" : "2π inside") +
                            " is required (angles are positive), but it is " + std::to_string(target[v]) +
                            " at vertex " + std::to_string(v) + ".");
    }
  }
  const double total = vertexCurvature(triangulation, Eigen::VectorXd::Zero(n)).sum();
  if (std::abs(target.sum() - total) > 1e-9 * (1 + std::sqrt(static_cast<double>(n)))) {
    throw InvalidArgument("Target curvatures with sum 2π χ = " + std::to_string(total) +
                          " are required (Gauss-Bonnet), but their sum is " + std::to_string(target.sum()) +
                          ", off by " + std::to_string(target.sum() - total) + ".");
  }
}

/// Newton's method for K(u) = K̄(u).
class Flow {
 public:
  Flow(IntrinsicTriangulation triangulation, const Eigen::VectorXd& target,
       std::vector<BoundaryCircle> circles, const YamabeFlowOptions& options, const Execution& execution)
      : options_(options),
        execution_(execution),
        originalVertices_(static_cast<int>(target.size())),
        circles_(std::move(circles)),
        target_(target),
        u_(Eigen::VectorXd::Zero(target.size())) {
    start(std::move(triangulation));
    moveTo(u_);
    record_ = residual_.norm();
  }

  void run(YamabeFlowResult& result);

 private:
  void start(IntrinsicTriangulation triangulation) {
    if (options_.metric == ConformalMetric::VertexScaling) {
      metric_ = std::make_unique<VertexScaling>(std::move(triangulation), options_.solver, execution_);
    } else {
      auto packing = std::make_unique<CirclePacking>(std::move(triangulation), options_.radii,
                                                     options_.solver, execution_);
      u_ = packing->logRadii();
      metric_ = std::move(packing);
    }
  }
  /// Evaluate at u; outer circles keep their curvature when they are frozen.
  void moveTo(const Eigen::VectorXd& u, bool freezeOuter = false) {
    metric_->moveTo(u);
    for (BoundaryCircle& circle : circles_) {
      if (freezeOuter && circle.outer()) continue;
      circle.update(metric_->triangulation(), u);
      circle.setCurvature(target_);
    }
    residual_ = target_ - metric_->curvature();
  }
  [[nodiscard]] double worst() const { return residual_.cwiseAbs().maxCoeff(); }

  [[nodiscard]] Eigen::VectorXd multiply(const Eigen::VectorXd& v, bool withOuter) const;
  [[nodiscard]] Eigen::VectorXd direction(bool withOuter) const;
  double takeStep();
  double takeRecordStep(const Eigen::VectorXd& delta);
  double takeDescentStep(const Eigen::VectorXd& delta, double before);
  int splitBoundary();
  bool atFloor();

  const YamabeFlowOptions& options_;
  const Execution& execution_;
  int originalVertices_;
  std::unique_ptr<MovingMetric> metric_;
  std::vector<BoundaryCircle> circles_;
  Eigen::VectorXd target_, u_, residual_, bestScale_;
  double record_ = 0;
  double best_ = 1e300;  // least max |K − K̄|, and the steps since
  int sinceBest_ = 0;
  int hindered_ = 0;           // faces that were no triangles on the way of the last step
  int hinderedSinceBest_ = 0;  // the most of one step
};

// (L − ∂K̄/∂u) v.
Eigen::VectorXd Flow::multiply(const Eigen::VectorXd& v, bool withOuter) const {
  Eigen::VectorXd product = metric_->multiply(v);
  for (const BoundaryCircle& circle : circles_) {
    if (withOuter || !circle.outer()) circle.addDerivative(v, -1, product);
  }
  return product;
}

// L δ = r, or conjugate gradients with L as preconditioner where K̄ depends on u. The derivatives of circles
// move only the lowest few modes of each loop: a handful of steps. Negative curvature ends it.
Eigen::VectorXd Flow::direction(bool withOuter) const {
  Eigen::VectorXd first = metric_->solve(residual_);
  first.array() -= first.mean();  // u keeps its sum of 0
  if (circles_.empty()) return first;
  Eigen::VectorXd x = Eigen::VectorXd::Zero(first.size()), r = residual_, z = first, p = z;
  double rz = r.dot(z);
  const double forcing = std::clamp(residual_.cwiseAbs().maxCoeff(), 1e-6, 1e-2),
               enough = forcing * forcing * rz;
  for (int k = 0; k < 60 && rz > enough; ++k) {
    const Eigen::VectorXd product = multiply(p, withOuter);
    const double bend = p.dot(product);
    if (!(bend > 1e-3 * rz)) break;
    x += rz / bend * p;
    r -= rz / bend * product;
    z = metric_->solve(r);
    z.array() -= z.mean();
    const double next = r.dot(z);
    p = z + next / rz * p;
    rz = next;
  }
  return x.isZero(0) ? first : x;
}

double longestStep(const Eigen::VectorXd& delta) {
  return std::min(1.0, kLongestChange / std::max(delta.maxCoeff() - delta.minCoeff(), 1e-300));
}

// The whole step when it brings ‖K − K̄‖ well below the least so far; 0 when not.
double Flow::takeRecordStep(const Eigen::VectorXd& delta) {
  if (longestStep(delta) < 1) return 0;
  moveTo(u_ + delta);
  const double norm = residual_.norm();
  if (!(norm <= kRecordFactor * record_) || metric_->degenerateFaces() > 0) return 0;
  record_ = norm;
  u_ += delta;
  return 1;
}

// Shorten the step until the energy still falls at its end: −δ·(K̄ − K) ≤ 0. With outer circles frozen the
// energy is a convex bound of the true one that touches it at u.
double Flow::takeDescentStep(const Eigen::VectorXd& delta, double before) {
  double step = longestStep(delta);
  hindered_ = 0;
  while (step > kSmallestStep) {
    moveTo(u_ + step * delta, true);
    const bool triangles = metric_->degenerateFaces() == 0;
    if (!triangles) hindered_ = metric_->degenerateFaces();
    const double slope = -delta.dot(residual_);
    if (slope <= 1e-4 * before && triangles) {
      u_ += step * delta;
      return step;
    }
    const double secant = slope > before ? step * before / (before - slope) : 0.5 * step;
    step = std::clamp(secant, 0.1 * step, triangles ? 0.9 * step : 0.5 * step);
  }
  return 0;
}

double Flow::takeStep() {
  metric_->settle(u_);
  metric_->factorize();
  const Eigen::VectorXd newton = direction(true);
  const Eigen::VectorXd residual = residual_;
  hindered_ = 0;
  if (takeRecordStep(newton) > 0) return 1;
  if (circles_.empty()) {
    residual_ = residual;
  } else {
    moveTo(u_);
  }
  const Eigen::VectorXd descent = circles_.empty() ? newton : direction(false);
  const double step = takeDescentStep(descent, -descent.dot(residual_));
  if (!circles_.empty() || step == 0) moveTo(u_);  // thaw the outer circle; go back
  return step;
}

// Split the boundary edges that see an angle above 100° at u. Returns how many there were.
int Flow::splitBoundary() {
  if (options_.metric != ConformalMetric::VertexScaling) return 0;
  constexpr double kCosine = -0.17364817766693;  // of 100°
  IntrinsicTriangulation triangulation = metric_->takeTriangulation();
  const int vertices = triangulation.vertexCount(), halfEdges = triangulation.halfEdgeCount();
  std::vector<int> tails;
  for (int h = 0; h < halfEdges; ++h) {
    if (triangulation.opposite(h) >= 0 || triangulation.oppositeCosine(h, u_) > kCosine) continue;
    if (!triangulation.shape(triangulation.face(h), u_).triangle) continue;
    const int tail = triangulation.tail(h);
    const double middle = 0.5 * (u_[tail] + u_[triangulation.head(h)]);
    tails.push_back(tail);
    triangulation.splitBoundaryEdge(h, u_);
    u_.conservativeResize(u_.size() + 1);
    u_[u_.size() - 1] = middle;
  }
  u_.array() -= u_.mean();
  target_.conservativeResize(u_.size());
  target_.tail(u_.size() - vertices).setZero();
  for (BoundaryCircle& circle : circles_) {
    std::vector<int> loop;
    for (const int v : circle.vertices()) {
      loop.push_back(v);
      const auto found = std::find(tails.begin(), tails.end(), v);
      if (found != tails.end()) loop.push_back(vertices + static_cast<int>(found - tails.begin()));
    }
    circle = BoundaryCircle(triangulation, loop, circle.outer());
  }
  start(std::move(triangulation));
  moveTo(u_);
  record_ = std::min(record_, residual_.norm());
  return static_cast<int>(tails.size());
}

// Rounding in u and λ, magnified by the cotangents of needles, is a floor under the residual: there steps go
// nowhere.
bool Flow::atFloor() {
  if (worst() < 0.9 * best_) {
    best_ = worst();
    bestScale_ = u_;
    sinceBest_ = 0;
    hinderedSinceBest_ = 0;
    return false;
  }
  return ++sinceBest_ > (best_ < 1e-2 ? 15 : 60);
}

void Flow::run(YamabeFlowResult& result) {
  for (;; ++result.iterations) {
    if (worst() <= options_.tolerance) result.status = Status::Converged;
    if (execution_.cancelled()) result.status = Status::Cancelled;
    if (result.status == Status::NotRun && result.iterations >= options_.maxIterations) {
      result.status = Status::NotConverged;
    }
    if (result.status == Status::NotRun && atFloor()) result.status = Status::Stalled;
    if (result.status != Status::NotRun) break;
    execution_.report(std::min(0.9, 0.1 * result.iterations), "curvature flow");
    YamabeIteration iteration{worst(), 0, metric_->flips()};
    iteration.step = takeStep();
    hinderedSinceBest_ = std::max(hinderedSinceBest_, hindered_);
    iteration.flips = metric_->flips() - iteration.flips;
    result.flips += iteration.flips;
    result.history.push_back(iteration);
    if (iteration.step > 0 && hindered_ == 0) continue;
    if (splitBoundary() == 0 && iteration.step == 0) {
      result.status = Status::Stalled;
      break;
    }
  }
  if (result.status == Status::Stalled && bestScale_.size() == u_.size()) {
    u_ = bestScale_;
    moveTo(u_);
  }
  result.residual = worst();
  result.degenerateFaces = result.status == Status::Stalled ? hinderedSinceBest_ : 0;
  result.addedVertices = static_cast<int>(u_.size()) - originalVertices_;
  result.curvature = metric_->curvature();
  result.target = target_;
  result.logScale = u_;
  result.triangulation = metric_->takeTriangulation();
}

}  // namespace

void YamabeFlowOptions::validate() const {
  if (!(tolerance > 0)) {
    throw InvalidArgument("A positive tolerance is required, but it is " + std::to_string(tolerance) + ".");
  }
  if (maxIterations < 0) {
    throw InvalidArgument("A non-negative number of iterations is required, but it is " +
                          std::to_string(maxIterations) + ".");
  }
  if (!SparseSolver::available(solver)) {
    throw InvalidArgument("A solver that is part of this build is required, but " +
                          std::string(solverBackendName(solver)) + " was not built in.");
  }
}

const char* conformalMetricName(ConformalMetric metric) noexcept {
  return metric == ConformalMetric::VertexScaling ? "vertex-scaling" : "circle-packing";
}

const char* packingRadiiName(PackingRadii radii) noexcept {
  return radii == PackingRadii::Tangent ? "tangent" : "circumradius";
}

Eigen::VectorXd vertexCurvature(const IntrinsicTriangulation& triangulation, const Eigen::VectorXd& u) {
  Eigen::VectorXd curvature = Eigen::VectorXd::Zero(triangulation.vertexCount());
  std::vector<char> used(static_cast<std::size_t>(triangulation.vertexCount()), 0);
  for (int f = 0; f < triangulation.faceCount(); ++f) {
    const FaceShape shape = triangulation.shape(f, u);
    int h = triangulation.first(f);
    for (int k = 0; k < 3; ++k, h = triangulation.next(h)) {
      const int apex = triangulation.tail(triangulation.previous(h));
      curvature[apex] -= shape.angle[k];
      used[static_cast<std::size_t>(apex)] = 1;
    }
  }
  for (int v = 0; v < triangulation.vertexCount(); ++v) {
    if (!used[static_cast<std::size_t>(v)]) continue;
    curvature[v] += triangulation.onBoundary()[static_cast<std::size_t>(v)] ? M_PI : 2 * M_PI;
  }
  return curvature;
}

YamabeFlowResult yamabeFlow(IntrinsicTriangulation triangulation, const Eigen::VectorXd& target,
                            std::vector<BoundaryCircle> circles, const YamabeFlowOptions& options,
                            const Execution& execution) {
  options.validate();
  const auto start = std::chrono::steady_clock::now();
  Eigen::VectorXd asked = target;
  for (const BoundaryCircle& circle : circles) circle.setCurvature(asked);
  requireAdmissible(triangulation, asked);
  YamabeFlowResult result;
  result.initialFlips =
      triangulation.makeDelaunay(Eigen::VectorXd::Zero(target.size()), FlipRule::Euclidean, execution);
  Flow flow(std::move(triangulation), asked, std::move(circles), options, execution);
  flow.run(result);
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  execution.report(1, "curvature flow");
  return result;
}

}  // namespace authalic
