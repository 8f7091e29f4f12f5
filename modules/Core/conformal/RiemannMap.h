/// @file
/// The Riemann map of a disk: conformal onto the unit disk.
#pragma once

#include <optional>
#include <vector>

#include "Core/base/Execution.h"
#include "Core/base/Status.h"
#include "Core/conformal/DiskNormalisation.h"
#include "Core/conformal/YamabeFlow.h"
#include "Core/geometry/CommonRefinement.h"
#include "Core/mesh/DiskMesh.h"

namespace authalic {

/// Which way leads to the disk. Both give the same map up to a Möbius transformation as meshes get finer.
enum class RiemannRoad {
  Boundary,  ///< prescribe the curvature of a circle on the boundary: discretely conformal up to the boundary
  Puncture,  ///< take out a face, make the rest a flat cylinder, close it by the exponential @cite nadeem2017
};

struct RiemannMapOptions {
  RiemannRoad road = RiemannRoad::Boundary;
  int puncture = -1;  ///< face taken out on the road Puncture, no vertex of it on the boundary; −1 = the one
                      ///< farthest from it
  DiskNormalisation normalisation;
  bool refine = false;   ///< also return the common refinement, on which nothing folds (road Boundary)
  bool unfold = true;    ///< re-embed small patches around folded faces (initial/Unfold); the boundary stays
  YamabeFlowOptions flow;
};

struct RiemannMapResult {
  Points2 image;                  ///< n×2; the boundary on the unit circle, counter-clockwise, to 1e-15
  Eigen::VectorXd logScale;       ///< n: u of the image's metric. Road Boundary with vertex scaling: image lengths are
                                  ///< l_ij e^{(u_i + u_j)/2}; Puncture: to second order in the length; circle
                                  ///< packing: ln of the radii, likewise to second order
  Status status = Status::NotRun; ///< of the flow
  double residual = 0;            ///< max |K − K̄| of the flow
  double holonomy = 0;            ///< of the layout, see Development
  double roundness = 0;           ///< how far boundary vertices were from the circle, relative, before they were
                                  ///< put on it
  int flippedBeforeUnfolding = 0; ///< faces of the input that the conformal map itself folds
  int flippedFaces = 0;           ///< faces of the input that are folded in the image
  int pockets = 0;                ///< pieces at the boundary that were bulged out of it, see FoldedPockets
  std::optional<CommonRefinement> refinement;  ///< when asked for, with the image as it is before unfolding
  int iterations = 0;             ///< Newton steps
  int edgeFlips = 0;              ///< of the intrinsic triangulation, all kinds
  std::vector<YamabeIteration> history;
  double seconds = 0;
};

/// Maps a disk conformally onto the unit disk.
///
/// **Boundary.** Curvature 0 inside, that of a polygon inscribed in a circle on the boundary (YamabeFlow with one
/// BoundaryCircle); the flat metric is developed into the plane, its boundary lies on a circle, which becomes the
/// unit circle. **Puncture.** Without one face the disk is an annulus; with K̄ = 0 inside and on both loops it
/// becomes a cylinder of circumference 2π; e^{height + i angle} closes it, and the face comes back. The
/// exponential is conformal, but edges near the puncture are long, so that a few faces there are less conformal.
/// Then the normalisation, a Möbius transformation.
///
/// Guarantees: the boundary on the circle in order; the same bits at any thread count.
/// Not guaranteed: no folded face (→ flippedFaces). The map is one-to-one on the flow's own Delaunay
/// triangulation; faces of the input with very obtuse angles, whose edges were flipped away, may fold. Unfolding
/// moves a few vertices around them; what it cannot undo within 32 rings stays and is counted.
/// Complexity: that of the flow. When cancelled, the image is empty and the status says so. @cite springborn2008
/// @cite nadeem2017
/// @throws InvalidArgument from options, also when a refinement is asked for on the road Puncture or where a
///         boundary edge had to be split; GeometryError when an edge has no length; SolverError
[[nodiscard]] RiemannMapResult riemannMap(const DiskMesh& disk, const RiemannMapOptions& options = {},
                                          const Execution& execution = {});

/// "boundary", "puncture".
[[nodiscard]] const char* riemannRoadName(RiemannRoad road) noexcept;

}  // namespace authalic
