/// @file
/// A disk flattened with a prescribed boundary curvature: the curvature flow as a map.
#pragma once

#include <optional>
#include <vector>

#include "Core/base/Execution.h"
#include "Core/base/Status.h"
#include "Core/conformal/YamabeFlow.h"
#include "Core/geometry/CommonRefinement.h"
#include "Core/mesh/DiskMesh.h"

namespace authalic {

struct YamabeMapOptions {
  /// n: target curvature, 0 at inner vertices, summing to 2π along the boundary (a corner turns by its K̄, a straight
  /// side has 0), where up to 10⁻⁴, the rounding of a text or of single precision, is spread in proportion to |K̄|;
  /// empty: a circle.
  Eigen::VectorXd curvature;
  int startVertex = -1;  ///< boundary vertex on the positive x axis; −1 = the one with the smallest id
  bool refine = false;   ///< also return the common refinement, on which nothing folds
  bool unfold = true;    ///< re-embed small patches around folded faces (initial/Unfold); the boundary stays
  YamabeFlowOptions flow;
};

struct YamabeMapResult {
  Points2 image;                  ///< n×2, as large in area as the surface, area centroid at 0
  Eigen::VectorXd logScale;       ///< n: u of the image's metric; vertex scaling: image lengths are
                                  ///< l_ij e^{(u_i + u_j)/2} where no edge was flipped; circle packing: ln of radii
  Eigen::VectorXd curvature;      ///< n: K reached
  Status status = Status::NotRun; ///< of the flow
  double residual = 0;            ///< max |K − K̄|
  double holonomy = 0;            ///< of the layout, see Development
  int flippedBeforeUnfolding = 0; ///< faces of the input that the conformal map itself folds
  int flippedFaces = 0;           ///< faces of the input that are folded in the image
  int pockets = 0;                ///< pieces at the boundary that were bulged out of it, see FoldedPockets
  std::optional<CommonRefinement> refinement;  ///< when asked for, with the image as it is before unfolding
  int addedVertices = 0;          ///< by which the flow split boundary edges; not part of the image
  int degenerateFaces = 0;        ///< see YamabeFlowResult
  int iterations = 0;
  int edgeFlips = 0;              ///< of the intrinsic triangulation, all kinds
  std::vector<YamabeIteration> history;
  double seconds = 0;
};

/// Runs the flow on a disk and develops the flat metric into the plane.
///
/// With a circle this is the RiemannMap before its Möbius normalisation, in the surface's own scale. A prescribed
/// boundary may make the image overlap itself: curvature says how the boundary turns, not where it goes.
/// Not guaranteed: no folded face (→ flippedFaces); an image without overlap. Complexity: that of the flow.
/// When cancelled, the image is empty and the status says so. @cite su2016 @cite springborn2008
/// @throws InvalidArgument when K̄ does not vanish inside, is not admissible (see yamabeFlow), or an option is
///         out of range; GeometryError; SolverError
[[nodiscard]] YamabeMapResult yamabeMap(const DiskMesh& disk, const YamabeMapOptions& options = {},
                                        const Execution& execution = {});

}  // namespace authalic
