#include "HoledDomains.h"

#include <cmath>
#include <vector>

#include <vtkPolyData.h>

#include "BoundaryLoops.h"
#include "CircleArrays.h"
#include "Core/geometry/Areas.h"
#include "FieldArrays.h"

namespace authalic {

const char* holedDomainName(HoledDomain domain) {
  switch (domain) {
    case HoledDomain::CircleDomain: return "circle-domain";
    case HoledDomain::Annulus: return "annulus";
    case HoledDomain::PeriodicRectangle: break;
  }
  return "periodic-rectangle";
}

CircleDomainHoles holesOf(const PolyAnnulusMesh& surface, HoledDomain domain, int outerVertex,
                          const std::vector<double>& areas) {
  CircleDomainHoles holes;
  holes.concentric = domain == HoledDomain::Annulus;
  holes.outerLoop = loopOf(surface.loops(), outerVertex);
  holes.holeAreas = areas;
  return holes;
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

}  // namespace authalic
