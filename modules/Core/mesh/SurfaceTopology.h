/// @file
/// Connectivity of a triangle mesh: half-edges, boundary loops, components.
#pragma once

#include <array>
#include <vector>

#include "Core/mesh/TriangleMesh.h"

namespace authalic {

/// Half-edge connectivity of a set of faces.
///
/// Half-edge h = 3 f + k runs from corner k of face f to corner k+1. `opposite(h)` is the half-edge that
/// runs the other way on the same edge, or -1 on the boundary. Where an edge is not manifold (more than two
/// faces, or two faces that run along it in the same direction) its half-edges have opposite -1 and the edge
/// is listed in `nonManifoldEdges`; such a mesh must not be handed to a map.
class SurfaceTopology {
 public:
  SurfaceTopology(const Faces& faces, int vertexCount);

  [[nodiscard]] int opposite(int halfEdge) const { return opposite_[static_cast<std::size_t>(halfEdge)]; }
  [[nodiscard]] int tail(int halfEdge) const { return faces_(halfEdge / 3, halfEdge % 3); }
  [[nodiscard]] int head(int halfEdge) const { return faces_(halfEdge / 3, (halfEdge + 1) % 3); }
  [[nodiscard]] static int next(int halfEdge) { return halfEdge % 3 == 2 ? halfEdge - 2 : halfEdge + 1; }
  [[nodiscard]] static int previous(int halfEdge) { return halfEdge % 3 == 0 ? halfEdge + 2 : halfEdge - 1; }
  [[nodiscard]] const Faces& faces() const noexcept { return faces_; }
  [[nodiscard]] int vertexCount() const noexcept { return vertexCount_; }

  /// Edges (undirected), boundary edges included.
  [[nodiscard]] int edgeCount() const noexcept { return edgeCount_; }
  /// Boundary loops as vertex cycles; the surface lies to the left. Sorted by smallest vertex id first.
  [[nodiscard]] const std::vector<std::vector<int>>& boundaryLoops() const noexcept { return loops_; }
  /// Vertex pairs of edges with more than two faces.
  [[nodiscard]] const std::vector<std::array<int, 2>>& nonManifoldEdges() const noexcept {
    return nonManifoldEdges_;
  }
  /// Vertex pairs of edges whose two faces run along it in the same direction.
  [[nodiscard]] const std::vector<std::array<int, 2>>& inconsistentEdges() const noexcept {
    return inconsistentEdges_;
  }
  /// Vertices whose faces do not form one fan or one cycle.
  [[nodiscard]] const std::vector<int>& nonManifoldVertices() const noexcept { return nonManifoldVertices_; }
  /// Vertices that no face uses.
  [[nodiscard]] const std::vector<int>& isolatedVertices() const noexcept { return isolatedVertices_; }
  /// Component id (0-based, in order of first face) of every face.
  [[nodiscard]] const std::vector<int>& faceComponents() const noexcept { return faceComponents_; }
  [[nodiscard]] int componentCount() const noexcept { return componentCount_; }
  [[nodiscard]] const std::vector<char>& onBoundary() const noexcept { return onBoundary_; }
  /// χ = V − E + F over the vertices that faces use.
  [[nodiscard]] int eulerCharacteristic() const noexcept;
  [[nodiscard]] bool manifold() const noexcept {
    return nonManifoldEdges_.empty() && inconsistentEdges_.empty() && nonManifoldVertices_.empty();
  }

 private:
  void pairHalfEdges();
  void findComponents();
  void classifyVertices();
  void traceLoops();

  Faces faces_;
  int vertexCount_ = 0;
  int edgeCount_ = 0;
  int componentCount_ = 0;
  std::vector<int> opposite_;
  std::vector<std::vector<int>> loops_;
  std::vector<std::array<int, 2>> nonManifoldEdges_, inconsistentEdges_;
  std::vector<int> nonManifoldVertices_, isolatedVertices_, faceComponents_;
  std::vector<char> onBoundary_;
};

}  // namespace authalic
