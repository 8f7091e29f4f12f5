#include "Core/geometry/LaplacianEigenfunctions.h"

#include <Eigen/Eigenvalues>
#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "Core/base/Error.h"
#include "Core/geometry/Areas.h"
#include "Core/geometry/Laplacian.h"

namespace authalic {
namespace {

constexpr double kEqual = 1e-6;  // relative distance below which two eigenvalues count as one
constexpr Eigen::Index kBasis = 64;

/// L, M, and (L + σM)⁻¹ M on functions orthogonal to the constants.
class Problem {
 public:
  Problem(const TriangleMesh& surface, SolverBackend backend)
      : mass_(vertexStars(faceAreas(surface), surface.faces(), surface.vertexCount())),
        solver_(backend) {
    area_ = mass_.sum();
    if (!(area_ > 0)) throw GeometryError("A surface with area is required for its eigenfunctions, but it has none.");
    mass_ = mass_.cwiseMax(1e-12 * area_ / static_cast<double>(mass_.size()));
    area_ = mass_.sum();
    shift_ = 1e-3 * 8 * M_PI / area_;  // far below λ_1 ≈ 8π / area of a round sphere
    SparseMatrix shifted = cotangentStiffness(surface);
    for (Eigen::Index i = 0; i < mass_.size(); ++i) shifted.coeffRef(i, i) += shift_ * mass_[i];
    solver_.compute(shifted);
  }

  [[nodiscard]] const Eigen::VectorXd& mass() const { return mass_; }
  [[nodiscard]] double eigenvalue(double ritz) const { return 1 / ritz - shift_; }
  [[nodiscard]] double dot(const Eigen::VectorXd& u, const Eigen::VectorXd& v) const {
    return (mass_.array() * u.array() * v.array()).sum();
  }
  void removeMean(Eigen::VectorXd& u) const { u.array() -= mass_.dot(u) / area_; }
  [[nodiscard]] Eigen::MatrixXd apply(const Eigen::MatrixXd& block) const {
    return solver_.solve(mass_.asDiagonal() * block);
  }

 private:
  Eigen::VectorXd mass_;
  SparseSolver solver_;
  double area_ = 0, shift_ = 0;
};

/// Orthonormal functions, the operator applied to the first `images` of them.
struct Basis {
  std::vector<Eigen::VectorXd> functions, images;

  /// Adds what the function has of its own, if that is more than rounding.
  void add(const Problem& problem, Eigen::VectorXd u) {
    problem.removeMean(u);
    const double before = std::sqrt(problem.dot(u, u));
    for (int pass = 0; pass < 2; ++pass) {
      for (const Eigen::VectorXd& q : functions) u -= problem.dot(q, u) * q;
      problem.removeMean(u);
    }
    const double norm = std::sqrt(problem.dot(u, u));
    if (norm > 1e-9 * before && std::isfinite(norm)) functions.push_back(u / norm);
  }

  /// Applies the operator to the functions that still wait for it; returns how many there were.
  int advance(const Problem& problem) {
    const std::size_t from = images.size(), count = functions.size() - from;
    if (count == 0) return 0;
    Eigen::MatrixXd block(functions[0].size(), static_cast<Eigen::Index>(count));
    for (std::size_t k = 0; k < count; ++k) block.col(static_cast<Eigen::Index>(k)) = functions[from + k];
    const Eigen::MatrixXd image = problem.apply(block);
    for (Eigen::Index k = 0; k < image.cols(); ++k) images.emplace_back(image.col(k));
    for (Eigen::Index k = 0; k < image.cols(); ++k) add(problem, image.col(k));
    return static_cast<int>(count);
  }
};

struct RitzPairs {
  Eigen::VectorXd values;     // eigenvalues of the problem, ascending
  Eigen::MatrixXd functions;  // as many columns as wanted
  double residual = 0;
};

RitzPairs ritzPairs(const Problem& problem, const Basis& basis, Eigen::Index wanted) {
  const auto size = static_cast<Eigen::Index>(basis.images.size());
  Eigen::MatrixXd projected(size, size);
  for (Eigen::Index j = 0; j < size; ++j) {
    const Eigen::VectorXd weighted = problem.mass().cwiseProduct(basis.images[static_cast<std::size_t>(j)]);
    for (Eigen::Index i = 0; i < size; ++i) {
      projected(i, j) = basis.functions[static_cast<std::size_t>(i)].dot(weighted);
    }
  }
  projected = (0.5 * (projected + projected.transpose())).eval();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> spectrum(projected);
  RitzPairs pairs;
  pairs.values.resize(size);
  for (Eigen::Index k = 0; k < size; ++k) {
    pairs.values[k] = problem.eigenvalue(spectrum.eigenvalues()[size - 1 - k]);
  }
  wanted = std::min(wanted, size);
  const auto equalsNext = [&](Eigen::Index k) {
    return pairs.values[k] - pairs.values[k - 1] <= kEqual * pairs.values[k - 1];
  };
  while (wanted < size && equalsNext(wanted)) ++wanted;
  pairs.functions = Eigen::MatrixXd::Zero(problem.mass().size(), wanted);
  for (Eigen::Index k = 0; k < wanted; ++k) {
    const auto coefficients = spectrum.eigenvectors().col(size - 1 - k);
    const double ritz = spectrum.eigenvalues()[size - 1 - k];
    Eigen::VectorXd rest = Eigen::VectorXd::Zero(problem.mass().size());
    for (Eigen::Index i = 0; i < size; ++i) {
      pairs.functions.col(k) += coefficients[i] * basis.functions[static_cast<std::size_t>(i)];
      rest += coefficients[i] * basis.images[static_cast<std::size_t>(i)];
    }
    rest -= ritz * pairs.functions.col(k);
    problem.removeMean(rest);
    pairs.residual = std::max(pairs.residual, std::sqrt(problem.dot(rest, rest)) / ritz);
  }
  return pairs;
}

Eigen::MatrixXd centredCoordinates(const TriangleMesh& surface, const Problem& problem) {
  Eigen::MatrixXd coordinates = surface.points();
  for (Eigen::Index k = 0; k < 3; ++k) {
    Eigen::VectorXd column = coordinates.col(k);
    problem.removeMean(column);
    coordinates.col(k) = column;
  }
  return coordinates;
}

/// Turns the functions of equal eigenvalues to their gauge; see the header.
void fixGauge(const Problem& problem, const Eigen::MatrixXd& coordinates, RitzPairs& pairs) {
  const Eigen::Index count = pairs.functions.cols();
  double largest = 0;
  for (Eigen::Index k = 0; k < 3; ++k) {
    largest = std::max(largest, problem.dot(coordinates.col(k), coordinates.col(k)));
  }
  for (Eigen::Index from = 0, to = 1; from < count; from = to++) {
    while (to < count && pairs.values[to] - pairs.values[to - 1] <= kEqual * pairs.values[to - 1]) ++to;
    const Eigen::MatrixXd space = pairs.functions.middleCols(from, to - from);
    const Eigen::MatrixXd products = space.transpose() * problem.mass().asDiagonal() * coordinates;
    Eigen::MatrixXd frame(to - from, 0);
    const auto extend = [&](Eigen::VectorXd direction, double least) {
      for (int pass = 0; pass < 2; ++pass) direction -= frame * (frame.transpose() * direction);
      if (!(direction.norm() > least) || frame.cols() == frame.rows()) return;
      frame.conservativeResize(Eigen::NoChange, frame.cols() + 1);
      frame.col(frame.cols() - 1) = direction.normalized();
    };
    for (Eigen::Index k = 0; k < 3; ++k) extend(products.col(k), 1e-6 * std::sqrt(largest));
    for (Eigen::Index k = 0; k < to - from; ++k) extend(Eigen::VectorXd::Unit(to - from, k), 1e-3);
    pairs.functions.middleCols(from, to - from) = space * frame;
  }
}

Basis startBasis(const Problem& problem, const Eigen::MatrixXd& coordinates, int count) {
  Basis basis;
  for (Eigen::Index k = 0; k < 3; ++k) basis.add(problem, coordinates.col(k));
  std::mt19937 random(1);
  for (int k = 0; k < count; ++k) {
    Eigen::VectorXd noise(coordinates.rows());
    for (double& value : noise) value = static_cast<double>(random()) / 4294967296.0 - 0.5;
    basis.add(problem, noise);
  }
  return basis;
}

}  // namespace

void LaplacianEigenfunctionsOptions::validate() const {
  if (count < 1 || !(tolerance > 0) || maxSolves < 1) {
    throw InvalidArgument("At least one eigenfunction, a positive tolerance and at least one solve are required, but "
                          "count is " + std::to_string(count) + ", tolerance " + std::to_string(tolerance) +
                          " and maxSolves " + std::to_string(maxSolves) + ".");
  }
  if (!SparseSolver::available(solver)) {
    throw InvalidArgument("A solver that is part of this build is required, but " +
                          std::string(solverBackendName(solver)) + " was not built in.");
  }
}

LaplacianEigenfunctionsResult laplacianEigenfunctions(const TriangleMesh& surface,
                                                      const LaplacianEigenfunctionsOptions& options,
                                                      const Execution& execution) {
  options.validate();
  if (surface.vertexCount() <= options.count) {
    throw GeometryError("More vertices than eigenfunctions are required, but there are " +
                        std::to_string(surface.vertexCount()) + " vertices for " + std::to_string(options.count) +
                        " eigenfunctions.");
  }
  execution.report(0, "eigenfunctions");
  const Problem problem(surface, options.solver);
  const Eigen::MatrixXd coordinates = centredCoordinates(surface, problem);
  Basis basis = startBasis(problem, coordinates, options.count);
  LaplacianEigenfunctionsResult result;
  RitzPairs pairs;
  while (result.status == Status::NotRun) {
    execution.throwIfCancelled();
    const int solved = basis.advance(problem);
    result.solves += solved;
    pairs = ritzPairs(problem, basis, options.count);
    result.residual = pairs.residual;
    execution.report(std::min(0.95, result.solves / 50.0), "eigenfunctions");
    const bool exhausted = solved == 0;
    if (result.residual <= options.tolerance && pairs.functions.cols() >= options.count) {
      result.status = Status::Converged;
    } else if (exhausted || result.solves >= options.maxSolves) {
      result.status = Status::NotConverged;
    } else if (static_cast<Eigen::Index>(basis.functions.size()) > kBasis + 4 * options.count) {
      const RitzPairs kept = ritzPairs(problem, basis, options.count + 6);
      basis = {};
      for (Eigen::Index k = 0; k < kept.functions.cols(); ++k) basis.add(problem, kept.functions.col(k));
    }
  }
  fixGauge(problem, coordinates, pairs);
  result.values = pairs.values.head(options.count);
  result.functions = pairs.functions.leftCols(options.count);
  const double last = result.values[options.count - 1];
  result.multiplicity = 0;
  for (Eigen::Index k = 0; k < pairs.functions.cols(); ++k) {
    result.multiplicity += std::abs(pairs.values[k] - last) <= 2 * kEqual * last;
  }
  execution.report(1, "eigenfunctions");
  return result;
}

}  // namespace authalic
