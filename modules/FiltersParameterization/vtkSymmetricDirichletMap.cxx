#include "vtkSymmetricDirichletMap.h"

#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>

#include "Conversion.h"
#include "Core/initial/BarycentricMap.h"
#include "Core/initial/SymmetricDirichletMap.h"
#include "FieldArrays.h"
#include "MapArrays.h"
#include "Reports/MapReport.h"

vtkStandardNewMacro(vtkSymmetricDirichletMap);

static_assert(static_cast<int>(authalic::IsometricBoundary::Fixed) == vtkSymmetricDirichletMap::FIXED);

vtkSymmetricDirichletMap::vtkSymmetricDirichletMap() {
  this->SetNumberOfInputPorts(2);
  const authalic::SymmetricDirichletMapOptions defaults;
  this->Tolerance = defaults.tolerance;
  this->MaximumIterations = defaults.maxIterations;
}

int vtkSymmetricDirichletMap::FillInputPortInformation(int port, vtkInformation* info) {
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  if (port == 1) info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

void vtkSymmetricDirichletMap::Compute(vtkInformationVector** inputs, vtkInformationVector* outputs,
                                       const authalic::Execution& execution) {
  vtkPolyData* input = vtkPolyData::GetData(inputs[0]);
  vtkPolyData* given = vtkPolyData::GetData(inputs[1]);
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  authalic::SymmetricDirichletMapOptions options;
  options.boundary = static_cast<authalic::IsometricBoundary>(this->Boundary);
  options.tolerance = this->Tolerance;
  options.maxIterations = this->MaximumIterations;
  const authalic::DiskMesh disk(authalic::toTriangleMesh(input));
  const authalic::TargetMeasure target = authalic::targetMeasureOf(input, disk.mesh(), this->MeasureArrayName);
  authalic::BarycentricMapOptions start;
  start.weights = this->InitialMethod == TUTTE ? authalic::BarycentricWeights::Uniform
                                               : authalic::BarycentricWeights::MeanValue;
  const authalic::Points2 initial = given ? authalic::toPlanarPoints(given)
                                          : authalic::barycentricMap(disk, start, execution.part(0, 0.1)).image;
  const authalic::SymmetricDirichletMapResult result =
      authalic::symmetricDirichletMap(disk, initial, options, execution.part(0.1, 1));
  authalic::MapReport report;
  report.metrics = authalic::fillMap(input, output, disk.mesh(), result.image, target.shares()).summary;
  authalic::addField(output, "Energy", result.energy);
  report.method = "slim";
  report.status = result.status;
  report.iterations = result.iterations;
  for (const authalic::SymmetricDirichletIteration& step : result.history) report.residuals.push_back(step.decrement);
  report.residuals.push_back(result.residual);
  report.seconds = {{"map", result.seconds}};
  report.topology = authalic::inspect(disk.mesh(), disk.topology());
  report.options.set("domain", this->Boundary == FREE ? "free" : "disk")
      .set("measure", this->MeasureArrayName)
      .set("initial", given ? "given" : authalic::barycentricWeightsName(start.weights))
      .set("tolerance", options.tolerance)
      .set("max_iterations", options.maxIterations);
  report.more.set("energy", result.energy);
  this->Publish(output, report);
}

void vtkSymmetricDirichletMap::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Boundary: " << this->Boundary << "\n";
  os << indent << "InitialMethod: " << this->InitialMethod << "\n";
  os << indent << "Tolerance: " << this->Tolerance << "\n";
  os << indent << "MaximumIterations: " << this->MaximumIterations << "\n";
}
