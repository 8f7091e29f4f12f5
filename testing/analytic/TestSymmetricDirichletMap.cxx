#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <random>

#include "Core/initial/BarycentricMap.h"
#include "Core/initial/IsometricElements.h"
#include "Core/initial/SymmetricDirichletMap.h"
#include "support/TestMeshes.h"

using namespace authalic;
using namespace authalic::testing;

namespace {

Points2 tutte(const DiskMesh& disk) {
  BarycentricMapOptions options;
  options.weights = BarycentricWeights::Uniform;
  return barycentricMap(disk, options).image;
}

/// Largest distance between two images after the best rigid motion.
double differenceUpToMotion(Points2 a, Points2 b) {
  const Eigen::RowVector2d meanA = a.colwise().mean(), meanB = b.colwise().mean();
  a.rowwise() -= meanA;
  b.rowwise() -= meanB;
  const double angle = std::atan2((a.col(0).dot(b.col(1)) - a.col(1).dot(b.col(0))), a.cwiseProduct(b).sum());
  return (a * Eigen::Rotation2Dd(angle).toRotationMatrix().transpose() - b).rowwise().norm().maxCoeff();
}

TriangleMesh flatRoughDisk(int rings) {
  const TriangleMesh flat = diskMesh(rings);
  std::mt19937 random(8);
  std::uniform_real_distribution<double> noise(-0.2 / rings, 0.2 / rings);
  Points3 points = flat.points();
  for (Eigen::Index i = 0; i < points.rows(); ++i) points.row(i) += Eigen::RowVector3d(noise(random), noise(random), 0);
  return TriangleMesh(points, flat.faces());
}

}  // namespace

TEST(IsometricElements, GradientAndWholeHessianAreDerivativesOfTheEnergy) {
  const TriangleMesh mesh = bumpyDisk(2, 1.0);
  const Points2 image = 1.3 * diskMesh(2).points().leftCols<2>();
  IsometricElements elements(mesh, 1);
  (void)elements.linearise(image, false);
  const Points2 gradient = elements.gradient();
  ElementAssembly::Unknowns unknowns(mesh.faceCount(), 6);
  for (int f = 0; f < mesh.faceCount(); ++f) {
    for (int k = 0; k < 6; ++k) unknowns(f, k) = 2 * mesh.faces()(f, k / 2) + k % 2;
  }
  ElementAssembly assembly(2 * mesh.vertexCount(), unknowns);
  const Eigen::MatrixXd hessian =
      Eigen::MatrixXd(assembly.assemble(elements.hessians())).selfadjointView<Eigen::Lower>();
  const double h = 1e-5;
  for (int i = 0; i < 2 * mesh.vertexCount(); i += 3) {
    Points2 ahead = image, behind = image;
    ahead(i / 2, i % 2) += h;
    behind(i / 2, i % 2) -= h;
    EXPECT_NEAR((elements.energy(ahead) - elements.energy(behind)) / (2 * h), gradient(i / 2, i % 2), 1e-7);
    (void)elements.linearise(ahead, false);
    Points2 change = elements.gradient();
    (void)elements.linearise(behind, false);
    change -= elements.gradient();
    for (int j = 0; j < 2 * mesh.vertexCount(); ++j) {
      EXPECT_NEAR(change(j / 2, j % 2) / (2 * h), hessian(i, j), 2e-6) << i << " " << j;
    }
  }
}

TEST(SymmetricDirichletMap, OfAFlatDiskIsAnIsometry) {
  const DiskMesh disk(flatRoughDisk(10));
  const SymmetricDirichletMapResult result = symmetricDirichletMap(disk, tutte(disk));
  EXPECT_EQ(result.status, Status::Converged);
  EXPECT_NEAR(result.energy, 4, 1e-10);
  EXPECT_LT(differenceUpToMotion(result.image, disk.mesh().points().leftCols<2>()), 1e-5);
}

TEST(SymmetricDirichletMap, UnrollsACylinder) {
  const TriangleMesh grid = gridMesh(24, 16, M_PI, 2);
  Points3 points = grid.points();
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    const double angle = grid.points()(i, 0);
    points.row(i) << std::cos(angle), std::sin(angle), grid.points()(i, 1);
  }
  Points2 unrolled = grid.points().leftCols<2>();
  unrolled.col(0) *= 24 / M_PI * 2 * std::sin(M_PI / 48);  // of each column, the chord in place of the arc
  const DiskMesh disk(TriangleMesh(points, grid.faces()));
  const SymmetricDirichletMapResult result = symmetricDirichletMap(disk, tutte(disk));
  EXPECT_NEAR(result.energy, 4, 1e-10);
  EXPECT_LT(differenceUpToMotion(result.image, unrolled), 1e-5);
}

TEST(SymmetricDirichletMap, ConvergesQuadraticallyAtTheEnd) {
  const DiskMesh disk(bumpyDisk(12, 1.0));
  SymmetricDirichletMapOptions options;
  options.tolerance = 1e-6;
  const SymmetricDirichletMapResult result = symmetricDirichletMap(disk, tutte(disk), options);
  ASSERT_EQ(result.status, Status::Converged);
  ASSERT_GT(result.history.size(), 3u);
  const double last = result.history.back().decrement, before = result.history[result.history.size() - 2].decrement;
  EXPECT_LT(last, 1e-2 * before);
  EXPECT_LT(result.iterations, 30);
}

TEST(SymmetricDirichletMap, KeepsTheBestScaleOfAStretchedCap) {
  // At the minimum the energy cannot be lowered by scaling: Σ ρ‖J‖² = Σ ρ‖J⁻¹‖².
  const DiskMesh disk(capMesh(10, 1.2));
  const SymmetricDirichletMapResult result = symmetricDirichletMap(disk, tutte(disk));
  const IsometricElements elements(disk.mesh(), 1);
  EXPECT_NEAR(elements.bestScale(result.image), 1, 1e-6);
}
