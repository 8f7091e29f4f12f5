#include "Core/authalic/BalanceCurve.h"

#include <chrono>
#include <string>
#include <utility>

#include "Core/authalic/FinishStart.h"
#include "Core/authalic/SphericalAuthalicMap.h"
#include "Core/base/Error.h"
#include "Core/conformal/RiemannMap.h"
#include "Core/conformal/SphericalConformalMap.h"
#include "Core/distortion/SphericalDistortion.h"
#include "Core/geometry/Areas.h"
#include "Core/geometry/SphericalAreas.h"
#include "Core/transport/OptimalTransportMap.h"
#include "Core/transport/SphericalTransportMap.h"

namespace authalic {
namespace {

double secondsSince(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// What differs between the disk and the sphere, under the same names.
auto conformal(const DiskMesh& disk, const Execution& execution) { return riemannMap(disk, {}, execution); }
auto conformal(const SphereMesh& sphere, const Execution& execution) {
  return sphericalConformalMap(sphere, {}, execution);
}

Eigen::VectorXd areasOf(const DiskMesh& disk, const Points2& image) {
  return signedFaceAreas(image, disk.mesh().faces());
}
Eigen::VectorXd areasOf(const SphereMesh& sphere, const Points3& image) {
  return signedSolidAngles(image, sphere.mesh().faces());
}

auto transport(const DiskMesh& disk, const TargetMeasure& target, const SemiDiscreteTransportOptions& options,
               const Points2& sites, const Heights& start, const Execution& execution) {
  OptimalTransportMapOptions planar;
  static_cast<SemiDiscreteTransportOptions&>(planar) = options;
  return optimalTransportMap(disk, target.vertices(), planar, sites, execution, start);
}
auto transport(const SphereMesh& sphere, const TargetMeasure& target, const SemiDiscreteTransportOptions& options,
               const Points3& sites, const Heights& start, const Execution& execution) {
  SphericalTransportMapOptions round;
  static_cast<SemiDiscreteTransportOptions&>(round) = options;
  return sphericalTransportMap(sphere, target.vertices(), round, sites, execution, start);
}

auto finish(const DiskMesh& disk, const TargetMeasure& target, const AuthalicMapOptions& options, const Points2& start,
            const Execution& execution, AnalysedSystems& systems) {
  return authalicMap(disk, target, options, start, execution, &systems);
}
auto finish(const SphereMesh& sphere, const TargetMeasure& target, const AuthalicMapOptions& options,
            const Points3& start, const Execution& execution, AnalysedSystems& systems) {
  return sphericalAuthalicMap(sphere, target, options, start, execution, &systems);
}

DistortionSummary measured(const DiskMesh& disk, const Points2& image, const TargetMeasure& target) {
  return measureDistortion(disk.mesh(), image, target.shares()).summary;
}
DistortionSummary measured(const SphereMesh& sphere, const Points3& image, const TargetMeasure& target) {
  return summariseSphericalDistortion(sphere.mesh(), image, target.shares());
}

void requireNoFolds(int flippedFaces) {
  if (flippedFaces == 0) return;
  throw GeometryError("A conformal map without folds is required for a balance, but " + std::to_string(flippedFaces) +
                      " faces of it are folded.");
}

// Heights of the balances before, and where the next ones are to be expected.
class HeightsSoFar {
 public:
  [[nodiscard]] Heights expected(double balance) const {
    if (before_.size() == 0 || last_ == first_) return heights_;
    return heights_ + static_cast<long double>((balance - last_) / (last_ - first_)) * (heights_ - before_);
  }
  void add(double balance, Heights heights) {
    before_ = std::move(heights_);
    heights_ = std::move(heights);
    first_ = last_;
    last_ = balance;
  }

 private:
  Heights before_, heights_;
  double first_ = 0, last_ = 0;  // their balances
};

// What the maps of a curve hand on from one to the next.
struct KeptAlong {
  explicit KeptAlong(int threads) : systems(threads) {}

  HeightsSoFar heights;
  AnalysedSystems systems;
};

template <class Mesh, class Image>
BalancePoint pointOf(const Mesh& mesh, const TargetMeasure& target, double balance, const BalanceCurveOptions& options,
                     const Image& sites, KeptAlong& kept, const Execution& execution) {
  const auto begun = std::chrono::steady_clock::now();
  const TargetMeasure wanted = target.blended(mesh.mesh(), areasOf(mesh, sites), balance);
  SemiDiscreteTransportOptions cells;
  cells.tolerance = options.cellTolerance;
  cells.solver = options.solver;
  AuthalicMapOptions exact;
  exact.tolerance = options.tolerance;
  exact.vertexTolerance = options.vertexTolerance;
  exact.solver = options.solver;
  auto moved = transport(mesh, wanted, cells, sites, kept.heights.expected(balance), execution.part(0, 0.5));
  BalancePoint point;
  point.balance = balance;
  point.status = moved.status;
  if (moved.status == Status::Cancelled) return point;
  const Image& first = finishStart(mesh, wanted, moved.image, sites);
  const auto finished = finish(mesh, wanted, exact, first, execution.part(0.5, 1), kept.systems);
  point.metrics = measured(mesh, finished.image, target);
  point.transport = measured(mesh, moved.image, target);
  if (point.status == Status::Converged || finished.status == Status::Cancelled) point.status = finished.status;
  kept.heights.add(balance, std::move(moved.heights));
  point.seconds = secondsSince(begun);
  return point;
}

template <class Mesh>
BalanceCurve curveOf(const Mesh& mesh, const TargetMeasure& target, const BalanceCurveOptions& options,
                     const Execution& execution) {
  options.validate();
  requireTargetOf(mesh.mesh(), target);
  const auto begun = std::chrono::steady_clock::now();
  BalanceCurve curve;
  const auto start = conformal(mesh, execution.part(0, 0.1));
  if (start.status == Status::Cancelled) {
    curve.status = start.status;
    return curve;
  }
  requireNoFolds(start.flippedFaces);
  curve.startSeconds = secondsSince(begun);
  curve.status = Status::Converged;
  KeptAlong kept(execution.threads());
  const double count = static_cast<double>(options.balances.size());
  for (std::size_t k = 0; k < options.balances.size(); ++k) {
    const Execution part = execution.part(0.1 + 0.9 * double(k) / count, 0.1 + 0.9 * double(k + 1) / count);
    const BalancePoint point = pointOf(mesh, target, options.balances[k], options, start.image, kept, part);
    if (point.status != Status::Converged) curve.status = point.status;
    if (point.status == Status::Cancelled) break;
    curve.points.push_back(point);
  }
  return curve;
}

void requirePositive(double value, const char* what) {
  if (value > 0) return;
  throw InvalidArgument(std::string(what) + " of a balance curve must be positive; it is " + std::to_string(value) +
                        ".");
}

}  // namespace

void BalanceCurveOptions::validate() const {
  if (balances.empty()) throw InvalidArgument("At least one balance is required, but there is none.");
  for (const double balance : balances) {
    if (balance >= 0 && balance <= 1) continue;
    throw InvalidArgument("A balance must be from 0 (conformal) to 1 (area-preserving); one is " +
                          std::to_string(balance) + ".");
  }
  requirePositive(tolerance, "The tolerance");
  requirePositive(vertexTolerance, "The vertex tolerance");
  requirePositive(cellTolerance, "The cell tolerance");
}

BalanceCurve balanceCurve(const DiskMesh& disk, const TargetMeasure& target, const BalanceCurveOptions& options,
                          const Execution& execution) {
  return curveOf(disk, target, options, execution);
}

BalanceCurve balanceCurve(const SphereMesh& sphere, const TargetMeasure& target, const BalanceCurveOptions& options,
                          const Execution& execution) {
  return curveOf(sphere, target, options, execution);
}

}  // namespace authalic
