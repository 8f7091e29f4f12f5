#include "vtkCircleDomainLieFlow.h"

#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>

#include "BoundaryLoops.h"
#include "CircleArrays.h"
#include "Conversion.h"
#include "Core/authalic/CircleDomainLieFlow.h"
#include "Core/base/Error.h"
#include "FieldArrays.h"
#include "LieFlowReport.h"
#include "MapArrays.h"

vtkStandardNewMacro(vtkCircleDomainLieFlow);

vtkCircleDomainLieFlow::vtkCircleDomainLieFlow() {
  const authalic::CircleDomainLieFlowOptions defaults;
  this->Concentric = defaults.concentric;
}

void vtkCircleDomainLieFlow::AddHoleArea(double area) {
  this->HoleAreas.push_back(area);
  this->Modified();
}

void vtkCircleDomainLieFlow::ClearHoleAreas() {
  this->HoleAreas.clear();
  this->Modified();
}

authalic::CircleDomainLieFlowOptions vtkCircleDomainLieFlow::Options(
    const std::vector<std::vector<int>>& loops) const {
  authalic::CircleDomainLieFlowOptions options;
  options.flow = this->Superclass::Options();
  options.concentric = this->Concentric;
  options.outerLoop = authalic::loopOf(loops, this->OuterVertex);
  options.holeAreas = this->HoleAreas;
  return options;
}

void vtkCircleDomainLieFlow::Compute(vtkInformationVector** inputs, vtkInformationVector* outputs,
                                     const authalic::Execution& execution) {
  vtkPolyData* input = vtkPolyData::GetData(inputs[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  const authalic::PolyAnnulusMesh surface(authalic::toTriangleMesh(input));
  const authalic::CircleDomainLieFlowOptions options = this->Options(surface.loops());
  const authalic::TargetMeasure target = authalic::targetMeasureOf(input, surface.mesh(), this->MeasureArrayName);
  const authalic::CircleDomainLieFlowResult result =
      authalic::circleDomainLieFlow(surface, target, options, execution);
  if (result.image.rows() == 0) throw authalic::CancelledError();
  const authalic::Distortion distortion =
      authalic::fillMap(input, output, surface.mesh(), result.image, target.shares());
  authalic::MapReport report = authalic::describeLieFlow(result, output);
  authalic::addCircles(result.circles, output, report);
  authalic::addField(output, "OuterLoop", result.outerLoop);
  authalic::addField(output, "HoleAreas", result.holeAreas);
  authalic::addField(output, "HoleResidual", result.holeResidual);
  authalic::addField(output, "Pockets", result.pockets);
  report.more.set("outer_loop", result.outerLoop);
  report.more.set("hole_areas", authalic::Json::arrayOf(result.holeAreas));
  report.more.set("hole_residual", result.holeResidual);
  report.more.set("pockets", result.pockets);
  report.metrics = distortion.summary;
  report.topology = authalic::inspect(surface.mesh(), surface.topology());
  report.options.set("domain", this->Concentric ? "annulus" : "circle-domain");
  report.options.set("measure", this->MeasureArrayName);
  report.options.set("outer_vertex", this->OuterVertex);
  report.options.set("hole_areas", authalic::Json::arrayOf(this->HoleAreas));
  authalic::addLieFlowOptions(report.options, options.flow);
  this->Publish(output, report);
}

void vtkCircleDomainLieFlow::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Concentric: " << this->Concentric << "\n";
  os << indent << "OuterVertex: " << this->OuterVertex << "\n";
  os << indent << "HoleAreas: " << this->HoleAreas.size() << "\n";
}
