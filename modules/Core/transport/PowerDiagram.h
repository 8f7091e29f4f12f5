/// @file
/// Power diagrams of weighted sites in the exact unit disk or a convex polygon.
#pragma once

#include <Eigen/Core>

#include <memory>
#include <vector>

#include "Core/base/Arrays.h"
#include "Core/base/Execution.h"
#include "Core/geometry/PlanarDomain.h"
#include "Core/transport/PiecewiseLinearDensity.h"

namespace authalic {

class DensityIntegrals;

/// One height per site. Extended precision: where sites crowd at distances d, a height that is off by ε moves sides
/// of cells by ε / d.
using Heights = Eigen::Matrix<long double, Eigen::Dynamic, 1>;

/// What two cells have in common.
struct PowerEdge {
  int first, second;  ///< sites, first < second
  double length;      ///< of their common side inside the domain, > 0
  double mass;        ///< ∫ ρ ds over it; the length when the source is uniform
};

/// The cells of one set of heights.
struct PowerCells {
  Eigen::VectorXd areas;   ///< n; sum to the area of the domain
  Eigen::VectorXd masses;  ///< n; ∫ ρ over the cell: its area when the source is uniform
  Points2 centroids;       ///< n×2; of ρ over the cell; the site itself where the cell is empty
  Eigen::VectorXd costs;   ///< n; ∫ |x − y_i|² ρ over the cell
  std::vector<PowerEdge> edges;
  int emptyCells = 0;
};

/// The outlines of all cells: cell i runs counter-clockwise through the rows starts[i] … starts[i + 1] − 1 of corners.
struct CellPolygons {
  Points2 corners;
  std::vector<int> starts;  ///< n + 1
};

/// Cells W_i = { x in Ω : ⟨x, y_i⟩ + h_i ≥ ⟨x, y_j⟩ + h_j for all j } of sites y with heights h: where the convex
/// function u(x) = max_i ⟨x, y_i⟩ + h_i has the gradient y_i. They are the power cells of weights |y_i|² + 2 h_i; for
/// h_i = −|y_i|² / 2 Voronoi's @cite aurenhammer1987.
///
/// Arcs of the disk are exact (Green's theorem), and every cell corner is computed once for all its cells: areas sum
/// to that of Ω up to rounding. Cells without any point are allowed and counted.
///
/// Masses, centroids and costs are those of the uniform measure, ρ = 1, or of a piecewise linear density ρ: cells are
/// cut along its triangles, and every part has a closed form. Masses sum to ∫ ρ up to rounding.
/// Complexity: O(n log n) for the first triangulation (exact predicates, one thread), O(n + flips) for later ones of
/// similar heights, O(n) for the cells (all threads), and the number of pairs of a cell and a triangle of ρ that meet.
class PowerDiagram {
 public:
  /// @param sites   n×2, n ≥ 1, anywhere in the plane, no two in one place
  /// @param domain  Ω: the unit disk or a convex polygon
  /// @throws GeometryError when there is no site, one is not finite or two coincide (they are named)
  /// @throws InvalidArgument when the domain is not convex, or this build has no CGAL
  PowerDiagram(Points2 sites, const PlanarDomain& domain);
  /// The same of a density, not null, on its domain.
  PowerDiagram(Points2 sites, std::shared_ptr<const PiecewiseLinearDensity> source);
  ~PowerDiagram();
  PowerDiagram(PowerDiagram&&) noexcept;
  PowerDiagram& operator=(PowerDiagram&&) noexcept;

  /// The cells of new heights. @param heights n. @throws GeometryError when there are not n finite ones.
  const PowerCells& compute(const Heights& heights, const Execution& execution = {});
  template <class Derived>
  const PowerCells& compute(const Eigen::MatrixBase<Derived>& heights, const Execution& execution = {}) {
    return compute(Heights(heights.template cast<long double>()), execution);
  }

  /// As compute(), but false, with nothing that cells() may be asked for, when the triangulation shows that a site has
  /// no cell: much quicker then.
  [[nodiscard]] bool computeUnlessHidden(const Heights& heights, const Execution& execution = {});

  /// Of the last heights.
  [[nodiscard]] const PowerCells& cells() const noexcept { return cells_; }

  /// The outlines of the last heights; no corner where a cell is empty.
  /// @param arcStep  arcs get a corner at least every so many radians, > 0
  [[nodiscard]] CellPolygons polygons(double arcStep = 0.02) const;

  [[nodiscard]] const Points2& sites() const noexcept;
  [[nodiscard]] const PlanarDomain& domain() const noexcept { return domain_; }
  /// ∫ ρ over the domain; its area when the source is uniform.
  [[nodiscard]] double total() const { return source_ ? source_->total() : domain_.area(); }
  /// ρ at a point of the domain; 1 when the source is uniform.
  [[nodiscard]] double densityAt(const Eigen::Vector2d& point) const;
  /// The diagram of other sites, of the same domain and source.
  [[nodiscard]] PowerDiagram withSites(Points2 sites) const;

  /// Whether this build can make power diagrams.
  [[nodiscard]] static bool available() noexcept;

 private:
  bool update(const Heights& heights, bool unlessHidden, const Execution& execution);

  void measure(int begin, int end, DensityIntegrals* density, std::vector<PowerEdge>& edges);

  struct Walk;
  std::unique_ptr<Walk> walk_;
  PlanarDomain domain_;
  std::shared_ptr<const PiecewiseLinearDensity> source_;  // none: uniform
  PowerCells cells_;
};

}  // namespace authalic
