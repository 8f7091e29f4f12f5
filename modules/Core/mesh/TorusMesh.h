/// @file
/// A mesh that is known to be a topological torus: the checked input type of toroidal maps.
#pragma once

#include "Core/mesh/SurfaceTopology.h"
#include "Core/mesh/TriangleMesh.h"

namespace authalic {

/// A connected, oriented, manifold surface of genus 1 without boundary and without isolated vertices.
class TorusMesh {
 public:
  /// @throws TopologyError naming what was found and where (mm), and what to do about it.
  explicit TorusMesh(TriangleMesh mesh);

  [[nodiscard]] const TriangleMesh& mesh() const noexcept { return mesh_; }
  [[nodiscard]] const SurfaceTopology& topology() const noexcept { return topology_; }

 private:
  TriangleMesh mesh_;
  SurfaceTopology topology_;
};

}  // namespace authalic
