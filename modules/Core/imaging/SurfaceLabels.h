/// @file
/// Labels of a volume carried to the vertices of a surface.
#pragma once

#include <cstdint>
#include <vector>

#include "Core/base/Execution.h"
#include "Core/imaging/Volume.h"
#include "Core/mesh/TriangleMesh.h"

namespace authalic {

/// For every vertex the label of the nearest labelled voxel centre within `maxDistance` mm, 0 where there is
/// none. Among equally near voxels the first in scan order wins. A white surface lies inside the grey matter
/// that atlases label: 2–5 mm is a useful reach.
///
/// O(vertices · voxels within reach).
/// @param maxDistance  mm, in (0, 50]
/// @throws InvalidArgument for a distance out of range
[[nodiscard]] std::vector<std::int32_t> labelsOnSurface(const TriangleMesh& mesh, const LabelVolume& labels,
                                                        double maxDistance, const Execution& execution = {});

}  // namespace authalic
