#include "Core/initial/BarycentricMap.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <string>

#include "Core/base/Error.h"
#include "Core/geometry/Areas.h"
#include "Core/initial/BarycentricSystem.h"

namespace authalic {
namespace {

double residualOf(const DiskMesh& disk, const MeanValueWeights& weights, const Points2& image) {
  const Faces& faces = disk.mesh().faces();
  Points2 force = Points2::Zero(image.rows(), 2);
  Eigen::VectorXd total = Eigen::VectorXd::Zero(image.rows());
  for (Eigen::Index f = 0; f < faces.rows(); ++f) {
    for (int k = 0; k < 3; ++k) {
      const int i = faces(f, k), j = faces(f, (k + 1) % 3);
      force.row(i) += weights.forward(f, k) * (image.row(j) - image.row(i));
      force.row(j) += weights.backward(f, k) * (image.row(i) - image.row(j));
      total[i] += std::abs(weights.forward(f, k));
      total[j] += std::abs(weights.backward(f, k));
    }
  }
  double worst = 0;
  for (Eigen::Index i = 0; i < image.rows(); ++i) {
    if (disk.topology().onBoundary()[static_cast<std::size_t>(i)] || !(total[i] > 0)) continue;
    worst = std::max(worst, force.row(i).norm() / total[i]);
  }
  return worst;
}

}  // namespace

const char* barycentricWeightsName(BarycentricWeights weights) noexcept {
  switch (weights) {
    case BarycentricWeights::Uniform: return "tutte";
    case BarycentricWeights::Harmonic: return "harmonic";
    case BarycentricWeights::MeanValue: return "mean-value";
  }
  return "mean-value";
}

MeanValueWeights barycentricWeights(const TriangleMesh& surface, BarycentricWeights weights) {
  if (weights == BarycentricWeights::MeanValue) return meanValueWeights(surface);
  HalfEdgeWeights both = weights == BarycentricWeights::Harmonic
                             ? cotangentWeights(surface)
                             : HalfEdgeWeights(HalfEdgeWeights::Constant(surface.faceCount(), 3, 0.5));
  return {both, both};
}

void BarycentricMapOptions::validate() const {
  if (startVertex < -1) {
    throw InvalidArgument("A start vertex of at least -1 is required, but it is " + std::to_string(startVertex) + ".");
  }
  if (!SparseSolver::available(solver)) {
    throw InvalidArgument("A solver that is part of this build is required, but " +
                          std::string(solverBackendName(solver)) + " was not built in.");
  }
}

BarycentricMapResult barycentricMap(const DiskMesh& disk, const BarycentricMapOptions& options,
                                    const Execution& execution) {
  options.validate();
  const auto start = std::chrono::steady_clock::now();
  execution.report(0, barycentricWeightsName(options.weights));
  BarycentricMapResult result;
  result.boundary = placeBoundary(disk, options.domain, options.startVertex);
  result.image = Points2::Zero(disk.mesh().vertexCount(), 2);
  for (std::size_t i = 0; i < result.boundary.vertices.size(); ++i) {
    result.image.row(result.boundary.vertices[i]) = result.boundary.points.row(static_cast<Eigen::Index>(i));
  }
  execution.throwIfCancelled();
  const MeanValueWeights weights = barycentricWeights(disk.mesh(), options.weights);
  const std::vector<char>& held = disk.topology().onBoundary();
  if (options.weights == BarycentricWeights::MeanValue) {
    solveBarycentric(disk.mesh().faces(), weights, held, options.solver, result.image);
  } else {
    solveBarycentric(disk.mesh().faces(), weights.forward, held, options.solver, result.image);
  }
  result.residual = residualOf(disk, weights, result.image);
  result.flippedFaces = countFlippedFaces(result.image, disk.mesh().faces());
  result.degenerateFaces = static_cast<int>((faceAreas(disk.mesh()).array() <= 0).count());
  result.status = Status::Converged;
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  execution.report(1, barycentricWeightsName(options.weights));
  return result;
}

}  // namespace authalic
