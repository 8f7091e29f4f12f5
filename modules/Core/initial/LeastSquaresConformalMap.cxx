#include "Core/initial/LeastSquaresConformalMap.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <complex>
#include <string>

#include "Core/base/Error.h"
#include "Core/geometry/Areas.h"
#include "Core/initial/BoundaryPair.h"
#include "Core/initial/ConformalEnergy.h"

namespace authalic {
namespace {

using Complex = std::complex<double>;

constexpr double kShift = 1e-9;  // ε of M + εB, with the boundary's length as unit: keeps the matrix definite
constexpr int kMostVectors = 3;  // of the subspace iteration

std::size_t at(int i) { return static_cast<std::size_t>(i); }

std::array<int, 2> pinsOf(const DiskMesh& disk, const LeastSquaresConformalMapOptions& options) {
  if (options.firstPin < 0) return farthestBoundaryPair(disk);
  for (const int pin : {options.firstPin, options.secondPin}) {
    if (pin < disk.mesh().vertexCount() && disk.topology().onBoundary()[at(pin)]) continue;
    throw InvalidArgument("Pins on the boundary loop are required, but vertex " + std::to_string(pin) +
                          " is not on it; choose one of its " + std::to_string(disk.boundary().size()) + " vertices.");
  }
  return {options.firstPin, options.secondPin};
}

// M z = 0 at every vertex but the pins, which lie at 0 and (distance, 0).
Points2 solveWithPins(const ConformalEnergy& energy, int n, const std::array<int, 2>& pins, double distance,
                      SolverBackend backend) {
  std::vector<int> unknown(at(2 * n), 0);
  std::vector<double> known(at(2 * n), 0);
  for (const int pin : pins) unknown[at(pin)] = unknown[at(n + pin)] = -1;
  known[at(pins[1])] = distance;
  int count = 0;
  for (int& u : unknown) u = u < 0 ? -1 : count++;
  SparseMatrix free(count, count);
  free.reserve(energy.matrix().nonZeros());
  Eigen::VectorXd right = Eigen::VectorXd::Zero(count);
  for (int column = 0; column < 2 * n; ++column) {
    const int c = unknown[at(column)];
    if (c >= 0) free.startVec(c);
    for (SparseMatrix::InnerIterator entry(energy.matrix(), column); entry; ++entry) {
      const int r = unknown[at(static_cast<int>(entry.row()))];
      if (r >= 0 && c >= 0) free.insertBack(r, c) = entry.value();
      if (r >= 0 && c < 0) right[r] -= entry.value() * known[at(column)];
      if (r < 0 && c >= 0) right[c] -= entry.value() * known[at(static_cast<int>(entry.row()))];
    }
  }
  free.finalize();
  free.makeCompressed();
  SparseSolver solver(backend);
  solver.compute(free);
  const Eigen::VectorXd solution = solver.solve(right);
  Points2 image(n, 2);
  for (int i = 0; i < 2 * n; ++i) image(i % n, i / n) = unknown[at(i)] < 0 ? known[at(i)] : solution[unknown[at(i)]];
  return image;
}

// Smallest eigenpair of M z = λ B z with zᴴ B 1 = 0, B the lumped length of the boundary (total 1).
class SpectralProblem {
 public:
  SpectralProblem(const DiskMesh& disk, const ConformalEnergy& energy, SolverBackend backend)
      : loop_(disk.boundary()), n_(disk.mesh().vertexCount()), matrix_(energy.matrix()), solver_(backend),
        block_(n_, std::min(kMostVectors, static_cast<int>(loop_.size()) - 1)) {
    measureBoundary(disk.mesh());
    SparseMatrix shifted = matrix_;
    for (const int v : loop_) {
      shifted.coeffRef(v, v) += kShift * length_[v];
      shifted.coeffRef(n_ + v, n_ + v) += kShift * length_[v];
    }
    solver_.compute(shifted);
    startFromCircles();
  }

  // One step of subspace iteration. @return the change of the first vector on the boundary
  double iterate() {
    const Eigen::VectorXcd before = block_.col(0);
    Eigen::MatrixXd right = Eigen::MatrixXd::Zero(2 * n_, block_.cols());
    for (const int v : loop_) {
      right.row(v) = length_[v] * block_.row(v).real();
      right.row(n_ + v) = length_[v] * block_.row(v).imag();
    }
    const Eigen::MatrixXd solution = solver_.solve(right);
    block_.real() = solution.topRows(n_);
    block_.imag() = solution.bottomRows(n_);
    for (Eigen::Index k = 0; k < block_.cols(); ++k)
      block_.col(k).array() -= length_.cast<Complex>().dot(block_.col(k));
    rotateToRitzVectors();
    // The phase of an eigenvector is free: compare after the best rotation.
    const Complex overlap = before.dot(length_.asDiagonal() * block_.col(0));
    const Complex phase = std::abs(overlap) > 0 ? overlap / std::abs(overlap) : Complex(1);
    double change = 0;
    for (const int v : loop_) change += length_[v] * std::norm(block_(v, 0) - phase * before[v]);
    return std::sqrt(change);
  }

  [[nodiscard]] Points2 image() const {
    Points2 points(n_, 2);
    points << block_.col(0).real(), block_.col(0).imag();
    return points;
  }

 private:
  void measureBoundary(const TriangleMesh& mesh) {
    length_ = Eigen::VectorXd::Zero(n_);
    for (std::size_t k = 0; k < loop_.size(); ++k) {
      const int a = loop_[k], b = loop_[(k + 1) % loop_.size()];
      const double half = 0.5 * (mesh.point(a) - mesh.point(b)).norm();
      length_[a] += half;
      length_[b] += half;
    }
    if (!(length_.sum() > 0)) throw GeometryError("A boundary with positive length is required, but it has none.");
    length_ /= length_.sum();
  }

  // e^{ikθ} of the arc length, k = 1, 2, 3: the start vertex changes a phase only.
  void startFromCircles() {
    block_.setZero();
    double arc = 0;
    for (const int v : loop_) {
      arc += length_[v];
      const Complex once = std::polar(1.0, 2 * M_PI * arc);
      for (Eigen::Index k = 0; k < block_.cols(); ++k) block_(v, k) = k == 0 ? once : block_(v, k - 1) * once;
    }
  }

  void rotateToRitzVectors() {
    Eigen::MatrixXd stacked(2 * n_, block_.cols());
    stacked << block_.real(), block_.imag();
    const Eigen::MatrixXd image = matrix_.selfadjointView<Eigen::Lower>() * stacked;
    Eigen::MatrixXcd product(n_, block_.cols());
    product.real() = image.topRows(n_);
    product.imag() = image.bottomRows(n_);
    const Eigen::MatrixXcd gram = block_.adjoint() * length_.asDiagonal() * block_;
    const Eigen::MatrixXcd form = block_.adjoint() * product;
    const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXcd> ritz(0.5 * (form + form.adjoint()), gram);
    if (ritz.info() == Eigen::Success) block_ = block_ * ritz.eigenvectors();
  }

  const std::vector<int>& loop_;
  int n_;
  const SparseMatrix& matrix_;
  SparseSolver solver_;
  Eigen::VectorXd length_;
  Eigen::MatrixXcd block_;
};

Points2 solveSpectral(const DiskMesh& disk, const ConformalEnergy& energy,
                      const LeastSquaresConformalMapOptions& options, const Execution& execution,
                      LeastSquaresConformalMapResult& result) {
  SpectralProblem problem(disk, energy, options.solver);
  result.status = Status::NotConverged;
  while (result.iterations < options.maxIterations && result.status == Status::NotConverged) {
    execution.throwIfCancelled();
    result.history.push_back(problem.iterate());
    ++result.iterations;
    if (result.history.back() <= options.tolerance) result.status = Status::Converged;
  }
  return problem.image();
}

// Area that of the surface, centroid 0, second pin to the right of the first.
void normalise(const TriangleMesh& surface, const std::array<int, 2>& pins, double area, Points2& image) {
  if (!(area > 0)) {
    throw GeometryError("An image with positive area is required, but the conformal energy left none; "
                        "look for degenerate faces, or choose other pins.");
  }
  const Eigen::VectorXd areas = signedFaceAreas(image, surface.faces());
  Eigen::RowVector2d centroid(0, 0);
  for (int f = 0; f < surface.faceCount(); ++f) {
    for (int k = 0; k < 3; ++k) centroid += areas[f] / (3 * area) * image.row(surface.faces()(f, k));
  }
  const Eigen::RowVector2d axis = (image.row(pins[1]) - image.row(pins[0])).normalized();
  Eigen::Matrix2d turn;
  turn << axis[0], -axis[1], axis[1], axis[0];
  if (!turn.allFinite()) turn.setIdentity();
  image.rowwise() -= centroid;
  image *= turn * std::sqrt(faceAreas(surface).sum() / area);
}

}  // namespace

const char* conformalPinsName(ConformalPins pins) noexcept {
  return pins == ConformalPins::Spectral ? "spectral" : "two-vertices";
}

void LeastSquaresConformalMapOptions::validate() const {
  if ((firstPin < 0) != (secondPin < 0) || firstPin < -1 || secondPin < -1 ||
      (firstPin >= 0 && firstPin == secondPin)) {
    throw InvalidArgument("Two different pins, or none (-1 twice), are required, but they are " +
                          std::to_string(firstPin) + " and " + std::to_string(secondPin) + ".");
  }
  if (!(tolerance > 0) || maxIterations < 1) {
    throw InvalidArgument("A positive tolerance and at least 1 iteration are required, but they are " +
                          std::to_string(tolerance) + " and " + std::to_string(maxIterations) + ".");
  }
  if (!SparseSolver::available(solver)) {
    throw InvalidArgument("A solver that is part of this build is required, but " +
                          std::string(solverBackendName(solver)) + " was not built in.");
  }
}

LeastSquaresConformalMapResult leastSquaresConformalMap(const DiskMesh& disk,
                                                        const LeastSquaresConformalMapOptions& options,
                                                        const Execution& execution) {
  options.validate();
  const auto start = std::chrono::steady_clock::now();
  execution.report(0, "Least-squares conformal map");
  const TriangleMesh& mesh = disk.mesh();
  const std::array<int, 2> pins = pinsOf(disk, options);
  const double distance = (mesh.point(pins[1]) - mesh.point(pins[0])).norm();
  if (!(distance > 0)) {
    throw GeometryError("Two pins at different places are required, but vertices " + std::to_string(pins[0]) + " and " +
                        std::to_string(pins[1]) + " coincide in space; choose others.");
  }
  const ConformalEnergy energy(disk);
  execution.throwIfCancelled();
  LeastSquaresConformalMapResult result;
  result.firstPin = pins[0];
  result.secondPin = pins[1];
  if (options.pins == ConformalPins::Spectral) {
    result.image = solveSpectral(disk, energy, options, execution, result);
  } else {
    result.image = solveWithPins(energy, mesh.vertexCount(), pins, distance, options.solver);
    result.status = Status::Converged;
  }
  const double area = energy.area(result.image);
  normalise(mesh, pins, area, result.image);
  result.conformalEnergy = energy.dirichlet(result.image) / energy.area(result.image) - 1;
  result.flippedFaces = countFlippedFaces(result.image, mesh.faces());
  result.degenerateFaces = static_cast<int>((faceAreas(mesh).array() <= 0).count());
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  execution.report(1, "Least-squares conformal map");
  return result;
}

}  // namespace authalic
