/// @file
/// Maps of a closed surface to the sphere by optimal transport: a conformal map, then every vertex to the middle of a
/// cell of its share.
#pragma once

#include "Core/mesh/SphereMesh.h"
#include "Core/transport/SphericalTransport.h"

namespace authalic {

/// Which transport.
enum class SphereFormulation {
  Spherical,      ///< on the sphere itself, cost −ln cos d: the same map however the sphere is turned
  Stereographic,  ///< in the plane of a stereographic projection @cite nadeem2017: depends on its pole
};

struct SphericalTransportMapOptions : SemiDiscreteTransportOptions {
  SphereFormulation formulation = SphereFormulation::Spherical;
  Eigen::Vector3d pole = Eigen::Vector3d::Zero();  ///< Stereographic, any length; 0: defaultPole() of the initial map

  /// @throws InvalidArgument naming the field that is outside its range, or a pole without a projection.
  void validate() const;
};

struct SphericalTransportMapResult : TransportSolution {
  Points3 image;                 ///< n×3 unit vectors: centroids of the cells
  Points3 sites;                 ///< n×3: the initial map
  Eigen::VectorXd masses;        ///< n: ν, the solid angle that each cell shall have; sum 4π
  Eigen::VectorXd cellAreas;     ///< n
  Eigen::VectorXd potential;     ///< n: u at the image, u(x) = max_i ln⟨x, y_i⟩ + h_i, or ⟨τ(x), z_i⟩ + h_i
  SphericalCellPolygons cells;   ///< outline of every cell
  double transportCost = 0;      ///< Σ ∫_{W_i} −ln cos d(x, y_i), by quadrature; Stereographic: none is finite, 0
  Eigen::Vector3d pole = Eigen::Vector3d::Zero();  ///< Stereographic: unit vector of the projection
  int emptyCells = 0;
  int flippedFaces = 0;          ///< of the image: exact cells do not keep faces from folding
  double startSeconds = 0, transportSeconds = 0;
};

/// The area-preserving (or measure-controlled) map of a genus-0 surface to the unit sphere by optimal transport: sites
/// = images of the vertices under an initial map; heights such that cell i has the solid angle ν_i
/// (sphericalTransport); image of vertex i = centroid of its cell. SphereFormulation::Stereographic does the same in a
/// stereographic plane (stereographicTransport), where the result depends on the pole.
///
/// @param shares   n, > 0, sum 1: of the sphere, for each vertex (TargetMeasure::vertices())
/// @param initial  n×3 unit vectors, or empty for sphericalConformalMap
/// @param start    heights to start from, such as those of other shares from the same initial map; empty, or heights
///                 that leave a cell empty: those of Voronoi's cells
///
/// Guarantees: cells have their areas to `tolerance`; none is empty. Not guaranteed: that faces keep theirs, or do not
/// fold (flippedFaces) — sphericalAuthalicMap started from this image removes both. Complexity: as sphericalTransport.
/// @throws InvalidArgument from options; GeometryError when initial or shares do not belong to the surface, or two
///         vertices have one image, or they lie in a hemisphere (Spherical), or one lies at the pole (Stereographic);
///         SolverError when a system cannot be factorised
[[nodiscard]] SphericalTransportMapResult sphericalTransportMap(const SphereMesh& sphere, const Eigen::VectorXd& shares,
                                                                const SphericalTransportMapOptions& options = {},
                                                                const Points3& initial = {},
                                                                const Execution& execution = {},
                                                                const Heights& start = {});

/// The middle of the face of the largest solid angle: far from all vertices.
[[nodiscard]] Eigen::Vector3d defaultPole(const Points3& image, const Faces& faces);

/// Σ ν_i d(x_i, y_i)², d the great-circle distance: how far masses move from sites to places.
[[nodiscard]] double displacementCost(const Eigen::VectorXd& masses, const Points3& sites, const Points3& places);

}  // namespace authalic
