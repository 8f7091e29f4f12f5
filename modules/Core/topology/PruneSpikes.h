/// @file
/// Removing the spikes of a surface that no map to the plane can make good triangles of.
#pragma once

#include <vector>

#include "Core/base/Execution.h"
#include "Core/mesh/TriangleMesh.h"

namespace authalic {

/// A surface without spikes and where its vertices come from.
struct PrunedSurface {
  TriangleMesh mesh;
  std::vector<int> originalPointIds;  ///< n': vertex of the input for each vertex of the result
  int spikes = 0;                     ///< parts that were cut off
  int removedFaces = 0;               ///< faces of those parts; each part got one face in its place
  double removedArea = 0;             ///< mm², of those parts minus that of the faces in their places
};

/// Cuts off every small part of a surface that hangs on a separating triangle, and closes the cut by a face.
///
/// A separating triangle is a cycle of three edges that is not a face. Where it cuts off a disk, that disk has
/// F = 2 k + 1 faces on k inner vertices, and a map without folds must fit all of them into one triangle of the
/// image: needles, if they are the walls of a thin spike. Edge collapse leaves such spikes behind, often nested;
/// the outermost go, and those inside with them. A vertex with three faces around it is the smallest case and goes
/// too.
///
/// Guarantees: manifoldness, orientation, components, handles and boundary loops stay what they were. Points of the
/// result are points of the input, bit for bit; vertices and faces that stay keep their order, the new faces follow.
/// Afterwards no separating triangle is left whose side with fewer faces is a disk of at most `largestShare` of the
/// area before; a surface that had none comes back unchanged. Not guaranteed: a good shape of the new faces,
/// absence of self-intersections.
///
/// Single-threaded and deterministic. O(Σ degree²), plus the faces of the smaller sides.
///
/// @param largestShare  of the area of the surface, per part; in [0, 0.5). The default is a spike's, not a gyrus's.
/// @throws InvalidArgument for a share outside that range; TopologyError when the surface is not a consistently
/// oriented
///         manifold; CancelledError
/// @cite garland1997
[[nodiscard]] PrunedSurface pruneSpikes(const TriangleMesh& surface, double largestShare = 1e-3,
                                        const Execution& execution = {});

}  // namespace authalic
