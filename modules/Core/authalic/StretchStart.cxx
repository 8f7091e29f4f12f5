#include "Core/authalic/StretchStart.h"

#include <limits>
#include <vector>

#include "Core/authalic/LieFlowStages.h"
#include "Core/base/Error.h"
#include "Core/geometry/Areas.h"
#include "Core/initial/BarycentricSystem.h"

namespace authalic {
namespace {

constexpr int kRounds = 7;

// ½ r cot θ of each half-edge, θ the opposite angle in the image: ¼ (x_i − x_k)·(x_j − x_k) / (S m), finite always.
HalfEdgeWeights stretchWeights(const StartSetting& setting, const Points2& image, const Eigen::VectorXd& target,
                               double total) {
  const Faces& faces = setting.topology.faces();
  HalfEdgeWeights weights(faces.rows(), 3);
  for (Eigen::Index f = 0; f < faces.rows(); ++f) {
    Eigen::Matrix<double, 3, 2> corners;
    for (int k = 0; k < 3; ++k) corners.row(k) = image.row(faces(f, k));
    if (setting.shifts.size() > 0) corners += setting.shifts.middleRows<3>(3 * f);
    for (int k = 0; k < 3; ++k) {
      const Eigen::RowVector2d apex = corners.row((k + 2) % 3);
      weights(f, k) =
          0.25 * (corners.row(k) - apex).dot(corners.row((k + 1) % 3) - apex) / (total * target[f]);
    }
  }
  return weights;
}

}  // namespace

StretchStart stretchStart(const TriangleMesh& surface, const StartSetting& setting, const Points2& image,
                          const TargetMeasure& target, SolverBackend backend, double goodEnough,
                          const Execution& execution) {
  const Faces& faces = setting.topology.faces();
  BarycentricSolver solver(faces, setting.held, backend);
  HalfEdgeWeights weights = cotangentWeights(surface);
  StretchStart best{image, std::numeric_limits<double>::infinity(), static_cast<int>(faces.rows())};
  Points2 current = image;
  for (int round = 0; round <= kRounds && best.error > goodEnough && !execution.cancelled(); ++round) {
    execution.report(double(round) / (kRounds + 1), "Stretching the start");
    try {
      solver.solve(weights, current, setting.shifts);
    } catch (const SolverError&) {
      break;
    }
    const Eigen::VectorXd areas = setting.shifts.size() == 0 ? signedFaceAreas(current, faces)
                                                              : periodicFaceAreas(current, setting.shifts, faces);
    const double error = measureStars(vertexStars(areas, faces, static_cast<int>(image.rows())), target.vertices())
                             .meanAbsLog;
    if (error < best.error) best = {current, error, static_cast<int>((areas.array() <= 0).count())};
    weights = stretchWeights(setting, current, target.faces(), areas.sum());
  }
  return best;
}

}  // namespace authalic
