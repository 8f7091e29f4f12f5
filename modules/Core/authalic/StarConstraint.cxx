#include "Core/authalic/StarConstraint.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "Core/geometry/Areas.h"

namespace authalic {
namespace {

constexpr int kMostIterations = 100;
constexpr double kAccuracy = 0.02;
constexpr double kRegularisation = 1e-9;  // stars depend on each other on three-colourable meshes

}  // namespace

double starResidual(const AreaFunctional& areas, const Eigen::VectorXd& targets, const Coordinates& image) {
  const Eigen::VectorXd a = areas.areas(image);
  if (!(a.minCoeff() > 0)) return std::numeric_limits<double>::infinity();
  const Eigen::VectorXd stars = vertexStars(a / a.sum(), areas.faces(), areas.vertexCount());
  double worst = 0;
  for (Eigen::Index v = 0; v < stars.size(); ++v) {
    if (targets[v] > 0) worst = std::max(worst, std::abs(std::log(stars[v] / targets[v])));
  }
  return worst;
}

StarConstraint::StarConstraint(const AreaFunctional& areas, const Eigen::VectorXd& targets, SolverBackend backend,
                               AnalysedSystems& systems)
    : areas_(areas), targets_(targets), backend_(backend), systems_(systems) {}

void StarConstraint::linearise(const Eigen::VectorXd& faceAreas, const AreaFunctional::Gradients& gradients,
                               const Eigen::VectorXd& weights) {
  if (preconditioner_ == nullptr) {
    preconditioner_ = systems_.of(areas_.vertexCount(), areas_.faces(), backend_, PatternUse::Once);
  }
  gradients_ = &gradients;
  total_ = faceAreas.sum();
  lacking_ = total_ * targets_ - vertexStars(faceAreas, areas_.faces(), areas_.vertexCount());
  std::vector<double> values(static_cast<std::size_t>(6 * weights.size()));
  for (Eigen::Index f = 0; f < weights.size(); ++f) {
    std::fill_n(&values[static_cast<std::size_t>(6 * f)], 6, 1 / (9 * weights[f]));
  }
  SparseMatrix matrix = preconditioner_->assemble(values);
  for (int v = 0; v < matrix.cols(); ++v) {
    double& diagonal = matrix.valuePtr()[matrix.outerIndexPtr()[v]];
    diagonal = diagonal > 0 ? diagonal * (1 + kRegularisation) : 1;  // 1 where no face uses the vertex
  }
  preconditioner_->factorize(matrix);
}

Eigen::VectorXd StarConstraint::starChanges(const Eigen::VectorXd& step) const {
  const Faces& faces = areas_.faces();
  Eigen::VectorXd changes = Eigen::VectorXd::Zero(faces.rows());
  for (Eigen::Index f = 0; f < faces.rows(); ++f) {
    for (int k = 0; k < 6; ++k) {
      const int u = areas_.unknown(faces(f, k / 2), k % 2);
      if (u >= 0) changes[f] += (*gradients_)(f, k) * step[u];
    }
  }
  return vertexStars(changes, faces, areas_.vertexCount());
}

Eigen::VectorXd StarConstraint::pull(const Eigen::VectorXd& multipliers) const {
  const Faces& faces = areas_.faces();
  Eigen::VectorXd result = Eigen::VectorXd::Zero(areas_.unknownCount());
  for (Eigen::Index f = 0; f < faces.rows(); ++f) {
    const double ofFace = (multipliers[faces(f, 0)] + multipliers[faces(f, 1)] + multipliers[faces(f, 2)]) / 3;
    for (int k = 0; k < 6; ++k) {
      const int u = areas_.unknown(faces(f, k / 2), k % 2);
      if (u >= 0) result[u] += (*gradients_)(f, k) * ofFace;
    }
  }
  return result;
}

double StarConstraint::farthest(const Eigen::VectorXd& errors) const {
  return (targets_.array() > 0).select(errors.array().abs() / (total_ * targets_.array()), 0.0).maxCoeff();
}

Eigen::VectorXd StarConstraint::solve(const SparseSolver& system, const Eigen::VectorXd& right) const {
  Eigen::VectorXd step = system.solve(right), left = lacking_ - starChanges(step), direction, way;
  const double enough = kAccuracy * farthest(left);
  double before = 1;
  for (int k = 0; k < kMostIterations && farthest(left) > enough; ++k) {
    const Eigen::VectorXd scaled = preconditioner_->solver().solve(left);
    const double square = left.dot(scaled);
    direction = k == 0 ? scaled : Eigen::VectorXd(scaled + (square / before) * direction);
    before = square;
    way = system.solve(pull(direction));
    const Eigen::VectorXd changes = starChanges(way);
    const double part = square / direction.dot(changes);
    step += part * way;
    left -= part * changes;
  }
  return step;
}

}  // namespace authalic
