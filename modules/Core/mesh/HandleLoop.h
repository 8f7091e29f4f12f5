/// @file
/// Where a surface has a handle. Private to mesh/.
#pragma once

#include <vector>

#include "Core/mesh/SurfaceTopology.h"
#include "Core/mesh/TriangleMesh.h"

namespace authalic {

/// A closed walk along edges around or through a handle, in order: the one with the fewest edges among 2g
/// generators of the closed surface (boundary loops capped) through one vertex @cite erickson2005, without the way
/// from there and back. Short, but not the shortest of all. Empty on genus 0.
/// @param topology  of `mesh`; connected, manifold, oriented
/// Complexity O(m log m).
[[nodiscard]] std::vector<int> handleLoop(const TriangleMesh& mesh, const SurfaceTopology& topology);

}  // namespace authalic
