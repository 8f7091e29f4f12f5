/// @file
/// Regions of interest: densities that give regions of a surface a larger or smaller share of a map.
#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "Core/mesh/TriangleMesh.h"

namespace authalic {

/// A part of a surface that shall get a larger or smaller share of the map.
struct RegionOfInterest {
  std::string name;          ///< for messages and reports
  std::vector<char> inside;  ///< n, 1 for the vertices of the region
  double factor = 1;         ///< of its area relative to the rest, > 0; 4 = four times, 0.25 = a quarter
  double blend = 0;          ///< mm, width of the transition of the density across the border, 0 or more
};

/// A density for TargetMeasure::fromFaceDensity, and what it gives the regions.
struct RegionsOfInterestDensity {
  Eigen::VectorXd faces;    ///< m, relative to the native area, > 0
  Eigen::VectorXd factors;  ///< one per region: the density in its middle, that makes the shares exact
  Eigen::VectorXd sourceShares, targetShares;  ///< one per region: of the native area, and of the target measure
};

/// A density under which every region gets exactly the share that its factor asks for @cite su2019 (eq. 6, section
/// 6.3),
/// @cite su2016 (section 4.3).
///
/// With β the density given (1 when empty), A the face areas, s_v = ⅓ Σ_{t∋v} β_t A_t the stars, and
/// D_v = Π_{r∋v} f_r the product of the factors of the regions that hold vertex v, region r shall have the share
///
///     T_r = Σ_{v∈r} D_v s_v / Σ_v D_v s_v
///
/// of the map: every area times its factor, then all of it normalised. For one region with the share s that is
/// T = f s / (f s + 1 − s): its odds s / (1 − s) are multiplied by f. The density is
///
///     ρ_t = β_t ⅓ Σ_{v∈t} exp(Σ_r g_r w_r(v)),
///
/// where w_r is 1 in the region and 0 outside, or with a blend b passes from 0 to 1 by 3x² − 2x³, x = ½ + d/b, d the
/// distance along the surface from the border, positive inside (surfaceDistance()). Faces across the border and the
/// blend would take some of the share away; the g_r, near ln f_r, are solved for so that stars of the regions'
/// vertices sum to T_r. So a blend moves area within the region and within the rest, never between them.
///
/// Regions may overlap: factors multiply there. The order of regions does not matter.
/// @param base     m densities > 0 to multiply, or empty for 1
/// @throws InvalidArgument when a factor is not positive and finite, a blend negative or not finite, a region is
/// empty
///         or everything, or the share cannot be reached by any density of that form (a region much narrower than its
///         blend with a large factor); the region is named
/// @throws GeometryError when a region has not n flags, or base not m numbers
/// Guarantees: |share of TargetMeasure − T_r| ≤ 1e-12, faces without area included as TargetMeasure counts them.
/// Complexity: O(m) per region and sweep, a few sweeps (more with wide blends); O(m log n) per blend.
[[nodiscard]] RegionsOfInterestDensity densityOfRegions(const TriangleMesh& surface, const Eigen::VectorXd& base,
                                                        const std::vector<RegionOfInterest>& regions);

/// The piece of the surface within `radius` mm of a place in space that is connected to the vertex nearest to that
/// place: 1 for its vertices. The opposite bank of a sulcus is left out unless it is joined within the ball.
/// @throws InvalidArgument when the radius is not positive and finite, or no vertex is that near; says where one is
[[nodiscard]] std::vector<char> ballOnSurface(const TriangleMesh& surface, const Eigen::Vector3d& centre,
                                              double radius);

/// The vertices within `radius` mm along the surface (surfaceDistance()) of the vertex nearest to a place in space.
/// @throws InvalidArgument as ballOnSurface
[[nodiscard]] std::vector<char> geodesicBallOnSurface(const TriangleMesh& surface, const Eigen::Vector3d& centre,
                                                      double radius);

/// Σ over the vertices of a region of their stars: a third of every face measure per corner inside.
/// @param faceMeasures  m, any unit; inside: n flags
[[nodiscard]] double regionMeasure(const Eigen::VectorXd& faceMeasures, const Faces& faces,
                                   const std::vector<char>& inside);

}  // namespace authalic
