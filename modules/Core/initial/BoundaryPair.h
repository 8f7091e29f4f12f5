/// @file
/// Two boundary vertices of a disk that are far from each other: what free-boundary maps take for their gauge.
#pragma once

#include <array>

#include "Core/mesh/DiskMesh.h"

namespace authalic {

/// The two boundary vertices that are farthest apart in space: exact. Sorted by distance from the middle, so that most
/// pairs are skipped; O(b²) at worst, for a circle of b vertices.
[[nodiscard]] std::array<int, 2> farthestBoundaryPair(const DiskMesh& disk);

}  // namespace authalic
