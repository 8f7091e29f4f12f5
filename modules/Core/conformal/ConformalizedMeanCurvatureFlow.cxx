#include "Core/conformal/ConformalizedMeanCurvatureFlow.h"

#include <Eigen/Geometry>

#include <chrono>
#include <cmath>
#include <string>
#include <utility>

#include "Core/base/Error.h"
#include "Core/geometry/Areas.h"
#include "Core/geometry/SphericalAreas.h"
#include "Core/initial/ConformalEnergy.h"
#include "Core/numerics/SphereMobius.h"

namespace authalic {
namespace {

Eigen::VectorXd vertexAreas(const Points3& points, const Faces& faces) {
  Eigen::VectorXd areas(faces.rows());
  for (Eigen::Index f = 0; f < faces.rows(); ++f) {
    const Eigen::Vector3d a = points.row(faces(f, 0)), b = points.row(faces(f, 1)), c = points.row(faces(f, 2));
    areas[f] = 0.5 * (b - a).cross(c - a).norm();
  }
  return vertexStars(areas, faces, static_cast<int>(points.rows()));
}

// Area 4π, centroid 0. @return the vertex areas after it
Eigen::VectorXd rescale(const Faces& faces, Points3& points) {
  Eigen::VectorXd mass = vertexAreas(points, faces);
  const double area = mass.sum();
  const Eigen::RowVector3d centroid = mass.transpose() * points / area;
  points = (points.rowwise() - centroid) * std::sqrt(4 * M_PI / area);
  return mass * (4 * M_PI / area);
}

// The step M + δ L_0, whose pattern and off-diagonal entries never change.
class FlowStep {
 public:
  FlowStep(const TriangleMesh& surface, double timeStep, SolverBackend backend)
      : matrix_(timeStep * shapeStiffness(surface)), solver_(backend, PatternUse::Reused) {
    solver_.analyze(matrix_);
    diagonal_.reserve(static_cast<std::size_t>(matrix_.cols()));
    for (int v = 0; v < matrix_.cols(); ++v) diagonal_.push_back(matrix_.valuePtr()[matrix_.outerIndexPtr()[v]]);
  }

  [[nodiscard]] Points3 operator()(const Points3& points, const Eigen::VectorXd& mass) {
    // The lower triangle keeps the diagonal first in every column.
    for (int v = 0; v < matrix_.cols(); ++v) {
      matrix_.valuePtr()[matrix_.outerIndexPtr()[v]] = diagonal_[static_cast<std::size_t>(v)] + mass[v];
    }
    solver_.factorize(matrix_);
    return solver_.solve(mass.asDiagonal() * points);
  }

 private:
  SparseMatrix matrix_;
  SparseSolver solver_;
  std::vector<double> diagonal_;
};

}  // namespace

void ConformalizedMeanCurvatureFlowOptions::validate() const {
  if (!(timeStep > 0) || !(tolerance > 0) || maxIterations < 0) {
    throw InvalidArgument("A positive time step and tolerance and at least 0 iterations are required, but they are " +
                          std::to_string(timeStep) + ", " + std::to_string(tolerance) + " and " +
                          std::to_string(maxIterations) + ".");
  }
  if (!SparseSolver::available(solver)) {
    throw InvalidArgument("A solver that is part of this build is required, but " +
                          std::string(solverBackendName(solver)) + " was not built in.");
  }
}

SphericalMapResult conformalizedMeanCurvatureFlow(const SphereMesh& sphere,
                                                  const ConformalizedMeanCurvatureFlowOptions& options,
                                                  const Execution& execution) {
  options.validate();
  const auto start = std::chrono::steady_clock::now();
  const TriangleMesh& mesh = sphere.mesh();
  const Eigen::VectorXd surfaceMass = vertexStars(faceAreas(mesh), mesh.faces(), mesh.vertexCount());
  FlowStep step(mesh, options.timeStep, options.solver);
  Points3 points = mesh.points();
  Eigen::VectorXd mass = rescale(mesh.faces(), points);
  SphericalMapResult result;
  result.status = Status::NotConverged;
  while (result.status == Status::NotConverged && result.iterations < options.maxIterations) {
    if (execution.cancelled()) {
      result.status = Status::Cancelled;
      break;
    }
    execution.report(double(result.iterations) / options.maxIterations, "Mean curvature flow");
    Points3 next = step(points, mass);
    mass = rescale(mesh.faces(), next);
    const Eigen::VectorXd growth = next.rowwise().norm() - points.rowwise().norm();
    result.residual = std::sqrt(mass.dot(growth.cwiseAbs2()) / (4 * M_PI));
    result.history.push_back(result.residual);
    points = std::move(next);
    ++result.iterations;
    if (result.residual <= options.tolerance) result.status = Status::Converged;
  }
  result.image = points.rowwise().normalized();
  result.image = centreOfSphericalMassToOrigin(result.image, surfaceMass).map(result.image);
  result.flippedFaces = countFlippedOnSphere(result.image, mesh.faces());
  result.degenerateFaces = static_cast<int>((faceAreas(mesh).array() <= 0).count());
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return result;
}

}  // namespace authalic
