/// @file
/// What a repair changed, as JSON.
#pragma once

#include <string>
#include <vector>

#include "Core/topology/SurfaceRepair.h"
#include "Reports/Json.h"

namespace authalic {

/// Members, in this order: version, status, rounds, changed, changes (per kind that occurred: count and `first`, a list
/// of ids of the input, place_mm, and length_mm or area_mm2 where the kind has one), remaining, topology (of the
/// result) and options. Lists are cut after `mostChanges` entries, that of handles is not; the counts are of all.
[[nodiscard]] Json repairReport(const SurfaceRepair& repair, const SurfaceRepairOptions& options,
                                std::size_t mostChanges = 100);

/// "3 handles cut and capped: 41.2 mm at (1, 2, 3) mm, …": one text per kind that occurred, in the order of kinds, with
/// the first few places.
[[nodiscard]] std::vector<std::string> repairLines(const SurfaceRepair& repair, std::size_t mostPlaces = 5);

}  // namespace authalic
