#include "Core/initial/ConformalEnergy.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>

#include "Core/numerics/ElementAssembly.h"

namespace authalic {
namespace {

constexpr double kSmallestHeight = 1e-8;  // of the longest side

std::size_t at(int i) { return static_cast<std::size_t>(i); }

}  // namespace

HalfEdgeWeights shapeWeights(const TriangleMesh& surface) {
  HalfEdgeWeights weights(surface.faceCount(), 3);
  for (int f = 0; f < surface.faceCount(); ++f) {
    const std::array<Eigen::Vector3d, 3> p{surface.corner(f, 0), surface.corner(f, 1), surface.corner(f, 2)};
    int base = 0;
    for (int k = 1; k < 3; ++k) {
      if ((p[at((k + 1) % 3)] - p[at(k)]).norm() > (p[at((base + 1) % 3)] - p[at(base)]).norm()) base = k;
    }
    // Laid flat: corners (0, 0), (x1, 0) along the longest side, the third at (x2, y2).
    const Eigen::Vector3d side = p[at((base + 1) % 3)] - p[at(base)], other = p[at((base + 2) % 3)] - p[at(base)];
    const double x1 = side.norm();
    if (!(x1 > 0)) {
      weights.row(f).setConstant(0.5 / std::sqrt(3.0));
      continue;
    }
    const double x2 = side.dot(other) / x1, y2 = std::max(side.cross(other).norm() / x1, kSmallestHeight * x1);
    // ½ cot opposite to the base, then to the sides 12 and 20.
    weights(f, base) = 0.5 * (y2 * y2 - x2 * (x1 - x2)) / (x1 * y2);
    weights(f, (base + 1) % 3) = 0.5 * x2 / y2;
    weights(f, (base + 2) % 3) = 0.5 * (x1 - x2) / y2;
  }
  return weights;
}

SparseMatrix shapeStiffness(const TriangleMesh& surface) {
  const HalfEdgeWeights weights = shapeWeights(surface);
  ElementAssembly assembly(surface.vertexCount(), surface.faces());
  std::vector<double> values(static_cast<std::size_t>(6 * surface.faceCount()));
  for (Eigen::Index f = 0; f < weights.rows(); ++f) {
    const double w01 = weights(f, 0), w12 = weights(f, 1), w20 = weights(f, 2);
    const std::array<double, 6> element{w01 + w20, -w01, -w20, w01 + w12, -w12, w12 + w20};
    std::copy(element.begin(), element.end(), values.begin() + 6 * f);
  }
  return assembly.assemble(values);
}

ConformalEnergy::ConformalEnergy(const DiskMesh& disk)
    : loop_(disk.boundary()), after_(at(disk.mesh().vertexCount()), -1), before_(after_) {
  for (std::size_t k = 0; k < loop_.size(); ++k) {
    const int here = loop_[k], next = loop_[(k + 1) % loop_.size()];
    after_[at(here)] = next;
    before_[at(next)] = here;
  }
  const SparseMatrix stiffness = shapeStiffness(disk.mesh());
  const int n = disk.mesh().vertexCount();
  matrix_.resize(2 * n, 2 * n);
  matrix_.reserve(2 * stiffness.nonZeros() + 2 * static_cast<Eigen::Index>(loop_.size()));
  for (int column = 0; column < n; ++column) insertColumn(stiffness, column, 0);
  for (int column = 0; column < n; ++column) insertColumn(stiffness, column, n);
  matrix_.makeCompressed();
}

void ConformalEnergy::insertColumn(const SparseMatrix& stiffness, int column, int offset) {
  matrix_.startVec(offset + column);
  for (SparseMatrix::InnerIterator entry(stiffness, column); entry; ++entry) {
    matrix_.insertBack(offset + entry.row(), offset + column) = entry.value();
  }
  const int n = static_cast<int>(stiffness.rows()), next = after_[at(column)], previous = before_[at(column)];
  if (offset > 0 || next < 0) return;
  // −½ ∂²(Σ x_i y_j − x_j y_i): x_i with the y of its two neighbours on the boundary.
  const std::array<std::pair<int, double>, 2> coupling =
      next < previous ? std::array<std::pair<int, double>, 2>{{{next, -0.5}, {previous, 0.5}}}
                      : std::array<std::pair<int, double>, 2>{{{previous, 0.5}, {next, -0.5}}};
  for (const auto& [vertex, value] : coupling) matrix_.insertBack(n + vertex, column) = value;
}

double ConformalEnergy::area(const Points2& image) const {
  double twice = 0;
  for (const int i : loop_) {
    const int j = after_[at(i)];
    twice += image(i, 0) * image(j, 1) - image(j, 0) * image(i, 1);
  }
  return 0.5 * twice;
}

double ConformalEnergy::dirichlet(const Points2& image) const {
  Eigen::VectorXd stacked(2 * image.rows());
  stacked << image.col(0), image.col(1);
  return 0.5 * stacked.dot(matrix_.selfadjointView<Eigen::Lower>() * stacked) + area(image);
}

}  // namespace authalic
