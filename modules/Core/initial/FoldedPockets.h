/// @file
/// Pockets of a surface behind a boundary loop that is straight or concave in its image.
#pragma once

#include <vector>

#include "Core/mesh/SurfaceTopology.h"
#include "Core/mesh/TriangleMesh.h"

namespace authalic {

struct FoldedPocketsResult {
  Points2 image;
  int pockets = 0;                 ///< that were bulged out
  std::vector<int> movedVertices;  ///< in increasing order; those of them on the boundary have left their circle or line
};

/// Bulges pockets out of the image.
///
/// An inner edge between two vertices of one boundary loop (a chord) cuts off a pocket; the smallest is an ear, a
/// triangle with two boundary edges. When the loop's image is a straight line, or a circle with the domain outside,
/// the pocket's boundary lies on the wrong side of its own chord: its faces are folded in *every* map that keeps
/// the loop on the line or circle. Each pocket with a folded face is put behind its chord instead: an ear keeps its
/// shape (height at most half the chord), a larger pocket goes into the segment of a parabola, by a barycentric map
/// with equal weights, which cannot fold @cite tutte1963. The chord's ends and everything else stay. O(m) without
/// pockets.
///
/// @param surface  the surface, for the shapes of ears (mm)
/// @param image    n×2
[[nodiscard]] FoldedPocketsResult bulgeFoldedPockets(const TriangleMesh& surface, const SurfaceTopology& topology,
                                                     Points2 image);

}  // namespace authalic
