#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <complex>
#include <random>

#include "Core/distortion/Distortion.h"
#include "Core/initial/LeastSquaresConformalMap.h"
#include "support/TestMeshes.h"

using namespace authalic;
using namespace authalic::testing;

namespace {

Eigen::VectorXcd complexOf(const Eigen::MatrixXd& p) {
  Eigen::VectorXcd z(p.rows());
  z.real() = p.col(0);
  z.imag() = p.col(1);
  return z;
}

/// Largest distance between two images after the best similarity, relative to the second one's spread.
double differenceUpToSimilarity(Eigen::VectorXcd z, Eigen::VectorXcd w) {
  z.array() -= z.mean();
  w.array() -= w.mean();
  const std::complex<double> factor = z.dot(w) / z.dot(z);
  return (factor * z - w).cwiseAbs().maxCoeff() / w.cwiseAbs().maxCoeff();
}

LeastSquaresConformalMapOptions withPins(ConformalPins pins) {
  LeastSquaresConformalMapOptions options;
  options.pins = pins;
  return options;
}

const ConformalPins kBoth[] = {ConformalPins::TwoVertices, ConformalPins::Spectral};

}  // namespace

TEST(LeastSquaresConformalMap, ReproducesFlatDisks) {
  const TriangleMesh flat = diskMesh(12);
  std::mt19937 random(5);
  std::uniform_real_distribution<double> noise(-0.02, 0.02);
  Points3 points = flat.points();
  for (Eigen::Index i = 0; i < points.rows(); ++i) points.row(i) += Eigen::RowVector3d(noise(random), noise(random), 0);
  const DiskMesh disk(TriangleMesh(points, flat.faces()));
  for (const ConformalPins pins : kBoth) {
    const LeastSquaresConformalMapResult result = leastSquaresConformalMap(disk, withPins(pins));
    EXPECT_EQ(result.status, Status::Converged);
    EXPECT_LT(differenceUpToSimilarity(complexOf(result.image), complexOf(points)), 1e-7) << conformalPinsName(pins);
    EXPECT_NEAR(result.conformalEnergy, 0, 1e-10);
  }
}

TEST(LeastSquaresConformalMap, UnrollsDevelopableSurfacesUpToSimilarity) {
  // A half cylinder: isometric to its flat rectangle up to the polygonal bend, which a regular grid unrolls exactly.
  const TriangleMesh grid = gridMesh(24, 16, M_PI, 2);
  Points3 points = grid.points();
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    const double angle = grid.points()(i, 0);
    points.row(i) << std::cos(angle), std::sin(angle), grid.points()(i, 1);
  }
  const double chord = 24 / M_PI * 2 * std::sin(M_PI / 48);  // of each column, against its arc
  Eigen::MatrixXd unrolled = grid.points().leftCols<2>();
  unrolled.col(0) *= chord;
  for (const ConformalPins pins : kBoth) {
    const DiskMesh disk(TriangleMesh(points, grid.faces()));
    const LeastSquaresConformalMapResult result = leastSquaresConformalMap(disk, withPins(pins));
    EXPECT_LT(differenceUpToSimilarity(complexOf(result.image), complexOf(unrolled)), 1e-7) << conformalPinsName(pins);
  }
}

TEST(LeastSquaresConformalMap, OfASphericalCapBecomesConformalUnderRefinement) {
  // With a free boundary every conformal map of the cap has energy 0; the mesh chooses among them.
  for (const ConformalPins pins : kBoth) {
    double previousEnergy = 0, previousDistortion = 0;
    for (const int rings : {8, 16, 32}) {
      const DiskMesh cap(capMesh(rings, 1.2));
      const LeastSquaresConformalMapResult result = leastSquaresConformalMap(cap, withPins(pins));
      const double distortion = measureDistortion(cap.mesh(), result.image).summary.angleDistortion - 2;
      EXPECT_EQ(result.flippedFaces, 0);
      if (previousEnergy > 0) {
        EXPECT_GT(previousEnergy / result.conformalEnergy, 3.8) << conformalPinsName(pins);
        EXPECT_GT(previousDistortion / distortion, 3.8) << conformalPinsName(pins);
      }
      previousEnergy = result.conformalEnergy;
      previousDistortion = distortion;
    }
  }
}

TEST(LeastSquaresConformalMap, SpectralPinsMapASphericalCapLikeTheStereographicProjection) {
  // Symmetric mesh, hence symmetric map; the sixfold mesh leaves a z⁷ of under 1e-3 that does not vanish under
  // refinement.
  const TriangleMesh cap = capMesh(24, 1.2);
  Eigen::MatrixXd projected(cap.vertexCount(), 2);
  for (int i = 0; i < cap.vertexCount(); ++i) {
    projected.row(i) = cap.points().row(i).leftCols<2>() / (1 + cap.points()(i, 2));
  }
  const LeastSquaresConformalMapResult result =
      leastSquaresConformalMap(DiskMesh(cap), withPins(ConformalPins::Spectral));
  EXPECT_LT(differenceUpToSimilarity(complexOf(result.image), complexOf(projected)), 2e-3);
}
