/// @file
/// Fewer triangles for the same surface and the same topology.
#pragma once

#include "Core/base/Execution.h"
#include "Core/mesh/TriangleMesh.h"

namespace authalic {

/// Collapses edges, cheapest first, until at most `targetFaces` triangles are left.
///
/// Cost and placement are Lindstrom and Turk's: the new vertex keeps the enclosed volume and minimises the
/// change of volume and boundary. A collapse is made only when it satisfies the link condition and turns no
/// face over, so that components, handles and boundary loops stay what they were. When no further collapse is
/// possible the result has more faces than asked for: compare `faceCount()`. A mesh that is already small
/// enough comes back unchanged. Vertices that no face uses are dropped.
///
/// Single-threaded and deterministic. O(n log n).
///
/// @param targetFaces  at least 4
/// @throws InvalidArgument for a smaller target; TopologyError when the mesh is not a consistently oriented
/// manifold;
///         CancelledError
/// @cite lindstrom1998
[[nodiscard]] TriangleMesh decimate(const TriangleMesh& mesh, int targetFaces,
                                    const Execution& execution = {});

}  // namespace authalic
