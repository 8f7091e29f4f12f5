/// @file
/// Polygons inscribed in circles: what the boundary curvature of a circle domain must be.
#pragma once

#include <Eigen/Core>

#include <vector>

#include "Core/geometry/IntrinsicTriangulation.h"

namespace authalic {

/// The polygon with given sides that is inscribed in a circle.
struct InscribedPolygon {
  Eigen::VectorXd halfArcs;  ///< half the arc over each side, radians; their sum is π
  double radius = 0;         ///< of the circle, unit of the sides
};

/// Σ asin(l_e / 2R) = π solved for R; where one side is so long that the centre lies outside, its half arc is
/// π − asin(l/2R). Where no polygon has such sides (one is longer than the rest together) arcs are in proportion to
/// the sides. O(k) per step of a bisection to the last bit.
/// @param sides  k ≥ 3 positive lengths
[[nodiscard]] InscribedPolygon inscribe(const Eigen::VectorXd& sides);

/// A boundary loop that is to become a circle: as the outer loop of the flat domain or as a hole in it.
///
/// A vertex of an inscribed polygon turns by half the sum of the arcs beside it, K̄_i = ±(α_(i−) + α_(i+)) with
/// half arcs α; for short sides that is the rule "in proportion to the length of the edges" @cite su2016. The rule
/// is exact: where the flow converges the vertices lie on a circle. It depends on u through the sides l e^{(u_i +
/// u_j)/2}:
///   dα_e = tan α_e (dln l_e − dln R),
/// a symmetric matrix D, positive semi-definite while the centre lies inside.
class BoundaryCircle {
 public:
  /// @param loop  vertices of a boundary loop in order, as SurfaceTopology::boundaryLoops gives them
  BoundaryCircle(const IntrinsicTriangulation& triangulation, const std::vector<int>& loop, bool outer);

  /// Take over the sides at u.
  void update(const IntrinsicTriangulation& triangulation, const Eigen::VectorXd& u);
  /// Write K̄ of the last update at the vertices of the loop.
  void setCurvature(Eigen::VectorXd& target) const;
  /// result += factor · (∂K̄/∂u) v of the last update.
  void addDerivative(const Eigen::VectorXd& v, double factor, Eigen::VectorXd& result) const;
  [[nodiscard]] bool outer() const noexcept { return outer_; }
  /// Vertices of the loop in order.
  [[nodiscard]] const std::vector<int>& vertices() const noexcept { return vertices_; }

 private:
  bool outer_;
  std::vector<int> vertices_, halfEdges_;  // half-edge k runs from vertex k to vertex k+1
  Eigen::VectorXd halfArcs_, tangents_;
};

}  // namespace authalic
