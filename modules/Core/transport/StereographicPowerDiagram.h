/// @file
/// Power diagrams of the whole plane, seen through a stereographic projection as cells of the unit sphere.
#pragma once

#include <Eigen/Core>

#include <memory>
#include <vector>

#include "Core/base/Arrays.h"
#include "Core/base/Execution.h"
#include "Core/transport/SphericalPowerDiagram.h"

namespace authalic {

/// Two cells with a common side.
struct StereographicPowerEdge {
  int first, second;  ///< sites, first < second
  double rate;        ///< −∂w_first/∂h_second = ∫ over the side of 4 / (1 + |x|²)² ds / |z_first − z_second|, > 0
};

/// The cells of one set of heights.
struct StereographicPowerCells {
  Eigen::VectorXd areas;  ///< n solid angles; sum to 4π
  Points3 centroids;      ///< n×3 unit vectors along ∫ x over the cell on the sphere
  std::vector<StereographicPowerEdge> edges;
};

/// Power cells W_i = { x ∈ R² : ⟨x, z_i⟩ + h_i ≥ ⟨x, z_j⟩ + h_j for all j } of the stereographic images z of sites on
/// the unit sphere, τ(x, y, z) = (x, y) / (1 − z) with the pole at (0, 0, 1), measured by 4 dx dy / (1 + |x|²)², the
/// area of the sphere @cite nadeem2017. Sides are straight in the plane, circles through the pole on the sphere; the
/// cells of the sites on the hull are unbounded and meet at the pole.
///
/// Everything is in closed form. A side on the line at distance d from the origin, from s₁ to s₂ along it, is an arc
/// of φ = φ₂ − φ₁, φ₁ = 2 atan(s₁/k), k = √(1 + d²), of a circle with axis c at the height d/k and the radius 1/k.
/// By Green's theorem w = Σ φ d/k, and 2 θ for the angle θ that the cell has at infinity; by Stokes's, up to its sign,
/// ∫ x = ½ Σ (d/k) c × (b − a) + φ c / k²; and ∫ 4 ds / (1 + |x|²)² = (φ + sin φ₂ − sin φ₁) / k³.
/// Both cells of a side get the same bits of it: areas sum to 4π up to rounding.
/// Complexity: as PowerDiagram.
class StereographicPowerDiagram {
 public:
  /// @param sites  n×3 unit vectors, n ≥ 3, no two in one place
  /// @param pole   of the projection, of any length above 0
  /// @throws GeometryError when there are fewer than 3, one is not on the sphere or within 1e-5 of the pole, or two
  ///         coincide (they are named)
  /// @throws InvalidArgument when the pole is zero or not finite, or this build has no CGAL
  StereographicPowerDiagram(Points3 sites, const Eigen::Vector3d& pole);
  ~StereographicPowerDiagram();

  /// The cells of new heights; false, with nothing that cells() may be asked for, when a site has none.
  /// @throws GeometryError when there are not n finite heights, or all sites lie on one circle through the pole
  [[nodiscard]] bool compute(const Heights& heights, const Execution& execution = {});

  /// Of the last heights.
  [[nodiscard]] const StereographicPowerCells& cells() const noexcept { return cells_; }

  /// Heights of Voronoi's cells in the plane: −|z_i|² / 2.
  [[nodiscard]] Heights voronoiHeights() const;

  /// ⟨τ(p_i), z_i⟩ + h_i: the plane of site i at the image of point i.
  [[nodiscard]] Eigen::VectorXd planesAt(const Points3& points) const;

  /// The outlines of the last heights.
  /// @param arcStep  arcs get a corner at least every so many radians of the sphere, and every four times as many of
  ///                 their circle, > 0
  [[nodiscard]] SphericalCellPolygons polygons(double arcStep = 0.05) const;

  [[nodiscard]] const Points3& sites() const noexcept { return sites_; }
  [[nodiscard]] const Points2& planarSites() const noexcept;
  [[nodiscard]] Eigen::Vector3d pole() const { return frame_.row(2).transpose(); }

 private:
  struct Walk;
  void addCell(int site, std::vector<StereographicPowerEdge>& edges);
  [[nodiscard]] Points2 project(const Points3& points) const;

  Points3 sites_;
  Eigen::Matrix3d frame_;  // rows: the axes of the plane, and the pole
  std::unique_ptr<Walk> walk_;
  StereographicPowerCells cells_;
};

}  // namespace authalic
