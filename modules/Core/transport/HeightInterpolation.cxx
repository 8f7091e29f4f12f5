#include "Core/transport/HeightInterpolation.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include <cmath>
#include <utility>

namespace authalic {
namespace {

using Vector6 = Eigen::Matrix<double, 6, 1>;
using Matrix6 = Eigen::Matrix<double, 6, 6>;

constexpr double kOuterWeight = 0.3;  // in a fit, of neighbours of neighbours
constexpr double kReach = 1.5;        // of a weight, in mean distances of neighbours
constexpr double kRound = 0.02;       // least eigenvalue of a Hessian / its largest

std::size_t at(int i) { return static_cast<std::size_t>(i); }

Vector6 monomials(double x, double y) { return (Vector6() << 1, x, y, x * x / 2, x * y, y * y / 2).finished(); }

Eigen::Matrix2d hessianOf(const Vector6& c) { return (Eigen::Matrix2d() << c[3], c[4], c[4], c[5]).finished(); }

// The Hessian with its eigenvalues raised to kRound of the largest.
void makeDefinite(Vector6& c) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver(hessianOf(c));
  const double least = kRound * solver.eigenvalues().cwiseAbs().maxCoeff();
  if (solver.eigenvalues()[0] >= least) return;
  const Eigen::Matrix2d& axes = solver.eigenvectors();
  const Eigen::Matrix2d round = axes * solver.eigenvalues().cwiseMax(least).asDiagonal() * axes.transpose();
  c[3] = round(0, 0), c[4] = round(0, 1), c[5] = round(1, 1);
}

// Neighbours of every cell, then the neighbours of those.
std::vector<std::vector<int>> ringsOf(const PowerCells& cells, std::vector<std::size_t>& direct) {
  std::vector<std::vector<int>> neighbours(direct.size()), rings;
  for (const PowerEdge& edge : cells.edges) {
    neighbours[at(edge.first)].push_back(edge.second);
    neighbours[at(edge.second)].push_back(edge.first);
  }
  std::vector<int> seen(direct.size(), -1);
  for (int j = 0; j < static_cast<int>(neighbours.size()); ++j) {
    std::vector<int> ring = neighbours[at(j)];
    seen[at(j)] = j;
    for (const int k : ring) seen[at(k)] = j;
    direct[at(j)] = ring.size();
    for (std::size_t k = 0; k < direct[at(j)]; ++k) {
      for (const int l : neighbours[at(ring[k])]) {
        if (std::exchange(seen[at(l)], j) != j) ring.push_back(l);
      }
    }
    rings.push_back(std::move(ring));
  }
  return rings;
}

}  // namespace

double HeightInterpolation::Quadratic::valueAt(const Eigen::RowVector2d& p) const {
  const Eigen::RowVector2d from = p - origin;
  return coefficients.dot(monomials(from[0] / scale, from[1] / scale)) + slope.dot(from) + value;
}

// (1 − d² / reach²)³.
double HeightInterpolation::Quadratic::weight(const Eigen::RowVector2d& p) const {
  const Eigen::Vector2d from = (p - origin).transpose() / scale;
  const double left = 1 - from.dot(hessianOf(coefficients) * from) / reach;
  return left > 0 ? left * left * left : 0;
}

HeightInterpolation::HeightInterpolation(const PowerDiagram& diagram, const Heights& heights)
    : fits_(static_cast<std::size_t>(heights.size())), direct_(fits_.size()) {
  const PowerCells& cells = diagram.cells();
  around_ = ringsOf(cells, direct_);
  for (int j = 0; j < static_cast<int>(fits_.size()); ++j) {
    fits_[at(j)].origin = diagram.sites().row(j);
    fits_[at(j)].slope = cells.centroids.row(j);
    fits_[at(j)].value = static_cast<double>(-heights[j]);
  }
  for (int j = 0; j < static_cast<int>(fits_.size()); ++j) fit(j, cells);
}

// To values and gradients less those of the tangent plane at j, distances by the scale.
void HeightInterpolation::fit(int j, const PowerCells& cells) {
  Quadratic& q = fits_[at(j)];
  const std::vector<int>& ring = around_[at(j)];
  usable_ = usable_ && cells.masses[j] > 0 && !ring.empty();
  if (!usable_) return;
  q.scale = 0;
  for (std::size_t k = 0; k < direct_[at(j)]; ++k) q.scale += (fits_[at(ring[k])].origin - q.origin).norm();
  q.scale /= static_cast<double>(direct_[at(j)]);
  Matrix6 normal = Matrix6::Zero();
  Vector6 right = Vector6::Zero();
  const auto add = [&](const Quadratic& other, double weight) {
    const Eigen::RowVector2d from = (other.origin - q.origin) / q.scale;
    const Eigen::RowVector2d turn = (other.slope - q.slope) * q.scale;
    const Vector6 value = monomials(from[0], from[1]);
    const Vector6 alongX = (Vector6() << 0, 1, 0, from[0], from[1], 0).finished();
    const Vector6 alongY = (Vector6() << 0, 0, 1, 0, from[0], from[1]).finished();
    normal += weight * (value * value.transpose() + alongX * alongX.transpose() + alongY * alongY.transpose());
    right += weight * (value * (other.value - q.value - q.slope.dot(other.origin - q.origin)) + alongX * turn[0] +
                       alongY * turn[1]);
  };
  add(q, 1);
  for (std::size_t k = 0; k < ring.size(); ++k) add(fits_[at(ring[k])], k < direct_[at(j)] ? 1 : kOuterWeight);
  q.coefficients = normal.ldlt().solve(right);
  usable_ = q.coefficients.allFinite();
  if (!usable_) return;
  makeDefinite(q.coefficients);
  double sum = 0;
  for (std::size_t k = 0; k < direct_[at(j)]; ++k) {
    const Eigen::Vector2d from = (fits_[at(ring[k])].origin - q.origin).transpose() / q.scale;
    sum += std::sqrt(from.dot(hessianOf(q.coefficients) * from));
  }
  q.reach = std::pow(kReach * sum / static_cast<double>(direct_[at(j)]), 2);
}

double HeightInterpolation::conjugateAt(const Eigen::RowVector2d& p, int cluster) const {
  double weights = fits_[at(cluster)].weight(p), sum = 0;
  if (weights > 0) sum = weights * fits_[at(cluster)].valueAt(p);
  for (const int k : around_[at(cluster)]) {
    const double weight = fits_[at(k)].weight(p);
    if (weight > 0) sum += weight * fits_[at(k)].valueAt(p), weights += weight;
  }
  return weights > 0 ? sum / weights : fits_[at(cluster)].valueAt(p);
}

Heights HeightInterpolation::heightsAt(const Points2& sites, const std::vector<int>& clusterOf,
                                        const Execution& execution) const {
  Heights heights(sites.rows());
  parallelFor(static_cast<std::size_t>(sites.rows()), execution, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const auto row = static_cast<Eigen::Index>(i);
      heights[row] = -conjugateAt(sites.row(row), clusterOf[i]);
    }
  });
  return heights;
}

}  // namespace authalic
