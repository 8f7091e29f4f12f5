/// @file
/// The zero surface of a scalar field on a voxel lattice, with the topology of its digital object.
#pragma once

#include "Core/base/Execution.h"
#include "Core/imaging/Volume.h"
#include "Core/mesh/TriangleMesh.h"

namespace authalic {

/// Surface between the voxels with value > 0 (inside) and the others.
///
/// Vertices lie on the lattice edges whose ends differ in side, at the zero of the linear interpolant
/// t = f0 / (f0 − f1), clamped to [0.01, 0.99] so that no two vertices coincide, and mapped to mm by
/// `voxelToWorld`.
///
/// Guarantees: a closed manifold whose components, handles and cavities are those of the object under the
/// 14-adjacency of SimplePoint.h (see LatticeSurfaceTable.h for why); a collapsible object gives one sphere,
/// χ = 2. Faces are counter-clockwise seen from outside, also when the affine mirrors. Not guaranteed: that
/// pieces inside one cube never intersect when a tube runs along its diagonal.
///
/// @param field  NaN counts as outside; the outermost layer must be outside
/// @throws InvalidArgument when nothing, or a voxel of the outermost layer, is inside; CancelledError
/// @cite lorensen1987 @cite kuhn1960
[[nodiscard]] TriangleMesh extractIsosurface(const ScalarVolume& field, const Execution& execution = {});

}  // namespace authalic
