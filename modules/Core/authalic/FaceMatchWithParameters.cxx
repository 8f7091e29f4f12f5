#include <Eigen/Cholesky>

#include <algorithm>

#include "Core/authalic/FaceMatch.h"

namespace authalic {
namespace {

constexpr double kRegularisation = 1e-10;  // of the diagonal: a translation of the whole is without effect
constexpr Eigen::Index kAtOnce = 32;       // right-hand sides

using Matrix6 = Eigen::Matrix<double, 6, 6>;
using Vector6 = Eigen::Matrix<double, 6, 1>;
using Moves6 = Eigen::Matrix<double, 6, Eigen::Dynamic>;

// Of the corners of a face, by the real and the imaginary part of each parameter.
bool movesOfFace(const CornerMoves& parameters, Eigen::Index face, Moves6& result) {
  bool any = false;
  result.setZero();
  for (Eigen::Index k = 0; k < 3; ++k) {
    const int row = parameters.row[static_cast<std::size_t>(3 * face + k)];
    for (Eigen::Index j = 0; row >= 0 && j < parameters.moves.cols(); ++j) {
      const std::complex<double> move = parameters.moves(row, j);
      result.block<2, 2>(2 * k, 2 * j) << move.real(), -move.imag(), move.imag(), move.real();
    }
    any = any || row >= 0;
  }
  return any;
}

// Derivatives of an area by the corners in the plane.
Vector6 slopesOf(const AreaFunctional::Corners& corners) {
  Vector6 result;
  for (int k = 0; k < 3; ++k) {
    const Eigen::RowVector2d side = corners.row((k + 2) % 3) - corners.row((k + 1) % 3);
    result.segment<2>(2 * k) << -0.5 * side[1], 0.5 * side[0];
  }
  return result;
}

}  // namespace

// [H B; Bᵀ C] with two columns of B for every parameter, by the Schur complement of H. Only few rows of B are not 0.
Coordinates FaceMatch::stepWithParameters(const Coordinates& image, const CornerMoves& parameters) const {
  const Faces& faces = areas_.faces();
  const Eigen::VectorXd a = areas_.areas(image);
  const double total = a.sum();
  const Eigen::Index count = 2 * parameters.moves.cols();
  Eigen::MatrixXd corner = Eigen::MatrixXd::Zero(count, count);
  Eigen::VectorXd right = Eigen::VectorXd::Zero(count);
  std::vector<int> rowOf(static_cast<std::size_t>(areas_.unknownCount()), -1), unknowns;
  std::vector<Eigen::RowVectorXd> border;
  Moves6 moves(6, count), forces(6, count);
  for (Eigen::Index f = 0; f < faces.rows(); ++f) {
    if (!movesOfFace(parameters, f, moves)) continue;
    const AreaFunctional::Corners corners = areas_.corners(image, static_cast<int>(f));
    const Vector6 slopes = slopesOf(corners);
    Matrix6 element = weights_[f] * slopes * slopes.transpose();
    Vector6 down = weights_[f] * (targets_[f] * total - a[f]) * slopes;
    for (int k = 0; k < 3; ++k) {
      for (int l = 0; l < 3; ++l) {
        element.block<2, 2>(2 * k, 2 * l).diagonal().array() += edgeStiffness(f, damping_ * stiffness_[f], k, l);
        down.segment<2>(2 * k) -= pull_ * shape_.stiffness(f, k, l) * corners.row(l).transpose();
      }
    }
    forces.noalias() = element * moves;
    corner.noalias() += moves.transpose() * forces;
    right.noalias() += moves.transpose() * down;
    const AreaFunctional::Directions directions = areas_.directions(frames_, static_cast<int>(f));
    for (int k = 0; k < 6; ++k) {
      const int u = areas_.unknown(faces(f, k / 2), k % 2);
      if (u < 0) continue;
      int& row = rowOf[static_cast<std::size_t>(u)];
      if (row < 0) {
        row = static_cast<int>(unknowns.size());
        unknowns.push_back(u);
        border.push_back(Eigen::RowVectorXd::Zero(count));
      }
      border[static_cast<std::size_t>(row)] += directions.row(k) * forces.middleRows<2>(k / 2 * 2);
    }
  }
  Eigen::MatrixXd sides(static_cast<Eigen::Index>(unknowns.size()), count);
  for (std::size_t i = 0; i < border.size(); ++i) sides.row(static_cast<Eigen::Index>(i)) = border[i];
  const SparseSolver& solver = system_->solver();
  right.noalias() -= sides.transpose() * Eigen::VectorXd(solver.solve(right_))(unknowns);
  for (Eigen::Index first = 0; first < count; first += kAtOnce) {
    const Eigen::Index width = std::min(kAtOnce, count - first);
    Eigen::MatrixXd some = Eigen::MatrixXd::Zero(areas_.unknownCount(), width);
    some(unknowns, Eigen::all) = sides.middleCols(first, width);
    some = solver.solve(some);
    corner.middleCols(first, width).noalias() -= sides.transpose() * some(unknowns, Eigen::all);
  }
  corner.diagonal().array() += kRegularisation * corner.diagonal().maxCoeff();
  const Eigen::VectorXd along = corner.selfadjointView<Eigen::Lower>().ldlt().solve(right);
  Eigen::VectorXd own = right_;
  const Eigen::VectorXd pulled = sides * along;
  for (std::size_t i = 0; i < unknowns.size(); ++i) own[unknowns[i]] -= pulled[static_cast<Eigen::Index>(i)];
  Coordinates result = areas_.displacement(frames_, solver.solve(own));
  for (Eigen::Index j = 0; j < count / 2; ++j) {
    result.row(areas_.vertexCount() + j) << along[2 * j], along[2 * j + 1];
  }
  return result;
}

}  // namespace authalic
