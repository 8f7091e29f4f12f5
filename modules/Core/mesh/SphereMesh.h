/// @file
/// A mesh that is known to be a topological sphere: the checked input type of every spherical map.
#pragma once

#include "Core/mesh/SurfaceTopology.h"
#include "Core/mesh/TriangleMesh.h"

namespace authalic {

/// A connected, oriented, manifold surface of genus 0 without boundary and without isolated vertices.
class SphereMesh {
 public:
  /// @throws TopologyError naming what was found and where (mm), and what to do about it.
  explicit SphereMesh(TriangleMesh mesh);

  [[nodiscard]] const TriangleMesh& mesh() const noexcept { return mesh_; }
  [[nodiscard]] const SurfaceTopology& topology() const noexcept { return topology_; }

 private:
  TriangleMesh mesh_;
  SurfaceTopology topology_;
};

}  // namespace authalic
