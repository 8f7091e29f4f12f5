#include "Core/conformal/SphericalConformalMap.h"

#include <chrono>
#include <string>
#include <utility>

#include "Core/base/Error.h"
#include "Core/conformal/SphereStarts.h"
#include "Core/conformal/UnfoldOnSphere.h"
#include "Core/geometry/SphericalAreas.h"

namespace authalic {
namespace {

Points3 harmonicStart(const SphereMesh& sphere, const SphereLaplacian& laplacian,
                      const SphericalConformalMapOptions& options) {
  if (options.start == HarmonicStart::GaussMap) return gaussSphereMap(sphere);
  const int face = options.puncturedFace < 0 ? mostRegularFace(sphere.mesh()) : options.puncturedFace;
  if (options.start == HarmonicStart::Tutte) return tutteSphereMap(sphere, face, options.solver);
  return dipoleSphereMap(sphere, laplacian, face);
}

SphericalMapResult byRoad(const SphereMesh& sphere, const SphericalConformalMapOptions& options,
                          const Execution& execution) {
  if (options.road == SphereRoad::MeanCurvatureFlow) {
    ConformalizedMeanCurvatureFlowOptions flow = options.flow;
    flow.solver = options.solver;
    return conformalizedMeanCurvatureFlow(sphere, flow, execution);
  }
  if (options.road == SphereRoad::Stereographic) {
    StereographicSphereMapOptions stereographic = options.stereographic;
    stereographic.solver = options.solver;
    stereographic.puncturedFace = options.puncturedFace;
    return stereographicSphereMap(sphere, stereographic, execution);
  }
  const SphereLaplacian laplacian(sphere, options.solver);
  execution.throwIfCancelled();
  return harmonicSphereMap(sphere, laplacian, harmonicStart(sphere, laplacian, options), options.harmonic, execution);
}

void normalise(const SphereMesh& sphere, const SphereNormalisationOptions& options, SphericalMapResult& result) {
  SphereNormalisation normal = normaliseSphere(sphere.mesh(), result.image, options);
  result.image = std::move(normal.image);
  result.centreOfMass = normal.residual;
  result.flippedFaces = countFlippedOnSphere(result.image, sphere.mesh().faces());
}

}  // namespace

const char* sphereRoadName(SphereRoad road) noexcept {
  switch (road) {
    case SphereRoad::Harmonic: return "harmonic";
    case SphereRoad::Stereographic: return "stereographic";
    case SphereRoad::MeanCurvatureFlow: return "mean-curvature-flow";
  }
  return "harmonic";
}

const char* harmonicStartName(HarmonicStart start) noexcept {
  switch (start) {
    case HarmonicStart::Dipole: return "dipole";
    case HarmonicStart::Tutte: return "tutte";
    case HarmonicStart::GaussMap: return "gauss-map";
  }
  return "dipole";
}

void SphericalConformalMapOptions::validate() const {
  if (puncturedFace < -1 || stereographic.puncturedFace != -1) {
    throw InvalidArgument("A punctured face of at least -1, given once, is required, but it is " +
                          std::to_string(puncturedFace) + " and for the stereographic road " +
                          std::to_string(stereographic.puncturedFace) + ".");
  }
  if (!SparseSolver::available(solver)) {
    throw InvalidArgument("A solver that is part of this build is required, but " +
                          std::string(solverBackendName(solver)) + " was not built in.");
  }
  harmonic.validate();
  stereographic.validate();
  flow.validate();
  normalisation.validate();
}

SphericalMapResult sphericalConformalMap(const SphereMesh& sphere, const SphericalConformalMapOptions& options,
                                         const Execution& execution) {
  options.validate();
  if (options.puncturedFace >= sphere.mesh().faceCount()) {
    throw InvalidArgument("A punctured face below " + std::to_string(sphere.mesh().faceCount()) +
                          " is required, but it is " + std::to_string(options.puncturedFace) + ".");
  }
  const auto start = std::chrono::steady_clock::now();
  execution.report(0, sphereRoadName(options.road));
  SphericalMapResult result = byRoad(sphere, options, execution.part(0, 0.95));
  result.flippedBeforeUnfolding = result.flippedFaces;
  if (options.unfold && result.flippedFaces > 0) {
    SphereUnfolding unfolded = unfoldOnSphere(sphere, std::move(result.image));
    result.image = std::move(unfolded.image);
    result.unfoldedVertices = unfolded.movedVertices;
  }
  normalise(sphere, options.normalisation, result);
  if (result.status == Status::Converged && result.flippedFaces > 0) result.status = Status::Stalled;
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  execution.report(1, sphereRoadName(options.road));
  return result;
}

}  // namespace authalic
