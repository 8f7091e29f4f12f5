#include "Core/transport/DampedNewton.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "Core/base/Error.h"

namespace authalic {
namespace {

constexpr double kSumTolerance = 1e-6;
constexpr double kShortestStep = 1e-8;
constexpr double kGrowth = 4;  // of the part of the step that is tried first

// Newton's matrix without the row and column of the last site, whose height stays.
SparseMatrix newtonMatrix(const TransportCells& cells, Eigen::Index count,
                          std::vector<Eigen::Triplet<double>>& entries) {
  entries.clear();
  cells.derivatives(entries);
  Eigen::VectorXd diagonal = Eigen::VectorXd::Zero(count);
  const int last = static_cast<int>(count) - 1;
  std::size_t kept = 0;
  for (const auto& entry : entries) {
    diagonal[entry.row()] += entry.value();
    diagonal[entry.col()] += entry.value();
    if (entry.row() != last && entry.col() != last) entries[kept++] = {entry.row(), entry.col(), -entry.value()};
  }
  entries.resize(kept);
  for (int i = 0; i < last; ++i) entries.emplace_back(i, i, diagonal[i]);
  SparseMatrix matrix(last, last);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

Eigen::VectorXd newtonStep(const TransportCells& cells, const Eigen::VectorXd& error, SolverBackend backend,
                           std::vector<Eigen::Triplet<double>>& entries) {
  const Eigen::Index count = error.size();
  Eigen::VectorXd step = Eigen::VectorXd::Zero(count);
  if (count < 2) return step;
  SparseSolver solver(backend);
  solver.compute(newtonMatrix(cells, count, entries));
  step.head(count - 1) = solver.solve(-error.head(count - 1));
  step.array() -= cells.constantOf(step);
  return step;
}

}  // namespace

Eigen::VectorXd checkedMasses(const Eigen::VectorXd& masses, Eigen::Index count, double area) {
  if (masses.size() != count) {
    throw GeometryError("One mass per site (" + std::to_string(count) + ") is required, but there are " +
                        std::to_string(masses.size()) + ".");
  }
  for (Eigen::Index i = 0; i < count; ++i) {
    if (masses[i] > 0 && std::isfinite(masses[i])) continue;
    throw GeometryError("Positive masses are required, but that of site " + std::to_string(i) + " is " +
                        std::to_string(masses[i]) + "; leave the site out or give it a share.");
  }
  const double sum = masses.sum();
  if (std::abs(sum - area) > kSumTolerance * area) {
    throw GeometryError("Masses that sum to that of the source, " + std::to_string(area) +
                        ", are required, but their sum is " + std::to_string(sum) + "; scale them.");
  }
  return masses * (area / sum);
}

TransportSolution dampedNewton(TransportCells& cells, Eigen::Index count, const Eigen::VectorXd& given, double area,
                               const SemiDiscreteTransportOptions& options, Heights start,
                               const Execution& execution) {
  options.validate();
  const Eigen::VectorXd masses = checkedMasses(given, count, area);
  const double mean = area / static_cast<double>(count);
  TransportSolution result;
  result.heights = std::move(start);
  const double smallest = cells.compute(result.heights) ? cells.areas().minCoeff() : 0;
  if (!(smallest > 0)) {
    throw GeometryError(
        "A cell for every site is required at the start, but some are empty; take an initial map that spreads close "
        "sites, or heights of these sites.");
  }
  const double floor = 0.5 * std::min(smallest, masses.minCoeff());
  Eigen::VectorXd error = cells.areas() - masses;
  std::vector<Eigen::Triplet<double>> entries;
  const double firstLog = std::log(error.cwiseAbs().maxCoeff() / mean / options.tolerance);
  result.status = Status::NotConverged;
  double part = 1;
  while (true) {
    result.residual = error.cwiseAbs().maxCoeff() / mean;
    if (result.residual <= options.tolerance) result.status = Status::Converged;
    if (execution.cancelled()) result.status = Status::Cancelled;
    if (result.status != Status::NotConverged || result.iterations >= options.maxIterations) break;
    execution.report(1 - std::log(result.residual / options.tolerance) / firstLog, "Optimal transport");
    const Eigen::VectorXd step = newtonStep(cells, error, options.solver, entries);
    const double size = error.norm(), largest = error.cwiseAbs().maxCoeff();
    for (part = std::min(1.0, kGrowth * part); part > kShortestStep; part /= 2) {
      if (!cells.compute(result.heights + (part * step).cast<long double>())) continue;
      if (!(cells.areas().minCoeff() >= floor)) continue;
      error = cells.areas() - masses;
      if (error.norm() <= (1 - part / 2) * size && error.cwiseAbs().maxCoeff() <= largest) break;
    }
    if (part <= kShortestStep) {
      (void)cells.compute(result.heights);
      result.status = Status::Stalled;
      break;
    }
    result.heights += (part * step).cast<long double>();
    result.history.push_back({result.residual, part, cells.areas().minCoeff() / mean});
    ++result.iterations;
  }
  return result;
}

}  // namespace authalic
