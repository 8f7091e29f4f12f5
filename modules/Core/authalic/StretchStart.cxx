#include "Core/authalic/StretchStart.h"

#include <limits>

#include "Core/authalic/LieFlowStages.h"
#include "Core/authalic/StretchWeights.h"
#include "Core/base/Error.h"
#include "Core/geometry/Areas.h"
#include "Core/initial/BarycentricSystem.h"

namespace authalic {
namespace {

constexpr int kRounds = 7;

}  // namespace

StretchStart stretchStart(const DiskMesh& disk, const Points2& image, const TargetMeasure& target,
                          SolverBackend backend, double goodEnough, const Execution& execution) {
  const Faces& faces = disk.mesh().faces();
  BarycentricSolver solver(faces, disk.topology().onBoundary(), backend, execution.threads());
  HalfEdgeWeights weights = cotangentWeights(disk.mesh());
  StretchStart best{image, std::numeric_limits<double>::infinity(), disk.mesh().faceCount()};
  Points2 current = image;
  for (int round = 0; round <= kRounds && best.error > goodEnough && !execution.cancelled(); ++round) {
    execution.report(double(round) / (kRounds + 1), "Stretching the start");
    try {
      solver.solve(weights, current);
    } catch (const SolverError&) {
      break;
    }
    const Eigen::VectorXd areas = signedFaceAreas(current, faces);
    const Eigen::VectorXd stars = vertexStars(areas, faces, disk.mesh().vertexCount());
    const double error = measureStars(stars, target.vertices()).meanAbsLog;
    if (error < best.error) best = {current, error, static_cast<int>((areas.array() <= 0).count())};
    weights = stretchWeights(current, faces, target.faces());
  }
  return best;
}

}  // namespace authalic
