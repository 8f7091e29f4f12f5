#include "Core/authalic/DiscreteLieFlow.h"

#include <string>
#include <utility>

#include "Core/authalic/BalancedStart.h"
#include "Core/authalic/LieFlowStages.h"
#include "Core/authalic/Stopwatch.h"
#include "Core/base/Error.h"
#include "Core/geometry/Areas.h"
#include "Core/initial/Unfold.h"

namespace authalic {
namespace {

constexpr int kMatchPasses = 3;
constexpr double kBalanced = 0.035;  // mean |ln r| of the stars: the least-squares steps do the rest faster

void require(bool condition, const std::string& required, double found) {
  if (condition) return;
  throw InvalidArgument("Discrete Lie flow: " + required + " is required, but it is " + std::to_string(found) + ".");
}

// Whether some vertex star has less than e⁻⁸ or more than e⁸ of its share.
bool farFromTarget(const DiskMesh& disk, const TargetMeasure& target, const Points2& image) {
  const Faces& faces = disk.mesh().faces();
  const Eigen::VectorXd stars = vertexStars(signedFaceAreas(image, faces), faces, disk.mesh().vertexCount());
  const double scale = target.vertices().sum() / stars.sum();
  for (Eigen::Index v = 0; v < stars.size(); ++v) {
    const double share = target.vertices()[v];
    if (share > 0 && std::abs(std::log(std::max(stars[v] * scale / share, 1e-300))) > 8) return true;
  }
  return false;
}

struct Start {
  Points2 image;
  bool balanced = false;
};

Start prepareStart(const DiskMesh& disk, const BoundaryPlacement& placement, const Points2& initial,
                   const TargetMeasure& target, const DiscreteLieFlowOptions& options, const Execution& execution) {
  Start start{initial};
  for (std::size_t i = 0; i < placement.vertices.size(); ++i) {
    start.image.row(placement.vertices[i]) = placement.points.row(static_cast<Eigen::Index>(i));
  }
  start.balanced = options.finish == LieFlowFinish::Match && farFromTarget(disk, target, start.image);
  if (start.balanced) start.image = balancedStart(disk, start.image, target, options.solver, kBalanced, execution);
  UnfoldResult unfolded = unfold(disk.topology(), start.image, execution);
  if (unfolded.flippedFaces > 0 && !execution.cancelled()) {
    throw GeometryError("An initial map that can be unfolded is required, but " +
                        std::to_string(unfolded.flippedFaces) +
                        " faces stay folded; start from a tutte or mean-value map to a convex domain.");
  }
  start.image = std::move(unfolded.image);
  return start;
}

// Matching may leave a few faces of tiny targets collapsed; reviving them disturbs their neighbours, hence the passes.
void matchAndRevive(const DiskMesh& disk, const SlidingBoundary& sliding, const TargetMeasure& target,
                    const DiscreteLieFlowOptions& options, const Execution& execution, DiscreteLieFlowResult& result) {
  int iterations = 0;
  for (int pass = 0; pass < kMatchPasses; ++pass) {
    matchAreas(disk, sliding, target, options, execution, result);
    iterations += result.finishIterations;
    if (result.status == Status::Cancelled) break;
    Points2 revived = reviveCollapsedFaces(disk, result.image, target, options.solver);
    if (revived == result.image) break;
    result.image = std::move(revived);
  }
  result.finishIterations = iterations;
}

void measureResult(const DiskMesh& disk, const TargetMeasure& target, double tolerance, DiscreteLieFlowResult& result) {
  const Faces& faces = disk.mesh().faces();
  const Eigen::VectorXd stars = vertexStars(signedFaceAreas(result.image, faces), faces, disk.mesh().vertexCount());
  result.residual = measureStars(stars, target.vertices()).residual;
  result.flippedFaces = countFlippedFaces(result.image, faces);
  const bool good = result.residual <= tolerance && result.flippedFaces == 0;
  if (result.status == Status::Converged && !good) result.status = Status::NotConverged;
  if (result.status == Status::NotConverged && good) result.status = Status::Converged;
}

}  // namespace

void DiscreteLieFlowOptions::validate() const {
  require(tolerance > 0, "a tolerance above 0", tolerance);
  require(flowTolerance > 0, "a flow tolerance above 0", flowTolerance);
  require(maxIterations >= 0, "a number of iterations of at least 0", maxIterations);
  require(maxFinishIterations >= 0, "a number of finishing iterations of at least 0", maxFinishIterations);
  require(stepRatio > 0 && stepRatio < 1, "a step ratio between 0 and 1", stepRatio);
  require(fixedStep >= 0 && fixedStep <= 1, "a fixed step from 0 (adaptive) to 1", fixedStep);
  if (!SparseSolver::available(solver)) {
    throw InvalidArgument("A solver that is part of this build is required, but " +
                          std::string(solverBackendName(solver)) + " was not built in.");
  }
}

DiscreteLieFlowResult discreteLieFlow(const DiskMesh& disk, const Points2& initial, const TargetMeasure& target,
                                      const DiscreteLieFlowOptions& options, const Execution& execution) {
  options.validate();
  requireTargetOf(disk.mesh(), target);
  const BoundaryPlacement placement = recogniseBoundary(disk, options.domain, initial);
  DiscreteLieFlowResult result;
  Stopwatch watch;
  const Start start = prepareStart(disk, placement, initial, target, options, execution.part(0, 0.3));
  result.image = start.image;
  result.balancedStart = start.balanced;
  result.startSeconds = watch.lap();
  const SlidingBoundary sliding(placement, options.domain, result.image);
  if (!start.balanced) flowWithFlips(disk, placement, sliding, target, options, execution.part(0.3, 0.6), result);
  result.flowSeconds = watch.lap();
  result.flippedBeforeFinish = countFlippedFaces(result.image, disk.mesh().faces());
  if (options.finish != LieFlowFinish::None) {
    result.image = unfold(disk.topology(), result.image).image;
    result.unfoldSeconds = watch.lap();
  }
  if (options.finish == LieFlowFinish::Match && result.status != Status::Cancelled) {
    matchAndRevive(disk, sliding, target, options, execution.part(0.6, 1), result);
    result.finishSeconds = watch.lap();
  }
  measureResult(disk, target, options.tolerance, result);
  execution.report(1, "Discrete Lie flow");
  return result;
}

}  // namespace authalic
