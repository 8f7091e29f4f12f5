#include "Core/conformal/SphereLaplacian.h"

#include "Core/initial/ConformalEnergy.h"

namespace authalic {

SphereLaplacian::SphereLaplacian(const SphereMesh& sphere, SolverBackend backend)
    : lower_(shapeStiffness(sphere.mesh())), full_(lower_.selfadjointView<Eigen::Lower>()), solver_(backend) {
  const Eigen::Index free = lower_.rows() - 1;
  const SparseMatrix grounded = lower_.bottomRightCorner(free, free);
  solver_.compute(grounded);
}

Eigen::MatrixXd SphereLaplacian::multiply(const Eigen::MatrixXd& x) const { return full_ * x; }

Eigen::MatrixXd SphereLaplacian::solve(const Eigen::MatrixXd& b) const {
  Eigen::MatrixXd x(b.rows(), b.cols());
  x.row(0).setZero();
  x.bottomRows(b.rows() - 1) = solver_.solve(b.bottomRows(b.rows() - 1));
  return x;
}

double SphereLaplacian::energy(const Eigen::MatrixXd& x) const { return 0.5 * x.cwiseProduct(multiply(x)).sum(); }

}  // namespace authalic
