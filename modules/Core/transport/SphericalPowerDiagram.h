/// @file
/// Power diagrams of weighted sites on the unit sphere: cells bounded by great circles.
#pragma once

#include <Eigen/Core>

#include <array>
#include <vector>

#include "Core/base/Arrays.h"
#include "Core/base/Execution.h"
#include "Core/transport/PowerDiagram.h"

namespace authalic {

/// What two cells have in common.
struct SphericalPowerEdge {
  int first, second;  ///< sites, first < second
  double length;      ///< of their common arc, radians, > 0
  double rate;        ///< −∂w_first/∂h_second = ∫ over the arc of ⟨x, Y_first⟩ / |Y_first − Y_second|
};

/// The cells of one set of heights.
struct SphericalPowerCells {
  Eigen::VectorXd areas;  ///< n solid angles; sum to 4π
  Points3 centroids;      ///< n×3 unit vectors along ∫ x over the cell; the site itself where the cell is empty
  std::vector<SphericalPowerEdge> edges;
  int emptyCells = 0;
  bool surrounded = false;  ///< 0 lies inside the hull of the Y_i: every point of a cell is within 90° of its site
};

/// The outlines of all cells: cell i runs counter-clockwise, seen from outside, through the rows starts[i] …
/// starts[i + 1] − 1 of corners.
struct SphericalCellPolygons {
  Points3 corners;          ///< unit vectors
  std::vector<int> starts;  ///< n + 1
};

/// Cells W_i = { x ∈ S² : ⟨x, Y_i⟩ ≥ ⟨x, Y_j⟩ for all j }, Y_i = e^{h_i} y_i, of sites y on the unit sphere with
/// heights h: the outward normals of the convex hull of the Y_i at its vertex Y_i. They are the cells of the cost
/// −ln cos d(x, y_i) − h_i @cite sugihara2002 @cite oliker2007; for h = 0 Voronoi's.
///
/// The hull is found as a regular triangulation of the plane: a projective map sends one of its vertices to infinity.
/// Every cell corner is computed once for all its cells: areas sum to 4π up to rounding.
/// Complexity: O(n log n) for the hull (exact predicates, one thread), O(n) for the cells (all threads).
class SphericalPowerDiagram {
 public:
  /// @param sites  n×3 unit vectors, n ≥ 4, no two in one place
  /// @throws GeometryError when there are fewer than 4, one is not on the sphere, or two coincide (they are named)
  /// @throws InvalidArgument when this build has no CGAL
  explicit SphericalPowerDiagram(Points3 sites);

  /// The cells of new heights. @throws GeometryError when there are not n finite ones.
  const SphericalPowerCells& compute(const Heights& heights, const Execution& execution = {});

  /// Of the last heights.
  [[nodiscard]] const SphericalPowerCells& cells() const noexcept { return cells_; }

  /// Σ_i ∫_{W_i} −ln cos d(x, y_i), by quadrature (the middles of the sides of each of the triangles of a cell):
  /// O(size of cells⁴) of itself off. Only where the sites are surrounded.
  [[nodiscard]] double transportCost() const;

  /// The outlines of the last heights; no corner where a cell is empty.
  /// @param arcStep  arcs get a corner at least every so many radians, > 0
  [[nodiscard]] SphericalCellPolygons polygons(double arcStep = 0.05) const;

  [[nodiscard]] const Points3& sites() const noexcept { return sites_; }

 private:
  void triangulate();
  void placeCorners(const Execution& execution);
  void addCell(int site, std::vector<SphericalPowerEdge>& edges);
  template <class Visit>
  void visitCorners(int site, const Visit& visit) const;

  Points3 sites_;
  Heights heights_;
  std::vector<std::array<int, 3>> faces_, neighbours_;  // of the hull, counter-clockwise seen from outside
  std::vector<int> faceOf_;                             // per site, −1 when hidden
  std::vector<Eigen::Vector3d> corners_;                // per face: its outward normal
  SphericalPowerCells cells_;
};

}  // namespace authalic
