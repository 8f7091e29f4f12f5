#include "vtkCircleDomainAuthalicMap.h"

#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>

#include "AuthalicReport.h"
#include "BoundaryLoops.h"
#include "Conversion.h"
#include "Core/authalic/CircleDomainAuthalicMap.h"
#include "Core/authalic/PeriodicRectangleAuthalicMap.h"
#include "Core/base/Error.h"
#include "HoledDomains.h"
#include "MapArrays.h"

vtkStandardNewMacro(vtkCircleDomainAuthalicMap);

static_assert(static_cast<int>(authalic::HoledDomain::PeriodicRectangle) ==
              vtkCircleDomainAuthalicMap::PERIODIC_RECTANGLE);

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
  static_cast<authalic::CircleDomainHoles&>(options) = authalic::holesOf(
      surface, static_cast<authalic::HoledDomain>(this->Domain), this->OuterVertex, this->HoleAreas);
  const authalic::TargetMeasure target = authalic::targetMeasureOf(input, surface.mesh(), this->MeasureArrayName);
  const auto result = authalic::circleDomainAuthalicMap(surface, target, options, execution);
  if (result.image.rows() == 0) throw authalic::CancelledError();
  const authalic::Distortion distortion =
      authalic::fillMap(input, output, surface.mesh(), result.image, target.shares());
  authalic::MapReport report = authalic::describeAuthalicMap(result, output);
  authalic::addHoles(result, output, report);
  report.metrics = distortion.summary;
  report.topology = authalic::inspect(surface.mesh(), surface.topology());
  return report;
}

authalic::MapReport vtkCircleDomainAuthalicMap::MapToRectangle(vtkPolyData* input, vtkPolyData* output,
                                            const authalic::Execution& execution) {
  if (!this->HoleAreas.empty()) {
    throw authalic::InvalidArgument(
        "A domain with holes is required for hole areas, but a periodic rectangle has none; leave them out.");
  }
  const authalic::AnnulusMesh annulus(authalic::toTriangleMesh(input));
  authalic::PeriodicRectangleAuthalicMapOptions options;
  options.solve = this->Options();
  options.outerLoop = authalic::loopOf(annulus.loops(), this->OuterVertex);
  const authalic::TargetMeasure target = authalic::targetMeasureOf(input, annulus.mesh(), this->MeasureArrayName);
  const auto result = authalic::periodicRectangleAuthalicMap(annulus, target, options, execution);
  if (result.image.rows() == 0) throw authalic::CancelledError();
  const authalic::Distortion distortion = authalic::fillOpenedMap(
      input, output, {result.faces, result.originalPointIds}, result.image, target.shares());
  authalic::MapReport report = authalic::describeAuthalicMap(result, output);
  authalic::addRectangle(annulus.mesh(), result, output, report);
  report.metrics = distortion.summary;
  report.topology = authalic::inspect(annulus.mesh(), annulus.topology());
  return report;
}

void vtkCircleDomainAuthalicMap::Compute(vtkInformationVector** inputs, vtkInformationVector* outputs,
                      const authalic::Execution& execution) {
  vtkPolyData* input = vtkPolyData::GetData(inputs[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  authalic::MapReport report = this->Domain == PERIODIC_RECTANGLE ? this->MapToRectangle(input, output, execution)
                                                                  : this->MapToCircles(input, output, execution);
  report.options.set("domain", authalic::holedDomainName(static_cast<authalic::HoledDomain>(this->Domain)))
      .set("measure", this->MeasureArrayName)
      .set("outer_vertex", this->OuterVertex)
      .set("hole_areas", authalic::Json::arrayOf(this->HoleAreas));
  authalic::addAuthalicOptions(report.options, this->Options());
  this->Publish(output, report);
}

void vtkCircleDomainAuthalicMap::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Domain: " << this->Domain << "\n";
  os << indent << "OuterVertex: " << this->OuterVertex << "\n";
  os << indent << "HoleAreas: " << this->HoleAreas.size() << "\n";
}
