#include "vtkCircleDomainMap.h"

#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include "BoundaryLoops.h"
#include "CircleArrays.h"
#include "ConformalReport.h"
#include "Conversion.h"
#include "Core/base/Error.h"
#include "Core/conformal/CircleDomainMap.h"
#include "MapArrays.h"

vtkStandardNewMacro(vtkCircleDomainMap);

static_assert(static_cast<int>(authalic::CircleDomainRoad::Koebe) == vtkCircleDomainMap::KOEBE);

vtkCircleDomainMap::vtkCircleDomainMap() {
  const authalic::CircleDomainOptions defaults;
  this->RoundnessTolerance = defaults.roundness;
  this->MaximumRounds = defaults.maxRounds;
}

void vtkCircleDomainMap::Compute(vtkInformationVector** inputs, vtkInformationVector* outputs,
                                 const authalic::Execution& execution) {
  vtkPolyData* input = vtkPolyData::GetData(inputs[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  const authalic::PolyAnnulusMesh surface(authalic::toTriangleMesh(input));
  authalic::CircleDomainOptions options;
  options.road = static_cast<authalic::CircleDomainRoad>(this->Road);
  options.outerLoop = authalic::loopOf(surface.loops(), this->OuterVertex);
  options.roundness = this->RoundnessTolerance;
  options.maxRounds = this->MaximumRounds;
  options.normalisation = this->Normalisation();
  options.refine = this->Refine;
  options.unfold = this->Unfold;
  options.flow = this->FlowOptions();
  const authalic::TargetMeasure target = authalic::targetMeasureOf(input, surface.mesh(), this->MeasureArrayName);
  const authalic::CircleDomainResult result = authalic::circleDomainMap(surface, options, execution);
  if (result.status == authalic::Status::Cancelled) throw authalic::CancelledError();
  const authalic::Distortion distortion =
      result.refinement ? authalic::fillRefinedMap(input, output, *result.refinement)
                        : authalic::fillMap(input, output, surface.mesh(), result.image, target.shares());
  authalic::MapReport report = authalic::describeConformalMap("circle-domain", result, output);
  authalic::addCircles(result.circles, output, report);
  if (result.logScale.size() > 0 && !result.refinement) {
    authalic::addArray(output->GetPointData(), "LogScaleFactor", result.logScale);
  }
  authalic::addField(output, "OuterLoop", result.outerLoop);
  authalic::addField(output, "Roundness", result.roundness);
  authalic::addField(output, "Pockets", result.pockets);
  report.more.set("outer_loop", result.outerLoop)
      .set("roundness", result.roundness)
      .set("pockets", result.pockets)
      .set("rounds", result.rounds);
  report.metrics = distortion.summary;
  report.topology = authalic::inspect(surface.mesh(), surface.topology());
  report.options = this->DescribeDisk("circle-domain");
  report.options.set("road", authalic::circleDomainRoadName(options.road)).set("outer_vertex", this->OuterVertex);
  if (this->Road == KOEBE) {
    report.options.set("roundness_tolerance", options.roundness).set("max_rounds", options.maxRounds);
  }
  this->Publish(output, report);
}

void vtkCircleDomainMap::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Road: " << this->Road << "\n";
  os << indent << "OuterVertex: " << this->OuterVertex << "\n";
  os << indent << "RoundnessTolerance: " << this->RoundnessTolerance << "\n";
  os << indent << "MaximumRounds: " << this->MaximumRounds << "\n";
}
