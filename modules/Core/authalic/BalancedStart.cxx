#include "Core/authalic/BalancedStart.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "Core/authalic/LieFlowStages.h"
#include "Core/geometry/Areas.h"
#include "Core/initial/BarycentricSystem.h"

namespace authalic {
namespace {

constexpr int kRounds = 15;
constexpr double kGoodEnough = 0.035;  // mean |ln r| of the stars: the least-squares steps do the rest faster
constexpr double kLargestLog = 30;     // of a ratio in one round, so that collapsed faces keep finite weights

// ln of (share of x / share of target), clamped; 0 where the target is.
Eigen::VectorXd logRatios(const Eigen::VectorXd& x, const Eigen::VectorXd& target) {
  const double scale = target.sum() / x.cwiseAbs().sum(), least = std::exp(-kLargestLog);
  Eigen::VectorXd logs = Eigen::VectorXd::Zero(x.size());
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    if (target[i] > 0) logs[i] = std::min(std::log(std::max(x[i] * scale / target[i], least)), kLargestLog);
  }
  return logs;
}

void reweight(const SurfaceTopology& topology, const Eigen::VectorXd& stars, const Eigen::VectorXd& faces,
              HalfEdgeWeights& weights) {
  for (int h = 0; h < 3 * static_cast<int>(weights.rows()); ++h) {
    const int across = topology.opposite(h), f = h / 3, g = across < 0 ? f : across / 3;
    weights(f, h % 3) *=
        std::exp(0.25 * (stars[topology.tail(h)] + stars[topology.head(h)] + faces[f] + faces[g]));
  }
  weights /= weights.mean();
}

}  // namespace

Points2 balancedStart(const DiskMesh& disk, const Points2& image, const TargetMeasure& target, SolverBackend backend,
                      const Execution& execution) {
  const Faces& faces = disk.mesh().faces();
  BarycentricSolver solver(faces, disk.topology().onBoundary(), backend);
  HalfEdgeWeights weights = HalfEdgeWeights::Constant(faces.rows(), 3, 1.0);
  Points2 best = image, current = image;
  double least = std::numeric_limits<double>::infinity();
  for (int round = 0; round < kRounds && least > kGoodEnough && !execution.cancelled(); ++round) {
    execution.report(double(round) / kRounds, "Balancing the start");
    solver.solve(weights, current);
    const Eigen::VectorXd areas = signedFaceAreas(current, faces);
    const Eigen::VectorXd stars = vertexStars(areas, faces, disk.mesh().vertexCount());
    const double error = measureStars(stars, target.vertices()).meanAbsLog;
    if (error < least && areas.minCoeff() > 0) {
      least = error;
      best = current;
    }
    reweight(disk.topology(), logRatios(stars, target.vertices()), logRatios(areas, target.faces()), weights);
  }
  return best;
}

}  // namespace authalic
