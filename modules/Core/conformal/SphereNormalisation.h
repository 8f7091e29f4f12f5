/// @file
/// Fixes what a conformal map to the sphere leaves free: the six parameters of its Möbius transformation.
#pragma once

#include "Core/base/Arrays.h"
#include "Core/base/Status.h"
#include "Core/mesh/TriangleMesh.h"
#include "Core/numerics/SphereMobius.h"

namespace authalic {

/// How the rotation is fixed once the centre of mass lies at 0.
enum class SphereRotation {
  Surface,        ///< the rotation that brings the image closest to the surface: least Σ m_i |R y_i − s (p_i − p̄)|²
  PrincipalAxes,  ///< axes of Σ m_i y_i y_iᵀ to z (largest), x, y; the signs of z and x such that Σ m_i (y_i·e)³ > 0
  Landmarks,      ///< one vertex to the north pole (0, 0, 1), another to the half-plane y = 0, x > 0
  None,           ///< none: the centring translation alone
};

/// "surface", "principal-axes", "landmarks", "none".
[[nodiscard]] const char* sphereRotationName(SphereRotation rotation) noexcept;

struct SphereNormalisationOptions {
  SphereRotation rotation = SphereRotation::Surface;
  int northVertex = -1;      ///< Landmarks: goes to (0, 0, 1)
  int meridianVertex = -1;   ///< Landmarks: goes to y = 0, x > 0
  double tolerance = 1e-12;  ///< of |Σ m_i y_i| / Σ m_i
  int maxIterations = 100;

  /// @throws InvalidArgument when a field is outside its range, or landmarks are missing or superfluous.
  void validate() const;
};

struct SphereNormalisation {
  Points3 image;                   ///< n×3 on the unit sphere
  SphereMobius map;                ///< what was applied
  Status status = Status::NotRun;  ///< of the centring
  int iterations = 0;
  double residual = 0;             ///< |Σ m_i y_i| / Σ m_i of `image`
};

/// Moves a spherical image by the Möbius transformation that puts its centre of mass at 0, and rotates it.
///
/// The mass m_i of a vertex is a third of the areas of its faces **on the surface**, not on the sphere: Σ m_i y_i
/// is the discrete ∫ f dA of @cite gu2004, the zero-mass-centre condition. By it and the rotation two conformal
/// images of one surface become comparable. A Möbius transformation changes no angle, but a mesh sees it at its
/// vertices only: where faces are very coarse on the sphere one may fold; count the flips of the result.
///
/// Surface and PrincipalAxes commute with similarities and renumbering of the surface. They are not unique where the
/// surface has symmetries (the sphere itself): then the outcome is deterministic, but small changes may turn it.
///
/// @param surface  n vertices (mm)
/// @param image    n×3 on the unit sphere
/// @throws InvalidArgument when an option is bad, or a landmark is not a vertex
/// @throws GeometryError when sizes do not match, a point is off the sphere, the surface has no area, or the two
///         landmarks lie at the same or at opposite points
/// Complexity O(n) per iteration; 4 to 10 iterations.
[[nodiscard]] SphereNormalisation normaliseSphere(const TriangleMesh& surface, const Points3& image,
                                                  const SphereNormalisationOptions& options = {});

/// |Σ m_i y_i| / Σ m_i of an image as it is. O(n).
[[nodiscard]] double centreOfMassDistance(const TriangleMesh& surface, const Points3& image);

/// The rotation alone, for images whose Möbius transformation is not free: nothing but isometries of the sphere.
/// @throws as normaliseSphere
[[nodiscard]] Points3 rotateSphere(const TriangleMesh& surface, const Points3& image,
                                   const SphereNormalisationOptions& options = {});

}  // namespace authalic
