/// @file
/// A start without folds for maps to polygons that are not convex. Private to authalic/.
#pragma once

#include "Core/authalic/TargetMeasure.h"
#include "Core/base/Execution.h"
#include "Core/initial/BoundaryPlacement.h"
#include "Core/numerics/SparseSolver.h"

namespace authalic {

/// A map φ⁻¹ ∘ f of a disk to a polygon: f the surface's balanced map to the unit disk (balancedStart), φ that of a
/// triangulation of the polygon.
///
/// Both send the boundary to the circle by arc length of the polygon, so that the composition is a homeomorphism with
/// the boundary of `placement`, whatever the polygon, and its areas are about as near to their targets as those of f
/// and φ. The faces of the surface are straight only in the end: those that fold, where they are large against the
/// bend of φ⁻¹, are untangled; count the ones that are left. Where an edge of the surface cuts a corner that
/// points inwards, no map with this boundary is without folds.
/// Complexity: as balancedStart, for the surface and for a polygon of about as many faces.
[[nodiscard]] Points2 polygonStart(const DiskMesh& disk, const PlanarDomain& domain,
                                   const BoundaryPlacement& placement, const TargetMeasure& target,
                                   SolverBackend backend, const Execution& execution = {});

}  // namespace authalic
