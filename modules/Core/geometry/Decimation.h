/// @file
/// Fewer triangles for the same surface and the same topology.
#pragma once

#include "Core/base/Execution.h"
#include "Core/mesh/TriangleMesh.h"

namespace authalic {

/// Collapses edges, cheapest first, until at most `targetFaces` triangles are left.
///
/// The cost of moving both ends of an edge to x is Garland and Heckbert's quadric Σ A_f (n_f · (x − p_f))²
/// over the planes of the faces gathered so far, plus 10⁻³ of their area times |x − m|², m the middle of the
/// edge; x is its minimum. The second term settles flat places, where the first is blind, in favour of short
/// edges and even triangles.
///
/// Guarantees: a collapse is made only when it satisfies the link condition, so that components, handles and
/// boundary loops stay what they were; only when no remaining face turns by more than about 75° or becomes a
/// needle; vertices of the boundary never move. When no further collapse is possible the result has more
/// faces than asked for: compare `faceCount()`. Vertices that no face uses are dropped. A mesh that is
/// already small enough comes back unchanged. Not guaranteed: the enclosed volume (it changes by some 10⁻⁴),
/// absence of self-intersections.
///
/// Single-threaded and deterministic. O(n log n); about 150,000 collapses per second.
///
/// @param targetFaces  at least 4
/// @throws InvalidArgument for a smaller target; TopologyError when the mesh is not a consistently oriented
/// manifold;
///         CancelledError
/// @cite garland1997 @cite lindstrom1998
[[nodiscard]] TriangleMesh decimate(const TriangleMesh& mesh, int targetFaces,
                                    const Execution& execution = {});

}  // namespace authalic
