#include "Core/conformal/CirclePacking.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>
#include <utility>

namespace authalic {

CirclePacking::CirclePacking(IntrinsicTriangulation triangulation, PackingRadii radii, SolverBackend backend,
                             const Execution& execution)
    : MovingMetric(std::move(triangulation), backend, execution),
      inversive_(static_cast<std::size_t>(triangulation_.halfEdgeCount()), 0.0) {
  chooseRadii(radii);
  // λ + (u_i + u_j)/2 is the length from now on.
  for (int h = 0; h < triangulation_.halfEdgeCount(); ++h) {
    if (triangulation_.opposite(h) > h) continue;
    const double share = 0.5 * (logRadii_[triangulation_.tail(h)] + logRadii_[triangulation_.head(h)]);
    triangulation_.setLogLength(h, triangulation_.logLength(h) - share);
    takeInversiveDistance(h, logRadii_);
  }
}

void CirclePacking::chooseRadii(PackingRadii radii) {
  const int n = triangulation_.vertexCount();
  const Eigen::VectorXd none = Eigen::VectorXd::Zero(n);
  logRadii_ = Eigen::VectorXd::Constant(n, std::numeric_limits<double>::infinity());
  for (int f = 0; f < triangulation_.faceCount(); ++f) {
    const FaceShape shape = triangulation_.shape(f, none);
    const int h = triangulation_.first(f), side[3] = {h, triangulation_.next(h), triangulation_.previous(h)};
    const double circumradius = triangulation_.logLength(h) - std::log(2 * std::sin(shape.angle[0]));
    for (int k = 0; k < 3; ++k) {
      const double beside = std::exp(triangulation_.logLength(side[k])),
                   before = std::exp(triangulation_.logLength(side[(k + 2) % 3])),
                   across = std::exp(triangulation_.logLength(side[(k + 1) % 3]));
      const double tangent = std::log(std::max(0.5 * (beside + before - across), 1e-3 * beside));
      double& least = logRadii_[triangulation_.tail(side[k])];
      least = std::min(least, radii == PackingRadii::Tangent ? tangent : circumradius);
    }
  }
  for (double& radius : logRadii_) {
    if (!std::isfinite(radius)) radius = 0;  // a vertex without a face
  }
}

void CirclePacking::takeInversiveDistance(int h, const Eigen::VectorXd& u) {
  // In units of √(γ_i γ_j): I = (l² − γ_i² − γ_j²) / (2 γ_i γ_j).
  const double ratio = u[triangulation_.tail(h)] - u[triangulation_.head(h)];
  const double distance = 0.5 * std::exp(2 * triangulation_.logLength(h)) - std::cosh(ratio);
  inversive_[static_cast<std::size_t>(h)] = distance;
  if (const int g = triangulation_.opposite(h); g >= 0) inversive_[static_cast<std::size_t>(g)] = distance;
}

void CirclePacking::changeLengths(const Eigen::VectorXd& u) {
  for (int h = 0; h < triangulation_.halfEdgeCount(); ++h) {
    if (triangulation_.opposite(h) > h) continue;
    const double ratio = u[triangulation_.tail(h)] - u[triangulation_.head(h)];
    const double squared = 2 * (std::cosh(ratio) + inversive_[static_cast<std::size_t>(h)]);
    triangulation_.setLogLength(h, 0.5 * std::log(std::max(squared, 1e-300)));
  }
}

// With d_ij = (l² + γ_i² − γ_j²)/2l, where the radical axis meets the edge, the power centre is at the height
// (d_ik − d_ij cos θ_i) / sin θ_i over it.
std::array<double, 3> CirclePacking::weights(int face, const FaceShape& shape, const Eigen::VectorXd& u) const {
  const int h0 = triangulation_.first(face), h1 = triangulation_.next(h0), h2 = triangulation_.next(h1);
  const int side[3] = {h0, h1, h2};
  double length[3], radius[3];
  for (int k = 0; k < 3; ++k) {
    length[k] = std::exp(triangulation_.logLength(side[k], u) - triangulation_.logLength(h0, u));
    radius[k] = std::exp(u[triangulation_.tail(side[k])] - triangulation_.logLength(h0, u));
  }
  std::array<double, 3> weight{};
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t next = (k + 1) % 3, last = (k + 2) % 3;  // corner k, edge k to corner next, edge `last` back to corner k
    const double angle = shape.angle[next], own = radius[k] * radius[k];
    const double along = (length[k] * length[k] + own - radius[next] * radius[next]) / (2 * length[k]),
                 other = (length[last] * length[last] + own - radius[last] * radius[last]) / (2 * length[last]);
    weight[k] = (other - along * std::cos(angle)) / (std::sin(angle) * length[k]);
  }
  return weight;
}

double CirclePacking::weightOf(int h, const Eigen::VectorXd& u) const {
  const int f = triangulation_.face(h);
  const FaceShape shape = triangulation_.shape(f, u);
  if (!shape.triangle) return 0;
  const auto weight = weights(f, shape, u);
  return h == triangulation_.first(f) ? weight[0] : h == triangulation_.next(triangulation_.first(f)) ? weight[1] : weight[2];
}

bool CirclePacking::convex(int h, const Eigen::VectorXd& u) const {
  const int g = triangulation_.opposite(h);
  const auto angleOpposite = [&](int half) {
    const FaceShape shape = triangulation_.shape(triangulation_.face(half), u);
    const int first = triangulation_.first(triangulation_.face(half));
    return shape.angle[half == first ? 0 : half == triangulation_.next(first) ? 1 : 2];
  };
  constexpr double kStraight = M_PI - 1e-6;
  return angleOpposite(triangulation_.next(h)) + angleOpposite(triangulation_.previous(g)) < kStraight &&
         angleOpposite(triangulation_.previous(h)) + angleOpposite(triangulation_.next(g)) < kStraight;
}

void CirclePacking::settle(const Eigen::VectorXd& u) {
  std::deque<int> queue;
  for (int h = 0; h < triangulation_.halfEdgeCount(); ++h) {
    if (triangulation_.opposite(h) > h) queue.push_back(h);
  }
  int left = 10 * triangulation_.halfEdgeCount();  // a bound on flips; rounding must not make them endless
  while (!queue.empty() && left > 0) {
    const int h = queue.front(), g = triangulation_.opposite(h);
    queue.pop_front();
    if (!triangulation_.flippable(h) || weightOf(h, u) + weightOf(g, u) >= -1e-10 || !convex(h, u)) continue;
    triangulation_.flip(h, u, FlipRule::Euclidean);
    takeInversiveDistance(h, u);
    ++flips_;
    --left;
    for (const int side : {triangulation_.next(h), triangulation_.previous(h), triangulation_.next(g), triangulation_.previous(g)}) {
      if (triangulation_.opposite(side) >= 0) queue.push_back(side);
    }
  }
  moveTo(u);
}

}  // namespace authalic
