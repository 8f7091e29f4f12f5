/// @file
/// Cutting an annulus open along a shortest path between its loops.
#pragma once

#include <vector>

#include "Core/mesh/SurfaceTopology.h"
#include "Core/mesh/TriangleMesh.h"

namespace authalic {

/// A path that opens an annulus to a disk, and which corners lie on which side of it.
struct AnnulusCut {
  std::vector<int> path;      ///< vertices from one loop to the other, along edges
  std::vector<char> onRight;  ///< 3m, per corner 3 f + k: 1 where it touches the path from the right
  /// 3m, per half-edge: winding numbers of edges around the annulus, +1 from the left copy of a path vertex to the
  /// right one. Closed: opposite half-edges have opposite numbers and every face has the sum 0.
  std::vector<int> winding;
};

/// The shortest path along edges (mm) from a vertex of `from` to one of `to`; of equals the one with smaller ids.
/// Dijkstra's method, O(m log m).
/// @throws TopologyError when no path leads from one loop to the other
[[nodiscard]] AnnulusCut cutAnnulus(const TriangleMesh& mesh, const SurfaceTopology& topology,
                                    const std::vector<int>& from, const std::vector<int>& to);

/// The faces with the path's vertices doubled.
struct CutFaces {
  Faces faces;                        ///< m×3: corners on the right of the path have vertices of their own
  std::vector<int> originalPointIds;  ///< n + path: vertex of the input; the first n are the input's
};
[[nodiscard]] CutFaces openAlong(const Faces& faces, int vertexCount, const AnnulusCut& cut);

}  // namespace authalic
