#include <utility>

#include "Core/authalic/LieFlowStages.h"
#include "Core/authalic/Stopwatch.h"
#include "Core/geometry/Areas.h"

namespace authalic {
namespace {

constexpr int kMatchPasses = 3;

// Matching may leave a few faces of tiny targets collapsed; reviving them disturbs their neighbours, hence the passes.
void matchAndRevive(const LieFlowDomain& domain, const DiscreteLieFlowOptions& options, const Execution& execution,
                    Coordinates& image, LieFlowSolution& solution) {
  int iterations = 0;
  for (int pass = 0; pass < kMatchPasses; ++pass) {
    matchAreas(domain, options, execution, image, solution);
    iterations += solution.finishIterations;
    if (solution.status == Status::Cancelled) break;
    Coordinates revived = domain.revived(image);
    if (revived == image) break;
    image = std::move(revived);
  }
  solution.finishIterations = iterations;
}

void measureSolution(const LieFlowDomain& domain, const AreaFunctional& areas, const Coordinates& image,
                     double tolerance, LieFlowSolution& solution) {
  const Eigen::VectorXd stars = vertexStars(areas.areas(image), domain.faces(), areas.vertexCount());
  solution.residual = measureStars(stars, domain.target().vertices()).residual;
  solution.flippedFaces = countFolded(areas, image);
  const bool good = solution.residual <= tolerance && solution.flippedFaces == 0;
  if (solution.status == Status::Converged && !good) solution.status = Status::NotConverged;
  if (solution.status == Status::NotConverged && good) solution.status = Status::Converged;
}

}  // namespace

void runLieFlow(const LieFlowDomain& domain, const DiscreteLieFlowOptions& options, const Execution& execution,
                Coordinates& image, LieFlowSolution& solution) {
  Stopwatch watch;
  const Coordinates start = image;
  const std::unique_ptr<AreaFunctional> areas = domain.areasOn(domain.faces(), domain.shifts());
  if (!solution.balancedStart) flowWithFlips(domain, options, execution.part(0, 0.4), image, solution);
  solution.flowSeconds = watch.lap();
  solution.flippedBeforeFinish = countFolded(*areas, image);
  if (options.finish != LieFlowFinish::None) {
    if (!solution.flowUndone) image = domain.unfolded(image, UnfoldReach::WholeMesh);
    solution.flowUndone = solution.flowUndone || countFolded(*areas, image) > 0;
    if (solution.flowUndone) image = start;
    solution.unfoldSeconds = watch.lap();
  }
  if (options.finish == LieFlowFinish::Match && solution.status != Status::Cancelled) {
    matchAndRevive(domain, options, execution.part(0.4, 1), image, solution);
    solution.finishSeconds = watch.lap();
  }
  measureSolution(domain, *areas, image, options.tolerance, solution);
}

}  // namespace authalic
