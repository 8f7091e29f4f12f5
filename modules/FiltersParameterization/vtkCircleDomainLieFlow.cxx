#include "vtkCircleDomainLieFlow.h"

#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>

#include "BoundaryLoops.h"
#include "Conversion.h"
#include "Core/authalic/CircleDomainLieFlow.h"
#include "Core/authalic/PeriodicRectangleLieFlow.h"
#include "HoledDomains.h"
#include "LieFlowReport.h"
#include "MapArrays.h"

vtkStandardNewMacro(vtkCircleDomainLieFlow);

static_assert(static_cast<int>(authalic::HoledDomain::PeriodicRectangle) == vtkCircleDomainLieFlow::PERIODIC_RECTANGLE);

void vtkCircleDomainLieFlow::AddHoleArea(double area) {
  this->HoleAreas.push_back(area);
  this->Modified();
}

void vtkCircleDomainLieFlow::ClearHoleAreas() {
  this->HoleAreas.clear();
  this->Modified();
}

authalic::MapReport vtkCircleDomainLieFlow::MapToCircles(vtkPolyData* input, vtkPolyData* output,
                                                         const authalic::Execution& execution) {
  const authalic::PolyAnnulusMesh surface(authalic::toTriangleMesh(input));
  authalic::CircleDomainLieFlowOptions options;
  options.flow = this->Options();
  static_cast<authalic::CircleDomainHoles&>(options) = authalic::holesOf(
      surface, static_cast<authalic::HoledDomain>(this->Domain), this->OuterVertex, this->HoleAreas);
  const authalic::TargetMeasure target = authalic::targetMeasureOf(input, surface.mesh(), this->MeasureArrayName);
  const auto result = authalic::circleDomainLieFlow(surface, target, options, execution);
  return authalic::reportCircles(input, output, surface, result, target,
                                 [&] { return authalic::describeLieFlow(result, output); });
}

authalic::MapReport vtkCircleDomainLieFlow::MapToRectangle(vtkPolyData* input, vtkPolyData* output,
                                                           const authalic::Execution& execution) {
  authalic::requireNoHoleAreas(this->HoleAreas);
  const authalic::AnnulusMesh annulus(authalic::toTriangleMesh(input));
  authalic::PeriodicRectangleLieFlowOptions options;
  options.flow = this->Options();
  options.outerLoop = authalic::loopOf(annulus.loops(), this->OuterVertex);
  const authalic::TargetMeasure target = authalic::targetMeasureOf(input, annulus.mesh(), this->MeasureArrayName);
  const auto result = authalic::periodicRectangleLieFlow(annulus, target, options, execution);
  return authalic::reportRectangle(input, output, annulus, result, target,
                                   [&] { return authalic::describeLieFlow(result, output); });
}

void vtkCircleDomainLieFlow::Compute(vtkInformationVector** inputs, vtkInformationVector* outputs,
                                     const authalic::Execution& execution) {
  vtkPolyData* input = vtkPolyData::GetData(inputs[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  authalic::MapReport report = this->Domain == PERIODIC_RECTANGLE ? this->MapToRectangle(input, output, execution)
                                                                  : this->MapToCircles(input, output, execution);
  authalic::addHoledOptions(report.options, static_cast<authalic::HoledDomain>(this->Domain), this->MeasureArrayName,
                            this->OuterVertex, this->HoleAreas);
  authalic::addLieFlowOptions(report.options, this->Options());
  this->Publish(output, report);
}

void vtkCircleDomainLieFlow::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Domain: " << this->Domain << "\n";
  os << indent << "OuterVertex: " << this->OuterVertex << "\n";
  os << indent << "HoleAreas: " << this->HoleAreas.size() << "\n";
}
