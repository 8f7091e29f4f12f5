/// @file
/// Systems of one pattern after the other, each analysed once.
#pragma once

#include <memory>
#include <vector>

#include "Core/numerics/ElementAssembly.h"

namespace authalic {

/// A sum of element matrices, and the solver that factorises it; analysed at the first factorisation.
class AssembledSystem {
 public:
  /// @param starts, unknowns  of the elements, as ElementAssembly takes them
  AssembledSystem(int unknownCount, std::vector<int> starts, std::vector<int> unknowns, SolverBackend backend,
                  PatternUse use, int threads);

  /// @param values  the upper triangles of all elements, one after the other
  /// @return lower triangle
  [[nodiscard]] const SparseMatrix& assemble(const std::vector<double>& values) { return assembly_.assemble(values); }

  /// @param lower  a matrix of the assembled pattern
  /// @throws SolverError when it is not definite
  void factorize(const SparseMatrix& lower);

  /// Of the last matrix.
  [[nodiscard]] const SparseSolver& solver() const noexcept { return solver_; }

 private:
  friend class AnalysedSystems;
  int unknownCount_;
  std::vector<int> starts_, unknowns_;
  SolverBackend backend_;
  PatternUse use_;
  ElementAssembly assembly_;
  SparseSolver solver_;
  bool analysed_ = false;
};

/// Where maps of one mesh are made one after the other, as for several targets, their systems have the same patterns:
/// what was sorted and analysed for one serves the next, to the same bits as if it had been done again.
///
/// Keeps the last few patterns. One solve at a time may use it.
class AnalysedSystems {
 public:
  /// @param threads  of the solvers, see SparseSolver, and for the work around them
  explicit AnalysedSystems(int threads = 1) : threads_(threads) {}

  [[nodiscard]] int threads() const noexcept { return threads_; }

  /// The system of that pattern, found or made: O(size of the pattern) to compare.
  [[nodiscard]] std::shared_ptr<AssembledSystem> of(int unknownCount, std::vector<int> starts,
                                                    std::vector<int> unknowns, SolverBackend backend, PatternUse use);
  /// Elements of one size.
  [[nodiscard]] std::shared_ptr<AssembledSystem> of(int unknownCount, const ElementAssembly::Unknowns& elements,
                                                    SolverBackend backend, PatternUse use);

 private:
  int threads_;
  std::vector<std::shared_ptr<AssembledSystem>> kept_;  // the last used at the end
};

}  // namespace authalic
