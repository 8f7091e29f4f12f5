#include <algorithm>
#include <cmath>

#include "Core/authalic/FlowingMesh.h"
#include "Core/authalic/LieFlowStages.h"
#include "Core/geometry/Areas.h"
#include "Core/geometry/Laplacian.h"
#include "Core/numerics/FlipFreeStep.h"

namespace authalic {
namespace {

constexpr double kFarFromTarget = 0.6;  // mean |ln r| above which the flow is never handed over for being slow
constexpr double kWantedStep = 0.5;  // faces that would collapse before it are relaxed

// Whether the last steps have not paid: neither measure of the error fell by the share it should over the last few.
bool slow(const std::vector<LieFlowIteration>& history, const LieFlowIteration& now,
          const DiscreteLieFlowOptions& options) {
  const bool handsOver = options.finish == LieFlowFinish::Match;
  const std::size_t window = handsOver ? 5 : 30;
  if (history.size() < window || options.fixedStep > 0 || (handsOver && now.meanAbsLog > kFarFromTarget)) return false;
  const LieFlowIteration& before = history[history.size() - window];
  const double share = handsOver ? 0.85 : 0.99;
  return now.residual > share * before.residual && now.meanAbsLog > share * before.meanAbsLog;
}

}  // namespace

void flowWithFlips(const DiskMesh& disk, const BoundaryPlacement& placement, const SlidingBoundary& sliding,
                   const TargetMeasure& target, const DiscreteLieFlowOptions& options, const Execution& execution,
                   DiscreteLieFlowResult& result) {
  const bool pockets = !placement.pockets.empty();
  FlowingMesh mesh(disk.mesh().faces(), disk.mesh().vertexCount(), pockets ? placement.inPocket : std::vector<char>());
  const Eigen::VectorXd targets = flowingTargets(disk, placement, target);
  const double goal = options.finish == LieFlowFinish::Match ? std::max(options.flowTolerance, options.tolerance)
                                                             : options.tolerance;
  result.status = Status::NotConverged;
  for (result.iterations = 0;; ++result.iterations) {
    const int flips = mesh.makeDelaunay(result.image);
    const Eigen::VectorXd faceArea = signedFaceAreas(result.image, mesh.faces());
    const Eigen::VectorXd areas = vertexStars(faceArea, mesh.faces(), disk.mesh().vertexCount());
    LieFlowIteration now = measureStars(areas, targets);
    now.edgeFlips = flips;
    result.edgeFlips += flips;
    if (now.residual <= goal) result.status = Status::Converged;
    if (result.status == Status::NotConverged && slow(result.history, now, options)) {
      result.status = Status::Stalled;
    }
    if (execution.cancelled()) result.status = Status::Cancelled;
    if (result.status != Status::NotConverged || result.iterations >= options.maxIterations) break;
    execution.report(double(result.iterations) / options.maxIterations, "Discrete Lie flow");

    const Eigen::VectorXd rightHandSide = areas - targets * faceArea.sum();
    const Eigen::VectorXd h = solvePoisson(result.image, mesh.faces(), rightHandSide, options.solver);
    Points2 velocity = vertexGradients(result.image, mesh.faces(), h);
    sliding.keepTangential(result.image, velocity);
    if (options.fixedStep <= 0) relaxPinned(result.image, mesh.faces(), sliding, kWantedStep, velocity);
    const double limit = flipFreeStep(result.image, velocity, mesh.faces(), execution);
    now.step = options.fixedStep > 0 ? options.fixedStep : std::min(1.0, options.stepRatio * limit);
    Points2 moved = result.image + now.step * velocity;
    sliding.retract(moved);
    for (int halving = 0; options.fixedStep <= 0 && halving < 30 && countFlippedFaces(moved, mesh.faces()) > 0;
         ++halving) {
      now.step *= 0.5;
      moved = result.image + now.step * velocity;
      sliding.retract(moved);
    }
    result.history.push_back(now);
    if (countFlippedFaces(moved, mesh.faces()) > 0) {
      result.collapsed = options.fixedStep > 0;
      result.status = Status::Stalled;
      break;
    }
    result.image = moved;
  }
  sliding.carryPockets(result.image);
}

}  // namespace authalic
