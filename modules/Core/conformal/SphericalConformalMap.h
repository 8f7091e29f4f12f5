/// @file
/// The conformal map of a topological sphere to the unit sphere, by one of several roads.
#pragma once

#include "Core/base/Execution.h"
#include "Core/conformal/ConformalizedMeanCurvatureFlow.h"
#include "Core/conformal/HarmonicSphereMap.h"
#include "Core/conformal/SphereNormalisation.h"
#include "Core/conformal/SphericalMapResult.h"
#include "Core/conformal/StereographicSphereMap.h"
#include "Core/mesh/SphereMesh.h"

namespace authalic {

/// Roads to the same map; they agree up to a Möbius transformation as meshes refine.
enum class SphereRoad {
  Harmonic,           ///< least harmonic energy @cite gu2004: accurate, fast, the default
  Stereographic,      ///< dipole and second pole @cite haker2000 @cite choi2015: two linear solves, no iteration
  MeanCurvatureFlow,  ///< conformalized mean curvature flow @cite kazhdan2012: a factorisation per step
};

/// "harmonic", "stereographic", "mean-curvature-flow".
[[nodiscard]] const char* sphereRoadName(SphereRoad road) noexcept;

/// Where the harmonic road starts; it ends at the same map.
enum class HarmonicStart {
  Dipole,    ///< the first solve of the stereographic road
  Tutte,     ///< tutteSphereMap
  GaussMap,  ///< gaussSphereMap
};

/// "dipole", "tutte", "gauss-map".
[[nodiscard]] const char* harmonicStartName(HarmonicStart start) noexcept;

struct SphericalConformalMapOptions {
  SphereRoad road = SphereRoad::Harmonic;
  HarmonicStart start = HarmonicStart::Dipole;
  int puncturedFace = -1;  ///< stereographic road, dipole and Tutte starts; −1: mostRegularFace
  bool unfold = true;      ///< repair folded faces (see unfoldOnSphere)
  HarmonicSphereMapOptions harmonic;
  StereographicSphereMapOptions stereographic;
  ConformalizedMeanCurvatureFlowOptions flow;
  SphereNormalisationOptions normalisation;
  SolverBackend solver = SolverBackend::Automatic;  ///< of all stages

  /// @throws InvalidArgument when a field of this or of the chosen road is outside its range.
  void validate() const;
};

/// Maps a genus-0 surface conformally to the unit sphere, repairs folds, and fixes the Möbius transformation.
///
/// The conformal map between two spheres exists and is unique up to Möbius transformations (uniformisation). After the
/// chosen road, faces that it folded are unfolded in small patches, and the map is normalised: the surface's centre of
/// mass at 0, then the rotation (see normaliseSphere). What is folded in the end is counted in `flippedFaces`,
/// and the status is then Stalled, not Converged.
///
/// A coarse triangulation is not conformally mappable face by face: the mean angle error cannot be below
/// Σ_v |angle defect_v| / (3 m), because around every vertex of the image the angles sum to nearly 2π.
///
/// @throws InvalidArgument when an option is bad
/// @throws SolverError     when the surface is too degenerate to factorise
/// @throws CancelledError  when the caller stops before there is an image
[[nodiscard]] SphericalMapResult sphericalConformalMap(const SphereMesh& sphere,
                                                       const SphericalConformalMapOptions& options = {},
                                                       const Execution& execution = {});

}  // namespace authalic
