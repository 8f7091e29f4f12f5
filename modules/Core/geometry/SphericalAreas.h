/// @file
/// Areas of triangles whose corners lie on the unit sphere: solid angles, flat triangles, signed volumes.
#pragma once

#include <Eigen/Core>

#include "Core/base/Arrays.h"

namespace authalic {

/// Signed solid angle of the spherical triangle a b c seen from the origin, in (−2π, 2π); positive when a, b, c run
/// counter-clockwise seen from outside. Its sides are the short great circles, so that it lies within a hemisphere.
///
/// tan(Ω/2) = det(a, b, c) / (1 + a·b + b·c + c·a) @cite vanoosterom1983, the determinant from the edge vectors at a,
/// so that it is exact to rounding of the *edge* lengths also for the smallest triangles.
/// @param a, b, c  unit vectors
[[nodiscard]] double signedSolidAngle(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c);

/// Six times the signed volume of the tetrahedron (0, a, b, c): det(a, b − a, c − a). Its sign is that of the solid
/// angle.
[[nodiscard]] double signedDeterminant(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c);

/// Solid angle of every face, steradians. For a homeomorphic image of a topological sphere they sum to 4π. O(m).
/// @param points  n×3 unit vectors
/// @param faces   m×3
[[nodiscard]] Eigen::VectorXd signedSolidAngles(const Points3& points, const Faces& faces);

/// Area of every flat triangle through three points of the sphere, with the sign of its solid angle. O(m).
[[nodiscard]] Eigen::VectorXd signedChordAreas(const Points3& points, const Faces& faces);

/// Faces of a spherical image whose signed volume is not positive: folded, or without area.
[[nodiscard]] int countFlippedOnSphere(const Points3& points, const Faces& faces);

/// @throws GeometryError naming the first row that is not finite or whose length differs from 1 by more than 1e-6
void requireOnUnitSphere(const Points3& points);

}  // namespace authalic
