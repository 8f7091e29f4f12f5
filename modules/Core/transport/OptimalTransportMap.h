/// @file
/// Maps of a disk by optimal transport: a conformal-like map, then every vertex to the middle of a cell of its share.
#pragma once

#include <memory>

#include "Core/mesh/DiskMesh.h"
#include "Core/transport/SemiDiscreteTransport.h"

namespace authalic {

struct OptimalTransportMapOptions : SemiDiscreteTransportOptions {
  PlanarDomain domain;  ///< unit disk, or a convex polygon
  std::shared_ptr<const PiecewiseLinearDensity> source;  ///< ρ, on that domain; none: uniform, ρ = 1

  /// @throws InvalidArgument naming the field that is outside its range.
  void validate() const;
};

struct OptimalTransportMapResult : TransportSolution {
  Points2 image;               ///< n×2: centroids of the cells; boundary vertices on the boundary
  Points2 sites;               ///< n×2: the initial map, inside the domain
  Eigen::VectorXd masses;      ///< n: ν, the ∫ ρ that each cell shall have; sum = ∫ ρ over the domain
  Eigen::VectorXd cellAreas;   ///< n
  Eigen::VectorXd cellMasses;  ///< n: ∫ ρ; the areas when the source is uniform
  Eigen::VectorXd potential;   ///< n: u at the image, u(x) = max_i ⟨x, y_i⟩ + h_i
  CellPolygons cells;          ///< outline of every cell, arcs sampled
  double transportCost = 0;    ///< W₂² = Σ ∫_{W_i} |x − y_i|² ρ dx: from the source to the masses
  int emptyCells = 0;
  int flippedFaces = 0;        ///< of the image: exact cells do not keep faces from folding
  double startSeconds = 0, transportSeconds = 0;
};

/// The area-preserving (or measure-controlled) map by optimal transport @cite su2016: sites y_i = images of the
/// vertices under an initial map; heights such that cell i has the mass ν_i (semiDiscreteTransport), its area
/// unless there is a source density; image of vertex i = centroid of its cell. Boundary vertices go to the point of the
/// boundary nearest to that: of the circle, or of their side; corners stay.
///
/// @param shares   n, > 0, sum 1: of the source, for each vertex (TargetMeasure::vertices())
/// @param initial  n×2, a map to the same domain with the boundary on its boundary, or empty for the harmonic map;
///                 vertices outside the domain (pockets) are put on its boundary
/// @param start    heights to start from, such as those of other shares from the same initial map; empty, or heights
///                 that leave a cell empty: those of Voronoi's cells
///
/// Guarantees: cells have their masses to `tolerance`; none is empty. Not guaranteed: that faces keep theirs, or do
/// not fold (flippedFaces) — authalicMap started from this image removes both when the source is uniform.
/// Complexity: as semiDiscreteTransport.
/// @throws InvalidArgument when the domain is not convex or not that of the source, and from options; GeometryError
///         when initial or shares do not belong to the disk, or two vertices have one image; SolverError when a system
///         cannot be factorised
[[nodiscard]] OptimalTransportMapResult optimalTransportMap(const DiskMesh& disk, const Eigen::VectorXd& shares,
                                                            const OptimalTransportMapOptions& options = {},
                                                            const Points2& initial = {},
                                                            const Execution& execution = {},
                                                            const Heights& start = {});

/// Σ ν_i |x_i − y_i|²: what it costs to move masses from sites to places.
[[nodiscard]] double displacementCost(const Eigen::VectorXd& masses, const Points2& sites, const Points2& places);

}  // namespace authalic
