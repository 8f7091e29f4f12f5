#include "vtkStretchEnergyMap.h"

#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>

#include "Conversion.h"
#include "Core/authalic/StretchEnergyMap.h"
#include "Core/initial/BarycentricMap.h"
#include "Core/mesh/DiskMesh.h"
#include "FieldArrays.h"
#include "MapArrays.h"
#include "Reports/MapReport.h"

vtkStandardNewMacro(vtkStretchEnergyMap);

static_assert(static_cast<int>(authalic::BarycentricWeights::MeanValue) == vtkStretchEnergyMap::MEAN_VALUE);
static_assert(static_cast<int>(authalic::StretchEnergyBoundary::Held) == vtkStretchEnergyMap::HELD);

namespace {

authalic::MapReport describe(const authalic::StretchEnergyMapResult& result) {
  authalic::MapReport report;
  report.method = "stretch-energy";
  report.status = result.status;
  report.iterations = result.iterations;
  report.residuals = result.history;
  report.residuals.push_back(result.residual);
  report.seconds = {{"map", result.seconds}};
  report.more.set("residual", result.residual);
  return report;
}

}  // namespace

vtkStretchEnergyMap::vtkStretchEnergyMap() {
  this->SetNumberOfInputPorts(2);
  const authalic::StretchEnergyMapOptions defaults;
  this->Boundary = static_cast<int>(defaults.boundary);
  this->Tolerance = defaults.tolerance;
  this->MaximumIterations = defaults.maxIterations;
}

int vtkStretchEnergyMap::FillInputPortInformation(int port, vtkInformation* info) {
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  if (port == 1) info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

void vtkStretchEnergyMap::Compute(vtkInformationVector** inputs, vtkInformationVector* outputs,
                                  const authalic::Execution& execution) {
  vtkPolyData* input = vtkPolyData::GetData(inputs[0]);
  vtkPolyData* given = vtkPolyData::GetData(inputs[1]);
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  authalic::StretchEnergyMapOptions options;
  options.domain = this->MakeDomain();
  options.boundary = static_cast<authalic::StretchEnergyBoundary>(this->Boundary);
  options.tolerance = this->Tolerance;
  options.maxIterations = this->MaximumIterations;
  const authalic::DiskMesh disk(authalic::toTriangleMesh(input));
  const authalic::TargetMeasure target = authalic::targetMeasureOf(input, disk.mesh(), this->MeasureArrayName);
  authalic::BarycentricMapOptions start;
  start.weights = static_cast<authalic::BarycentricWeights>(this->InitialMethod);
  start.domain = options.domain;
  const authalic::Points2 initial = given ? authalic::toPlanarPoints(given)
                                          : authalic::barycentricMap(disk, start, execution.part(0.0, 0.05)).image;
  const authalic::StretchEnergyMapResult result =
      authalic::stretchEnergyMap(disk, initial, target, options, execution.part(0.05, 1.0));
  authalic::MapReport report = describe(result);
  report.metrics = authalic::fillMap(input, output, disk.mesh(), result.image, target.shares()).summary;
  report.topology = authalic::inspect(disk.mesh(), disk.topology());
  report.options = this->DescribeOptions();
  report.options.set("initial", given ? "given" : authalic::barycentricWeightsName(start.weights));
  report.options.set("boundary", authalic::stretchEnergyBoundaryName(options.boundary));
  report.options.set("tolerance", options.tolerance);
  report.options.set("max_iterations", options.maxIterations);
  this->Publish(output, report);
}

void vtkStretchEnergyMap::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "InitialMethod: " << this->InitialMethod << "\n";
  os << indent << "Boundary: " << this->Boundary << "\n";
  os << indent << "Tolerance: " << this->Tolerance << "\n";
  os << indent << "MaximumIterations: " << this->MaximumIterations << "\n";
}
