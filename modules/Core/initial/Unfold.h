/// @file
/// Removes folded faces from a planar image by re-embedding small patches around them.
#pragma once

#include <vector>

#include "Core/base/Execution.h"
#include "Core/mesh/SurfaceTopology.h"

namespace authalic {

enum class UnfoldReach { Patches, WholeMesh };

struct UnfoldResult {
  Points2 image;
  int rounds = 0;
  int movedVertices = 0;  ///< size of the last round's patches; all vertices when they grew to the whole mesh
  int flippedFaces = 0;   ///< folds that are left; 0 on a convex domain whose boundary is in order
};

/// Unfold the faces of `image` whose signed area is not positive.
///
/// The vertices within 2, 4, 8, … edges of a fold are put where each is the weighted mean of its neighbours, the rest
/// held, until nothing is folded. The weights are the mean-value weights of the image itself with unsigned angles
/// @cite floater2003: positive everywhere, and such that a vertex without a fold around it is already at its mean. So
/// the image changes near folds only; and when a patch grows to the whole mesh, the result is a barycentric map with
/// positive weights: no folds when the boundary is convex and in order.
/// Where collapsed triangles make those weights unusable, equal weights take their place.
/// Boundary vertices never move. Complexity: one sparse solve per round on the patches.
/// With UnfoldReach::Patches folds are left where patches of 32 rings do not suffice.
/// @param shifts  3m×2 or empty: those of a periodic image, see periodicFaceAreas()
[[nodiscard]] UnfoldResult unfold(const SurfaceTopology& topology, Points2 image, const Execution& execution = {},
                                  UnfoldReach reach = UnfoldReach::WholeMesh, const Points2& shifts = {});

}  // namespace authalic
