/// @file
/// Symmetric sparse matrices summed from small element matrices over a pattern that is found once.
#pragma once

#include <array>
#include <vector>

#include "Core/numerics/SparseSolver.h"

namespace authalic {

/// Pattern of Σ_e Bₑᵀ Mₑ Bₑ for symmetric k×k element matrices Mₑ, and the place of each of their entries.
///
/// Entry (a, b), a ≤ b, of an element is number p of a·k − a(a−1)/2 + (b − a): row by row of the upper triangle.
/// Unknowns of −1 are left out (known values). Found by counting sort in O(m k²); an assembly is one pass over
/// the entries without searching. The order of summation is that of the elements: same bits every time.
class ElementAssembly {
 public:
  /// Row e holds the unknowns of element e, −1 for none.
  using Unknowns = Eigen::Matrix<int, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

  ElementAssembly(int unknownCount, const Unknowns& elements);

  /// Elements of different sizes: the unknowns of element e are unknowns[starts[e]] … unknowns[starts[e + 1] − 1].
  ElementAssembly(int unknownCount, const std::vector<int>& starts, const std::vector<int>& unknowns);

  /// Sum the elements.
  /// @param values  the upper triangles of all elements, one after the other
  /// @return lower triangle, O(m k²)
  const SparseMatrix& assemble(const std::vector<double>& values);

  [[nodiscard]] const SparseMatrix& matrix() const noexcept { return matrix_; }

 private:
  void sortPairs(int unknownCount, const std::vector<std::array<int, 2>>& pairs);

  SparseMatrix matrix_;
  std::vector<int> slots_;  // place in matrix_.valuePtr() of each entry, −1 = left out
};

}  // namespace authalic
