#include "Core/authalic/CircleDomainAuthalicMap.h"

#include <utility>

#include "Core/authalic/AreaSolve.h"
#include "Core/authalic/CircleDomainStart.h"
#include "Core/authalic/Stopwatch.h"
#include "Core/geometry/Areas.h"

namespace authalic {

void CircleDomainAuthalicMapOptions::validate(const PolyAnnulusMesh& surface) const {
  solve.validate();
  CircleDomainHoles::validate(surface);
}

CircleDomainAuthalicMapResult circleDomainAuthalicMap(const PolyAnnulusMesh& surface, const TargetMeasure& target,
                                                      const CircleDomainAuthalicMapOptions& options,
                                                      const Execution& execution) {
  options.validate(surface);
  requireTargetOf(surface.mesh(), target);
  Stopwatch watch;
  CircleDomainStart start = circleDomainStart(surface, target, options, execution.part(0, 0.3));
  CircleDomainAuthalicMapResult result;
  result.status = Status::Cancelled;
  if (start.image.rows() == 0) return result;
  const double startSeconds = watch.lap();
  const CircleFreedom freedom{!options.holdCentres && !options.concentric, options.freeRadii};
  const CircleDomainAreas areas(surface.mesh().faces(), start.loops, surface.mesh().vertexCount(), freedom);
  AreaSolveResult solved =
      solveAreas(areas, surface.mesh(), target, areas.begun(start.image), options.solve, execution.part(0.3, 1));
  const Points2 image = areas.ended(solved.image, start.loops);
  static_cast<CircleDomainImage&>(result) = imageOf(start, image);
  static_cast<AuthalicSolution&>(result) = std::move(solved);
  result.startSeconds = startSeconds;
  result.flippedFaces = countFlippedFaces(result.image, surface.mesh().faces());
  execution.report(1, "Authalic map");
  return result;
}

}  // namespace authalic
