/// @file
/// Boundary loops named by one of their vertices. Private to FiltersParameterization/.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "Core/base/Error.h"

namespace authalic {

/// Which loop a vertex is on; −1 for vertex −1.
/// @throws InvalidArgument when the vertex is on none
[[nodiscard]] inline int loopOf(const std::vector<std::vector<int>>& loops, int vertex) {
  if (vertex == -1) return -1;
  for (std::size_t k = 0; k < loops.size(); ++k) {
    if (std::find(loops[k].begin(), loops[k].end(), vertex) != loops[k].end()) return static_cast<int>(k);
  }
  throw InvalidArgument(
      "A vertex of a boundary loop, or -1 for the longest one, is required as the outer vertex, but vertex " +
      std::to_string(vertex) + " is on none of the " + std::to_string(loops.size()) + " loops.");
}

}  // namespace authalic
