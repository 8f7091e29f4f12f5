#include "Core/conformal/SphereLaplacian.h"

#include "Core/initial/ConformalEnergy.h"

namespace authalic {

SphereLaplacian::SphereLaplacian(const SphereMesh& sphere, SolverBackend backend)
    : lower_(shapeStiffness(sphere.mesh())), solver_(backend) {
  const Eigen::Index free = lower_.rows() - 1;
  const SparseMatrix grounded = lower_.bottomRightCorner(free, free);
  solver_.compute(grounded);
  edges_.reserve(static_cast<std::size_t>(lower_.nonZeros() - lower_.rows()));
  for (int column = 0; column < lower_.cols(); ++column) {
    for (SparseMatrix::InnerIterator entry(lower_, column); entry; ++entry) {
      const int row = static_cast<int>(entry.row());
      if (row != column) edges_.push_back({column, row, -entry.value()});
    }
  }
}

Points3 SphereLaplacian::multiply(const Points3& f) const {
  Points3 image = Points3::Zero(f.rows(), 3);
  for (const Edge& edge : edges_) {
    const Eigen::RowVector3d force = edge.weight * (f.row(edge.from) - f.row(edge.to));
    image.row(edge.from) += force;
    image.row(edge.to) -= force;
  }
  return image;
}

double SphereLaplacian::energy(const Points3& f) const {
  double sum = 0;
  for (const Edge& edge : edges_) sum += edge.weight * (f.row(edge.from) - f.row(edge.to)).squaredNorm();
  return 0.5 * sum;
}

Eigen::MatrixXd SphereLaplacian::solve(const Eigen::MatrixXd& b) const {
  Eigen::MatrixXd x(b.rows(), b.cols());
  x.row(0).setZero();
  x.bottomRows(b.rows() - 1) = solver_.solve(b.bottomRows(b.rows() - 1));
  return x;
}

}  // namespace authalic
