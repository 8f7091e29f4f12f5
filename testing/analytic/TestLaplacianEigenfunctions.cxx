#include <gtest/gtest.h>

#include <cmath>

#include "Core/base/Error.h"
#include "Core/geometry/Areas.h"
#include "Core/geometry/LaplacianEigenfunctions.h"
#include "support/TestMeshes.h"

using namespace authalic;
using namespace authalic::testing;

namespace {

TriangleMesh stretched(const TriangleMesh& mesh, double x, double y, double z) {
  Points3 points = mesh.points();
  points.col(0) *= x;
  points.col(1) *= y;
  points.col(2) *= z;
  return TriangleMesh(points, mesh.faces());
}

Eigen::VectorXd massOf(const TriangleMesh& mesh) {
  return vertexStars(faceAreas(mesh), mesh.faces(), mesh.vertexCount());
}

LaplacianEigenfunctionsOptions counting(int count) {
  LaplacianEigenfunctionsOptions options;
  options.count = count;
  return options;
}

}  // namespace

TEST(LaplacianEigenfunctions, OfTheSphereConvergeAtSecondOrder) {
  const auto errors = [](int level) {  // of λ = 2, three times, and of λ = 6
    const LaplacianEigenfunctionsResult result = laplacianEigenfunctions(sphereMesh(level), counting(4));
    EXPECT_EQ(result.status, Status::Converged);
    return Eigen::Vector2d(std::abs(result.values[0] - 2), std::abs(result.values[3] - 6));
  };
  const Eigen::Vector2d coarse = errors(3), fine = errors(4);
  EXPECT_LT(fine[0], 2e-5);  // the octahedral mesh is better than second order here
  EXPECT_GT(coarse[0] / fine[0], 4);
  EXPECT_NEAR(coarse[1] / fine[1], 4, 0.1);
}

TEST(LaplacianEigenfunctions, OfTheSphereAreTheCoordinatesInTheirOrder) {
  EXPECT_EQ(laplacianEigenfunctions(sphereMesh(3)).multiplicity, 3);
  const TriangleMesh mesh = sphereMesh(4);
  const LaplacianEigenfunctionsResult three = laplacianEigenfunctions(mesh, counting(3));
  for (int k = 0; k < 3; ++k) {
    const Eigen::VectorXd scaled = three.functions.col(k) * std::sqrt(4 * M_PI / 3);
    EXPECT_LT((scaled - mesh.points().col(k)).cwiseAbs().maxCoeff(), 5e-3) << k;
  }
}

TEST(LaplacianEigenfunctions, OfTheSphereComeInMultipletsOfThreeFiveAndSeven) {
  const LaplacianEigenfunctionsResult result = laplacianEigenfunctions(sphereMesh(5), counting(15));
  EXPECT_EQ(result.status, Status::Converged);
  for (int k = 0; k < 15; ++k) {
    const int l = k < 3 ? 1 : k < 8 ? 2 : 3;
    EXPECT_NEAR(result.values[k], l * (l + 1), 0.01 * l * (l + 1)) << k;
  }
}

TEST(LaplacianEigenfunctions, OfARectangleAreItsCosines) {
  const auto error = [](int columns) {
    const TriangleMesh mesh = gridMesh(columns, columns / 2, 2.0, 1.0);
    const LaplacianEigenfunctionsResult result = laplacianEigenfunctions(mesh);
    EXPECT_EQ(result.multiplicity, 1);
    const Eigen::ArrayXd cosine = -(M_PI / 2 * mesh.points().col(0)).array().cos();
    EXPECT_LT((result.functions.col(0).array() - cosine).abs().maxCoeff(), 0.01);
    return std::abs(result.values[0] - M_PI * M_PI / 4);
  };
  EXPECT_NEAR(error(20) / error(40), 4, 0.2);
}

TEST(LaplacianEigenfunctions, AreOrthonormalWithoutMeanAndSolveTheEquation) {
  const TriangleMesh mesh = stretched(sphereMesh(3), 1, 1.5, 2.5);
  const LaplacianEigenfunctionsResult result = laplacianEigenfunctions(mesh, counting(6));
  const Eigen::VectorXd mass = massOf(mesh);
  const Eigen::MatrixXd gram = result.functions.transpose() * mass.asDiagonal() * result.functions;
  EXPECT_LT((gram - Eigen::MatrixXd::Identity(6, 6)).cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_LT((mass.transpose() * result.functions).cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_LE(result.residual, 1e-8);
  EXPECT_GT(result.values[0], 0);
  for (int k = 1; k < 6; ++k) EXPECT_GE(result.values[k], result.values[k - 1]);
}

TEST(LaplacianEigenfunctions, ScaleWithTheInverseSquareAndIgnoreTheOrderOfVertices) {
  const TriangleMesh mesh = stretched(sphereMesh(3), 1, 1.5, 2.5), large = stretched(mesh, 10, 10, 10);
  const LaplacianEigenfunctionsResult one = laplacianEigenfunctions(mesh), ten = laplacianEigenfunctions(large);
  EXPECT_NEAR(ten.values[0] * 100 / one.values[0], 1, 1e-9);
  EXPECT_LT((10 * ten.functions - one.functions).cwiseAbs().maxCoeff(), 1e-6);
  const int n = mesh.vertexCount();
  Points3 points(n, 3);
  Faces faces = mesh.faces();
  for (int i = 0; i < n; ++i) points.row(n - 1 - i) = mesh.points().row(i);
  for (Eigen::Index i = 0; i < faces.size(); ++i) faces.data()[i] = n - 1 - faces.data()[i];
  const LaplacianEigenfunctionsResult reversed = laplacianEigenfunctions(TriangleMesh(points, faces));
  EXPECT_LT((reversed.functions.reverse() - one.functions).cwiseAbs().maxCoeff(), 1e-6);
}

TEST(LaplacianEigenfunctions, SayWhenTheyDidNotConverge) {
  LaplacianEigenfunctionsOptions options;
  options.maxSolves = 1;
  const LaplacianEigenfunctionsResult result = laplacianEigenfunctions(stretched(sphereMesh(4), 1, 3, 4), options);
  EXPECT_EQ(result.status, Status::NotConverged);
  EXPECT_GT(result.residual, options.tolerance);
}

TEST(LaplacianEigenfunctions, RefuseWhatTheyCannotDo) {
  EXPECT_THROW((void)laplacianEigenfunctions(sphereMesh(0), counting(0)), InvalidArgument);
  EXPECT_THROW((void)laplacianEigenfunctions(sphereMesh(0), counting(6)), GeometryError);
  EXPECT_THROW((void)laplacianEigenfunctions(stretched(sphereMesh(0), 0, 0, 1)), GeometryError);
  EXPECT_THROW((void)laplacianEigenfunctions(sphereMesh(1), {}, Execution({}, [] { return true; })), CancelledError);
}
