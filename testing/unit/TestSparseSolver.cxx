#include <gtest/gtest.h>

#include "Core/base/Error.h"
#include "Core/geometry/Laplacian.h"
#include "Core/numerics/ElementAssembly.h"
#include "Core/numerics/SparseSolver.h"
#include "support/TestMeshes.h"

using namespace authalic;
using namespace authalic::testing;

namespace {

// Stiffness plus identity: positive definite.
SparseMatrix definiteMatrix() {
  SparseMatrix matrix = cotangentStiffness(bumpyDisk(12));
  for (int i = 0; i < matrix.rows(); ++i) matrix.coeffRef(i, i) += 1;
  return matrix;
}

class EveryBackend : public ::testing::TestWithParam<SolverBackend> {
 protected:
  void SetUp() override {
    if (!SparseSolver::available(GetParam())) GTEST_SKIP() << solverBackendName(GetParam()) << " was not built in";
  }
};

}  // namespace

TEST_P(EveryBackend, SolvesSeveralRightHandSidesAtOnce) {
  const SparseMatrix matrix = definiteMatrix();
  const Eigen::MatrixXd expected = Eigen::MatrixXd::Random(matrix.rows(), 3);
  const Eigen::MatrixXd b = matrix.selfadjointView<Eigen::Lower>() * expected;
  for (const PatternUse use : {PatternUse::Once, PatternUse::Reused}) {
    SparseSolver solver(GetParam(), use);
    solver.compute(matrix);
    EXPECT_EQ(solver.backend(), GetParam());
    EXPECT_LT((solver.solve(b) - expected).cwiseAbs().maxCoeff(), 1e-11);
  }
}

TEST_P(EveryBackend, RefactorisesNewNumbersOnAnAnalysedPattern) {
  SparseMatrix matrix = definiteMatrix();
  SparseSolver solver(GetParam(), PatternUse::Reused);
  solver.compute(matrix);
  const Eigen::MatrixXd b = Eigen::MatrixXd::Ones(matrix.rows(), 1);
  const Eigen::MatrixXd once = solver.solve(b);
  matrix *= 4;
  solver.factorize(matrix);
  EXPECT_LT((4 * solver.solve(b) - once).cwiseAbs().maxCoeff(), 1e-12);
}

TEST_P(EveryBackend, ReportsASingularMatrix) {
  SparseMatrix zero(3, 3);
  for (int i = 0; i < 3; ++i) zero.insert(i, i) = 0;
  zero.makeCompressed();
  SparseSolver solver(GetParam());
  EXPECT_THROW(solver.compute(zero), SolverError);
}

TEST_P(EveryBackend, RefusesCallsInTheWrongOrderAndWrongSizes) {
  SparseSolver solver(GetParam());
  const SparseMatrix matrix = definiteMatrix();
  EXPECT_THROW(static_cast<void>(solver.solve(Eigen::MatrixXd::Ones(3, 1))), SolverError);
  EXPECT_THROW(solver.factorize(matrix), SolverError);
  solver.compute(matrix);
  EXPECT_THROW(static_cast<void>(solver.solve(Eigen::MatrixXd::Ones(3, 1))), SolverError);
  EXPECT_THROW(solver.analyze(SparseMatrix(2, 3)), InvalidArgument);
}

// Large enough to be solved in two halves.
TEST_P(EveryBackend, SolvesLargeSystemsToTheSameBitsOnAnyNumberOfThreads) {
  SparseMatrix matrix = cotangentStiffness(bumpyDisk(90));
  ASSERT_GT(matrix.rows(), 20000);
  for (int i = 0; i < matrix.rows(); ++i) matrix.coeffRef(i, i) += 1e-3;
  const Eigen::MatrixXd expected = Eigen::MatrixXd::Random(matrix.rows(), 2);
  const Eigen::MatrixXd b = matrix.selfadjointView<Eigen::Lower>() * expected;
  Eigen::MatrixXd onOne;
  for (const int threads : {1, 2, 3}) {
    SparseSolver solver(GetParam(), PatternUse::Reused, threads);
    solver.compute(matrix);
    const Eigen::MatrixXd x = solver.solve(b);
    EXPECT_LT((x - expected).cwiseAbs().maxCoeff(), 1e-9);
    if (threads == 1) onOne = x;
    EXPECT_EQ(x, onOne);
  }
}

// Two meshes that nothing joins have no separator at all.
TEST_P(EveryBackend, SolvesLargeSystemsInSeveralPieces) {
  const SparseMatrix piece = cotangentStiffness(bumpyDisk(65));
  const int size = static_cast<int>(piece.rows());
  ASSERT_GT(2 * size, 20000);
  std::vector<Eigen::Triplet<double>> entries;
  for (int j = 0; j < size; ++j) {
    for (SparseMatrix::InnerIterator entry(piece, j); entry; ++entry) {
      const double value = entry.value() + (entry.row() == j ? 1 : 0);
      entries.emplace_back(entry.row(), j, value);
      entries.emplace_back(size + entry.row(), size + j, value);
    }
  }
  SparseMatrix matrix(2 * size, 2 * size);
  matrix.setFromTriplets(entries.begin(), entries.end());
  const Eigen::MatrixXd expected = Eigen::MatrixXd::Random(matrix.rows(), 1);
  SparseSolver solver(GetParam(), PatternUse::Reused, 2);
  solver.compute(matrix);
  EXPECT_LT((solver.solve(matrix.selfadjointView<Eigen::Lower>() * expected) - expected).cwiseAbs().maxCoeff(), 1e-11);
}

INSTANTIATE_TEST_SUITE_P(SparseSolver, EveryBackend,
                         ::testing::Values(SolverBackend::EigenLDLT, SolverBackend::EigenLLT, SolverBackend::Cholmod),
                         [](const auto& parameter) {
                           std::string name = solverBackendName(parameter.param);
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

TEST(SparseSolver, ReportsALargeIndefiniteMatrix) {
  SparseMatrix matrix = cotangentStiffness(bumpyDisk(90));
  for (int i = 0; i < matrix.rows(); ++i) matrix.coeffRef(i, i) -= 1;
  SparseSolver solver(SolverBackend::Automatic, PatternUse::Reused, 2);
  if (solver.backend() == SolverBackend::EigenLDLT) GTEST_SKIP() << "Eigen's LDLT factorises indefinite matrices";
  EXPECT_THROW(solver.compute(matrix), SolverError);
}

TEST(ElementAssembly, SumsSharedEntriesAndLeavesOutKnownValues) {
  ElementAssembly::Unknowns elements(2, 3);
  elements << 2, 0, -1, 1, 2, 0;
  ElementAssembly assembly(3, elements);
  const Eigen::MatrixXd dense =
      Eigen::MatrixXd(assembly.assemble({1, 2, 99, 3, 99, 99, 10, 20, 30, 40, 50, 60}));
  Eigen::Matrix3d expected;  // lower triangle
  expected << 63, 0, 0, 30, 10, 0, 52, 20, 41;
  EXPECT_EQ(dense, Eigen::MatrixXd(expected));
}
