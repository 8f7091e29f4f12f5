#include <Eigen/Cholesky>

#include <algorithm>
#include <utility>

#include "Core/authalic/FaceMatch.h"

namespace authalic {
namespace {

constexpr double kRegularisation = 1e-10;  // of the diagonal: a translation of the whole is without effect
constexpr Eigen::Index kAtOnce = 32;       // right-hand sides

using Vector6 = Eigen::Matrix<double, 6, 1>;
using Moves = Eigen::Matrix<double, 6, Eigen::Dynamic>;

// Of the corners of a face, by the real and the imaginary part of each parameter; whether any moves.
bool movesOfFace(const CornerMoves& parameters, Eigen::Index face, Moves& result) {
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

// [H B; Bᵀ C] (x, y) = (f, g) by the Schur complement of H. Only few rows of B are not 0.
class BorderedSystem {
 public:
  BorderedSystem(int unknownCount, Eigen::Index count)
      : corner_(Eigen::MatrixXd::Zero(count, count)), right_(Eigen::VectorXd::Zero(count)),
        rowOf_(static_cast<std::size_t>(unknownCount), -1) {}

  // C and g.
  void addCorner(const Moves& moves, const Moves& forces, const Vector6& down) {
    corner_.noalias() += moves.transpose() * forces;
    right_.noalias() += moves.transpose() * down;
  }

  void addSide(int unknown, const Eigen::RowVectorXd& values) {
    int& row = rowOf_[static_cast<std::size_t>(unknown)];
    if (row < 0) {
      row = static_cast<int>(unknowns_.size());
      unknowns_.push_back(unknown);
      sides_.push_back(Eigen::RowVectorXd::Zero(right_.size()));
    }
    sides_[static_cast<std::size_t>(row)] += values;
  }

  // x and y.
  [[nodiscard]] std::pair<Eigen::VectorXd, Eigen::VectorXd> solve(const SparseSolver& solver, Eigen::VectorXd f) {
    Eigen::MatrixXd sides(static_cast<Eigen::Index>(unknowns_.size()), right_.size());
    for (std::size_t i = 0; i < sides_.size(); ++i) sides.row(static_cast<Eigen::Index>(i)) = sides_[i];
    right_.noalias() -= sides.transpose() * Eigen::VectorXd(solver.solve(f))(unknowns_);
    for (Eigen::Index first = 0; first < right_.size(); first += kAtOnce) {
      const Eigen::Index width = std::min(kAtOnce, right_.size() - first);
      Eigen::MatrixXd some = Eigen::MatrixXd::Zero(f.size(), width);
      some(unknowns_, Eigen::all) = sides.middleCols(first, width);
      some = solver.solve(some);
      corner_.middleCols(first, width).noalias() -= sides.transpose() * some(unknowns_, Eigen::all);
    }
    corner_.diagonal().array() += kRegularisation * corner_.diagonal().maxCoeff();
    Eigen::VectorXd y = corner_.selfadjointView<Eigen::Lower>().ldlt().solve(right_);
    f(unknowns_) -= sides * y;
    return {solver.solve(f), std::move(y)};
  }

 private:
  Eigen::MatrixXd corner_;
  Eigen::VectorXd right_;
  std::vector<int> rowOf_, unknowns_;
  std::vector<Eigen::RowVectorXd> sides_;
};

}  // namespace

FaceMatch::PlanarModel FaceMatch::planarModel(const AreaFunctional::Corners& corners, Eigen::Index face,
                                              double lacking) const {
  const Vector6 slopes = slopesOf(corners);
  PlanarModel model{weights_[face] * slopes * slopes.transpose(), weights_[face] * lacking * slopes};
  for (int k = 0; k < 3; ++k) {
    for (int l = 0; l < 3; ++l) {
      const double stiffness = edgeStiffness(face, rigidity(face, damping_), k, l);
      model.second.block<2, 2>(2 * k, 2 * l).diagonal().array() += stiffness;
      model.down.segment<2>(2 * k) -= pull_ * shape_.stiffness(face, k, l) * corners.row(l).transpose();
    }
  }
  return model;
}

Coordinates FaceMatch::stepWithParameters(const Coordinates& image, const CornerMoves& parameters) const {
  const Eigen::VectorXd a = areas_.areas(image);
  const double total = a.sum();
  const Eigen::Index count = 2 * parameters.moves.cols();
  BorderedSystem system(areas_.unknownCount(), count);
  Moves moves(6, count), forces(6, count);
  for (int f = 0; f < static_cast<int>(a.size()); ++f) {
    if (!movesOfFace(parameters, f, moves)) continue;
    const PlanarModel model = planarModel(areas_.corners(image, f), f, targets_[f] * total - a[f]);
    forces.noalias() = model.second * moves;
    system.addCorner(moves, forces, model.down);
    const AreaFunctional::Directions directions = areas_.directions(frames_, f);
    for (int k = 0; k < 6; ++k) {
      const int u = areas_.unknown(areas_.faces()(f, k / 2), k % 2);
      if (u >= 0) system.addSide(u, directions.row(k) * forces.middleRows<2>(k / 2 * 2));
    }
  }
  const auto [step, along] = system.solve(system_->solver(), right_);
  Coordinates result = areas_.displacement(frames_, step);
  for (Eigen::Index j = 0; j < count / 2; ++j) {
    result.row(areas_.vertexCount() + j) << along[2 * j], along[2 * j + 1];
  }
  return result;
}

}  // namespace authalic
