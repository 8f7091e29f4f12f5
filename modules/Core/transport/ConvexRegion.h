/// @file
/// The exact unit disk or a convex polygon, as cells of a power diagram meet it. Private to transport/.
#pragma once

#include <Eigen/Core>

#include <vector>

#include "Core/geometry/PlanarDomain.h"

namespace authalic {

/// A closed convex curve of straight sides and arcs of the unit circle, counter-clockwise.
struct CellOutline {
  std::vector<Eigen::Vector2d> corners;
  std::vector<double> sweeps;  ///< angle of the arc from corner k to corner k+1; 0 for a straight side

  void clear() { corners.clear(), sweeps.clear(); }
  void add(const Eigen::Vector2d& corner, double sweep = 0) { corners.push_back(corner), sweeps.push_back(sweep); }
};

/// Moments of a region.
struct CellMoments {
  double area = 0;
  Eigen::Vector2d first = Eigen::Vector2d::Zero();  ///< ∫ x
  double cost = 0;                                  ///< ∫ |x − y|² about a given y
};

/// Exact to rounding: triangles for the polygon, Green's theorem for the arcs. O(k).
[[nodiscard]] CellMoments momentsOf(const CellOutline& outline, const Eigen::Vector2d& site);

class ConvexRegion {
 public:
  /// @throws InvalidArgument when the polygon is not convex
  explicit ConvexRegion(const PlanarDomain& domain);

  [[nodiscard]] bool contains(const Eigen::Vector2d& p) const;

  /// The part of a line inside: parameters low ≤ high along `direction` from `foot`; low > high when there is none.
  struct Interval {
    double low, high;
  };
  [[nodiscard]] Interval along(const Eigen::Vector2d& foot, const Eigen::Vector2d& direction) const;

  /// Adds the boundary from a to b, both on it: a arc from a, or a and the corners between; b itself is not added.
  /// @param whole  a and b bound all of the region but a sliver when they are close (one chord only)
  void addBoundary(const Eigen::Vector2d& a, const Eigen::Vector2d& b, bool whole, CellOutline& outline) const;

  /// The whole region.
  [[nodiscard]] CellOutline outline() const;

 private:
  [[nodiscard]] double parameter(const Eigen::Vector2d& p) const;

  Points2 corners_;
  std::vector<double> arc_;  // length of the boundary up to each corner; one more entry for the whole
};

}  // namespace authalic
