/// @file
/// A mesh that is known to have genus 0 and a boundary: the checked input type of circle domains.
#pragma once

#include <vector>

#include "Core/mesh/SurfaceTopology.h"
#include "Core/mesh/TriangleMesh.h"

namespace authalic {

/// A connected, oriented, manifold surface of genus 0 with at least one boundary loop and no isolated vertex.
class PolyAnnulusMesh {
 public:
  /// @throws TopologyError naming what was found and where (mm), and what to do about it.
  explicit PolyAnnulusMesh(TriangleMesh mesh);

  [[nodiscard]] const TriangleMesh& mesh() const noexcept { return mesh_; }
  [[nodiscard]] const SurfaceTopology& topology() const noexcept { return topology_; }
  /// Boundary loops, surface to the left, each starting at its smallest vertex id; the one with the smallest id first.
  [[nodiscard]] const std::vector<std::vector<int>>& loops() const noexcept { return topology_.boundaryLoops(); }

 private:
  TriangleMesh mesh_;
  SurfaceTopology topology_;
};

}  // namespace authalic
