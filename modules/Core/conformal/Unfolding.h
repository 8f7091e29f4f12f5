/// @file
/// What is done about folded faces of the input after a conformal map. Private to conformal/.
#pragma once

#include "Core/mesh/SurfaceTopology.h"
#include "Core/mesh/TriangleMesh.h"

namespace authalic {

struct UnfoldedImage {
  Points2 image;
  int flippedBefore = 0, flippedAfter = 0;
  int pockets = 0;  ///< bulged out, see FoldedPockets
};

/// Pockets first, then patches of up to 32 rings around what is still folded; nothing when `repair` is false.
[[nodiscard]] UnfoldedImage unfoldImage(const TriangleMesh& surface, const SurfaceTopology& topology, Points2 image,
                                        bool repair);

}  // namespace authalic
