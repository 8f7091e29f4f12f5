/// @file
/// How the boundary of a planar domain lets its vertices move. Private to authalic/.
#pragma once

#include <vector>

#include "Core/initial/BoundaryPlacement.h"

namespace authalic {

/// Boundary vertices slide along the circle or their side; corners stay; the vertices of a pocket ride on its chord.
class SlidingBoundary {
 public:
  SlidingBoundary(const BoundaryPlacement& placement, const PlanarDomain& domain, const Points2& image);

  /// Directions a vertex may move in: 2 = anywhere, 1 = along tangent(), 0 = fixed.
  [[nodiscard]] int freedom(int vertex) const { return freedom_[static_cast<std::size_t>(vertex)]; }

  [[nodiscard]] bool onCircle() const noexcept { return circle_; }

  /// Unit vector along the boundary at a vertex with freedom 1.
  [[nodiscard]] Eigen::RowVector2d tangent(const Points2& image, int vertex) const;

  /// Remove from the velocities (n×2) what would leave the boundary.
  void keepTangential(const Points2& image, Points2& velocities) const;

  /// Put circle vertices back on the unit circle.
  void retract(Points2& image) const;

  /// Put pocket vertices where their chord has carried them (similarity of the chord).
  void carryPockets(Points2& image) const;

 private:
  struct Rider {
    int vertex, from, to;
    double along, across;
  };
  void attachPockets(const BoundaryPlacement& placement, const Points2& image);

  std::vector<char> freedom_;
  std::vector<int> sliders_;               // vertices with freedom 1
  std::vector<int> fixed_;                 // vertices with freedom 0
  std::vector<Eigen::RowVector2d> along_;  // per vertex that slides on a straight side, zero elsewhere
  std::vector<Rider> riders_;
  bool circle_;
};

}  // namespace authalic
