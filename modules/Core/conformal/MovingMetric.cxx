#include "Core/conformal/MovingMetric.h"

#include <algorithm>
#include <cmath>

#include "Core/base/Error.h"

namespace authalic {
namespace {

constexpr int kHeld = -1, kNoFace = -2;
constexpr double kLeastWeight = 1e-3, kMostWeight = 1e9;  // in place of negative and boundless ones

}  // namespace

MovingMetric::MovingMetric(IntrinsicTriangulation triangulation, SolverBackend backend, const Execution& execution)
    : triangulation_(std::move(triangulation)),
      execution_(execution),
      angles_(static_cast<std::size_t>(triangulation_.halfEdgeCount()), 0.0),
      weights_(angles_),
      triangle_(static_cast<std::size_t>(triangulation_.faceCount()), 1),
      unknown_(static_cast<std::size_t>(triangulation_.vertexCount()), kNoFace),
      solver_(backend) {
  for (int h = 0; h < triangulation_.halfEdgeCount(); ++h) unknown_[static_cast<std::size_t>(triangulation_.tail(h))] = 0;
  int next = kHeld;  // the first vertex with a face
  for (int& id : unknown_) {
    if (id == 0) id = next++;
  }
}

void MovingMetric::moveTo(const Eigen::VectorXd& u) {
  changeLengths(u);
  parallelFor(triangle_.size(), execution_, [&](std::size_t begin, std::size_t end) {
    for (std::size_t f = begin; f < end; ++f) {
      const int face = static_cast<int>(f);
      const FaceShape shape = triangulation_.shape(face, u);
      const std::array<double, 3> weight = shape.triangle ? weights(face, shape, u) : std::array<double, 3>{};
      triangle_[f] = shape.triangle;
      int h = triangulation_.first(face);
      for (std::size_t k = 0; k < 3; ++k, h = triangulation_.next(h)) {
        angles_[static_cast<std::size_t>(h)] = shape.angle[k];
        weights_[static_cast<std::size_t>(h)] = weight[k];
      }
    }
  });
  degenerateFaces_ = static_cast<int>(std::count(triangle_.begin(), triangle_.end(), 0));
  sumCurvature();
}

void MovingMetric::sumCurvature() {
  const int n = triangulation_.vertexCount();
  curvature_.resize(n);
  for (int v = 0; v < n; ++v) curvature_[v] = triangulation_.onBoundary()[static_cast<std::size_t>(v)] ? M_PI : 2 * M_PI;
  for (int f = 0; f < triangulation_.faceCount(); ++f) {
    const int h0 = triangulation_.first(f), h1 = triangulation_.next(h0), h2 = triangulation_.next(h1);
    curvature_[triangulation_.tail(h2)] -= angles_[static_cast<std::size_t>(h0)];
    curvature_[triangulation_.tail(h0)] -= angles_[static_cast<std::size_t>(h1)];
    curvature_[triangulation_.tail(h1)] -= angles_[static_cast<std::size_t>(h2)];
  }
  for (int v = 0; v < n; ++v) {
    if (unknown_[static_cast<std::size_t>(v)] == kNoFace) curvature_[v] = 0;
  }
}

void MovingMetric::findPattern() {
  if (flipsOfPattern_ == flips_) return;
  flipsOfPattern_ = flips_;
  edges_.clear();
  ends_.clear();
  for (int h = 0; h < triangulation_.halfEdgeCount(); ++h) {
    if (triangulation_.opposite(h) < h) edges_.push_back(h);
  }
  ElementAssembly::Unknowns ends(static_cast<Eigen::Index>(edges_.size()), 2);
  int unknowns = 0;
  for (const int id : unknown_) unknowns = std::max(unknowns, id + 1);
  for (std::size_t e = 0; e < edges_.size(); ++e) {
    const int i = triangulation_.tail(edges_[e]), j = triangulation_.head(edges_[e]);
    ends_.push_back({i, j});
    if (i == j) {  // an edge from a vertex to itself: no difference of u along it
      ends.row(static_cast<Eigen::Index>(e)) << -1, -1;
    } else {
      ends.row(static_cast<Eigen::Index>(e)) << unknown_[static_cast<std::size_t>(i)], unknown_[static_cast<std::size_t>(j)];
    }
  }
  assembly_ = std::make_unique<ElementAssembly>(unknowns, ends);
  solver_.analyze(assembly_->matrix());
}

void MovingMetric::factorize() {
  findPattern();
  elements_.resize(3 * edges_.size());
  for (std::size_t e = 0; e < edges_.size(); ++e) {
    const int g = triangulation_.opposite(edges_[e]);
    const double weight = weights_[static_cast<std::size_t>(edges_[e])] + (g < 0 ? 0 : weights_[static_cast<std::size_t>(g)]);
    elements_[3 * e] = elements_[3 * e + 2] = weight;
    elements_[3 * e + 1] = -weight;
  }
  try {
    solver_.factorize(assembly_->assemble(elements_));
  } catch (const SolverError&) {
    // Negative weights that no flip takes away: without them L is definite, and its directions still lead downhill.
    for (std::size_t e = 0; e < edges_.size(); ++e) {
      const double weight = elements_[3 * e] > kLeastWeight ? std::min(elements_[3 * e], kMostWeight) : kLeastWeight;
      elements_[3 * e] = elements_[3 * e + 2] = weight;
      elements_[3 * e + 1] = -weight;
    }
    solver_.factorize(assembly_->assemble(elements_));
  }
}

Eigen::VectorXd MovingMetric::solve(const Eigen::VectorXd& b) const {
  Eigen::VectorXd reduced(assembly_->matrix().rows()), x = Eigen::VectorXd::Zero(b.size());
  for (Eigen::Index v = 0; v < b.size(); ++v) {
    if (const int id = unknown_[static_cast<std::size_t>(v)]; id >= 0) reduced[id] = b[v];
  }
  const Eigen::VectorXd solution = solver_.solve(reduced);
  for (Eigen::Index v = 0; v < b.size(); ++v) {
    if (const int id = unknown_[static_cast<std::size_t>(v)]; id >= 0) x[v] = solution[id];
  }
  return x;
}

Eigen::VectorXd MovingMetric::multiply(const Eigen::VectorXd& x) const {
  Eigen::VectorXd result = Eigen::VectorXd::Zero(x.size());
  for (std::size_t e = 0; e < edges_.size(); ++e) {
    const auto [i, j] = ends_[e];
    const double flow = elements_[3 * e] * (x[i] - x[j]);
    result[i] += flow;
    result[j] -= flow;
  }
  return result;
}

void VertexScaling::changeLengths(const Eigen::VectorXd& u) {
  flips_ += triangulation_.makeDelaunay(u, FlipRule::Ptolemy, execution_);
}

std::array<double, 3> VertexScaling::weights(int /*face*/, const FaceShape& shape, const Eigen::VectorXd& /*u*/) const {
  return {0.5 * shape.cotangent[0], 0.5 * shape.cotangent[1], 0.5 * shape.cotangent[2]};
}

}  // namespace authalic
