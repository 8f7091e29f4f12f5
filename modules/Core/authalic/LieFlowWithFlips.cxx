#include <algorithm>
#include <cmath>

#include "Core/authalic/FlowingMesh.h"
#include "Core/authalic/LieFlowStages.h"
#include "Core/geometry/Areas.h"

namespace authalic {
namespace {

constexpr double kFarFromTarget = 0.6;  // mean |ln r| above which the flow is never handed over for being slow
constexpr double kPinnedStep = 1e-3;
constexpr std::ptrdiff_t kPinnedSteps = 4;
constexpr double kWantedStep = 0.5;  // faces that would collapse before it are relaxed

// Whether the last steps were so short that a few faces pin the flow.
bool pinned(const std::vector<LieFlowIteration>& history, const DiscreteLieFlowOptions& options) {
  const bool handsOver = options.finish == LieFlowFinish::Match && options.fixedStep <= 0 && !options.keepInitial;
  if (!handsOver || std::ptrdiff_t(history.size()) < kPinnedSteps) return false;
  return std::all_of(history.end() - kPinnedSteps, history.end(), [](const auto& x) { return x.step < kPinnedStep; });
}

// Whether the last steps have not paid: neither measure of the error fell by the share it should over the last few.
bool slow(const std::vector<LieFlowIteration>& history, const LieFlowIteration& now,
          const DiscreteLieFlowOptions& options) {
  const bool handsOver = options.finish == LieFlowFinish::Match;
  const std::size_t window = !handsOver ? 30 : options.keepInitial ? 10 : 5;
  if (history.size() < window || options.fixedStep > 0 || (handsOver && now.meanAbsLog > kFarFromTarget)) return false;
  const LieFlowIteration& before = history[history.size() - window];
  const double share = handsOver ? 0.85 : 0.99;
  return now.residual > share * before.residual && now.meanAbsLog > share * before.meanAbsLog;
}

// The fixed step, or the longest adaptive one that folds nothing. @return where it leads
Coordinates takeStep(const AreaFunctional& areas, const Coordinates& image, const DiscreteLieFlowOptions& options,
                     Coordinates& velocity, double& step) {
  const bool adaptive = options.fixedStep <= 0;
  if (adaptive) relaxPinned(areas, image, kWantedStep, velocity);
  step = adaptive ? std::min(1.0, options.stepRatio * flipFreeStep(areas, image, velocity)) : options.fixedStep;
  Coordinates moved = areas.moved(image, velocity, step);
  for (int halving = 0; adaptive && halving < 30 && countFolded(areas, moved) > 0; ++halving) {
    step *= 0.5;
    moved = areas.moved(image, velocity, step);
  }
  return moved;
}

}  // namespace

void flowWithFlips(const LieFlowDomain& domain, const DiscreteLieFlowOptions& options, const Execution& execution,
                   Coordinates& image, LieFlowSolution& solution) {
  const int vertexCount = static_cast<int>(image.rows());
  FlowingMesh mesh(domain.faces(), vertexCount, domain.frozen(), domain.shifts());
  const std::unique_ptr<AreaFunctional> areas = domain.areasOn(mesh.faces(), mesh.shifts());
  const Eigen::VectorXd& targets = domain.flowingTargets();
  const double goal = options.finish == LieFlowFinish::Match ? std::max(options.flowTolerance, options.tolerance)
                                                             : options.tolerance;
  solution.status = Status::NotConverged;
  for (solution.iterations = 0;; ++solution.iterations) {
    const int flips = mesh.makeDelaunay(image);
    const Eigen::VectorXd faceArea = areas->areas(image);
    const Eigen::VectorXd stars = vertexStars(faceArea, mesh.faces(), vertexCount);
    LieFlowIteration now = measureStars(stars, targets);
    now.edgeFlips = flips;
    solution.edgeFlips += flips;
    if (now.residual <= goal) solution.status = Status::Converged;
    if (solution.status == Status::NotConverged &&
        (slow(solution.history, now, options) || pinned(solution.history, options))) {
      solution.status = Status::Stalled;
    }
    if (execution.cancelled()) solution.status = Status::Cancelled;
    if (solution.status != Status::NotConverged || solution.iterations >= options.maxIterations) break;
    execution.report(double(solution.iterations) / options.maxIterations, "Discrete Lie flow");

    Coordinates velocity = poissonVelocity(*areas, image, stars - targets * faceArea.sum(), options.solver);
    const Coordinates moved = takeStep(*areas, image, options, velocity, now.step);
    solution.history.push_back(now);
    if (countFolded(*areas, moved) > 0) {
      solution.collapsed = options.fixedStep > 0;
      solution.status = Status::Stalled;
      break;
    }
    image = moved;
  }
  solution.flowUndone = pinned(solution.history, options) && solution.history.back().meanAbsLog > kFarFromTarget;
  domain.carryFrozen(image);
}

}  // namespace authalic
