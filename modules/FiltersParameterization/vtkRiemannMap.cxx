#include "vtkRiemannMap.h"

#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include "ConformalReport.h"
#include "Conversion.h"
#include "Core/base/Error.h"
#include "Core/conformal/RiemannMap.h"
#include "MapArrays.h"

vtkStandardNewMacro(vtkRiemannMap);

static_assert(static_cast<int>(authalic::RiemannRoad::Puncture) == vtkRiemannMap::PUNCTURE);

void vtkRiemannMap::Compute(vtkInformationVector** inputs, vtkInformationVector* outputs,
                            const authalic::Execution& execution) {
  vtkPolyData* input = vtkPolyData::GetData(inputs[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  authalic::RiemannMapOptions options;
  options.road = static_cast<authalic::RiemannRoad>(this->Road);
  options.puncture = this->PuncturedFace;
  options.normalisation = this->Normalisation();
  options.refine = this->Refine;
  options.unfold = this->Unfold;
  options.flow = this->FlowOptions();
  const authalic::DiskMesh disk(authalic::toTriangleMesh(input));
  const authalic::TargetMeasure target = authalic::targetMeasureOf(input, disk.mesh(), this->MeasureArrayName);
  const authalic::RiemannMapResult result = authalic::riemannMap(disk, options, execution);
  if (result.status == authalic::Status::Cancelled) throw authalic::CancelledError();
  const authalic::Distortion distortion =
      result.refinement ? authalic::fillRefinedMap(input, output, *result.refinement)
                        : authalic::fillMap(input, output, disk.mesh(), result.image, target.shares());
  if (!result.refinement) authalic::addArray(output->GetPointData(), "LogScaleFactor", result.logScale);
  authalic::MapReport report = authalic::describeConformalMap("riemann", result, output);
  authalic::addField(output, "Roundness", result.roundness);
  report.more.set("roundness", result.roundness);
  report.metrics = distortion.summary;
  report.topology = authalic::inspect(disk.mesh(), disk.topology());
  report.options = this->DescribeDisk("disk");
  report.options.set("road", authalic::riemannRoadName(options.road)).set("punctured_face", options.puncture);
  this->Publish(output, report);
}

void vtkRiemannMap::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Road: " << this->Road << "\n";
  os << indent << "PuncturedFace: " << this->PuncturedFace << "\n";
}
