/// @file
/// Where to put the cones of a flat metric. Private to conformal/.
#pragma once

#include <vector>

#include "Core/mesh/HighGenusMesh.h"
#include "Core/numerics/SparseSolver.h"

namespace authalic {

struct Cone {
  int vertex;
  double curvature;  ///< −π/2 or π/2
};

/// Greedy choice of vertices that hold the curvature 2πχ of a surface in quarter turns.
///
/// With K̄ the curvature of the cones so far and the rest spread evenly over the area, L u = K̄ − K gives the scale
/// factors of that metric to first order. A cone of negative curvature shrinks what is around it, one of positive
/// curvature widens it @cite benchen2008: the next one of −π/2 goes where u is largest, until there are 4|χ|. Then
/// pairs of opposite cones follow, the positive one where u is least (tips of protrusions), while the standard
/// deviation of u is more than 0.25: as many as take two hundredths off it each, up to sixteen together where one by
/// one they do not (a finger asks for several). Cones keep two edges apart while there is room; negative ones like
/// vertices with seven faces, positive ones those with five. The first one is negative.
/// O(n^1.5 + count · n log n)
/// @throws GeometryError when the surface has fewer vertices than it needs cones
[[nodiscard]] std::vector<Cone> placeCones(const HighGenusMesh& surface, SolverBackend backend);

}  // namespace authalic
