#include "vtkAuthalicMap.h"

#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>

#include "Conversion.h"
#include "Core/authalic/AuthalicMap.h"
#include "Core/mesh/DiskMesh.h"
#include "FieldArrays.h"
#include "MapArrays.h"
#include "Reports/MapReport.h"

vtkStandardNewMacro(vtkAuthalicMap);

namespace {

authalic::MapReport describe(const authalic::AuthalicMapResult& result) {
  authalic::MapReport report;
  report.method = "authalic";
  report.status = result.status;
  report.iterations = result.iterations;
  int vertexSteps = 0;
  for (const authalic::AuthalicIteration& step : result.history) {
    report.residuals.push_back(step.residual);
    vertexSteps += step.exact;
  }
  report.residuals.push_back(result.vertexResidual);
  report.seconds = {{"start", result.startSeconds}, {"faces", result.faceSeconds}, {"vertices", result.vertexSeconds}};
  report.more.set("face_residual", result.faceResidual);
  report.more.set("vertex_residual", result.vertexResidual);
  report.more.set("vertex_steps", vertexSteps);
  return report;
}

}  // namespace

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
  const authalic::Points2 initial = given ? authalic::toPlanarPoints(given) : authalic::Points2();
  const authalic::AuthalicMapResult result = authalic::authalicMap(disk, target, options, initial, execution);
  authalic::MapReport report = describe(result);
  report.metrics = authalic::fillMap(input, output, disk.mesh(), result.image, target.faces()).summary;
  report.topology = authalic::inspect(disk.mesh(), disk.topology());
  report.options = this->DescribeOptions();
  report.options.set("initial", given ? "given" : "tutte");
  report.options.set("tolerance", this->Tolerance);
  report.options.set("vertex_tolerance", this->VertexTolerance);
  report.options.set("max_iterations", this->MaximumIterations);
  authalic::addField(output, "FaceResidual", result.faceResidual);
  authalic::addField(output, "VertexResidual", result.vertexResidual);
  this->Publish(output, report);
}

void vtkAuthalicMap::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Tolerance: " << this->Tolerance << "\n";
  os << indent << "VertexTolerance: " << this->VertexTolerance << "\n";
  os << indent << "MaximumIterations: " << this->MaximumIterations << "\n";
}
