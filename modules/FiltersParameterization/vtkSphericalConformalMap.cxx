#include "vtkSphericalConformalMap.h"

#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>

#include "Conversion.h"
#include "Core/conformal/SphericalConformalMap.h"
#include "FieldArrays.h"
#include "MapArrays.h"
#include "Reports/MapReport.h"

vtkStandardNewMacro(vtkSphericalConformalMap);

using authalic::HarmonicStart;
using authalic::SphereRoad;
using authalic::SphereRotation;
static_assert(static_cast<int>(SphereRoad::Harmonic) == vtkSphericalConformalMap::HARMONIC);
static_assert(static_cast<int>(SphereRoad::Stereographic) == vtkSphericalConformalMap::STEREOGRAPHIC);
static_assert(static_cast<int>(SphereRoad::MeanCurvatureFlow) == vtkSphericalConformalMap::MEAN_CURVATURE_FLOW);
static_assert(static_cast<int>(SphereRoad::Welding) == vtkSphericalConformalMap::WELDING);
static_assert(static_cast<int>(HarmonicStart::Dipole) == vtkSphericalConformalMap::DIPOLE);
static_assert(static_cast<int>(HarmonicStart::Tutte) == vtkSphericalConformalMap::TUTTE);
static_assert(static_cast<int>(HarmonicStart::GaussMap) == vtkSphericalConformalMap::GAUSS_MAP);
static_assert(static_cast<int>(SphereRotation::Surface) == vtkSphericalConformalMap::TO_SURFACE);
static_assert(static_cast<int>(SphereRotation::PrincipalAxes) == vtkSphericalConformalMap::TO_PRINCIPAL_AXES);
static_assert(static_cast<int>(SphereRotation::Landmarks) == vtkSphericalConformalMap::TO_LANDMARKS);
static_assert(static_cast<int>(SphereRotation::None) == vtkSphericalConformalMap::NO_ROTATION);

namespace {

/// Tolerance and limit of the chosen road, for which each has a field of its own.
struct RoadLimits {
  double* tolerance;
  int* maxIterations;
};

RoadLimits limitsOf(authalic::SphericalConformalMapOptions& options) {
  switch (options.road) {
    case SphereRoad::MeanCurvatureFlow: return {&options.flow.tolerance, &options.flow.maxIterations};
    case SphereRoad::Welding:
      return {&options.welding.riemann.flow.tolerance, &options.welding.riemann.flow.maxIterations};
    case SphereRoad::Stereographic: return {nullptr, nullptr};
    case SphereRoad::Harmonic: break;
  }
  return {&options.harmonic.tolerance, &options.harmonic.maxIterations};
}

authalic::Json describe(authalic::SphericalConformalMapOptions options, const std::string& measure) {
  authalic::Json json = authalic::Json::object();
  json.set("domain", "sphere").set("measure", measure).set("initial", authalic::sphereRoadName(options.road));
  const RoadLimits limits = limitsOf(options);
  if (limits.tolerance) json.set("tolerance", *limits.tolerance).set("max_iterations", *limits.maxIterations);
  if (options.road == SphereRoad::Harmonic) json.set("harmonic_start", authalic::harmonicStartName(options.start));
  json.set("punctured_face", options.puncturedFace);
  if (options.road == SphereRoad::Stereographic) json.set("corrected_share", options.stereographic.correctedShare);
  if (options.road == SphereRoad::MeanCurvatureFlow) json.set("time_step", options.flow.timeStep);
  json.set("unfold", options.unfold);
  const authalic::SphereNormalisationOptions& normal = options.normalisation;
  json.set("rotation", authalic::sphereRotationName(normal.rotation));
  if (normal.rotation != SphereRotation::Landmarks) return json;
  return json.set("landmarks", authalic::Json::array().add(normal.northVertex).add(normal.meridianVertex));
}

}  // namespace

vtkSphericalConformalMap::vtkSphericalConformalMap() {
  const authalic::SphericalConformalMapOptions defaults;
  this->InitialMethod = static_cast<int>(defaults.road);
  this->HarmonicStart = static_cast<int>(defaults.start);
  this->PuncturedFace = defaults.puncturedFace;
  this->CorrectedShare = defaults.stereographic.correctedShare;
  this->TimeStep = defaults.flow.timeStep;
  this->Unfold = defaults.unfold;
  this->Rotation = static_cast<int>(defaults.normalisation.rotation);
  this->NorthVertex = defaults.normalisation.northVertex;
  this->MeridianVertex = defaults.normalisation.meridianVertex;
}

authalic::SphericalConformalMapOptions vtkSphericalConformalMap::Options() const {
  authalic::SphericalConformalMapOptions options;
  options.road = static_cast<SphereRoad>(this->InitialMethod);
  options.start = static_cast<authalic::HarmonicStart>(this->HarmonicStart);
  options.puncturedFace = this->PuncturedFace;
  options.stereographic.correctedShare = this->CorrectedShare;
  options.flow.timeStep = this->TimeStep;
  const RoadLimits limits = limitsOf(options);
  if (limits.tolerance && this->Tolerance != 0) *limits.tolerance = this->Tolerance;
  if (limits.maxIterations && this->MaximumIterations >= 0) *limits.maxIterations = this->MaximumIterations;
  options.unfold = this->Unfold;
  options.normalisation.rotation = static_cast<SphereRotation>(this->Rotation);
  options.normalisation.northVertex = this->NorthVertex;
  options.normalisation.meridianVertex = this->MeridianVertex;
  options.validate();
  return options;
}

void vtkSphericalConformalMap::Compute(vtkInformationVector** inputs, vtkInformationVector* outputs,
                                       const authalic::Execution& execution) {
  vtkPolyData* input = vtkPolyData::GetData(inputs[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  const authalic::SphericalConformalMapOptions options = this->Options();
  const authalic::SphereMesh sphere(authalic::toTriangleMesh(input));
  const authalic::TargetMeasure target = authalic::targetMeasureOf(input, sphere.mesh(), this->MeasureArrayName);
  const authalic::SphericalMapResult map = authalic::sphericalConformalMap(sphere, options, execution);
  const authalic::SphericalDistortion distortion =
      authalic::fillMap(input, output, sphere.mesh(), map.image, target.shares());
  authalic::MapReport report;
  report.method = options.road == SphereRoad::Welding ? "welding" : "sphere";
  report.status = map.status;
  report.iterations = map.iterations;
  report.residuals = map.history;
  report.seconds = {{"map", map.seconds}};
  report.metrics = distortion.summary;
  report.topology = authalic::inspect(sphere.mesh(), sphere.topology());
  report.options = describe(options, this->MeasureArrayName);
  report.more.set("centre_of_mass", map.centreOfMass)
      .set("flipped_before_unfolding", map.flippedBeforeUnfolding)
      .set("unfolded_vertices", map.unfoldedVertices)
      .set("sphere", authalic::sphericalDistortionReport(distortion));
  authalic::addField(output, "InitialMethod", std::string(authalic::sphereRoadName(options.road)));
  authalic::addField(output, "CentreOfMass", map.centreOfMass);
  authalic::addField(output, "FlippedBeforeUnfolding", map.flippedBeforeUnfolding);
  authalic::addField(output, "UnfoldedVertices", map.unfoldedVertices);
  this->Publish(output, report);
}

void vtkSphericalConformalMap::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "InitialMethod: " << this->InitialMethod << "\n";
  os << indent << "HarmonicStart: " << this->HarmonicStart << "\n";
  os << indent << "PuncturedFace: " << this->PuncturedFace << "\n";
  os << indent << "CorrectedShare: " << this->CorrectedShare << "\n";
  os << indent << "TimeStep: " << this->TimeStep << "\n";
  os << indent << "Tolerance: " << this->Tolerance << "\n";
  os << indent << "MaximumIterations: " << this->MaximumIterations << "\n";
  os << indent << "Unfold: " << (this->Unfold ? "On" : "Off") << "\n";
  os << indent << "Rotation: " << this->Rotation << "\n";
  os << indent << "NorthVertex: " << this->NorthVertex << "\n";
  os << indent << "MeridianVertex: " << this->MeridianVertex << "\n";
}
