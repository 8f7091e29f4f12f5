#include <algorithm>
#include <cmath>

#include "Core/authalic/LieFlowStages.h"
#include "Core/geometry/Areas.h"
#include "Core/geometry/Laplacian.h"
#include "Core/numerics/ElementAssembly.h"
#include "Core/numerics/FlipFreeStep.h"

namespace authalic {
namespace {

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

Eigen::VectorXd flowingTargets(const DiskMesh& disk, const BoundaryPlacement& placement, const TargetMeasure& target) {
  Eigen::VectorXd ofFace = target.faces();
  for (Eigen::Index f = 0; f < ofFace.size(); ++f) {
    if (placement.inPocket[static_cast<std::size_t>(f)]) ofFace[f] = 0;
  }
  ofFace /= ofFace.sum();
  return vertexStars(ofFace, disk.mesh().faces(), disk.mesh().vertexCount());
}

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

}  // namespace authalic
