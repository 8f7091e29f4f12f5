#include "Core/authalic/BalancedStart.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <vector>

#include "Core/authalic/LieFlowStages.h"
#include "Core/authalic/Patches.h"
#include "Core/base/Error.h"
#include "Core/geometry/Areas.h"
#include "Core/initial/BarycentricSystem.h"

namespace authalic {
namespace {

constexpr int kRounds = 15;
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

Parts onePart(const Faces& faces, Eigen::Index vertexCount) {
  return {std::vector<int>(static_cast<std::size_t>(vertexCount), 0),
          std::vector<int>(static_cast<std::size_t>(faces.rows()), 0), 1};
}

// Σ m_t (r_t + 1/r_t) of every part; infinite where a face with a target has no positive area.
std::vector<double> areaDistortions(const Eigen::VectorXd& areas, const Eigen::VectorXd& targets, const Parts& parts) {
  const double scale = targets.sum() / areas.sum();
  std::vector<double> sums(static_cast<std::size_t>(parts.count), 0);
  for (Eigen::Index f = 0; f < areas.size(); ++f) {
    const int part = parts.ofFace[static_cast<std::size_t>(f)];
    if (part < 0) continue;
    double& sum = sums[static_cast<std::size_t>(part)];
    if (!(areas[f] > 0)) sum = std::numeric_limits<double>::infinity();
    else if (targets[f] > 0) sum += areas[f] * scale + targets[f] * targets[f] / (areas[f] * scale);
  }
  return sums;
}

// Barycentric maps in the plane or, with shifts (3m×2), on the flat torus.
BarycentricImage planar(const Faces& faces, const std::vector<char>& held, const Points2& shifts,
                        SolverBackend backend) {
  const auto solver = std::make_shared<BarycentricSolver>(faces, held, backend);
  return {HalfEdgeWeights::Constant(faces.rows(), 3, 1.0),
          [solver, shifts](const HalfEdgeWeights& weights, Points2& image) { solver->solve(weights, image, shifts); },
          [&faces, shifts](const Points2& image) {
            return shifts.size() == 0 ? signedFaceAreas(image, faces) : periodicFaceAreas(image, shifts, faces);
          }};
}

// The rounds of balancedStart; every part has its best one.
Points2 balancedParts(const SurfaceTopology& topology, const BarycentricImage& map, const Points2& image,
                      const TargetMeasure& target, double goodEnough, const Parts& parts, const Execution& execution) {
  const Faces& faces = topology.faces();
  HalfEdgeWeights weights = map.weights;
  Points2 best = image, current = image;
  std::vector<double> least = areaDistortions(map.areas(image), target.faces(), parts);
  double error = 1;
  for (int round = 0; round < kRounds && error > goodEnough; ++round) {
    if (round > 0 && execution.cancelled()) break;
    execution.report(double(round) / kRounds, "Balancing the start");
    try {
      map.solve(weights, current);
    } catch (const SolverError&) {
      if (round == 0) throw;
      break;  // weights too far apart for the solver
    }
    const Eigen::VectorXd areas = map.areas(current);
    const Eigen::VectorXd stars = vertexStars(areas, faces, static_cast<int>(image.rows()));
    error = measureStars(stars, target.vertices()).meanAbsLog;
    const std::vector<double> distortions = areaDistortions(areas, target.faces(), parts);
    for (Eigen::Index v = 0; v < image.rows(); ++v) {
      const int part = parts.ofVertex[static_cast<std::size_t>(v)];
      if (part >= 0 && distortions[static_cast<std::size_t>(part)] < least[static_cast<std::size_t>(part)]) {
        best.row(v) = current.row(v);
      }
    }
    std::transform(least.begin(), least.end(), distortions.begin(), least.begin(),
                   [](double a, double b) { return std::min(a, b); });
    reweight(topology, logRatios(stars, target.vertices()), logRatios(areas, target.faces()), weights);
  }
  return best;
}

}  // namespace

Points2 balancedStart(const SurfaceTopology& topology, const BarycentricImage& map, const Points2& image,
                      const TargetMeasure& target, double goodEnough, const Execution& execution) {
  return balancedParts(topology, map, image, target, goodEnough, onePart(topology.faces(), image.rows()), execution);
}

Points2 balancedStart(const DiskMesh& disk, const Points2& image, const TargetMeasure& target, SolverBackend backend,
                      double goodEnough, const Execution& execution) {
  const SurfaceTopology& topology = disk.topology();
  return balancedStart(topology, planar(topology.faces(), topology.onBoundary(), {}, backend), image, target,
                       goodEnough, execution);
}

Points2 balancedPeriodicStart(const SurfaceTopology& topology, const Points2& image, const Points2& shifts,
                              const std::vector<char>& held, const TargetMeasure& target, SolverBackend backend,
                              double goodEnough, const Execution& execution) {
  return balancedStart(topology, planar(topology.faces(), held, shifts, backend), image, target, goodEnough, execution);
}

Points2 reviveCollapsedFaces(const DiskMesh& disk, const Points2& image, const TargetMeasure& target,
                             SolverBackend backend, double collapsed) {
  Points2 result = image;
  for (const int rings : {3, 6, 12}) {
    const Eigen::VectorXd logs = logRatios(signedFaceAreas(result, disk.mesh().faces()), target.faces());
    if (!(logs.minCoeff() <= std::log(collapsed))) return result;
    const std::vector<char> held = heldAround(
        disk.mesh().faces(), disk.topology().onBoundary(), logs.array() <= std::log(collapsed), rings);
    result = balancedParts(disk.topology(), planar(disk.mesh().faces(), held, {}, backend), result, target, 0,
                           partsBetween(held, disk.mesh().faces()), {});
  }
  return result;
}

}  // namespace authalic
