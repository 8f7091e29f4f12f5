/// @file
/// A start for area-preserving maps to the sphere: two disks, each balanced, on two caps of their areas. Private to
/// authalic/.
#pragma once

#include "Core/authalic/TargetMeasure.h"
#include "Core/base/Execution.h"
#include "Core/mesh/SphereMesh.h"
#include "Core/numerics/SparseSolver.h"

namespace authalic {

/// A map to the unit sphere with areas within sight of their targets, from any spherical image of the surface.
///
/// The faces north of the image's equator, made connected and simple, and the rest are two disks with a common
/// boundary. Each is mapped to the unit disk (stretchStart; the boundary by arc length, the same for both), and that
/// disk to the cap that holds its share f of the target measure by Lambert's projection, cos θ = 1 − 2 f r²: areas come
/// out as they were balanced. Faces that the projection folds are unfolded and what that leaves narrow is opened; where
/// some stay folded, halves that fold less are tried, then other parallels than the equator and those of the other two
/// axes, and the start with the fewest folds is returned.
///
/// @param image       n×3 on the unit sphere, roughly injective
/// @param goodEnough  mean |ln r| of the stars, see balancedStart
[[nodiscard]] Points3 twoCapsStart(const SphereMesh& sphere, const Points3& image, const TargetMeasure& target,
                                   SolverBackend backend, double goodEnough, const Execution& execution = {});

}  // namespace authalic
