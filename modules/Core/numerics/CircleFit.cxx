#include "Core/numerics/CircleFit.h"

#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <string>

#include "Core/base/Error.h"

namespace authalic {
namespace {

std::string noCircle(Eigen::Index count, const std::string& where) {
  const std::string required =
      "At least three points that do not lie on one line are required for a circle, but " + std::to_string(count);
  if (count < 3) return required + " are given.";
  return required + " lie " + where +
         ": a map has shrunk their loop beyond the digits of a number; for a long tube take the domain "
         "periodic-rectangle.";
}

}  // namespace

FittedCircle fitCircle(const Points2& points, const std::vector<int>& vertices) {
  const auto count = static_cast<Eigen::Index>(vertices.size());
  Points2 chosen(count, 2);
  for (Eigen::Index k = 0; k < count; ++k) chosen.row(k) = points.row(vertices[static_cast<std::size_t>(k)]);
  const Eigen::RowVector2d middle =
      count > 0 ? Eigen::RowVector2d(chosen.colwise().mean()) : Eigen::RowVector2d(0, 0);
  chosen.rowwise() -= middle;
  const double size = count > 0 ? chosen.cwiseAbs().maxCoeff() : 0;
  if (count < 3 || !(size > 0)) throw GeometryError(noCircle(count, "in one place"));
  chosen /= size;
  Eigen::MatrixX3d system(count, 3);
  system << 2 * chosen, Eigen::VectorXd::Ones(count);
  const Eigen::ColPivHouseholderQR<Eigen::MatrixX3d> factor(system);
  if (factor.rank() < 3) throw GeometryError(noCircle(count, "on one line"));
  const Eigen::Vector3d solution = factor.solve(chosen.rowwise().squaredNorm());
  FittedCircle circle;
  const Eigen::RowVector2d centre = solution.head(2).transpose();
  const double radius = std::sqrt(std::max(solution[2] + centre.squaredNorm(), 0.0));
  for (Eigen::Index k = 0; k < count; ++k) {
    circle.deviation = std::max(circle.deviation, std::abs((chosen.row(k) - centre).norm() / radius - 1));
  }
  circle.centre = middle + size * centre;
  circle.radius = size * radius;
  return circle;
}

}  // namespace authalic
