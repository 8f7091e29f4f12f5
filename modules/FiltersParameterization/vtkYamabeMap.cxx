#include "vtkYamabeMap.h"

#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include "ConformalReport.h"
#include "Conversion.h"
#include "Core/base/Error.h"
#include "Core/conformal/YamabeMap.h"
#include "MapArrays.h"

vtkStandardNewMacro(vtkYamabeMap);

void vtkYamabeMap::Compute(vtkInformationVector** inputs, vtkInformationVector* outputs,
                           const authalic::Execution& execution) {
  vtkPolyData* input = vtkPolyData::GetData(inputs[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  authalic::YamabeMapOptions options;
  if (!this->CurvatureArrayName.empty()) {
    options.curvature = authalic::toVector(
        authalic::requireArray(input->GetPointData(), this->CurvatureArrayName, 1, "target curvature"));
  }
  options.startVertex = this->StartVertex;
  options.refine = this->Refine;
  options.unfold = this->Unfold;
  options.flow = this->FlowOptions();
  const authalic::DiskMesh disk(authalic::toTriangleMesh(input));
  const authalic::TargetMeasure target = authalic::targetMeasureOf(input, disk.mesh(), this->MeasureArrayName);
  const authalic::YamabeMapResult result = authalic::yamabeMap(disk, options, execution);
  if (result.status == authalic::Status::Cancelled) throw authalic::CancelledError();
  const authalic::Distortion distortion =
      result.refinement ? authalic::fillRefinedMap(input, output, *result.refinement)
                        : authalic::fillMap(input, output, disk.mesh(), result.image, target.shares());
  if (!result.refinement) {
    authalic::addArray(output->GetPointData(), "LogScaleFactor", result.logScale);
    authalic::addArray(output->GetPointData(), "Curvature", result.curvature);
  }
  authalic::MapReport report = authalic::describeConformalMap("yamabe", result, output);
  report.more.set("added_vertices", result.addedVertices).set("degenerate_faces_of_the_flow", result.degenerateFaces);
  report.metrics = distortion.summary;
  report.topology = authalic::inspect(disk.mesh(), disk.topology());
  report.options = this->DescribeFlow(this->CurvatureArrayName.empty() ? "disk" : "free");
  report.options.set("curvature", this->CurvatureArrayName)
      .set("start_vertex", this->StartVertex)
      .set("refine", this->Refine);
  this->Publish(output, report);
}

void vtkYamabeMap::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "CurvatureArrayName: " << this->CurvatureArrayName << "\n";
  os << indent << "StartVertex: " << this->StartVertex << "\n";
  os << indent << "Refine: " << (this->Refine ? "On" : "Off") << "\n";
}
