/// @file
/// Haker's conformal sphere: puncture a face, solve in the plane, lift by the stereographic projection.
#pragma once

#include "Core/base/Execution.h"
#include "Core/conformal/SphereLaplacian.h"
#include "Core/conformal/SphericalMapResult.h"

namespace authalic {

/// Inverse stereographic projection from (0, 0, 1): z ↦ (2x, 2y, |z|² − 1)/(1 + |z|²). @param plane  n×2
[[nodiscard]] Points3 liftToSphere(const Points2& plane);
/// Stereographic projection from (0, 0, 1); points there go to infinity.
[[nodiscard]] Points2 projectToPlane(const Points3& sphere);

/// The face that is nearest to equilateral; the smallest number where several are.
[[nodiscard]] int mostRegularFace(const TriangleMesh& surface);

struct StereographicSphereMapOptions {
  int puncturedFace = -1;        ///< face whose middle goes to the pole; −1: mostRegularFace
  double correctedShare = 0.95;  ///< share of the surface around the pole that the second solve places anew; 0: none
  SolverBackend solver = SolverBackend::Automatic;

  /// @throws InvalidArgument when a field is outside its range.
  void validate() const;
};

/// Solves Δz = (∂/∂x − i ∂/∂y) δ_p on the surface, p in the punctured face, and lifts z to the sphere.
///
/// The dipole makes z a conformal map to the plane with its pole at p @cite haker2000: one sparse solve. Where the
/// image is coarse, around p, the lifted map is poor; so the sphere is turned over and the part around p, bounded
/// by the vertices that hold `correctedShare` of the area, is solved once more in the other chart with its outer
/// vertices held
/// @cite choi2015 (whose Beltrami solver is, on the surface's own metric, this Dirichlet problem).
/// The image has its centre of mass at 0 (see normaliseSphere), without a rotation.
///
/// Guarantees: the start of every other road: no iteration, no parameter. Faces may fold → `flippedFaces`.
/// `history`: empty. Complexity: two sparse factorisations, O(n^1.5).
/// @throws InvalidArgument when an option is bad
/// @throws SolverError     when the surface is too degenerate to factorise
/// @throws CancelledError  when the caller stops before there is an image
[[nodiscard]] SphericalMapResult stereographicSphereMap(const SphereMesh& sphere,
                                                        const StereographicSphereMapOptions& options = {},
                                                        const Execution& execution = {});

/// A planar image of a punctured sphere, lifted so that the surface has its centre of mass at 0 (see
/// normaliseSphere).
/// @param plane  n×2 of any place and size; clockwise, as the sphere is seen from outside with the pole at infinity
[[nodiscard]] Points3 liftCentred(const TriangleMesh& surface, Points2 plane);

/// The first solve alone, with a Laplacian that is already factorised: n×3 on the sphere, centre of mass at 0.
[[nodiscard]] Points3 dipoleSphereMap(const SphereMesh& sphere, const SphereLaplacian& laplacian, int puncturedFace);

}  // namespace authalic
