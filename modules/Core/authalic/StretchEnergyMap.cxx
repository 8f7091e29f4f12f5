#include "Core/authalic/StretchEnergyMap.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "Core/authalic/Stopwatch.h"
#include "Core/authalic/StretchWeights.h"
#include "Core/base/Error.h"
#include "Core/geometry/Areas.h"
#include "Core/initial/BarycentricSystem.h"
#include "Core/initial/BoundaryPlacement.h"

namespace authalic {
namespace {

constexpr double kCentre = 1e-4;  // least radius that is inverted

void require(bool condition, const std::string& required, double found) {
  if (condition) return;
  throw InvalidArgument("Stretch energy: " + required + " is required, but it is " + std::to_string(found) + ".");
}

// (E − 1)^½ = (Σ m (r − 1)²)^½
double residualOf(const Points2& image, const Faces& faces, const Eigen::VectorXd& target) {
  const Eigen::VectorXd areas = signedFaceAreas(image, faces);
  const double scale = target.sum() / areas.sum();
  double sum = 0;
  for (Eigen::Index f = 0; f < areas.size(); ++f) {
    if (target[f] > 0) sum += std::pow(areas[f] * scale - target[f], 2) / target[f];
  }
  return std::sqrt(sum);
}

std::vector<char> complementOf(std::vector<char> flags) {
  for (char& flag : flags) flag = !flag;
  return flags;
}

class StretchRounds {
 public:
  StretchRounds(const DiskMesh& disk, const TargetMeasure& target, const StretchEnergyMapOptions& options)
      : disk_(disk), target_(target.faces()),
        moving_(options.domain.isDisk() && options.boundary == StretchEnergyBoundary::Inverted),
        inside_(disk.mesh().faces(), disk.topology().onBoundary(), options.solver),
        outside_(disk.mesh().faces(), held_ = complementOf(disk.topology().onBoundary()), options.solver) {}

  [[nodiscard]] double residual(const Points2& image) const { return residualOf(image, disk_.mesh().faces(), target_); }

  [[nodiscard]] Points2 next(const Points2& image) {
    const HalfEdgeWeights weights = stretchWeights(image, disk_.mesh().faces(), target_);
    Points2 result = image;
    if (moving_) moveBoundary(weights, result);
    inside_.solve(weights, result);
    return result;
  }

 private:
  void moveBoundary(const HalfEdgeWeights& weights, Points2& image) {
    Points2 inverted = image;
    for (Eigen::Index v = 0; v < inverted.rows(); ++v) {
      inverted.row(v) /= std::max(inverted.row(v).squaredNorm(), kCentre * kCentre);
    }
    outside_.solve(weights, inverted);
    Eigen::RowVector2d centre(0, 0);
    for (const int v : disk_.boundary()) centre += inverted.row(v) / double(disk_.boundary().size());
    for (const int v : disk_.boundary()) {
      const Eigen::RowVector2d place = inverted.row(v) - centre;
      if (place.norm() > 0) image.row(v) = place.normalized();
    }
  }

  const DiskMesh& disk_;
  const Eigen::VectorXd& target_;
  bool moving_;
  std::vector<char> held_;
  BarycentricSolver inside_, outside_;
};

Points2 startOf(const DiskMesh& disk, const PlanarDomain& domain, const Points2& initial) {
  const BoundaryPlacement placement = recogniseBoundary(disk, domain, initial);
  Points2 start = initial;
  for (std::size_t i = 0; i < placement.vertices.size(); ++i) {
    start.row(placement.vertices[i]) = placement.points.row(static_cast<Eigen::Index>(i));
  }
  return start;
}

void iterate(StretchRounds& rounds, const StretchEnergyMapOptions& options, const Execution& execution,
             StretchEnergyMapResult& result) {
  result.residual = rounds.residual(result.image);
  while (result.status == Status::NotRun) {
    if (execution.cancelled()) {
      result.status = Status::Cancelled;
    } else if (result.iterations >= options.maxIterations) {
      result.status = Status::NotConverged;
    } else {
      execution.report(double(result.iterations) / options.maxIterations, "Lowering the stretch energy");
      result.history.push_back(result.residual);
      Points2 next = rounds.next(result.image);
      const double residual = rounds.residual(next);
      ++result.iterations;
      if (!(residual <= result.residual)) {
        result.status = Status::Stalled;
        break;
      }
      if (residual >= (1 - options.tolerance) * result.residual) result.status = Status::Converged;
      result.image = std::move(next);
      result.residual = residual;
    }
  }
}

}  // namespace

const char* stretchEnergyBoundaryName(StretchEnergyBoundary boundary) noexcept {
  return boundary == StretchEnergyBoundary::Inverted ? "inverted" : "held";
}

void StretchEnergyMapOptions::validate() const {
  require(tolerance > 0, "a tolerance above 0", tolerance);
  require(maxIterations >= 0, "a number of iterations of at least 0", maxIterations);
  if (!SparseSolver::available(solver)) {
    throw InvalidArgument("A solver that is part of this build is required, but " +
                          std::string(solverBackendName(solver)) + " was not built in.");
  }
}

StretchEnergyMapResult stretchEnergyMap(const DiskMesh& disk, const Points2& initial, const TargetMeasure& target,
                                        const StretchEnergyMapOptions& options, const Execution& execution) {
  options.validate();
  requireTargetOf(disk.mesh(), target);
  Stopwatch watch;
  StretchEnergyMapResult result;
  result.image = startOf(disk, options.domain, initial);
  StretchRounds rounds(disk, target, options);
  iterate(rounds, options, execution, result);
  result.flippedFaces = countFlippedFaces(result.image, disk.mesh().faces());
  if (result.status == Status::Converged && result.flippedFaces > 0) result.status = Status::NotConverged;
  result.seconds = watch.lap();
  execution.report(1, "Stretch energy");
  return result;
}

}  // namespace authalic
