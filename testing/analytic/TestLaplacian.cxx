#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

#include <cmath>

#include "Core/geometry/Areas.h"
#include "Core/geometry/Laplacian.h"
#include "support/TestMeshes.h"

using namespace authalic;
using namespace authalic::testing;

namespace {

Eigen::VectorXd apply(const SparseMatrix& lower, const Eigen::VectorXd& u) {
  return lower.selfadjointView<Eigen::Lower>() * u;
}

}  // namespace

TEST(Areas, OfASphereConvergeToFourPiAtSecondOrder) {
  const auto error = [](int level) { return 4 * M_PI - faceAreas(sphereMesh(level)).sum(); };
  EXPECT_NEAR(error(4) / error(5), 4, 0.05);
}

TEST(Areas, OfVertexStarsSumToTheSurface) {
  const TriangleMesh mesh = bumpyDisk(10);
  const Eigen::VectorXd areas = faceAreas(mesh), stars = vertexStars(areas, mesh.faces(), mesh.vertexCount());
  EXPECT_NEAR(stars.sum(), areas.sum(), 1e-12);
  EXPECT_GT(stars.minCoeff(), 0);
}

TEST(Areas, OfPlanarFacesAreSignedAndSumToThePolygon) {
  const TriangleMesh mesh = diskMesh(6);
  Points2 points = mesh.points().leftCols(2);
  const double total = signedFaceAreas(points, mesh.faces()).sum();
  EXPECT_NEAR(total, 18 * std::sin(2 * M_PI / 36), 1e-12);  // regular 36-gon
  EXPECT_EQ(countFlippedFaces(points, mesh.faces()), 0);
  points.col(0) *= -1;
  EXPECT_NEAR(signedFaceAreas(points, mesh.faces()).sum(), -total, 1e-12);
  EXPECT_EQ(countFlippedFaces(points, mesh.faces()), mesh.faceCount());
}

TEST(CotangentStiffness, AnnihilatesConstantsAndInnerLinearFunctions) {
  const TriangleMesh mesh = diskMesh(8);
  const Points2 points = mesh.points().leftCols(2);
  const SparseMatrix stiffness = cotangentStiffness(points, mesh.faces());
  EXPECT_LT(apply(stiffness, Eigen::VectorXd::Ones(mesh.vertexCount())).cwiseAbs().maxCoeff(), 1e-12);
  const Eigen::VectorXd image = apply(stiffness, 2 * points.col(0) - points.col(1));
  const int inner = mesh.vertexCount() - 48;  // the last ring is the boundary
  EXPECT_LT(image.head(inner).cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_GT(image.tail(48).cwiseAbs().maxCoeff(), 1e-2);
}

TEST(CotangentStiffness, GivesTheDirichletEnergyOfALinearFunction) {
  const TriangleMesh mesh = gridMesh(5, 3, 2.0, 1.5);
  const Eigen::VectorXd u = 3 * mesh.points().col(0) + 4 * mesh.points().col(1);
  EXPECT_NEAR(u.dot(apply(cotangentStiffness(mesh), u)), 25 * 3.0, 1e-11);  // |∇u|² × area
}

TEST(CotangentStiffness, DoesNotDependOnScaleAndAgreesBetweenPlaneAndSpace) {
  const TriangleMesh flat = diskMesh(5), large(Points3(1000 * flat.points()), flat.faces());
  const Eigen::MatrixXd a = cotangentStiffness(flat), b = cotangentStiffness(large);
  const Eigen::MatrixXd c = cotangentStiffness(Points2(flat.points().leftCols(2)), flat.faces());
  EXPECT_LT((a - b).cwiseAbs().maxCoeff(), 1e-11);
  EXPECT_LT((a - c).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(CotangentStiffness, StaysSemiDefiniteOnADegenerateFace) {
  Points3 points(4, 3);
  points << 0, 0, 0, 1, 0, 0, 2, 0, 0, 1, 1, 0;  // 0, 1, 2 on one line
  Faces faces(2, 3);
  faces << 0, 1, 2, 0, 2, 3;
  const Eigen::MatrixXd lower = cotangentStiffness(TriangleMesh(points, faces));
  ASSERT_TRUE(lower.allFinite());
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> spectrum(lower);
  EXPECT_GT(spectrum.eigenvalues()[0], -1e-9 * spectrum.eigenvalues()[3]);
}

TEST(MeanValueWeights, ArePositiveAndReproduceEveryInnerVertexOfAFlatMesh) {
  const TriangleMesh mesh = diskMesh(6);
  const MeanValueWeights w = meanValueWeights(mesh);
  EXPECT_GT(w.forward.minCoeff(), 0);
  EXPECT_GT(w.backward.minCoeff(), 0);
  Points3 force = Points3::Zero(mesh.vertexCount(), 3);
  for (int f = 0; f < mesh.faceCount(); ++f) {
    for (int k = 0; k < 3; ++k) {
      const int i = mesh.faces()(f, k), j = mesh.faces()(f, (k + 1) % 3);
      force.row(i) += w.forward(f, k) * (mesh.points().row(j) - mesh.points().row(i));
      force.row(j) += w.backward(f, k) * (mesh.points().row(i) - mesh.points().row(j));
    }
  }
  EXPECT_LT(force.topRows(mesh.vertexCount() - 36).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(VertexGradients, AreExactForLinearAndConvergeForQuadraticFunctions) {
  const auto error = [](int rings) {
    const TriangleMesh mesh = diskMesh(rings);
    const Points2 p = mesh.points().leftCols(2);
    const Eigen::VectorXd u = p.col(0).array().square();
    Points2 exact = Points2::Zero(p.rows(), 2);
    exact.col(0) = 2 * p.col(0);
    const Eigen::Index inner = p.rows() - 6 * rings;
    return (vertexGradients(p, mesh.faces(), u) - exact).topRows(inner).cwiseAbs().mean();
  };
  EXPECT_GT(error(8) / error(16), 1.9);
  const TriangleMesh mesh = diskMesh(4);
  const Points2 p = mesh.points().leftCols(2);
  const Points2 gradients = vertexGradients(p, mesh.faces(), 2 * p.col(0) - 3 * p.col(1));
  EXPECT_LT((gradients.rowwise() - Eigen::RowVector2d(2, -3)).cwiseAbs().maxCoeff(), 1e-12);
}
