/// @file
/// A mesh that is known to be closed with two handles or more: the checked input type of maps to flat cone surfaces.
#pragma once

#include "Core/mesh/SurfaceTopology.h"
#include "Core/mesh/TriangleMesh.h"

namespace authalic {

/// A connected, oriented, manifold surface of genus ≥ 2 without boundary and without isolated vertices.
class HighGenusMesh {
 public:
  /// @throws TopologyError naming what was found and where (mm), and what to do about it.
  explicit HighGenusMesh(TriangleMesh mesh);

  [[nodiscard]] const TriangleMesh& mesh() const noexcept { return mesh_; }
  [[nodiscard]] const SurfaceTopology& topology() const noexcept { return topology_; }
  [[nodiscard]] int genus() const noexcept { return 1 - topology_.eulerCharacteristic() / 2; }

 private:
  TriangleMesh mesh_;
  SurfaceTopology topology_;
};

}  // namespace authalic
