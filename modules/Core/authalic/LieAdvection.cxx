#include "Core/authalic/LieAdvection.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "Core/authalic/FlowingMesh.h"
#include "Core/authalic/LieFlowStages.h"
#include "Core/authalic/Stopwatch.h"
#include "Core/base/Error.h"
#include "Core/geometry/Areas.h"
#include "Core/geometry/Laplacian.h"
#include "Core/numerics/FlipFreeStep.h"
#include "Core/initial/Unfold.h"

namespace authalic {
namespace {

constexpr double kLargestLog = 3;  // of λ in one step
constexpr int kHalvings = 30, kPasses = 20;
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

// The displacement of one step, on the domain's boundary where the vertices are.
Points2 displacementFor(const Points2& image, const Faces& faces, const Eigen::VectorXd& areas,
                        const Eigen::VectorXd& h, const SlidingBoundary& sliding, SolverBackend backend) {
  Eigen::VectorXd right = -areas.cwiseProduct((h.array() - 1).matrix());
  right -= areas * (right.sum() / areas.sum());
  Points2 displacement = vertexGradients(image, faces, solvePoisson(image, faces, right, backend));
  for (Eigen::Index v = 0; v < displacement.rows(); ++v) displacement.row(v) *= integrated(h[v]);
  sliding.keepTangential(image, displacement);
  return displacement;
}

// Slows vertices, and only those, whose faces would fold on the way. @return how many
int slowDown(const Points2& image, const Faces& faces, Points2& displacement) {
  std::vector<char> slowed(static_cast<std::size_t>(image.rows()), 0);
  for (int pass = 0; pass < kPasses; ++pass) {
    Eigen::VectorXd part = Eigen::VectorXd::Ones(image.rows());
    for (Eigen::Index f = 0; f < faces.rows(); ++f) {
      const double first = firstFlip(image, displacement, faces(f, 0), faces(f, 1), faces(f, 2));
      for (int k = 0; k < 3 && first < kMargin; ++k) part[faces(f, k)] = std::min(part[faces(f, k)], 0.5 * first);
    }
    if (part.minCoeff() == 1) break;
    displacement.array().colwise() *= part.array();
    for (Eigen::Index v = 0; v < part.size(); ++v) slowed[static_cast<std::size_t>(v)] |= part[v] < 1;
  }
  return static_cast<int>(std::count(slowed.begin(), slowed.end(), 1));
}

// Moves by as much of the displacement as folds no face of the flowing mesh. @return that part
double advance(const Points2& displacement, const Faces& faces, const SlidingBoundary& sliding, Points2& image) {
  double part = 1;
  for (int halving = 0; halving < kHalvings; ++halving, part *= 0.5) {
    Points2 moved = image + part * displacement;
    sliding.retract(moved);
    if (countFlippedFaces(moved, faces) > 0) continue;
    image = std::move(moved);
    return part;
  }
  return 0;
}

void advect(const DiskMesh& disk, const BoundaryPlacement& placement, const SlidingBoundary& sliding,
            const TargetMeasure& target, const LieAdvectionOptions& options, const Execution& execution,
            LieAdvectionResult& result) {
  const bool pockets = !placement.pockets.empty();
  FlowingMesh mesh(disk.mesh().faces(), disk.mesh().vertexCount(), pockets ? placement.inPocket : std::vector<char>());
  const Eigen::VectorXd targets = flowingTargets(disk, placement, target);
  for (int k = 1; k <= options.steps; ++k) {
    if (execution.cancelled()) {
      result.status = Status::Cancelled;
      break;
    }
    execution.report(double(k - 1) / options.steps, "Lie advection");
    const int flips = mesh.makeDelaunay(result.image);
    const Eigen::VectorXd areas =
        vertexStars(signedFaceAreas(result.image, mesh.faces()), mesh.faces(), disk.mesh().vertexCount());
    LieFlowIteration now = measureStars(areas, targets);
    const Eigen::VectorXd h = scheduled(areas, targets, options.steps - k + 1);
    Points2 displacement = displacementFor(result.image, mesh.faces(), areas, h, sliding, options.solver);
    relaxPinned(result.image, mesh.faces(), sliding, kMargin, displacement);
    result.slowedVertices = std::max(result.slowedVertices, slowDown(result.image, mesh.faces(), displacement));
    now.step = advance(displacement, mesh.faces(), sliding, result.image);
    now.edgeFlips = flips;
    result.edgeFlips += flips;
    result.shortenedSteps += now.step < 1;
    result.history.push_back(now);
    ++result.iterations;
  }
  sliding.carryPockets(result.image);
}

}  // namespace

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
  UnfoldResult start = unfold(disk.topology(), initial, execution.part(0, 0.05));
  if (start.flippedFaces > 0 && !execution.cancelled()) {
    throw GeometryError("An initial map that can be unfolded is required, but " + std::to_string(start.flippedFaces) +
                        " faces stay folded; start from a tutte or mean-value map to a convex domain.");
  }
  result.image = std::move(start.image);
  for (std::size_t i = 0; i < placement.vertices.size(); ++i) {
    result.image.row(placement.vertices[i]) = placement.points.row(static_cast<Eigen::Index>(i));
  }
  const SlidingBoundary sliding(placement, options.domain, result.image);
  result.startSeconds = watch.lap();
  advect(disk, placement, sliding, target, options, execution.part(0.05, 0.95), result);
  result.advectionSeconds = watch.lap();
  const Faces& faces = disk.mesh().faces();
  result.flippedBeforeUnfolding = countFlippedFaces(result.image, faces);
  if (options.unfold) result.image = unfold(disk.topology(), std::move(result.image)).image;
  result.unfoldSeconds = watch.lap();
  result.flippedFaces = countFlippedFaces(result.image, faces);
  const Eigen::VectorXd stars = vertexStars(signedFaceAreas(result.image, faces), faces, disk.mesh().vertexCount());
  result.residual = measureStars(stars, target.vertices()).residual;
  if (result.status == Status::NotRun) {
    result.status = result.shortenedSteps == 0 && result.flippedFaces == 0 ? Status::Converged : Status::NotConverged;
  }
  execution.report(1, "Lie advection");
  return result;
}

}  // namespace authalic
