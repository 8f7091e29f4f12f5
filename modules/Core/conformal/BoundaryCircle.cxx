#include "Core/conformal/BoundaryCircle.h"

#include <cmath>

namespace authalic {
namespace {

// Half arcs for 2R = longest / x, x in (0, 1].
Eigen::VectorXd halfArcsAt(const Eigen::VectorXd& relative, Eigen::Index longest, bool centreInside, double x) {
  Eigen::VectorXd arcs = (relative * x).array().min(1.0).asin();
  if (!centreInside) arcs[longest] = M_PI - arcs[longest];
  return arcs;
}

}  // namespace

InscribedPolygon inscribe(const Eigen::VectorXd& sides) {
  Eigen::Index longest = 0;
  const double most = sides.maxCoeff(&longest);
  const Eigen::VectorXd relative = sides / most;
  InscribedPolygon polygon;
  if (relative.sum() <= 2) {
    polygon.halfArcs = M_PI * sides / sides.sum();
    polygon.radius = sides.sum() / (2 * M_PI);
    return polygon;
  }
  const bool centreInside = halfArcsAt(relative, longest, true, 1).sum() >= M_PI;
  // Inside, the sum of arcs grows with x; outside, it starts above π and falls below it.
  double low = 0, high = 1;
  for (int halving = 0; halving < 200; ++halving) {
    const double x = 0.5 * (low + high);
    if (x == low || x == high) break;
    const double excess = halfArcsAt(relative, longest, centreInside, x).sum() - M_PI;
    ((excess < 0) == centreInside ? low : high) = x;
  }
  polygon.halfArcs = halfArcsAt(relative, longest, centreInside, high);
  polygon.radius = most / (2 * high);
  return polygon;
}

BoundaryCircle::BoundaryCircle(const IntrinsicTriangulation& triangulation, const std::vector<int>& loop, bool outer)
    : outer_(outer), vertices_(loop) {
  std::vector<int> leaving(static_cast<std::size_t>(triangulation.vertexCount()), -1);
  for (int h = 0; h < triangulation.halfEdgeCount(); ++h) {
    if (triangulation.opposite(h) < 0) leaving[static_cast<std::size_t>(triangulation.tail(h))] = h;
  }
  for (const int v : vertices_) halfEdges_.push_back(leaving[static_cast<std::size_t>(v)]);
  update(triangulation, Eigen::VectorXd::Zero(triangulation.vertexCount()));
}

void BoundaryCircle::update(const IntrinsicTriangulation& triangulation, const Eigen::VectorXd& u) {
  Eigen::VectorXd logs(static_cast<Eigen::Index>(halfEdges_.size()));
  for (std::size_t k = 0; k < halfEdges_.size(); ++k) {
    logs[static_cast<Eigen::Index>(k)] = triangulation.logLength(halfEdges_[k], u);
  }
  halfArcs_ = inscribe((logs.array() - logs.maxCoeff()).exp().matrix()).halfArcs;
  tangents_ = halfArcs_.array().tan();
}

void BoundaryCircle::setCurvature(Eigen::VectorXd& target) const {
  const double sign = outer_ ? 1 : -1;
  for (const int v : vertices_) target[v] = 0;
  for (std::size_t k = 0; k < vertices_.size(); ++k) {
    const double arc = sign * halfArcs_[static_cast<Eigen::Index>(k)];
    target[vertices_[k]] += arc;
    target[vertices_[(k + 1) % vertices_.size()]] += arc;
  }
}

void BoundaryCircle::addDerivative(const Eigen::VectorXd& v, double factor, Eigen::VectorXd& result) const {
  const double sign = outer_ ? factor : -factor;
  const std::size_t count = vertices_.size();
  Eigen::VectorXd means(static_cast<Eigen::Index>(count));  // dln l_e
  for (std::size_t k = 0; k < count; ++k) {
    means[static_cast<Eigen::Index>(k)] = 0.5 * (v[vertices_[k]] + v[vertices_[(k + 1) % count]]);
  }
  const double dlnRadius = tangents_.dot(means) / tangents_.sum();
  for (std::size_t k = 0; k < count; ++k) {
    const auto e = static_cast<Eigen::Index>(k);
    const double change = sign * tangents_[e] * (means[e] - dlnRadius);
    result[vertices_[k]] += change;
    result[vertices_[(k + 1) % count]] += change;
  }
}

}  // namespace authalic
