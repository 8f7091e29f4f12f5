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

/// A triangulation kept Delaunay at a moving u, with the factorised stiffness of where it was last asked for.
class ScaledMetric {
 public:
  ScaledMetric(IntrinsicTriangulation triangulation, SolverBackend backend, const Execution& execution);

  /// Move to u: flip to Delaunay, take angles.
  void moveTo(const Eigen::VectorXd& u);
  [[nodiscard]] const Eigen::VectorXd& curvature() const noexcept { return curvature_; }
  [[nodiscard]] const IntrinsicTriangulation& triangulation() const noexcept { return triangulation_; }
  [[nodiscard]] IntrinsicTriangulation takeTriangulation() { return std::move(triangulation_); }
  [[nodiscard]] int degenerateFaces() const noexcept { return degenerateFaces_; }
  [[nodiscard]] int flips() const noexcept { return flips_; }

  /// Factorise L, the cotangent stiffness here, with one vertex held.
  void factorize();
  /// L⁻¹ b with x = 0 at the held vertex; b with Σ b = 0.
  [[nodiscard]] Eigen::VectorXd solve(const Eigen::VectorXd& b) const;
  /// L x for the L that was factorised last.
  [[nodiscard]] Eigen::VectorXd multiply(const Eigen::VectorXd& x) const;

 private:
  void sumCurvature();
  void findPattern();

  IntrinsicTriangulation triangulation_;
  const Execution* execution_;
  Eigen::VectorXd curvature_;
  std::vector<double> angles_, cotangents_;  // per half-edge, of the angle opposite to it
  int degenerateFaces_ = 0, flips_ = 0, flipsOfPattern_ = -1;
  std::vector<int> unknown_;  // per vertex, −1 = held or without face
  std::vector<int> edges_;    // one half-edge per edge, as of the last factorisation
  std::vector<std::array<int, 2>> ends_;
  std::vector<double> elements_;
  std::unique_ptr<ElementAssembly> assembly_;
  SparseSolver solver_;
};

}  // namespace authalic
