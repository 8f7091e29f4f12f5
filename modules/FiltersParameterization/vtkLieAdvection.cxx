#include "vtkLieAdvection.h"

#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>

#include "Conversion.h"
#include "Core/authalic/LieAdvection.h"
#include "Core/initial/BarycentricMap.h"
#include "Core/mesh/DiskMesh.h"
#include "LieFlowReport.h"
#include "MapArrays.h"

vtkStandardNewMacro(vtkLieAdvection);

static_assert(static_cast<int>(authalic::BarycentricWeights::MeanValue) == vtkLieAdvection::MEAN_VALUE);

vtkLieAdvection::vtkLieAdvection() {
  this->SetNumberOfInputPorts(2);
  const authalic::LieAdvectionOptions defaults;
  this->NumberOfSteps = defaults.steps;
  this->Unfold = defaults.unfold;
}

int vtkLieAdvection::FillInputPortInformation(int port, vtkInformation* info) {
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  if (port == 1) info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

void vtkLieAdvection::Compute(vtkInformationVector** inputs, vtkInformationVector* outputs,
                              const authalic::Execution& execution) {
  vtkPolyData* input = vtkPolyData::GetData(inputs[0]);
  vtkPolyData* given = vtkPolyData::GetData(inputs[1]);
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  authalic::LieAdvectionOptions options;
  options.domain = this->MakeDomain();
  options.steps = this->NumberOfSteps;
  options.unfold = this->Unfold;
  const authalic::DiskMesh disk(authalic::toTriangleMesh(input));
  const authalic::TargetMeasure target = authalic::targetMeasureOf(input, disk.mesh(), this->MeasureArrayName);
  authalic::BarycentricMapOptions start;
  start.weights = static_cast<authalic::BarycentricWeights>(this->InitialMethod);
  start.domain = options.domain;
  const authalic::Points2 initial = given ? authalic::toPlanarPoints(given)
                                          : authalic::barycentricMap(disk, start, execution.part(0.0, 0.05)).image;
  const authalic::LieAdvectionResult advection =
      authalic::lieAdvection(disk, initial, target, options, execution.part(0.05, 1.0));
  const authalic::Distortion distortion =
      authalic::fillMap(input, output, disk.mesh(), advection.image, target.shares());
  authalic::MapReport report = authalic::describeLieAdvection(advection, output);
  report.metrics = distortion.summary;
  report.topology = authalic::inspect(disk.mesh(), disk.topology());
  report.options = this->DescribeOptions();
  report.options.set("initial", given ? "given" : authalic::barycentricWeightsName(start.weights));
  report.options.set("steps", options.steps);
  report.options.set("unfold", options.unfold);
  this->Publish(output, report);
}

void vtkLieAdvection::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "InitialMethod: " << this->InitialMethod << "\n";
  os << indent << "NumberOfSteps: " << this->NumberOfSteps << "\n";
  os << indent << "Unfold: " << (this->Unfold ? "On" : "Off") << "\n";
}
