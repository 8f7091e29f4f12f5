/// @file
/// The part of a hemisphere's surface that is no cortex.
#pragma once

#include <vector>

#include "Core/base/Execution.h"
#include "Core/imaging/Volume.h"
#include "Core/mesh/TriangleMesh.h"

namespace authalic {

/// Vertices within `reach` mm of a source voxel: a filled structure, or white matter that belongs to the
/// other hemisphere or the hindbrain. There the surface follows a cut or a filling, not a border of grey and
/// white matter.
///
/// The set is then made one clean region: its border is smoothed by repeated averaging over neighbours, its
/// largest component (by area) is kept, and of the complement the largest component too, the others joining
/// the region.
/// @param sources  1 = source voxel
/// @return 1 per vertex of the region; all 0 when there is none
[[nodiscard]] std::vector<char> findMedialWall(const TriangleMesh& mesh, const MaskVolume& sources,
                                               double reach, const Execution& execution = {});

/// Area in mm² of a vertex region: a third of every face for each of its vertices inside.
[[nodiscard]] double regionArea(const TriangleMesh& mesh, const std::vector<char>& region);

}  // namespace authalic
