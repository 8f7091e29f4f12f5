#include <algorithm>
#include <cmath>
#include <utility>

#include "Core/authalic/FlowingMesh.h"
#include "Core/authalic/LieFlowStages.h"
#include "Core/authalic/Stopwatch.h"
#include "Core/geometry/Areas.h"

namespace authalic {
namespace {

constexpr double kLargestLog = 3;  // of λ in one step
constexpr int kHalvings = 30;
constexpr double kMargin = 1.25;  // faces that fold before this part of a step slow their corners

// ∫₀¹ dt / ((1 − t) + t h) = ln h / (h − 1).
double integrated(double h) { return std::abs(h - 1) < 1e-8 ? 1 - 0.5 * (h - 1) : std::log(h) / (h - 1); }

// h of every vertex; 1 outside the flowing part.
Eigen::VectorXd scheduled(const Eigen::VectorXd& areas, const Eigen::VectorXd& targets, int stepsLeft) {
  const double total = areas.sum();
  Eigen::VectorXd h = Eigen::VectorXd::Ones(areas.size());
  for (Eigen::Index v = 0; v < h.size(); ++v) {
    if (!(targets[v] > 0)) continue;
    const double log = std::log(targets[v] * total / std::max(areas[v], 1e-300));
    h[v] += (std::exp(std::clamp(log, -kLargestLog, kLargestLog)) - 1) / stepsLeft;
  }
  return h;
}

// The displacement of one step, along the domain.
Coordinates displacementFor(const AreaFunctional& areas, const Coordinates& image, const Eigen::VectorXd& stars,
                            const Eigen::VectorXd& h, SolverBackend backend) {
  Eigen::VectorXd right = -stars.cwiseProduct((h.array() - 1).matrix());
  right -= stars * (right.sum() / stars.sum());
  Coordinates displacement = poissonVelocity(areas, image, right, backend);
  for (Eigen::Index v = 0; v < displacement.rows(); ++v) displacement.row(v) *= integrated(h[v]);
  return displacement;
}

// Moves by as much of the displacement as folds no face of the flowing mesh. @return that part
double advance(const AreaFunctional& areas, const Coordinates& displacement, Coordinates& image) {
  double part = 1;
  for (int halving = 0; halving < kHalvings; ++halving, part *= 0.5) {
    Coordinates moved = areas.moved(image, displacement, part);
    if (countFolded(areas, moved) > 0) continue;
    image = std::move(moved);
    return part;
  }
  return 0;
}

void advect(const LieFlowDomain& domain, const LieAdvectionOptions& options, const Execution& execution,
            Coordinates& image, LieAdvectionSolution& solution) {
  const int vertexCount = static_cast<int>(image.rows());
  FlowingMesh mesh(domain.faces(), vertexCount, domain.frozen(), domain.shifts());
  const std::unique_ptr<AreaFunctional> areas = domain.areasOn(mesh.faces(), mesh.shifts());
  const Eigen::VectorXd& targets = domain.flowingTargets();
  for (int k = 1; k <= options.steps; ++k) {
    if (execution.cancelled()) {
      solution.status = Status::Cancelled;
      break;
    }
    execution.report(double(k - 1) / options.steps, "Lie advection");
    const int flips = mesh.makeDelaunay(image);
    const Eigen::VectorXd stars = vertexStars(areas->areas(image), mesh.faces(), vertexCount);
    LieFlowIteration now = measureStars(stars, targets);
    const Eigen::VectorXd h = scheduled(stars, targets, options.steps - k + 1);
    Coordinates displacement = displacementFor(*areas, image, stars, h, options.solver);
    relaxPinned(*areas, image, kMargin, displacement);
    solution.slowedVertices = std::max(solution.slowedVertices, slowPinned(*areas, image, kMargin, displacement));
    now.step = advance(*areas, displacement, image);
    now.edgeFlips = flips;
    solution.edgeFlips += flips;
    solution.shortenedSteps += now.step < 1;
    solution.history.push_back(now);
    ++solution.iterations;
  }
  domain.carryFrozen(image);
}

}  // namespace

void runLieAdvection(const LieFlowDomain& domain, const LieAdvectionOptions& options, const Execution& execution,
                     Coordinates& image, LieAdvectionSolution& solution) {
  Stopwatch watch;
  const std::unique_ptr<AreaFunctional> areas = domain.areasOn(domain.faces(), domain.shifts());
  advect(domain, options, execution.part(0, 0.95), image, solution);
  solution.advectionSeconds = watch.lap();
  solution.flippedBeforeUnfolding = countFolded(*areas, image);
  if (options.unfold) image = domain.unfolded(image, UnfoldReach::WholeMesh);
  solution.unfoldSeconds = watch.lap();
  solution.flippedFaces = countFolded(*areas, image);
  const Eigen::VectorXd stars = vertexStars(areas->areas(image), domain.faces(), areas->vertexCount());
  solution.residual = measureStars(stars, domain.target().vertices()).residual;
  if (solution.status == Status::NotRun) {
    const bool whole = solution.shortenedSteps == 0 && solution.flippedFaces == 0;
    solution.status = whole ? Status::Converged : Status::NotConverged;
  }
  execution.report(1, "Lie advection");
}

}  // namespace authalic
