#include "Core/authalic/FaceMatch.h"

#include <Eigen/Cholesky>

namespace authalic {
namespace {

// A step along x and y for every row of an image in the plane.
AreaFunctional::Frames wholePlane(Eigen::Index rows) {
  AreaFunctional::Frames result(rows, 4);
  result.rowwise() = Eigen::RowVector4d(1, 0, 0, 1);
  return result;
}

AreaFunctional::Corners cornersOf(const Coordinates& rows, const Faces& faces, Eigen::Index face) {
  AreaFunctional::Corners result(3, rows.cols());
  for (int k = 0; k < 3; ++k) result.row(k) = rows.row(faces(face, k));
  return result;
}

}  // namespace

// What the model of one step answers to a displacement: its second derivative times `displacement`, n×2.
Coordinates FaceMatch::answer(const AreaFunctional::Gradients& slopes, const Coordinates& displacement) const {
  const Faces& faces = areas_.faces();
  Coordinates result = Coordinates::Zero(displacement.rows(), 2);
  for (Eigen::Index f = 0; f < faces.rows(); ++f) {
    const AreaFunctional::Corners moves = cornersOf(displacement, faces, f);
    if (moves.isZero(0)) continue;
    double grows = 0;
    for (int k = 0; k < 3; ++k) grows += slopes.row(f).segment<2>(2 * k).dot(moves.row(k));
    for (int k = 0; k < 3; ++k) {
      auto force = result.row(faces(f, k));
      force += weights_[f] * grows * slopes.row(f).segment<2>(2 * k);
      for (int l = 0; l < 3; ++l) force += edgeStiffness(f, rigidity(f, damping_), k, l) * moves.row(l);
    }
  }
  return result;
}

// −∂Φ by the place of every vertex, n×2.
Coordinates FaceMatch::descent(const AreaFunctional::Gradients& slopes, const Coordinates& image) const {
  const Faces& faces = areas_.faces();
  Coordinates result = Coordinates::Zero(image.rows(), 2);
  for (Eigen::Index f = 0; f < faces.rows(); ++f) {
    const AreaFunctional::Corners corners = areas_.corners(image, static_cast<int>(f));
    for (int k = 0; k < 3; ++k) {
      auto force = result.row(faces(f, k));
      force += pulls_[f] * slopes.row(f).segment<2>(2 * k);
      for (int l = 0; l < 3; ++l) force -= pull_ * shape_.stiffness(f, k, l) * corners.row(l);
    }
  }
  return result;
}

// The frames' share of n×2 forces.
Eigen::VectorXd FaceMatch::onUnknowns(const Coordinates& forces) const {
  Eigen::VectorXd result = Eigen::VectorXd::Zero(areas_.unknownCount());
  for (int v = 0; v < areas_.vertexCount(); ++v) {
    for (int j = 0; j < areas_.freedom(v); ++j) {
      result[areas_.unknown(v, j)] = frames_.row(v).segment<2>(2 * j).dot(forces.row(v));
    }
  }
  return result;
}

// [H B; Bᵀ C] with a column of B for every joint move, by the Schur complement of H.
Coordinates FaceMatch::jointStep(const Coordinates& image, const std::vector<Coordinates>& moves) const {
  const auto count = static_cast<Eigen::Index>(moves.size());
  const AreaFunctional::Gradients slopes = areas_.gradients(image, wholePlane(image.rows()));
  const Coordinates down = descent(slopes, image);
  Eigen::MatrixXd sides(areas_.unknownCount(), count + 1), corner(count, count);
  Eigen::VectorXd right(count);
  sides.col(count) = right_;
  for (Eigen::Index m = 0; m < count; ++m) {
    const Coordinates forces = answer(slopes, moves[static_cast<std::size_t>(m)]);
    sides.col(m) = onUnknowns(forces);
    right[m] = moves[static_cast<std::size_t>(m)].cwiseProduct(down).sum();
    for (Eigen::Index n = 0; n < count; ++n) {
      corner(n, m) = moves[static_cast<std::size_t>(n)].cwiseProduct(forces).sum();
    }
  }
  const Eigen::MatrixXd solved = system_->solver().solve(sides);
  const auto border = sides.leftCols(count);
  corner -= border.transpose() * solved.leftCols(count);
  right -= border.transpose() * solved.col(count);
  const Eigen::VectorXd along = corner.selfadjointView<Eigen::Lower>().ldlt().solve(right);
  Coordinates result = areas_.displacement(frames_, solved.col(count) - solved.leftCols(count) * along);
  for (Eigen::Index m = 0; m < count; ++m) result += along[m] * moves[static_cast<std::size_t>(m)];
  return result;
}

}  // namespace authalic
