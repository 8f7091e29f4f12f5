/// @file
/// Curvature and its derivative at scale factors u: what every Newton step of the flow needs. Private to conformal/.
#pragma once

#include <array>
#include <memory>
#include <utility>
#include <vector>

#include "Core/base/Execution.h"
#include "Core/geometry/IntrinsicTriangulation.h"
#include "Core/numerics/ElementAssembly.h"
#include "Core/numerics/SparseSolver.h"

namespace authalic {

/// A triangulation whose lengths move with u, with the factorised derivative L = ∂K/∂u of where it was last asked
/// for.
///
/// The lengths at u are those of triangulation().logLength(h, u). A rule of change (vertex scaling, circle packing)
/// says how to get there and what each half-edge weighs: L_ij = −(w_h + w_opposite(h)).
class MovingMetric {
 public:
  MovingMetric(IntrinsicTriangulation triangulation, SolverBackend backend, const Execution& execution);
  virtual ~MovingMetric() = default;
  MovingMetric(const MovingMetric&) = delete;
  MovingMetric& operator=(const MovingMetric&) = delete;

  /// Move to u and take angles. A trial: may be followed by another.
  void moveTo(const Eigen::VectorXd& u);
  /// Tell the metric that it will go on from here.
  virtual void settle(const Eigen::VectorXd& /*u*/) {}

  [[nodiscard]] const Eigen::VectorXd& curvature() const noexcept { return curvature_; }
  [[nodiscard]] const IntrinsicTriangulation& triangulation() const noexcept { return triangulation_; }
  [[nodiscard]] IntrinsicTriangulation takeTriangulation() { return std::move(triangulation_); }
  /// Faces whose lengths are no sides of a triangle.
  [[nodiscard]] int degenerateFaces() const noexcept { return degenerateFaces_; }
  [[nodiscard]] int flips() const noexcept { return flips_; }

  /// Factorise L here, with one vertex held. @throws SolverError when L is not semi-definite
  void factorize();
  /// L⁻¹ b with x = 0 at the held vertex; b with Σ b = 0.
  [[nodiscard]] Eigen::VectorXd solve(const Eigen::VectorXd& b) const;
  /// L x for the L that was factorised last.
  [[nodiscard]] Eigen::VectorXd multiply(const Eigen::VectorXd& x) const;

 protected:
  /// Set the lengths at u; flip what the rule flips on the way.
  virtual void changeLengths(const Eigen::VectorXd& u) = 0;
  /// Weights of a face's half-edges in the order first, next, previous.
  [[nodiscard]] virtual std::array<double, 3> weights(int face, const FaceShape& shape, const Eigen::VectorXd& u) const = 0;

  IntrinsicTriangulation triangulation_;
  const Execution& execution_;
  int flips_ = 0;

 private:
  void sumCurvature();
  void findPattern();

  Eigen::VectorXd curvature_;
  std::vector<double> angles_, weights_;  // per half-edge: the angle opposite to it, its part of L
  std::vector<char> triangle_;            // per face
  int degenerateFaces_ = 0, flipsOfPattern_ = -1;
  std::vector<int> unknown_;  // per vertex, negative = held or without face
  std::vector<int> edges_;    // one half-edge per edge, as of the last factorisation
  std::vector<std::array<int, 2>> ends_;
  std::vector<double> elements_;
  std::unique_ptr<ElementAssembly> assembly_;
  SparseSolver solver_;
};

/// l_ij e^{(u_i + u_j)/2}, Delaunay by Ptolemy flips wherever it goes; w = ½ cot of the opposite angle @cite luo2004.
class VertexScaling final : public MovingMetric {
 public:
  using MovingMetric::MovingMetric;

 private:
  void changeLengths(const Eigen::VectorXd& u) override;
  [[nodiscard]] std::array<double, 3> weights(int face, const FaceShape& shape, const Eigen::VectorXd& u) const override;
};

}  // namespace authalic
