#include "vtkSymmetricDirichletMap.h"

#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>

#include "Conversion.h"
#include "Core/initial/BarycentricMap.h"
#include "Core/initial/SymmetricDirichletMap.h"
#include "Core/mesh/DiskMesh.h"
#include "FieldArrays.h"
#include "MapArrays.h"
#include "Reports/MapReport.h"

vtkStandardNewMacro(vtkSymmetricDirichletMap);

static_assert(static_cast<int>(authalic::IsometricBoundary::Fixed) == vtkSymmetricDirichletMap::FIXED);
static_assert(static_cast<int>(authalic::BarycentricWeights::Harmonic) == vtkSymmetricDirichletMap::HARMONIC);
static_assert(static_cast<int>(authalic::BarycentricWeights::MeanValue) == vtkSymmetricDirichletMap::MEAN_VALUE);

vtkSymmetricDirichletMap::vtkSymmetricDirichletMap() {
  this->SetNumberOfInputPorts(2);
  const authalic::SymmetricDirichletMapOptions defaults;
  this->Boundary = static_cast<int>(defaults.boundary);
  this->Tolerance = defaults.tolerance;
  this->MaximumIterations = defaults.maxIterations;
}

int vtkSymmetricDirichletMap::FillInputPortInformation(int port, vtkInformation* info) {
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  if (port == 1) info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

authalic::SymmetricDirichletMapOptions vtkSymmetricDirichletMap::Options() const {
  authalic::SymmetricDirichletMapOptions options;
  options.boundary = static_cast<authalic::IsometricBoundary>(this->Boundary);
  options.tolerance = this->Tolerance;
  options.maxIterations = this->MaximumIterations;
  options.validate();
  return options;
}

authalic::BarycentricMapResult vtkSymmetricDirichletMap::Start(const authalic::DiskMesh& disk,
                                                               const authalic::Execution& execution) const {
  authalic::BarycentricMapOptions options;
  options.weights = static_cast<authalic::BarycentricWeights>(this->InitialMethod);
  options.domain = this->MakeDomain();
  return authalic::barycentricMap(disk, options, execution);
}

void vtkSymmetricDirichletMap::Compute(vtkInformationVector** inputs, vtkInformationVector* outputs,
                                       const authalic::Execution& execution) {
  vtkPolyData* input = vtkPolyData::GetData(inputs[0]);
  vtkPolyData* given = vtkPolyData::GetData(inputs[1]);
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  const authalic::SymmetricDirichletMapOptions options = this->Options();
  const authalic::DiskMesh disk(authalic::toTriangleMesh(input));
  const authalic::TargetMeasure target = authalic::targetMeasureOf(input, disk.mesh(), this->MeasureArrayName);
  authalic::BarycentricMapResult start;
  if (given) start.image = authalic::toPlanarPoints(given);
  else start = this->Start(disk, execution.part(0.0, 0.1));
  const authalic::SymmetricDirichletMapResult map =
      authalic::symmetricDirichletMap(disk, start.image, options, execution.part(0.1, 1.0));
  authalic::MapReport report;
  report.method = "slim";
  report.status = map.status;
  report.iterations = map.iterations;
  for (const authalic::SymmetricDirichletIteration& step : map.history) report.residuals.push_back(step.decrement);
  report.seconds = {{"initial", start.seconds}, {"descent", map.seconds}};
  report.metrics = authalic::fillMap(input, output, disk.mesh(), map.image, target.faces()).summary;
  report.topology = authalic::inspect(disk.mesh(), disk.topology());
  if (given) report.options.set("measure", this->MeasureArrayName);
  else report.options = this->DescribeOptions();
  report.options.set("boundary", authalic::isometricBoundaryName(options.boundary));
  const auto weights = static_cast<authalic::BarycentricWeights>(this->InitialMethod);
  report.options.set("initial", given ? "given" : authalic::barycentricWeightsName(weights));
  report.options.set("tolerance", this->Tolerance);
  report.options.set("max_iterations", this->MaximumIterations);
  report.more.set("isometric_energy", map.energy);
  report.more.set("residual", map.residual);
  authalic::addField(output, "IsometricEnergy", map.energy);
  this->Publish(output, report);
}

void vtkSymmetricDirichletMap::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Boundary: " << this->Boundary << "\n";
  os << indent << "InitialMethod: " << this->InitialMethod << "\n";
  os << indent << "Tolerance: " << this->Tolerance << "\n";
  os << indent << "MaximumIterations: " << this->MaximumIterations << "\n";
}
