/// @file
/// A closed surface with handles, cut open to a disk, and how often its edges wind around the handles.
#pragma once

#include <vector>

#include "Core/mesh/SurfaceTopology.h"
#include "Core/mesh/TriangleMesh.h"

namespace authalic {

/// Edges that open a closed surface of genus g to one disk, and its homology by them.
struct CutGraph {
  int genus = 0;
  std::vector<char> onCut;            ///< 3m, per half-edge: 1 where its edge belongs to the cut
  Faces faces;                        ///< m×3, the disk: corners with vertices of their own on every side of the cut
  std::vector<int> originalPointIds;  ///< per vertex of the disk: vertex of the surface; the first n are 0 … n − 1
  /// 3m×2g, integer: row 3 f + k says by how many periods corner k of face f is displaced from where its vertex is. The
  /// differences along half-edges are closed 1-forms, opposite half-edges have opposite ones; their classes are a basis
  /// of H¹(M; ℤ).
  Eigen::MatrixXi windings;
};

/// Tree–cotree cut @cite erickson2005: shortest paths (mm) from a root span the vertices; a spanning tree of the dual
/// that prefers edges of long loops spans the faces; the 2g edges in neither close the shortest loops that generate the
/// homology. Dangling branches are pruned. O(m log m).
/// @param root  vertex in whose neighbourhood the cut may start
/// @param ends  vertices that the cut has to reach; branches to them stay
/// @throws TopologyError when the surface has a boundary or is not connected
[[nodiscard]] CutGraph cutToFundamentalDomain(const TriangleMesh& mesh, const SurfaceTopology& topology, int root = 0,
                                              const std::vector<int>& ends = {});

}  // namespace authalic
