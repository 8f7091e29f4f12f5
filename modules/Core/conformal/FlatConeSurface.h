/// @file
/// A surface of genus ≥ 2 as a flat surface with cones, cut open to the plane.
#pragma once

#include <vector>

#include "Core/conformal/ConeHolonomy.h"
#include "Core/conformal/YamabeFlow.h"
#include "Core/mesh/HighGenusMesh.h"

namespace authalic {

/// Charts of a flat cone surface: every vertex has one place, every corner of a face sees it through a rigid motion.
///
/// The cut reaches every cone and opens the surface to a disk, whose image in the plane need not be embedded: it may
/// lie in several layers. Corner 3 f + k of that image is at motions.corners[3 f + k](place of its vertex). Across an
/// edge of the cut the plane is continued by motions.across[h], constant along each seam; around a vertex that is no
/// cone these motions compose to the identity, around a cone to the turn by its curvature about its place, to
/// rounding.
struct FlatConeSurface {
  std::vector<int> cones;             ///< vertices
  std::vector<double> curvature;      ///< of each cone, ±π/2 radians: its angle is 2π − curvature
  CutGraph cut;
  ConeHolonomy holonomy;
  Eigen::VectorXcd translations;      ///< parameters of the holonomy
  ConeMotions motions;                ///< across the cut, and from charts to corners
  Points2 places;                     ///< n×2, in the chart of the vertex
  YamabeFlowResult flow;              ///< of the metric (without its triangulation)
};

/// Finds a flat metric in the conformal class of the surface (yamabeFlow()) with cones of angle 5π/2 and 3π/2 and
/// lays it out.
///
/// There are 4|χ| more of the former than of the latter. Cones stand where they even out the scale factors most.
/// The metric decides the turns and the translations of the holonomy; the motions close to rounding, not only to
/// the tolerance of the flow (ConeHolonomy). Faces of the surface may come out folded where it is far from Delaunay.
/// When the flow does not converge, the charts close all the same; see flow.status.
/// Complexity: that of the flow.
/// @throws SolverError from the flow
/// @cite springborn2008
[[nodiscard]] FlatConeSurface flatConeSurface(const HighGenusMesh& surface, SolverBackend backend,
                                              const Execution& execution = {});

/// The motions of some parameters of flat.holonomy, with the places of the cones that belong to them.
void setMotions(FlatConeSurface& flat, ConeMotions motions);

/// Places of the disk's vertices: the image of cut.faces. @param places  n×2, in the charts
[[nodiscard]] Points2 openImage(const FlatConeSurface& flat, const Faces& faces, const Points2& places);

}  // namespace authalic
