#include "Core/authalic/CircleDomainAuthalicMap.h"

#include <string>
#include <utility>

#include "Core/authalic/AreaSolve.h"
#include "Core/authalic/CircleDomainStart.h"
#include "Core/authalic/NarrowFaces.h"
#include "Core/authalic/Stopwatch.h"
#include "Core/base/Error.h"
#include "Core/geometry/Areas.h"

namespace authalic {

void CircleDomainAuthalicMapOptions::validate(const PolyAnnulusMesh& surface) const {
  solve.validate();
  if (freeRadii && !holeAreas.empty()) {
    throw InvalidArgument("No hole areas are required where radii are free, but there are " +
                          std::to_string(holeAreas.size()) + "; give areas or free radii.");
  }
  CircleDomainHoles::validate(surface);
}

namespace {

// Where radii are free: what the holes have become, mm².
void measureHoles(const Points2& image, const TriangleMesh& surface, CircleDomainStart& start) {
  const double whole = polygonArea(image, start.loops.front().vertices);
  double ground = whole;
  for (std::size_t k = 1; k < start.loops.size(); ++k) {
    const double hole = -polygonArea(image, start.loops[k].vertices);
    start.loops[k].share = hole / whole;
    ground -= hole;
  }
  const double scale = faceAreas(surface).sum() * whole / ground;
  for (std::size_t k = 1; k < start.loops.size(); ++k) start.holeAreas[k - 1] = scale * start.loops[k].share;
}

// One solve from one start; the status says Cancelled and the image is empty when it was cancelled in the start.
CircleDomainAuthalicMapResult solveFrom(const PolyAnnulusMesh& surface, const TargetMeasure& target,
                                        const CircleDomainAuthalicMapOptions& options, HolesRoad& road,
                                        const Execution& execution) {
  Stopwatch watch;
  CircleDomainStart start =
      circleDomainStart(surface, target, options, road, options.solve.solver, execution.part(0, 0.3));
  road = start.road;
  CircleDomainAuthalicMapResult result;
  result.status = Status::Cancelled;
  if (start.image.rows() == 0) return result;
  const double startSeconds = watch.lap();
  const CircleFreedom freedom{!options.holdCentres && !options.concentric, options.freeRadii};
  const CircleDomainAreas areas(surface.mesh().faces(), start.loops, surface.mesh().vertexCount(), freedom);
  Coordinates begun = areas.begun(start.image);
  openNarrowFaces(areas, target, surface.mesh().points(), options.solve.solver, begun, kCollapsing);
  AreaSolveResult solved =
      solveAreas(areas, surface.mesh(), target, begun, options.solve, execution.part(0.3, 1));
  const Points2 image = areas.ended(solved.image, start.loops);
  if (options.freeRadii) measureHoles(image, surface.mesh(), start);
  static_cast<CircleDomainImage&>(result) = imageOf(start, image);
  static_cast<AuthalicSolution&>(result) = std::move(solved);
  result.startSeconds = startSeconds;
  result.flippedFaces = countFlippedFaces(result.image, surface.mesh().faces());
  return result;
}

// The other road, where the first did not arrive; with the steps and the time of both.
CircleDomainAuthalicMapResult secondTry(const PolyAnnulusMesh& surface, const TargetMeasure& target,
                                        CircleDomainAuthalicMapOptions options, HolesRoad road,
                                        CircleDomainAuthalicMapResult first, const Execution& execution) {
  options.solve.maxIterations -= first.iterations;
  CircleDomainAuthalicMapResult second;
  try {
    second = solveFrom(surface, target, options, road, execution);
  } catch (const GeometryError&) {
    return first;
  }
  if (second.status == Status::Cancelled) {
    first.status = Status::Cancelled;
    return first;
  }
  return giveBetterTheEffortOfBoth(first, second) ? second : first;
}

}  // namespace

CircleDomainAuthalicMapResult circleDomainAuthalicMap(const PolyAnnulusMesh& surface, const TargetMeasure& target,
                                                      const CircleDomainAuthalicMapOptions& options,
                                                      const Execution& execution) {
  options.validate(surface);
  requireTargetOf(surface.mesh(), target);
  const bool oneRoad = (options.holdCentres && !options.concentric) || surface.loops().size() == 1;
  HolesRoad road = oneRoad ? HolesRoad::Conformal : HolesRoad::Either;
  CircleDomainAuthalicMapOptions half = options;
  if (!oneRoad) half.solve.maxIterations = (options.solve.maxIterations + 1) / 2;
  CircleDomainAuthalicMapResult result = solveFrom(surface, target, half, road, execution.part(0, 0.7));
  const bool arrived = result.status == Status::Converged || result.status == Status::Cancelled;
  if (!arrived && !oneRoad && options.solve.maxIterations > result.iterations) {
    const HolesRoad other = road == HolesRoad::Conformal ? HolesRoad::AreasFirst : HolesRoad::Conformal;
    result = secondTry(surface, target, options, other, std::move(result), execution.part(0.7, 1));
  }
  execution.report(1, "Authalic map");
  return result;
}

}  // namespace authalic
