#include "vtkCircleDomainMap.h"

#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>

#include "ConformalArrays.h"
#include "Conversion.h"
#include "Core/base/Error.h"
#include "FieldArrays.h"
#include "MapArrays.h"

vtkStandardNewMacro(vtkCircleDomainMap);

static_assert(static_cast<int>(authalic::CircleDomainRoad::Koebe) == vtkCircleDomainMap::KOEBE);
static_assert(static_cast<int>(authalic::DiskCentre::Vertex) == vtkCircleDomainMap::VERTEX);
static_assert(static_cast<int>(authalic::DiskCentre::Face) == vtkCircleDomainMap::FACE);

namespace {

void describeLoops(const authalic::CircleDomainResult& result, vtkPolyData* map, authalic::MapReport& report) {
  authalic::addCircles(result.circles, map, report);
  authalic::addField(map, "OuterLoop", result.outerLoop);
  authalic::addField(map, "Roundness", result.roundness);
  authalic::addField(map, "Rounds", result.rounds);
  report.more.set("outer_loop", result.outerLoop);
  report.more.set("roundness", result.roundness);
  report.more.set("rounds", result.rounds);
}

}  // namespace

vtkCircleDomainMap::vtkCircleDomainMap() {
  const authalic::CircleDomainOptions defaults;
  this->Road = static_cast<int>(defaults.road);
  this->RoundnessTolerance = defaults.roundness;
  this->MaximumRounds = defaults.maxRounds;
  this->Centre = static_cast<int>(defaults.normalisation.centre);
  this->CentreId = defaults.normalisation.centreId;
}

authalic::CircleDomainOptions vtkCircleDomainMap::Options(const std::vector<std::vector<int>>& loops) const {
  authalic::CircleDomainOptions options;
  options.road = static_cast<authalic::CircleDomainRoad>(this->Road);
  options.outerLoop = authalic::loopThrough(this->OuterVertex, loops);
  options.roundness = this->RoundnessTolerance;
  options.maxRounds = this->MaximumRounds;
  options.normalisation.centre = static_cast<authalic::DiskCentre>(this->Centre);
  options.normalisation.centreId = this->CentreId;
  options.normalisation.startVertex = this->StartVertex;
  options.refine = this->Refine;
  options.unfold = this->Unfold;
  options.flow = this->FlowOptions();
  return options;
}

void vtkCircleDomainMap::Compute(vtkInformationVector** inputs, vtkInformationVector* outputs,
                                 const authalic::Execution& execution) {
  vtkPolyData* input = vtkPolyData::GetData(inputs[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  const authalic::PolyAnnulusMesh surface(authalic::toTriangleMesh(input));
  const authalic::CircleDomainOptions options = this->Options(surface.loops());
  const authalic::TargetMeasure target = authalic::targetMeasureOf(input, surface.mesh(), this->MeasureArrayName);
  const authalic::CircleDomainResult map = authalic::circleDomainMap(surface, options, execution);
  if (map.image.rows() == 0) throw authalic::CancelledError();
  const authalic::Distortion distortion = authalic::fillMap(input, output, surface.mesh(), map.image, target.faces());
  authalic::MapReport report = authalic::describeFlowMap(map, output);
  authalic::fillRefinement(map.refinement, output, vtkPolyData::GetData(outputs, 1), report);
  describeLoops(map, output, report);
  report.method = "circle-domain";
  report.metrics = distortion.summary;
  report.topology = authalic::inspect(surface.mesh(), surface.topology());
  report.options = this->DescribeOptions();
  report.options.set("road", authalic::circleDomainRoadName(options.road));
  report.options.set("outer_vertex", this->OuterVertex);
  if (options.road == authalic::CircleDomainRoad::Koebe) {
    report.options.set("roundness_tolerance", options.roundness);
    report.options.set("max_rounds", options.maxRounds);
  }
  report.options.set("centre", authalic::diskCentreName(options.normalisation.centre));
  if (this->Centre != AREA_CENTROID) report.options.set("centre_id", this->CentreId);
  this->Publish(output, report);
}

void vtkCircleDomainMap::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Road: " << this->Road << "\n";
  os << indent << "OuterVertex: " << this->OuterVertex << "\n";
  os << indent << "RoundnessTolerance: " << this->RoundnessTolerance << "\n";
  os << indent << "MaximumRounds: " << this->MaximumRounds << "\n";
  os << indent << "Centre: " << this->Centre << "\n";
  os << indent << "CentreId: " << this->CentreId << "\n";
}
