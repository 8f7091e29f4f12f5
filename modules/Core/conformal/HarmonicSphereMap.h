/// @file
/// Gu and Yau's conformal sphere: the harmonic map of degree 1.
#pragma once

#include "Core/base/Execution.h"
#include "Core/conformal/SphereLaplacian.h"
#include "Core/conformal/SphericalMapResult.h"

namespace authalic {

struct HarmonicSphereMapOptions {
  double tolerance = 1e-6;   ///< of the relative residual √(gᵀL⁺g / 2E), g the tangential part of Lf
  int maxIterations = 200;
  SolverBackend solver = SolverBackend::Automatic;

  /// @throws InvalidArgument when a field is outside its range.
  void validate() const;
};

/// Minimises the harmonic energy E(f) = ½ Σ_ij w_ij |f_i − f_j|² over maps to the unit sphere @cite gu2004: a
/// harmonic map of degree 1 between topological spheres is conformal.
///
/// At the minimum the tangential part of Lf vanishes at every vertex. Gradient descent needs thousands of steps; here
/// the gradient is taken in the H¹ metric, d = −L⁺ P Lf (P: onto the tangent planes), and conjugated (Polak–Ribière):
/// the Hessian on vector fields of degree l is 1 − 2/(l (l + 1)) of L, so that the steps do not depend on the mesh.
/// The three infinitesimal Möbius transformations are left out of gradient and steps, and the centre of mass of the
/// surface is brought back to 0 (see normaliseSphere) after every step: a discrete energy is not quite Möbius
/// invariant. One factorisation of L serves all.
///
/// @param start  n×3 on the unit sphere, of degree 1. From a start with few folds (stereographicSphereMap) the energy
///               unfolds the map; from a far one (gaussSphereMap) it takes some more steps.
/// Guarantees: the energy never rises, and the degree (how often the image covers the sphere) never changes from
/// step to step: where the faces are too coarse to hold a conformal map, the descent ends as Stalled. Faces may
/// fold where cotangent weights are negative → `flippedFaces`. `history`: the relative residual.
/// Complexity: one factorisation, one solve of three columns per iteration.
/// @throws InvalidArgument when an option is bad
/// @throws GeometryError   when the start is not on the sphere or has another number of points
/// @throws SolverError     when the surface is too degenerate to factorise
[[nodiscard]] SphericalMapResult harmonicSphereMap(const SphereMesh& sphere, const Points3& start,
                                                   const HarmonicSphereMapOptions& options = {},
                                                   const Execution& execution = {});

/// The same with a Laplacian that is already factorised.
[[nodiscard]] SphericalMapResult harmonicSphereMap(const SphereMesh& sphere, const SphereLaplacian& laplacian,
                                                   const Points3& start, const HarmonicSphereMapOptions& options = {},
                                                   const Execution& execution = {});

}  // namespace authalic
