/// @file
/// Circle packings of given inversive distances: the metric of Ricci flow. Private to conformal/.
#pragma once

#include <vector>

#include "Core/conformal/MovingMetric.h"
#include "Core/conformal/YamabeFlow.h"

namespace authalic {

/// l_ij² = γ_i² + γ_j² + 2 I_ij γ_i γ_j with radii γ = e^u and inversive distances I that stay @cite bowers2004
/// @cite su2016.
///
/// I follows from the lengths and the first radii: the cosine of the angle of the circles where they meet, above 1
/// where they do not. w_h = (distance of the face's power centre from the edge) / l_ij, signed.
/// Edges are flipped by the Euclidean rule to the power-Delaunay triangulation wherever the flow settles, so that w
/// ≥ 0; between, triangles may degenerate.
class CirclePacking final : public MovingMetric {
 public:
  CirclePacking(IntrinsicTriangulation triangulation, PackingRadii radii, SolverBackend backend,
                const Execution& execution);

  /// u = ln γ at the start.
  [[nodiscard]] const Eigen::VectorXd& logRadii() const noexcept { return logRadii_; }
  void settle(const Eigen::VectorXd& u) override;

 private:
  void changeLengths(const Eigen::VectorXd& u) override;
  [[nodiscard]] std::array<double, 3> weights(int face, const FaceShape& shape, const Eigen::VectorXd& u) const override;
  void chooseRadii(PackingRadii radii);
  [[nodiscard]] double weightOf(int h, const Eigen::VectorXd& u) const;
  void takeInversiveDistance(int h, const Eigen::VectorXd& u);
  [[nodiscard]] bool convex(int h, const Eigen::VectorXd& u) const;

  Eigen::VectorXd logRadii_;
  std::vector<double> inversive_;  // per half-edge
};

}  // namespace authalic
