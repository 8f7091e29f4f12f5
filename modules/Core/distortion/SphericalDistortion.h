/// @file
/// How much a map to the unit sphere changes areas and angles.
#pragma once

#include "Core/distortion/Distortion.h"

namespace authalic {

/// The arrays and numbers of Distortion for an image on the sphere, and what only a sphere has.
///
/// A face of the image is two things: a spherical triangle, whose area is its solid angle (these tile the sphere
/// exactly), and a flat triangle through the same corners. They differ by O(h²). `arrays` and `summary` take areas from
/// solid angles, and angles, σ and μ from flat triangles, whose affine face maps have them.
struct SphericalDistortion {
  DistortionArrays arrays;
  DistortionSummary summary;          ///< areas: solid angles; angles: flat triangles
  DistortionSummary flatSummary;      ///< areas and angles of flat triangles
  double sphericalAngleError = 0;     ///< mean |angle of the spherical triangle − surface angle| over corners, degrees
  double coverage = 0;                ///< Σ solid angles / 4π, signed as the majority: 1 for a homeomorphism
  int flippedBySolidAngle = 0;        ///< faces whose solid angle is not positive against the majority
  int flippedByVolume = 0;            ///< faces whose signed volume is not positive against the majority
};

/// Measures a map to the unit sphere on its own connectivity. O(m).
///
/// @param surface  mesh with n vertices (mm) and m faces
/// @param image    n×3 on the unit sphere, to 1e-6
/// @param target   m target measures (any scale, ≥ 0), or empty for the surface areas
/// @throws GeometryError when a point is not on the sphere, sizes do not match, the surface has no area, or a target is
///         negative or not finite
///
/// A face counts as flipped against the orientation that most faces have. Solid angle and signed volume agree on the
/// sign of every face by definition; both are counted, as a check.
/// @cite nadeem2017 (appendix), @cite vanoosterom1983
[[nodiscard]] SphericalDistortion measureSphericalDistortion(const TriangleMesh& surface, const Points3& image,
                                                             const Eigen::VectorXd& target = {});

/// SphericalDistortion::summary alone, in half the time.
/// @throws GeometryError as measureSphericalDistortion()
[[nodiscard]] DistortionSummary summariseSphericalDistortion(const TriangleMesh& surface, const Points3& image,
                                                             const Eigen::VectorXd& target = {});

/// An image on a sphere of any radius around 0, along its radii onto the unit sphere: files of other programs hold
/// spheres of radius 100 whose single-precision points lie off it by 1e-4.
/// @throws GeometryError when a radius differs from their mean by more than 1 in 1,000, or the mean is 0 or not finite
[[nodiscard]] Points3 ontoUnitSphere(const Points3& image);

}  // namespace authalic
