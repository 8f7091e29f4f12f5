/// @file
/// The exact authalic solve on the sphere.
#pragma once

#include "Core/authalic/AuthalicMap.h"
#include "Core/mesh/SphereMesh.h"

namespace authalic {

struct SphericalAuthalicMapResult : AuthalicSolution {
  Points3 image;  ///< n×3 on the unit sphere; vertices in the order of the input; shares are those of solid angles
};

/// Maps a genus-0 surface to the unit sphere so that every vertex star has its target solid angle, as authalicMap().
///
/// Areas are solid angles, which tile the sphere exactly; every vertex moves along its tangent plane. The start is
/// made of two disks on two caps (see twoCapsStart in authalic/), or is `initial`; where caps stay folded, as those of
/// a few dozen faces may, it is the conformal map. The rotation is the one that brings the image closest to the
/// surface (SphereRotation::Surface).
///
/// @param initial  n×3 on the unit sphere, or empty. One whose areas are far from their targets (a conformal map of a
///                 cortex) only decides where the two disks meet.
/// @param systems  for several targets on one surface, as authalicMap()
/// Guarantees and failures as authalicMap(); the start of a surface that folds on the sphere beyond repair is
/// refused.
/// @throws InvalidArgument from options; GeometryError when initial or target do not belong to the surface, or
///         no start without a fold was found; SolverError when a system cannot be factorised
/// @cite zou2011 @cite su2019
[[nodiscard]] SphericalAuthalicMapResult sphericalAuthalicMap(const SphereMesh& sphere,
                                                              const TargetMeasure& target,
                                                              const AuthalicMapOptions& options = {},
                                                              const Points3& initial = {},
                                                              const Execution& execution = {},
                                                              AnalysedSystems* systems = nullptr);

}  // namespace authalic
