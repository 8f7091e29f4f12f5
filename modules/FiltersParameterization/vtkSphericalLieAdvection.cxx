#include "vtkSphericalLieAdvection.h"

#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>

#include "Conversion.h"
#include "Core/authalic/SphericalLieFlow.h"
#include "Core/mesh/SphereMesh.h"
#include "LieFlowReport.h"
#include "MapArrays.h"

vtkStandardNewMacro(vtkSphericalLieAdvection);

vtkSphericalLieAdvection::vtkSphericalLieAdvection() {
  this->SetNumberOfInputPorts(2);
  const authalic::LieAdvectionOptions defaults;
  this->NumberOfSteps = defaults.steps;
  this->Unfold = defaults.unfold;
}

int vtkSphericalLieAdvection::FillInputPortInformation(int port, vtkInformation* info) {
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  if (port == 1) info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

void vtkSphericalLieAdvection::Compute(vtkInformationVector** inputs, vtkInformationVector* outputs,
                                       const authalic::Execution& execution) {
  vtkPolyData* input = vtkPolyData::GetData(inputs[0]);
  vtkPolyData* given = vtkPolyData::GetData(inputs[1]);
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  authalic::LieAdvectionOptions options;
  options.steps = this->NumberOfSteps;
  options.unfold = this->Unfold;
  const authalic::SphereMesh sphere(authalic::toTriangleMesh(input));
  const authalic::TargetMeasure target = authalic::targetMeasureOf(input, sphere.mesh(), this->MeasureArrayName);
  const authalic::Points3 initial = given ? authalic::toPoints(given) : authalic::Points3();
  const auto result = authalic::sphericalLieAdvection(sphere, target, options, initial, execution);
  const authalic::SphericalDistortion distortion =
      authalic::fillMap(input, output, sphere.mesh(), result.image, target.shares());
  authalic::MapReport report = authalic::describeLieAdvection(result, output);
  report.metrics = distortion.summary;
  report.topology = authalic::inspect(sphere.mesh(), sphere.topology());
  report.options.set("domain", "sphere");
  report.options.set("measure", this->MeasureArrayName);
  report.options.set("initial", result.balancedStart ? "two-caps" : given ? "given" : "stereographic");
  report.options.set("steps", options.steps);
  report.options.set("unfold", options.unfold);
  report.more.set("balanced_start", result.balancedStart);
  this->Publish(output, report);
}

void vtkSphericalLieAdvection::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfSteps: " << this->NumberOfSteps << "\n";
  os << indent << "Unfold: " << (this->Unfold ? "On" : "Off") << "\n";
}
