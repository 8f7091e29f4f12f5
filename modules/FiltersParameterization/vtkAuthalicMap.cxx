#include "vtkAuthalicMap.h"

#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>

#include "AuthalicReport.h"
#include "ConformalImages.h"
#include "Conversion.h"
#include "Core/geometry/Areas.h"
#include "Core/initial/BarycentricMap.h"
#include "Core/mesh/DiskMesh.h"
#include "FieldArrays.h"
#include "MapArrays.h"

vtkStandardNewMacro(vtkAuthalicMap);

static_assert(static_cast<int>(authalic::BarycentricWeights::MeanValue) == vtkAuthalicMap::MEAN_VALUE);

vtkAuthalicMap::vtkAuthalicMap() {
  this->SetNumberOfInputPorts(2);
  const authalic::AuthalicMapOptions defaults;
  this->Tolerance = defaults.tolerance;
  this->VertexTolerance = defaults.vertexTolerance;
  this->MaximumIterations = defaults.maxIterations;
}

int vtkAuthalicMap::FillInputPortInformation(int port, vtkInformation* info) {
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  if (port == 1) info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

authalic::AuthalicMapOptions vtkAuthalicMap::Options() const {
  authalic::AuthalicMapOptions options;
  options.domain = this->MakeDomain();
  options.tolerance = this->Tolerance;
  options.vertexTolerance = this->VertexTolerance;
  options.maxIterations = this->MaximumIterations;
  options.validate();
  return options;
}

void vtkAuthalicMap::Compute(vtkInformationVector** inputs, vtkInformationVector* outputs,
                             const authalic::Execution& execution) {
  vtkPolyData* input = vtkPolyData::GetData(inputs[0]);
  vtkPolyData* given = vtkPolyData::GetData(inputs[1]);
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  const authalic::AuthalicMapOptions options = this->Options();
  const authalic::DiskMesh disk(authalic::toTriangleMesh(input));
  const authalic::TargetMeasure target = authalic::targetMeasureOf(input, disk.mesh(), this->MeasureArrayName);
  authalic::BarycentricMapOptions start;
  start.weights = static_cast<authalic::BarycentricWeights>(this->InitialMethod);
  start.domain = options.domain;
  authalic::Points2 initial;  // empty: Core starts from Tutte's map
  authalic::TargetMeasure wanted = target;
  const authalic::Balance balance{this->Balance, this->BalanceArrayName};
  if (!balance.whole()) {
    initial = authalic::conformalImage(disk, this->Domain == DISK, "a balance below 1", false, execution.part(0, 0.1));
    const Eigen::VectorXd areas = authalic::signedFaceAreas(initial, disk.mesh().faces());
    wanted = authalic::balancedTarget(input, disk.mesh(), target, areas, balance);
  }
  if (given) initial = authalic::toPlanarPoints(given);
  else if (balance.whole() && this->InitialMethod != TUTTE) {
    initial = authalic::barycentricMap(disk, start, execution.part(0, 0.1)).image;
  }
  const authalic::AuthalicMapResult result =
      authalic::authalicMap(disk, wanted, options, initial, execution.part(0.1, 1));
  const authalic::Distortion distortion = authalic::fillMap(input, output, disk.mesh(), result.image, target.shares());
  authalic::MapReport report = authalic::describeAuthalicMap(result, output);
  report.metrics = distortion.summary;
  report.topology = authalic::inspect(disk.mesh(), disk.topology());
  report.options = this->DescribeOptions();
  const char* startName = balance.whole() ? authalic::barycentricWeightsName(start.weights) : "riemann";
  report.options.set("initial", given ? "given" : startName);
  authalic::describeBalance(balance, report.options, output);
  authalic::addAuthalicOptions(report.options, options);
  this->Publish(output, report);
}

void vtkAuthalicMap::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "InitialMethod: " << this->InitialMethod << "\n";
  os << indent << "Balance: " << this->Balance << "\n";
  os << indent << "BalanceArrayName: " << this->BalanceArrayName << "\n";
  os << indent << "Tolerance: " << this->Tolerance << "\n";
  os << indent << "VertexTolerance: " << this->VertexTolerance << "\n";
  os << indent << "MaximumIterations: " << this->MaximumIterations << "\n";
}
