/// @file
/// Removes folded faces from a planar image by re-embedding small patches around them.
#pragma once

#include <vector>

#include "Core/base/Execution.h"
#include "Core/mesh/SurfaceTopology.h"

namespace authalic {

struct UnfoldResult {
  Points2 image;
  int rounds = 0;
  int movedVertices = 0;  ///< vertices whose place was solved for, counted once per round
  int flippedFaces = 0;   ///< folds that are left; 0 on a convex domain whose boundary is in order
};

/// Unfold the faces of `image` whose signed area is not positive.
///
/// The vertices within a growing number of edges of a fold are put where each is the mean of its neighbours, the rest
/// held. Round by round the patches that still fold grow (1, 2, 4, … rings), until nothing is folded; in the limit
/// everything but the boundary is solved for, which is Tutte's embedding @cite tutte1963: no folds when the boundary
/// is convex and in order.
/// Boundary vertices never move. Complexity: one sparse solve per round on the patches only.
[[nodiscard]] UnfoldResult unfold(const SurfaceTopology& topology, Points2 image, const Execution& execution = {});

}  // namespace authalic
