#include <algorithm>
#include <cmath>

#include "Core/authalic/FlowingMesh.h"
#include "Core/authalic/LieFlowStages.h"
#include "Core/geometry/Areas.h"
#include "Core/geometry/Laplacian.h"
#include "Core/numerics/ElementAssembly.h"
#include "Core/numerics/FlipFreeStep.h"

namespace authalic {
namespace {

constexpr double kFarFromTarget = 0.6;  // mean |ln r| above which the flow is never handed over for being slow
constexpr double kWantedStep = 0.5;  // faces that would collapse before it are relaxed

// h with L h = areas − targets (same total), natural boundary; h = 0 at one vertex and at unused ones.
Eigen::VectorXd solvePoisson(const Points2& points, const Faces& faces, const Eigen::VectorXd& rightHandSide,
                             SolverBackend backend) {
  std::vector<int> unknown(static_cast<std::size_t>(points.rows()), -1), vertices;
  std::vector<char> used(unknown.size(), 0);
  for (Eigen::Index k = 0; k < faces.size(); ++k) used[static_cast<std::size_t>(faces.data()[k])] = 1;
  used[static_cast<std::size_t>(faces(0, 0))] = 0;
  for (std::size_t v = 0; v < used.size(); ++v) {
    if (!used[v]) continue;
    unknown[v] = static_cast<int>(vertices.size());
    vertices.push_back(static_cast<int>(v));
  }
  const HalfEdgeWeights weights = cotangentWeights(points, faces);
  ElementAssembly::Unknowns elements(faces.rows(), 3);
  std::vector<double> values(static_cast<std::size_t>(6 * faces.rows()));
  for (Eigen::Index f = 0; f < faces.rows(); ++f) {
    for (int k = 0; k < 3; ++k) elements(f, k) = unknown[static_cast<std::size_t>(faces(f, k))];
    const double w01 = weights(f, 0), w12 = weights(f, 1), w20 = weights(f, 2);
    const double element[6] = {w01 + w20, -w01, -w20, w01 + w12, -w12, w12 + w20};
    std::copy(element, element + 6, values.begin() + 6 * f);
  }
  ElementAssembly assembly(static_cast<int>(vertices.size()), elements);
  SparseSolver solver(backend);
  solver.compute(assembly.assemble(values));
  const Eigen::VectorXd x = solver.solve(rightHandSide(vertices));
  Eigen::VectorXd h = Eigen::VectorXd::Zero(points.rows());
  h(vertices) = x;
  return h;
}

// Target shares of the vertices within the flowing part, summing to 1; 0 elsewhere.
Eigen::VectorXd flowingTargets(const DiskMesh& disk, const BoundaryPlacement& placement, const TargetMeasure& target) {
  Eigen::VectorXd ofFace = target.faces();
  for (Eigen::Index f = 0; f < ofFace.size(); ++f) {
    if (placement.inPocket[static_cast<std::size_t>(f)]) ofFace[f] = 0;
  }
  ofFace /= ofFace.sum();
  return vertexStars(ofFace, disk.mesh().faces(), disk.mesh().vertexCount());
}

// Marks the corners of faces that would collapse before the wanted step.
std::vector<char> pinnedVertices(const Points2& points, const Points2& velocity, const Faces& faces, double wanted) {
  std::vector<char> pinned(static_cast<std::size_t>(points.rows()), 0);
  for (Eigen::Index f = 0; f < faces.rows(); ++f) {
    const int a = faces(f, 0), b = faces(f, 1), c = faces(f, 2);
    if (firstFlip(points, velocity, a, b, c) >= wanted) continue;
    for (const int v : {a, b, c}) pinned[static_cast<std::size_t>(v)] = 1;
  }
  return pinned;
}

// A triangle that moves rigidly cannot collapse: where a few triangles would pin the whole flow, their corners take
// the mean velocity of their neighbours instead, a few times over.
void relaxPinned(const Points2& points, const Faces& faces, const SlidingBoundary& sliding, double wanted,
                 Points2& velocity) {
  for (int pass = 0; pass < 8; ++pass) {
    const std::vector<char> pinned = pinnedVertices(points, velocity, faces, wanted);
    Points2 sum = Points2::Zero(points.rows(), 2);
    Eigen::VectorXd count = Eigen::VectorXd::Zero(points.rows());
    for (Eigen::Index f = 0; f < faces.rows(); ++f) {
      for (int k = 0; k < 3; ++k) {
        const int i = faces(f, k);
        if (!pinned[static_cast<std::size_t>(i)]) continue;
        sum.row(i) += velocity.row(faces(f, (k + 1) % 3)) + velocity.row(faces(f, (k + 2) % 3));
        count[i] += 2;
      }
    }
    if (count.maxCoeff() == 0) return;
    for (Eigen::Index i = 0; i < points.rows(); ++i) {
      if (count[i] > 0) velocity.row(i) = sum.row(i) / count[i];
    }
    sliding.keepTangential(points, velocity);
  }
}

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

LieFlowIteration measureStars(const Eigen::VectorXd& areas, const Eigen::VectorXd& targets) {
  LieFlowIteration iteration;
  const double total = areas.sum(), targetTotal = targets.sum();
  double square = 0;
  for (Eigen::Index v = 0; v < areas.size(); ++v) {
    if (!(targets[v] > 0)) continue;
    const double share = targets[v] / targetTotal, ratio = areas[v] / total / share;
    square += share * (ratio - 1) * (ratio - 1);
    iteration.meanAbsLog += share * std::abs(std::log(std::max(ratio, 1e-300)));
  }
  iteration.residual = std::sqrt(square);
  return iteration;
}

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
