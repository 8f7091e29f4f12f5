#include "vtkYamabeMap.h"

#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include "ConformalArrays.h"
#include "Conversion.h"
#include "Core/base/Error.h"
#include "Core/mesh/DiskMesh.h"
#include "FieldArrays.h"
#include "MapArrays.h"

vtkStandardNewMacro(vtkYamabeMap);

void vtkYamabeMap::Compute(vtkInformationVector** inputs, vtkInformationVector* outputs,
                           const authalic::Execution& execution) {
  vtkPolyData* input = vtkPolyData::GetData(inputs[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  authalic::YamabeMapOptions options;
  options.flow = this->FlowOptions();
  options.startVertex = this->StartVertex;
  options.refine = this->Refine;
  options.unfold = this->Unfold;
  const authalic::DiskMesh disk(authalic::toTriangleMesh(input));
  const authalic::TargetMeasure target = authalic::targetMeasureOf(input, disk.mesh(), this->MeasureArrayName);
  if (!this->CurvatureArrayName.empty()) {
    options.curvature = authalic::toVector(
        authalic::requireArray(input->GetPointData(), this->CurvatureArrayName, 1, "target curvature"));
  }
  const authalic::YamabeMapResult map = authalic::yamabeMap(disk, options, execution);
  if (map.image.rows() == 0) throw authalic::CancelledError();
  const authalic::Distortion distortion = authalic::fillMap(input, output, disk.mesh(), map.image, target.faces());
  authalic::MapReport report = authalic::describeFlowMap(map, output);
  authalic::fillRefinement(map.refinement, output, vtkPolyData::GetData(outputs, 1), report);
  authalic::addArray(output->GetPointData(), "Curvature", map.curvature);
  authalic::addField(output, "AddedVertices", map.addedVertices);
  report.method = "yamabe";
  report.metrics = distortion.summary;
  report.topology = authalic::inspect(disk.mesh(), disk.topology());
  report.options = this->DescribeOptions();
  report.options.set("curvature", this->CurvatureArrayName);
  report.more.set("added_vertices", map.addedVertices);
  this->Publish(output, report);
}

void vtkYamabeMap::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "CurvatureArrayName: " << this->CurvatureArrayName << "\n";
}
