#include "vtkCircleDomainAuthalicMap.h"

#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>

#include "AuthalicReport.h"
#include "BoundaryLoops.h"
#include "Conversion.h"
#include "Core/authalic/CircleDomainAuthalicMap.h"
#include "Core/authalic/PeriodicRectangleAuthalicMap.h"
#include "HoledDomains.h"
#include "MapArrays.h"

vtkStandardNewMacro(vtkCircleDomainAuthalicMap);

static_assert(static_cast<int>(authalic::HoledDomain::PeriodicRectangle) ==
              vtkCircleDomainAuthalicMap::PERIODIC_RECTANGLE);

vtkCircleDomainAuthalicMap::vtkCircleDomainAuthalicMap() {
  const authalic::CircleDomainAuthalicMapOptions defaults;
  this->HoldCentres = defaults.holdCentres;
  this->FreeRadii = defaults.freeRadii;
}

void vtkCircleDomainAuthalicMap::AddHoleArea(double area) {
  this->HoleAreas.push_back(area);
  this->Modified();
}

void vtkCircleDomainAuthalicMap::ClearHoleAreas() {
  this->HoleAreas.clear();
  this->Modified();
}

authalic::MapReport vtkCircleDomainAuthalicMap::MapToCircles(vtkPolyData* input, vtkPolyData* output,
                                                             const authalic::Execution& execution) {
  const authalic::PolyAnnulusMesh surface(authalic::toTriangleMesh(input));
  authalic::CircleDomainAuthalicMapOptions options;
  options.solve = this->Options();
  options.holdCentres = this->HoldCentres;
  options.freeRadii = this->FreeRadii;
  static_cast<authalic::CircleDomainHoles&>(options) = authalic::holesOf(
      surface, static_cast<authalic::HoledDomain>(this->Domain), this->OuterVertex, this->HoleAreas);
  const authalic::TargetMeasure target = authalic::targetMeasureOf(input, surface.mesh(), this->MeasureArrayName);
  const auto result = authalic::circleDomainAuthalicMap(surface, target, options, execution);
  return authalic::reportCircles(input, output, surface, result, target,
                                 [&] { return authalic::describeAuthalicMap(result, output); });
}

authalic::MapReport vtkCircleDomainAuthalicMap::MapToRectangle(vtkPolyData* input, vtkPolyData* output,
                                                               const authalic::Execution& execution) {
  authalic::requireNoHoleAreas(this->HoleAreas);
  const authalic::AnnulusMesh annulus(authalic::toTriangleMesh(input));
  authalic::PeriodicRectangleAuthalicMapOptions options;
  options.solve = this->Options();
  options.outerLoop = authalic::loopOf(annulus.loops(), this->OuterVertex);
  const authalic::TargetMeasure target = authalic::targetMeasureOf(input, annulus.mesh(), this->MeasureArrayName);
  const auto result = authalic::periodicRectangleAuthalicMap(annulus, target, options, execution);
  return authalic::reportRectangle(input, output, annulus, result, target,
                                   [&] { return authalic::describeAuthalicMap(result, output); });
}

void vtkCircleDomainAuthalicMap::Compute(vtkInformationVector** inputs, vtkInformationVector* outputs,
                                         const authalic::Execution& execution) {
  vtkPolyData* input = vtkPolyData::GetData(inputs[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  authalic::MapReport report = this->Domain == PERIODIC_RECTANGLE ? this->MapToRectangle(input, output, execution)
                                                                  : this->MapToCircles(input, output, execution);
  authalic::addHoledOptions(report.options, static_cast<authalic::HoledDomain>(this->Domain), this->MeasureArrayName,
                            this->OuterVertex, this->HoleAreas);
  report.options.set("hold_centres", this->HoldCentres).set("free_radii", this->FreeRadii);
  authalic::addAuthalicOptions(report.options, this->Options());
  this->Publish(output, report);
}

void vtkCircleDomainAuthalicMap::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Domain: " << this->Domain << "\n";
  os << indent << "OuterVertex: " << this->OuterVertex << "\n";
  os << indent << "HoleAreas: " << this->HoleAreas.size() << "\n";
  os << indent << "HoldCentres: " << this->HoldCentres << "\n";
  os << indent << "FreeRadii: " << this->FreeRadii << "\n";
}
