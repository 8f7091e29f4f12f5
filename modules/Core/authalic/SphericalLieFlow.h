/// @file
/// The discrete Lie flow and Lie advection on the sphere.
#pragma once

#include "Core/authalic/DiscreteLieFlow.h"
#include "Core/authalic/LieAdvection.h"
#include "Core/mesh/SphereMesh.h"

namespace authalic {

struct SphericalLieFlowResult : LieFlowSolution {
  Points3 image;  ///< n×3 on the unit sphere; vertices in the order of the input; shares are those of solid angles
};

/// Flows a spherical map of a closed surface of genus 0 until every vertex star has its target solid angle.
///
/// As discreteLieFlow(), with solid angles as areas: L h = A_Ω − A_M on the flat faces through the image's points,
/// edges flipped until those are the convex hull; a vertex moves by λ times the tangential part of the averaged ∇h
/// and is put back on the sphere. λ is bounded by the first zero of the signed volumes det(a, b, c), a cubic per
/// face, and halved where putting back folds a face @cite su2019. The finish is that of discreteLieFlow() with
/// tangential unknowns; folds of the original faces are unfolded in patches (unfoldOnSphere), and where some stay the
/// finish begins at the start (`flowUndone`).
///
/// @param initial  n×3 on the unit sphere, or empty: the conformal map (stereographicSphereMap). Where some star
///                 of it has less than e⁻⁸ or more than e⁸ of its share, two balanced caps take its place
///                 (twoCapsStart in authalic/, `balancedStart`)
/// @param target   shares per face, from TargetMeasure for this surface
///
/// The rotation is the one that brings the image closest to the surface (SphereRotation::Surface).
/// Guarantees: with finish ≠ None no folded face, whatever the status; points of length 1 to 1e-15. Not guaranteed:
/// that the tolerance is reached (→ status, residual). Complexity: one sparse factorisation per step, O(n^1.5).
/// When cancelled, the last valid iterate is returned with Status::Cancelled.
/// @throws InvalidArgument from options; GeometryError when initial or target do not belong to the surface, or no
///         start without a fold was found; SolverError when a system cannot be factorised
[[nodiscard]] SphericalLieFlowResult sphericalLieFlow(const SphereMesh& sphere, const TargetMeasure& target,
                                                      const DiscreteLieFlowOptions& options = {},
                                                      const Points3& initial = {}, const Execution& execution = {});

struct SphericalLieAdvectionResult : LieAdvectionSolution {
  Points3 image;               ///< n×3 on the unit sphere; vertices in the order of the input
  bool balancedStart = false;  ///< as LieFlowSolution::balancedStart
};

/// Advects the area form of the sphere to that of the surface in K steps, as lieAdvection() @cite zou2011, with
/// solid angles as areas and motion as in sphericalLieFlow(). Start, rotation and failures are those of
/// sphericalLieFlow(); with `unfold` folded faces are unfolded in patches, and those that stay are counted.
[[nodiscard]] SphericalLieAdvectionResult sphericalLieAdvection(const SphereMesh& sphere, const TargetMeasure& target,
                                                                const LieAdvectionOptions& options = {},
                                                                const Points3& initial = {},
                                                                const Execution& execution = {});

}  // namespace authalic
