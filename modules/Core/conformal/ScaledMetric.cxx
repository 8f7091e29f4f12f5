#include "Core/conformal/ScaledMetric.h"

#include <array>
#include <cmath>
#include <utility>

namespace authalic {

ScaledMetric::ScaledMetric(IntrinsicTriangulation triangulation, SolverBackend backend, const Execution& execution)
    : triangulation_(std::move(triangulation)),
      execution_(&execution),
      angles_(static_cast<std::size_t>(triangulation_.halfEdgeCount()), 0.0),
      cotangents_(angles_),
      unknown_(static_cast<std::size_t>(triangulation_.vertexCount()), -1),
      solver_(backend) {
  for (int h = 0; h < triangulation_.halfEdgeCount(); ++h) unknown_[static_cast<std::size_t>(triangulation_.tail(h))] = 0;
  int next = -1;  // the first vertex with a face is held
  for (int& id : unknown_) {
    if (id == 0) id = next++;
  }
}

void ScaledMetric::moveTo(const Eigen::VectorXd& u) {
  flips_ += triangulation_.makeDelaunay(u, FlipRule::Ptolemy, *execution_);
  const auto faces = static_cast<std::size_t>(triangulation_.faceCount());
  parallelFor(faces, *execution_, [&](std::size_t begin, std::size_t end) {
    for (std::size_t f = begin; f < end; ++f) {
      const FaceShape shape = triangulation_.shape(static_cast<int>(f), u);
      int h = triangulation_.first(static_cast<int>(f));
      for (int k = 0; k < 3; ++k, h = triangulation_.next(h)) {
        angles_[static_cast<std::size_t>(h)] = shape.angle[k];
        cotangents_[static_cast<std::size_t>(h)] = shape.triangle ? shape.cotangent[k] : NAN;
      }
    }
  });
  sumCurvature();
}

void ScaledMetric::sumCurvature() {
  const int n = triangulation_.vertexCount();
  curvature_.resize(n);
  for (int v = 0; v < n; ++v) curvature_[v] = triangulation_.onBoundary()[static_cast<std::size_t>(v)] ? M_PI : 2 * M_PI;
  degenerateFaces_ = 0;
  std::vector<char> used(static_cast<std::size_t>(n), 0);
  for (int f = 0; f < triangulation_.faceCount(); ++f) {
    const int h0 = triangulation_.first(f), h1 = triangulation_.next(h0), h2 = triangulation_.next(h1);
    for (const auto& [edge, apex] : {std::pair{h0, h2}, std::pair{h1, h0}, std::pair{h2, h1}}) {
      curvature_[triangulation_.tail(apex)] -= angles_[static_cast<std::size_t>(edge)];
      used[static_cast<std::size_t>(triangulation_.tail(apex))] = 1;
    }
    if (std::isnan(cotangents_[static_cast<std::size_t>(h0)])) {
      ++degenerateFaces_;
      for (const int h : {h0, h1, h2}) cotangents_[static_cast<std::size_t>(h)] = 0;
    }
  }
  for (int v = 0; v < n; ++v) {
    if (!used[static_cast<std::size_t>(v)]) curvature_[v] = 0;
  }
}

void ScaledMetric::findPattern() {
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

void ScaledMetric::factorize() {
  findPattern();
  elements_.resize(3 * edges_.size());
  for (std::size_t e = 0; e < edges_.size(); ++e) {
    const int g = triangulation_.opposite(edges_[e]);
    const double weight =
        0.5 * (cotangents_[static_cast<std::size_t>(edges_[e])] + (g < 0 ? 0 : cotangents_[static_cast<std::size_t>(g)]));
    elements_[3 * e] = elements_[3 * e + 2] = weight;
    elements_[3 * e + 1] = -weight;
  }
  assembly_->assemble(elements_);
  solver_.factorize(assembly_->matrix());
}

Eigen::VectorXd ScaledMetric::solve(const Eigen::VectorXd& b) const {
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

Eigen::VectorXd ScaledMetric::multiply(const Eigen::VectorXd& x) const {
  Eigen::VectorXd result = Eigen::VectorXd::Zero(x.size());
  for (std::size_t e = 0; e < edges_.size(); ++e) {
    const auto [i, j] = ends_[e];
    const double flow = elements_[3 * e] * (x[i] - x[j]);
    result[i] += flow;
    result[j] -= flow;
  }
  return result;
}

}  // namespace authalic
