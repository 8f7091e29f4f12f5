/// @file
/// Arcs of the unit circle that leave room for what stands on them. Private to authalic/.
#pragma once

#include "Core/authalic/TargetMeasure.h"
#include "Core/initial/BoundaryPlacement.h"
#include "Core/mesh/DiskMesh.h"

namespace authalic {

/// Moves the boundary vertices of a placement on the circle until no arc is too short for what stands on it.
///
/// An ear, a face with two edges on the boundary, is inscribed in the circle: over arcs α, β its area is about
/// αβ(α + β)/4, so that its share m of the disk needs arcs near (2π m)^⅓; and its derivatives vanish with its area,
/// which pins any flow that starts from arcs in proportion to lengths. Both arcs of an ear get at least that, every
/// other arc at least a hundredth of the mean; the rest shrink in proportion. Where these together would take more
/// than half of the circle, they are shortened in proportion.
///
/// A piece that an inner edge between two boundary vertices cuts off, with at most a tenth of the area, goes to a
/// segment of the circle, of area (α − sin α)/2: its arcs together get at least 2 (2π m)^⅓, of which (12π m)^⅓ is
/// just enough, in proportion to what they have. O(number of faces, and of arcs of pieces in pieces)
void makeRoomOnCircle(const DiskMesh& disk, const TargetMeasure& target, BoundaryPlacement& placement);

}  // namespace authalic
