/// @file
/// A mesh that is known to be a topological disk: the checked input type of every disk map.
#pragma once

#include <vector>

#include "Core/mesh/SurfaceTopology.h"
#include "Core/mesh/TriangleMesh.h"

namespace authalic {

/// A connected, oriented, manifold surface of genus 0 with exactly one boundary loop and no isolated vertex.
class DiskMesh {
 public:
  /// @throws TopologyError naming what was found and where (mm), and what to do about it.
  explicit DiskMesh(TriangleMesh mesh);

  [[nodiscard]] const TriangleMesh& mesh() const noexcept { return mesh_; }
  [[nodiscard]] const SurfaceTopology& topology() const noexcept { return topology_; }
  /// Vertices of the boundary loop, surface to the left, starting at the smallest vertex id.
  [[nodiscard]] const std::vector<int>& boundary() const { return topology_.boundaryLoops().front(); }

 private:
  TriangleMesh mesh_;
  SurfaceTopology topology_;
};

}  // namespace authalic
