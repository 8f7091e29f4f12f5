/// @file
/// Starts for the harmonic map to the sphere that do not look at angles.
#pragma once

#include "Core/mesh/SphereMesh.h"
#include "Core/numerics/SparseSolver.h"

namespace authalic {

/// Tutte's embedding @cite tutte1963 of the surface less one face, that face as the outer triangle, lifted to the
/// sphere with the surface's centre of mass at 0. Injective in the plane, whatever the angles.
/// @throws SolverError when the system cannot be factorised
[[nodiscard]] Points3 tutteSphereMap(const SphereMesh& sphere, int outerFace,
                                     SolverBackend solver = SolverBackend::Automatic);

/// Area-weighted vertex normals: the Gauss map, the start of @cite gu2004. Of degree 1, and folded wherever the
/// surface is not convex. A vertex whose normals cancel takes its direction from the centroid.
[[nodiscard]] Points3 gaussSphereMap(const SphereMesh& sphere);

}  // namespace authalic
