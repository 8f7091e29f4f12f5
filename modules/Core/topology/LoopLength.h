/// @file
/// Lengths of boundary loops.
#pragma once

#include <vector>

#include "Core/mesh/TriangleMesh.h"

namespace authalic {

/// Sum of the edge lengths of a closed loop of vertices, mm.
[[nodiscard]] double loopLength(const TriangleMesh& mesh, const std::vector<int>& loop);

/// Index of the longest loop; of equals the first. Needs at least one.
[[nodiscard]] std::size_t longestLoop(const TriangleMesh& mesh, const std::vector<std::vector<int>>& loops);

}  // namespace authalic
