/// @file
/// What a triangle mesh is, topologically, and every defect with its place in mm.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "Core/mesh/SurfaceTopology.h"
#include "Core/mesh/TriangleMesh.h"

namespace authalic {

/// A defect of a mesh: the vertex, edge or face that has it, and where.
struct MeshDefect {
  std::vector<int> ids;      ///< vertex id; two vertex ids of an edge; or a face id
  Eigen::Vector3d place{0, 0, 0};  ///< mm: the vertex, the middle of the edge, the centroid of the face
};

/// One boundary loop.
struct BoundaryLoopReport {
  int vertexCount = 0;
  double length = 0;               ///< mm
  Eigen::Vector3d place{0, 0, 0};  ///< mean of its vertices, mm
};

/// One connected component (pieces that share a vertex are one component).
struct ComponentReport {
  int vertexCount = 0, faceCount = 0;
  double area = 0;                 ///< mm²
  Eigen::Vector3d place{0, 0, 0};  ///< area-weighted centroid, mm
};

/// Topology, size and defects of a mesh.
struct MeshReport {
  int vertexCount = 0, edgeCount = 0, faceCount = 0;
  int eulerCharacteristic = 0;  ///< χ = V − E + F over used vertices
  int genus = -1;               ///< summed over components, (2 c − χ − loops)/2; −1 when not an oriented manifold
  double area = 0;              ///< mm²
  double volume = 0;            ///< signed enclosed volume in mm³, meaningful for closed surfaces; > 0 = outward faces
  Eigen::Vector3d lower{0, 0, 0}, upper{0, 0, 0};  ///< bounding box, mm
  std::vector<ComponentReport> components;         ///< largest area first
  std::vector<BoundaryLoopReport> loops;           ///< longest first
  std::vector<MeshDefect> nonManifoldEdges, inconsistentEdges, nonManifoldVertices, isolatedVertices;
  std::vector<MeshDefect> degenerateFaces;  ///< area ≤ 1e-12 × (longest edge)²
  std::vector<MeshDefect> duplicateFaces;   ///< the same three vertices as an earlier face

  [[nodiscard]] bool orientedManifold() const {
    return nonManifoldEdges.empty() && inconsistentEdges.empty() && nonManifoldVertices.empty();
  }
  /// "1 component, χ = 1, genus 0, 1 boundary loop" and the counts of defects, in one line.
  [[nodiscard]] std::string summary() const;
};

/// Examines a mesh. Never throws on defects: it lists them. O(m log m).
[[nodiscard]] MeshReport inspect(const TriangleMesh& mesh);
[[nodiscard]] MeshReport inspect(const TriangleMesh& mesh, const SurfaceTopology& topology);

}  // namespace authalic
