#include "Core/authalic/LieAdvection.h"

#include <string>
#include <utility>

#include "Core/authalic/DiskFlowDomain.h"
#include "Core/authalic/Stopwatch.h"
#include "Core/base/Error.h"

namespace authalic {

void LieAdvectionOptions::validate() const {
  if (steps < 1) {
    throw InvalidArgument("Lie advection: at least 1 step is required, but it is " + std::to_string(steps) + ".");
  }
  if (!SparseSolver::available(solver)) {
    throw InvalidArgument("A solver that is part of this build is required, but " +
                          std::string(solverBackendName(solver)) + " was not built in.");
  }
}

LieAdvectionResult lieAdvection(const DiskMesh& disk, const Points2& initial, const TargetMeasure& target,
                                const LieAdvectionOptions& options, const Execution& execution) {
  options.validate();
  requireTargetOf(disk.mesh(), target);
  const BoundaryPlacement placement = recogniseBoundary(disk, options.domain, initial);
  LieAdvectionResult result;
  Stopwatch watch;
  result.image =
      unfoldedStart(disk, options.domain, placement, initial, target, options.solver, execution.part(0, 0.05));
  result.startSeconds = watch.lap();
  const DiskFlowDomain domain(disk, options.domain, placement, result.image, target, options.solver);
  Coordinates image = result.image;
  runLieAdvection(domain, options, execution.part(0.05, 1), image, result);
  result.image = image;
  return result;
}

}  // namespace authalic
