#include "vtkRiemannMap.h"

#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>

#include "ConformalArrays.h"
#include "Conversion.h"
#include "Core/base/Error.h"
#include "Core/mesh/DiskMesh.h"
#include "FieldArrays.h"
#include "MapArrays.h"

vtkStandardNewMacro(vtkRiemannMap);

static_assert(static_cast<int>(authalic::RiemannRoad::Puncture) == vtkRiemannMap::PUNCTURE);
static_assert(static_cast<int>(authalic::DiskCentre::Vertex) == vtkRiemannMap::VERTEX);
static_assert(static_cast<int>(authalic::DiskCentre::Face) == vtkRiemannMap::FACE);

vtkRiemannMap::vtkRiemannMap() {
  const authalic::RiemannMapOptions defaults;
  this->Road = static_cast<int>(defaults.road);
  this->Puncture = defaults.puncture;
  this->Centre = static_cast<int>(defaults.normalisation.centre);
  this->CentreId = defaults.normalisation.centreId;
  this->StartVertex = defaults.normalisation.startVertex;
  this->Refine = defaults.refine;
  this->Unfold = defaults.unfold;
}

authalic::RiemannMapOptions vtkRiemannMap::Options() const {
  authalic::RiemannMapOptions options;
  options.road = static_cast<authalic::RiemannRoad>(this->Road);
  options.puncture = this->Puncture;
  options.normalisation.centre = static_cast<authalic::DiskCentre>(this->Centre);
  options.normalisation.centreId = this->CentreId;
  options.normalisation.startVertex = this->StartVertex;
  options.refine = this->Refine;
  options.unfold = this->Unfold;
  options.flow = this->FlowOptions();
  return options;
}

void vtkRiemannMap::Compute(vtkInformationVector** inputs, vtkInformationVector* outputs,
                            const authalic::Execution& execution) {
  vtkPolyData* input = vtkPolyData::GetData(inputs[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  const authalic::RiemannMapOptions options = this->Options();
  const authalic::DiskMesh disk(authalic::toTriangleMesh(input));
  const authalic::TargetMeasure target = authalic::targetMeasureOf(input, disk.mesh(), this->MeasureArrayName);
  const authalic::RiemannMapResult map = authalic::riemannMap(disk, options, execution);
  if (map.image.rows() == 0) throw authalic::CancelledError();
  const authalic::Distortion distortion = authalic::fillMap(input, output, disk.mesh(), map.image, target.faces());
  authalic::MapReport report = authalic::describeFlowMap(map, output);
  authalic::fillRefinement(map.refinement, output, vtkPolyData::GetData(outputs, 1), report);
  authalic::addField(output, "Roundness", map.roundness);
  report.method = "riemann";
  report.metrics = distortion.summary;
  report.topology = authalic::inspect(disk.mesh(), disk.topology());
  report.options = this->DescribeOptions();
  report.options.set("road", authalic::riemannRoadName(options.road));
  if (options.road == authalic::RiemannRoad::Puncture) report.options.set("puncture", this->Puncture);
  report.options.set("centre", authalic::diskCentreName(options.normalisation.centre));
  if (this->Centre != AREA_CENTROID) report.options.set("centre_id", this->CentreId);
  report.more.set("roundness", map.roundness);
  this->Publish(output, report);
}

void vtkRiemannMap::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Road: " << this->Road << "\n";
  os << indent << "Puncture: " << this->Puncture << "\n";
  os << indent << "Centre: " << this->Centre << "\n";
  os << indent << "CentreId: " << this->CentreId << "\n";
}
