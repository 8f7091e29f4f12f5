#include "Core/authalic/BalancedStart.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "Core/geometry/Areas.h"
#include "Core/initial/BarycentricSystem.h"

namespace authalic {
namespace {

constexpr int kRounds = 20;
constexpr double kStrength = 0.35;
constexpr double kSmallest = 1e-12;  // of a share, so that collapsed stars do not end the powers

// Σ m_t (r_t + 1/r_t); infinite when a face with a target has no positive area.
double areaDistortion(const Points2& image, const Faces& faces, const Eigen::VectorXd& targets) {
  const Eigen::VectorXd areas = signedFaceAreas(image, faces);
  const double total = areas.sum(), targetTotal = targets.sum();
  double sum = 0;
  for (Eigen::Index f = 0; f < areas.size(); ++f) {
    const double share = targets[f] / targetTotal, q = areas[f] / total;
    if (!(q > 0)) return std::numeric_limits<double>::infinity();
    if (share > 0) sum += q + share * share / q;
  }
  return sum;
}

Eigen::VectorXd starRatios(const Points2& image, const Faces& faces, const TargetMeasure& target, int vertexCount) {
  const Eigen::VectorXd stars = vertexStars(signedFaceAreas(image, faces), faces, vertexCount);
  const Eigen::VectorXd& targets = target.vertices();
  return ((stars / stars.sum()).array().max(kSmallest) / (targets / targets.sum()).array().max(kSmallest)).matrix();
}

void stiffen(HalfEdgeWeights& weights, const Faces& faces, const Eigen::VectorXd& ratios) {
  const Eigen::VectorXd power = ratios.array().pow(0.5 * kStrength);
  for (Eigen::Index f = 0; f < faces.rows(); ++f) {
    for (int k = 0; k < 3; ++k) weights(f, k) *= power[faces(f, k)] * power[faces(f, (k + 1) % 3)];
  }
  weights /= weights.mean();
}

}  // namespace

Points2 balancedStart(const DiskMesh& disk, const Points2& image, const TargetMeasure& target, SolverBackend backend,
                      const Execution& execution) {
  const Faces& faces = disk.mesh().faces();
  Points2 best = image, current = image;
  double least = areaDistortion(image, faces, target.faces());
  HalfEdgeWeights weights = HalfEdgeWeights::Constant(faces.rows(), 3, 1.0);
  for (int round = 0; round < kRounds && !execution.cancelled(); ++round) {
    execution.report(double(round) / kRounds, "Balancing the start");
    solveBarycentric(faces, weights, disk.topology().onBoundary(), backend, current);
    const double distortion = areaDistortion(current, faces, target.faces());
    if (distortion < least) {
      least = distortion;
      best = current;
    } else if (round > 2 && std::isfinite(least)) {
      break;
    }
    stiffen(weights, faces, starRatios(current, faces, target, disk.mesh().vertexCount()));
  }
  return best;
}

}  // namespace authalic
