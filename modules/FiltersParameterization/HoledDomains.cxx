#include "HoledDomains.h"

#include <cmath>

#include <vtkPolyData.h>

#include "BoundaryLoops.h"
#include "CircleArrays.h"
#include "Core/base/Error.h"
#include "Core/geometry/Areas.h"
#include "FieldArrays.h"
#include "MapArrays.h"

namespace authalic {
namespace {

const char* holedDomainName(HoledDomain domain) {
  switch (domain) {
    case HoledDomain::CircleDomain: return "circle-domain";
    case HoledDomain::Annulus: return "annulus";
    case HoledDomain::PeriodicRectangle: break;
  }
  return "periodic-rectangle";
}

void addHoles(const CircleDomainImage& image, vtkPolyData* map, MapReport& report) {
  addCircles(image.circles, map, report);
  addField(map, "OuterLoop", image.outerLoop);
  addField(map, "HoleAreas", image.holeAreas);
  addField(map, "HoleResidual", image.holeResidual);
  addField(map, "Pockets", image.pockets);
  report.more.set("outer_loop", image.outerLoop)
      .set("hole_areas", Json::arrayOf(image.holeAreas))
      .set("hole_residual", image.holeResidual)
      .set("pockets", image.pockets);
}

void addRectangle(const TriangleMesh& surface, const PeriodicRectangleImage& image, vtkPolyData* map,
                  MapReport& report) {
  const double circumference = std::sqrt(faceAreas(surface).sum() / image.height);
  addField(map, "Height", image.height * circumference);
  addField(map, "Circumference", circumference);
  addField(map, "OuterLoop", image.outerLoop);
  addField(map, "Pockets", image.pockets);
  addField(map, "Cut", std::vector<double>(image.cut.begin(), image.cut.end()));
  report.more.set("height", image.height * circumference)
      .set("circumference", circumference)
      .set("outer_loop", image.outerLoop)
      .set("pockets", image.pockets)
      .set("cut", Json::arrayOf(image.cut));
}

}  // namespace

CircleDomainHoles holesOf(const PolyAnnulusMesh& surface, HoledDomain domain, int outerVertex,
                          const std::vector<double>& areas) {
  CircleDomainHoles holes;
  holes.concentric = domain == HoledDomain::Annulus;
  holes.outerLoop = loopOf(surface.loops(), outerVertex);
  holes.holeAreas = areas;
  return holes;
}

void requireNoHoleAreas(const std::vector<double>& areas) {
  if (areas.empty()) return;
  throw InvalidArgument(
      "A domain with holes is required for hole areas, but a periodic rectangle has none; leave them out.");
}

MapReport reportCircles(vtkPolyData* input, vtkPolyData* map, const PolyAnnulusMesh& surface,
                        const CircleDomainImage& image, const TargetMeasure& target,
                        const std::function<MapReport()>& describe) {
  if (image.image.rows() == 0) throw CancelledError();
  const Distortion distortion = fillMap(input, map, surface.mesh(), image.image, target.shares());
  MapReport report = describe();
  addHoles(image, map, report);
  report.metrics = distortion.summary;
  report.topology = inspect(surface.mesh(), surface.topology());
  return report;
}

MapReport reportRectangle(vtkPolyData* input, vtkPolyData* map, const AnnulusMesh& annulus,
                          const PeriodicRectangleImage& image, const TargetMeasure& target,
                          const std::function<MapReport()>& describe) {
  if (image.image.rows() == 0) throw CancelledError();
  const Distortion distortion =
      fillOpenedMap(input, map, {image.faces, image.originalPointIds}, image.image, target.shares());
  MapReport report = describe();
  addRectangle(annulus.mesh(), image, map, report);
  report.metrics = distortion.summary;
  report.topology = inspect(annulus.mesh(), annulus.topology());
  return report;
}

void addHoledOptions(Json& options, HoledDomain domain, const std::string& measure, int outerVertex,
                     const std::vector<double>& areas) {
  options.set("domain", holedDomainName(domain))
      .set("measure", measure)
      .set("outer_vertex", outerVertex)
      .set("hole_areas", Json::arrayOf(areas));
}

}  // namespace authalic
