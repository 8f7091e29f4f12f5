/// @file
/// The check behind the mesh types DiskMesh, SphereMesh, AnnulusMesh, PolyAnnulusMesh, TorusMesh and HighGenusMesh.
/// Private to mesh/.
#pragma once

#include <limits>

#include "Core/mesh/SurfaceTopology.h"
#include "Core/mesh/TriangleMesh.h"

namespace authalic {

/// A connected, oriented, manifold surface without isolated vertices, how many boundary loops it may have, and its
/// genus.
struct RequiredTopology {
  const char* words;  ///< "A topological disk is required (1 component, genus 0, 1 boundary loop)"
  std::size_t fewestLoops, mostLoops;
  int genus = 0;
  int mostGenus = genus;
};

inline constexpr int kAnyGenus = std::numeric_limits<int>::max();

inline constexpr std::size_t kAnyNumberOfLoops = std::numeric_limits<std::size_t>::max();

/// @throws TopologyError naming what is required, what was found and where (mm), and what to do about it.
void requireTopology(const TriangleMesh& mesh, const SurfaceTopology& topology, const RequiredTopology& required);

}  // namespace authalic
