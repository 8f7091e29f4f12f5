/// @file
/// Where to put the cones of a flat metric. Private to conformal/.
#pragma once

#include <vector>

#include "Core/mesh/HighGenusMesh.h"
#include "Core/numerics/SparseSolver.h"

namespace authalic {

/// Greedy choice of `count` vertices that share the curvature 2πχ of a surface in equal parts.
///
/// With K̄ the curvature of the cones so far and the rest spread evenly over the area, L u = K̄ − K gives the scale
/// factors of that metric to first order; the next cone goes where u is largest, for a cone of negative curvature
/// shrinks what is around it @cite benchen2008. Cones keep two edges apart and stand on vertices with at least five
/// faces, while there are such. O(n^1.5 + count · n log n)
[[nodiscard]] std::vector<int> placeCones(const HighGenusMesh& surface, int count, SolverBackend backend);

}  // namespace authalic
