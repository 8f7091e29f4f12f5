/// @file
/// The shortest loop around or through a handle.
#pragma once

#include <vector>

#include "Core/base/Execution.h"
#include "Core/mesh/SurfaceTopology.h"
#include "Core/mesh/TriangleMesh.h"

namespace authalic {

/// A closed walk along edges that does not separate the surface.
struct NonSeparatingLoop {
  std::vector<int> vertices;  ///< in order, each once; empty when there is none
  double length = 0;          ///< mm
};

/// The shortest closed walk of edges through vertices off the boundary that is not a boundary modulo 2 of the surface
/// with its boundary loops capped: cutting along it leaves the component in one piece and lowers the genus by one.
///
/// A tree of shortest paths and a tree of the dual that avoids it leave 2g edges, whose loops generate the homology
/// @cite erickson2005. Dual loops through the same edges say of any walk whether it is trivial. A non-trivial one
/// meets a generator, so shortest paths from the vertices of the generators find the shortest of all; they are grown to
/// half the length of the best loop so far.
///
/// Guarantees: exact up to genus 32; above, the shortest among the loops that are crossed by one of the 64 shortest
/// generators' duals. Empty on genus 0, and on a surface so coarse that every such loop touches the boundary.
/// Single-threaded, deterministic. O(m log m) per vertex on a generator at worst.
///
/// @param topology  of `mesh`: manifold, oriented; any number of components
/// @throws CancelledError
[[nodiscard]] NonSeparatingLoop shortestHandleLoop(const TriangleMesh& mesh, const SurfaceTopology& topology,
                                                   const Execution& execution = {});

}  // namespace authalic
