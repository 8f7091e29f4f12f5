#include "Core/authalic/StretchStart.h"

#include <limits>

#include "Core/authalic/BalancedStart.h"
#include "Core/authalic/LieFlowStages.h"
#include "Core/authalic/NarrowFaces.h"
#include "Core/authalic/StretchWeights.h"
#include "Core/base/Error.h"
#include "Core/geometry/Areas.h"
#include "Core/initial/BarycentricSystem.h"

namespace authalic {
namespace {

constexpr int kRounds = 8;
constexpr double kPriceOfFolds = 100, kHighPriceOfFolds = 1000;  // mean |ln r| by the share of folded faces

// Mean |ln r| of the stars.
double starError(const DiskMesh& disk, const Points2& image, const TargetMeasure& target) {
  const Faces& faces = disk.mesh().faces();
  return measureStars(vertexStars(signedFaceAreas(image, faces), faces, disk.mesh().vertexCount()), target.vertices())
      .meanAbsLog;
}

struct Round {
  Points2 image;
  double price = std::numeric_limits<double>::infinity();  // mean |ln r| of the stars, and what folds cost
};

Round bestRound(const DiskMesh& disk, const Points2& image, const TargetMeasure& target, SolverBackend backend,
                double wellInSight, double priceOfFolds, const Execution& execution) {
  const Faces& faces = disk.mesh().faces();
  BarycentricSolver solver(faces, disk.topology().onBoundary(), backend, execution.threads());
  HalfEdgeWeights weights = cotangentWeights(disk.mesh());
  Round best;
  Points2 current = image;
  double error = best.price;
  for (int round = 0; round < kRounds && error > wellInSight && !execution.cancelled(); ++round) {
    execution.report(double(round) / kRounds, "Stretching the start");
    try {
      solver.solve(weights, current);
    } catch (const SolverError&) {
      break;
    }
    error = starError(disk, current, target);
    const auto folded = static_cast<double>((signedFaceAreas(current, faces).array() <= 0).count());
    const double price = error + priceOfFolds * folded / disk.mesh().faceCount();
    if (price < best.price) best = {current, price};
    weights = stretchWeights(current, faces, target.faces());
  }
  return best;
}

}  // namespace

StretchStart stretchStart(const DiskMesh& disk, const Points2& image, const TargetMeasure& target,
                          SolverBackend backend, double withinSight, double wellInSight, StretchRounds rounds,
                          const Execution& execution) {
  Round best;
  if (rounds != StretchRounds::None) {
    best = bestRound(disk, image, target, backend, wellInSight,
                     rounds == StretchRounds::Bold ? kPriceOfFolds : kHighPriceOfFolds, execution.part(0, 0.5));
  }
  bool stretched = true;
  if (best.price > withinSight) {
    Points2 balanced = balancedStart(disk, image, target, backend, withinSight, execution.part(0.5, 0.9));
    stretched = best.price <= starError(disk, balanced, target);
    if (!stretched) best.image = std::move(balanced);
  }
  return {openNarrowFaces(disk, best.image, target, backend, execution.part(0.9, 1)), stretched};
}

}  // namespace authalic
