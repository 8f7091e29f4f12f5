#include "Core/authalic/PeriodicRectangleAuthalicMap.h"

#include <utility>

#include "Core/authalic/AreaSolve.h"
#include "Core/authalic/PeriodicAreas.h"
#include "Core/authalic/RectangleStart.h"
#include "Core/authalic/Stopwatch.h"
#include "Core/geometry/Areas.h"

namespace authalic {

void PeriodicRectangleAuthalicMapOptions::validate() const { solve.validate(); }

PeriodicRectangleAuthalicMapResult periodicRectangleAuthalicMap(const AnnulusMesh& annulus,
                                                                const TargetMeasure& target,
                                                                const PeriodicRectangleAuthalicMapOptions& options,
                                                                const Execution& execution) {
  options.validate();
  requireTargetOf(annulus.mesh(), target);
  Stopwatch watch;
  const RectangleStart start =
      rectangleStart(annulus, target, options.outerLoop, options.solve.solver, execution.part(0, 0.3));
  PeriodicRectangleAuthalicMapResult result;
  result.status = Status::Cancelled;
  if (start.image.rows() == 0) return result;
  const double startSeconds = watch.lap();
  const PeriodicAreas areas(annulus.mesh().faces(), start.shifts, start.heldFreedom());
  AreaSolveResult solved =
      solveAreas(areas, annulus.mesh(), target, start.image, options.solve, execution.part(0.3, 1));
  static_cast<PeriodicRectangleImage&>(result) = openRectangle(annulus, start, solved.image);
  static_cast<AuthalicSolution&>(result) = std::move(solved);
  result.startSeconds = startSeconds;
  result.flippedFaces = countFlippedFaces(result.image, result.faces);
  execution.report(1, "Authalic map");
  return result;
}

}  // namespace authalic
