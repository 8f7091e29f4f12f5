/// @file
/// Outlines of cells cut by lines, and their moments of a linear density. Private to transport/.
#pragma once

#include <vector>

#include "Core/transport/ConvexRegion.h"
#include "Core/transport/PiecewiseLinearDensity.h"

namespace authalic {

/// What cuts have left of an outline, and where its sides come from.
struct ClippedOutline : CellOutline {
  std::vector<int> origins;  ///< side of the outline at first; −1 − tag along a cut

  void clear() { CellOutline::clear(), origins.clear(); }
  void add(const Eigen::Vector2d& corner, double sweep, int origin) {
    CellOutline::add(corner, sweep), origins.push_back(origin);
  }
};

/// The outline itself, arcs of more than a quarter of the circle in parts.
void uncut(const CellOutline& outline, ClippedOutline& result);

/// The part of an outline in a half-plane. The same line from its other side gives the same corners.
/// @return false, and an empty part, when there is nothing inside it
bool clip(const ClippedOutline& whole, const HalfPlane& half, int tag, ClippedOutline& part);

/// ∫ ρ, ∫ ρ x and ∫ ρ |x − y|². Exact to rounding: triangles, and Green's theorem for the arcs. O(k).
[[nodiscard]] CellMoments momentsOf(const CellOutline& outline, const LinearFunction& density,
                                    const Eigen::Vector2d& site);

/// The least value of a linear function on an outline and where it is, arcs included.
struct Least {
  double value;
  Eigen::Vector2d place;
};
[[nodiscard]] Least leastOf(const LinearFunction& function, const CellOutline& outline);

}  // namespace authalic
