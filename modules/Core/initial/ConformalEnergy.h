/// @file
/// The stiffness of a surface with degenerate faces, and the quadratic form of the conformal energy on a disk.
#pragma once

#include <complex>
#include <vector>

#include "Core/geometry/Laplacian.h"
#include "Core/mesh/DiskMesh.h"

namespace authalic {

/// Half cotangents of a surface whose degenerate faces are clamped to the nearest triangle of height 1e-8 of its
/// longest side: unlike cotangentWeights, they belong to real triangles, so that E_D − A stays positive
/// semi-definite.
[[nodiscard]] HalfEdgeWeights shapeWeights(const TriangleMesh& surface);

/// The cotangent stiffness with those weights, n×n, lower triangle.
[[nodiscard]] SparseMatrix shapeStiffness(const TriangleMesh& surface);

/// E_C(x, y) = ½ (xᵀLx + yᵀLy) − A(x, y), A = ½ Σ_{boundary edges i→j} (x_i y_j − x_j y_i).
///
/// As a real symmetric 2n×2n matrix: unknown i is x_i, unknown n + i is y_i.
class ConformalEnergy {
 public:
  explicit ConformalEnergy(const DiskMesh& disk);

  /// Lower triangle, 2n×2n, with explicit diagonal.
  [[nodiscard]] const SparseMatrix& matrix() const noexcept { return matrix_; }

  /// E_D and A of an image.
  [[nodiscard]] double dirichlet(const Points2& image) const;
  [[nodiscard]] double area(const Points2& image) const;

 private:
  void insertColumn(const SparseMatrix& stiffness, int column, int offset);

  const std::vector<int>& loop_;
  std::vector<int> after_, before_;  // neighbours on the boundary, −1 inside
  SparseMatrix matrix_;
};

}  // namespace authalic
