/// @file
/// Arcs of the unit circle that leave room for the faces that stand on them. Private to authalic/.
#pragma once

#include "Core/authalic/TargetMeasure.h"
#include "Core/initial/BoundaryPlacement.h"
#include "Core/mesh/DiskMesh.h"

namespace authalic {

/// Moves the boundary vertices of a placement on the circle until no arc is too short for its face.
///
/// An ear, a face with two edges on the boundary, is inscribed in the circle: over arcs α, β its area is about
/// αβ(α + β)/4, so that its share m of the disk needs arcs near (2π m)^⅓; and its derivatives vanish with its area,
/// which pins any flow that starts from arcs in proportion to lengths. Both arcs of an ear get at least that, every
/// other arc at least a hundredth of the mean; the rest shrink in proportion. Where these together would take more
/// than half of the circle, they are shortened in proportion. O(number of faces)
void makeRoomOnCircle(const DiskMesh& disk, const TargetMeasure& target, BoundaryPlacement& placement);

}  // namespace authalic
