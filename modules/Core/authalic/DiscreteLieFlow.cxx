#include "Core/authalic/DiscreteLieFlow.h"

#include <string>
#include <utility>

#include "Core/authalic/BalancedStart.h"
#include "Core/authalic/DiskFlowDomain.h"
#include "Core/authalic/Stopwatch.h"
#include "Core/base/Error.h"
#include "Core/geometry/Areas.h"

namespace authalic {
namespace {

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
  const Execution starting = execution.part(0, 0.3);
  result.image = initial;
  for (std::size_t i = 0; i < placement.vertices.size(); ++i) {
    result.image.row(placement.vertices[i]) = placement.points.row(static_cast<Eigen::Index>(i));
  }
  result.balancedStart = !options.keepInitial && options.finish == LieFlowFinish::Match && options.domain.convex() &&
                         farFromTarget(disk, target, result.image);
  if (result.balancedStart) {
    result.image = balancedStart(disk, result.image, target, options.solver, kBalanced, starting);
  }
  result.image = unfoldedStart(disk, options.domain, placement, std::move(result.image), target,
                               options.solver, starting);
  result.startSeconds = watch.lap();
  const DiskFlowDomain domain(disk, options.domain, placement, result.image, target, options.solver);
  Coordinates image = result.image;
  runLieFlow(domain, options, execution.part(0.3, 1), image, result);
  result.image = image;
  execution.report(1, "Discrete Lie flow");
  return result;
}

}  // namespace authalic
