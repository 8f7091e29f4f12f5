/// @file
/// Conformal maps of annuli: onto a concentric ring and onto a periodic rectangle.
#pragma once

#include <optional>
#include <vector>

#include "Core/base/Execution.h"
#include "Core/base/Status.h"
#include "Core/conformal/YamabeFlow.h"
#include "Core/geometry/CommonRefinement.h"
#include "Core/mesh/AnnulusMesh.h"

namespace authalic {

struct AnnulusMapOptions {
  int outerLoop = -1;    ///< loop of AnnulusMesh::loops() that becomes the outer circle; −1 = the longer one (mm)
  int startVertex = -1;  ///< vertex of the outer loop at angle 0; −1 = the one with the smallest id
  bool refine = false;   ///< also return the common refinement of surface and flow on the ring
  bool unfold = true;    ///< bulge pockets, re-embed small patches around folded faces (initial/Unfold)
  YamabeFlowOptions flow;
};

/// The same annulus as a rectangle whose left and right sides are one line of the surface.
struct PeriodicRectangle {
  /// n' × 2: (x, y); once around is 1 in x; y is 0 on the outer loop and `modulus` on the inner one.
  Points2 points;
  Faces faces;                        ///< m×3, faces of the input in order, opened along the cut
  std::vector<int> originalPointIds;  ///< n': vertex of the input; the first n are the input's, then the copies
  Eigen::VectorXd logScale;           ///< n': u, as for the ring, and exact
};

struct AnnulusMapResult {
  Points2 image;                  ///< n×2: outer loop on the unit circle, inner loop on the circle of
                                  ///< `innerRadius` about 0
  Eigen::VectorXd logScale;       ///< n: u of the ring: image lengths are l_ij e^{(u_i + u_j)/2} to second order in
                                  ///< the length; circle packing: ln of the radii
  PeriodicRectangle rectangle;
  double modulus = 0;             ///< (1/2π) ln R/r = height / circumference
  double innerRadius = 0;         ///< r, with R = 1
  std::vector<int> cut;           ///< vertices of the cut, from the outer loop to the inner one
  Status status = Status::NotRun; ///< of the flow
  double residual = 0;            ///< max |K| of the flow
  double holonomy = 0;            ///< how far the development is from closing by a pure translation, see
                                  ///< Development
  double straightness = 0;        ///< how far the loops were from their circles, in circumferences, before they
                                  ///< were put there
  int flippedBeforeUnfolding = 0; ///< faces that the conformal map itself folds, on ring and rectangle
  int flippedFaces = 0;           ///< folded faces of the ring
  int flippedRectangleFaces = 0;  ///< folded faces of the rectangle
  int pockets = 0;                ///< pockets bulged into the hole of the ring, see FoldedPockets
  int rectanglePockets = 0;       ///< pockets bulged out of the rectangle
  std::optional<CommonRefinement> refinement;  ///< when asked for, with the ring as it is before unfolding
  int iterations = 0;
  int edgeFlips = 0;              ///< of the intrinsic triangulation, all kinds
  std::vector<YamabeIteration> history;
  double seconds = 0;
};

/// Maps an annulus conformally.
///
/// The flow makes it flat with straight loops (K̄ = 0 everywhere): a cylinder. It is cut along a shortest path
/// between its loops and developed: a strip that closes by a translation, because K = 0 leaves no rotation. Scaled
/// to circumference 2π with coordinates ξ ≤ 0 (height) and θ, the ring is e^{ξ + iθ}, the rectangle (θ, −ξ)/2π.
/// Both are oriented like the surface. The modulus is a conformal invariant of the surface.
///
/// The rectangle's sides follow the edges of the cut; they are alike but for a shift by 1.
/// Guarantees: loops on their circles and lines to 1e-15, but for vertices of pockets. Ears of the surface
/// (triangles with two boundary edges) and larger pockets have no area on a straight line and are folded in a
/// hole: there they are bulged out and counted (pockets, rectanglePockets). Not guaranteed: no folded face (→
/// flippedFaces, flippedRectangleFaces).
/// Complexity: that of the flow. When cancelled, the image is empty and the status says so. @cite nadeem2017
/// @cite springborn2008
/// @throws InvalidArgument from options, also when a refinement is asked for where a boundary edge had to be split;
///         GeometryError when an edge has no length; SolverError
[[nodiscard]] AnnulusMapResult annulusMap(const AnnulusMesh& annulus, const AnnulusMapOptions& options = {},
                                          const Execution& execution = {});

}  // namespace authalic
