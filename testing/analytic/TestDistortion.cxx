#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "Core/base/Error.h"
#include "Core/distortion/Distortion.h"
#include "support/TestMeshes.h"

using namespace authalic;
using namespace authalic::testing;

namespace {

Points2 flat(const TriangleMesh& mesh) { return mesh.points().leftCols<2>(); }

/// x -> x A for every point.
Points2 linear(const TriangleMesh& mesh, const Eigen::Matrix2d& a) { return flat(mesh) * a.transpose(); }

/// Lambert's equal-area image of the unit sphere's cap around +z: radius 2 sin(θ/2).
Points2 lambert(const TriangleMesh& cap) {
  Points2 image(cap.vertexCount(), 2);
  for (int i = 0; i < cap.vertexCount(); ++i) {
    const Eigen::Vector3d p = cap.point(i);
    const double s = std::sqrt(2 / (1 + p.z()));
    image.row(i) << s * p.x(), s * p.y();
  }
  return image;
}

/// Stereographic image from −z: conformal.
Points2 stereographic(const TriangleMesh& cap) {
  Points2 image(cap.vertexCount(), 2);
  for (int i = 0; i < cap.vertexCount(); ++i) {
    image.row(i) = cap.points().row(i).leftCols<2>() / (1 + cap.points()(i, 2));
  }
  return image;
}

}  // namespace

TEST(Distortion, OfASimilarityIsIdeal) {
  const TriangleMesh grid = gridMesh(7, 5, 2, 1);
  const Eigen::Matrix2d similarity = 3.7 * Eigen::Rotation2Dd(0.6).toRotationMatrix();
  const DistortionSummary s = measureDistortion(grid, linear(grid, similarity)).summary;
  EXPECT_NEAR(s.areaDistortion, 2, 1e-13);
  EXPECT_NEAR(s.angleDistortion, 2, 1e-13);
  EXPECT_NEAR(s.symmetricDirichlet, 4, 1e-12);
  EXPECT_NEAR(s.asRigidAsPossible, 0, 1e-13);
  EXPECT_NEAR(s.meanBeltrami, 0, 1e-13);
  EXPECT_NEAR(s.meanAngleError, 0, 1e-6);
  EXPECT_NEAR(s.vertexMaxAbsLog, 0, 1e-13);
  EXPECT_EQ(s.flippedFaces, 0);
}

TEST(Distortion, OfALinearMapHasItsSingularValues) {
  const TriangleMesh grid = gridMesh(6, 6);
  Eigen::Matrix2d a;
  a << 3, 0, 0, 1;  // normalised by det^½: σ = √3, 1/√3; K = 3; μ = (K−1)/(K+1) = ½
  const Distortion d = measureDistortion(grid, linear(grid, a));
  EXPECT_NEAR(d.summary.areaDistortion, 2, 1e-13);
  EXPECT_NEAR(d.summary.angleDistortion, 3 + 1.0 / 3, 1e-12);
  EXPECT_NEAR(d.summary.symmetricDirichlet, 2 * (3 + 1.0 / 3), 1e-12);
  EXPECT_NEAR(d.summary.asRigidAsPossible, std::pow(std::sqrt(3.0) - 1, 2) + std::pow(1 / std::sqrt(3.0) - 1, 2),
              1e-12);
  EXPECT_NEAR(std::abs(d.arrays.beltrami[0] - std::complex<double>(0.5, 0)), 0, 1e-12);
  EXPECT_NEAR(d.arrays.sigmaMin[0], 1 / std::sqrt(3.0), 1e-12);
}

TEST(Distortion, BeltramiCoefficientTurnsWithTheStretchDirection) {
  const TriangleMesh grid = gridMesh(3, 3);
  const double angle = 0.4;
  const Eigen::Matrix2d r = Eigen::Rotation2Dd(angle).toRotationMatrix();
  const Eigen::Matrix2d stretch = r * Eigen::Vector2d(2, 1).asDiagonal() * r.transpose();
  const Distortion d = measureDistortion(grid, linear(grid, stretch));
  // The face frame of face 0 is the x axis (its first edge); μ = (1/3) e^{2 i angle}.
  EXPECT_NEAR(std::abs(d.arrays.beltrami[0] - std::polar(1.0 / 3, 2 * angle)), 0, 1e-12);
}

TEST(Distortion, OfAMirrorImageIsIdealWithoutFlips) {
  const TriangleMesh grid = gridMesh(4, 4);
  const DistortionSummary s = measureDistortion(grid, linear(grid, Eigen::Vector2d(-1, 1).asDiagonal())).summary;
  EXPECT_EQ(s.flippedFaces, 0);
  EXPECT_NEAR(s.areaDistortion, 2, 1e-13);
  EXPECT_NEAR(s.meanBeltrami, 0, 1e-13);
}

TEST(Distortion, CountsFoldedAndCollapsedFaces) {
  const TriangleMesh grid = gridMesh(4, 4);
  Points2 image = flat(grid);
  image.row(12) << 1.9, 0.5;  // the middle vertex leaves its star
  const Distortion folded = measureDistortion(grid, image);
  EXPECT_GT(folded.summary.flippedFaces, 0);
  EXPECT_EQ(folded.summary.flippedFaces, folded.arrays.flipped.sum());
  for (int f = 0; f < grid.faceCount(); ++f) {
    EXPECT_EQ(folded.arrays.flipped[f] == 1, folded.arrays.sigmaMin[f] < 0) << f;
  }
  image = flat(grid);
  image.row(0) = image.row(1);
  EXPECT_GE(measureDistortion(grid, image).summary.flippedFaces, 1);
}

TEST(Distortion, OfLambertsMapHasVanishingAreaError) {
  double previous = 0;
  for (const int rings : {8, 16, 32}) {
    const TriangleMesh cap = capMesh(rings, 1.2);
    const double error = measureDistortion(cap, lambert(cap)).summary.areaDistortion - 2;
    if (previous > 0) {
      EXPECT_GT(previous / error, 3.4);
    }
    previous = error;
  }
}

TEST(Distortion, OfTheStereographicMapHasVanishingAngleError) {
  double previous = 0;
  for (const int rings : {8, 16, 32}) {
    const TriangleMesh cap = capMesh(rings, 1.2);
    const double error = measureDistortion(cap, stereographic(cap)).summary.angleDistortion - 2;
    if (previous > 0) {
      EXPECT_GT(previous / error, 3.4);
    }
    previous = error;
  }
}

TEST(Distortion, ComparesWithATargetMeasure) {
  const TriangleMesh grid = gridMesh(4, 1, 4, 1);  // the right half counts three times
  Eigen::VectorXd target(grid.faceCount());
  for (int f = 0; f < grid.faceCount(); ++f) target[f] = f < 4 ? 1 : 3;
  Points2 image = flat(grid);
  for (int i = 0; i < grid.vertexCount(); ++i) {
    const double x = image(i, 0);
    image(i, 0) = x <= 2 ? x : 2 + 3 * (x - 2);
  }
  const Distortion d = measureDistortion(grid, image, target);
  EXPECT_NEAR(d.summary.areaDistortion, 2, 1e-13);
  EXPECT_NEAR(d.summary.vertexMaxAbsLog, 0, 1e-13);
  EXPECT_GT(measureDistortion(grid, image).summary.areaDistortion, 2.1);
}

TEST(Distortion, RefusesMismatchedSizesAndBadTargets) {
  const TriangleMesh grid = gridMesh(2, 2);
  EXPECT_THROW((void)measureDistortion(grid, Points2(3, 2)), GeometryError);
  EXPECT_THROW((void)measureDistortion(grid, flat(grid), Eigen::VectorXd::Ones(3)), GeometryError);
  EXPECT_THROW((void)measureDistortion(grid, flat(grid), -Eigen::VectorXd::Ones(8)), GeometryError);
  EXPECT_THROW((void)measureDistortion(grid, flat(grid), Eigen::VectorXd::Constant(8, NAN)), GeometryError);
  EXPECT_THROW((void)transportCost(flat(grid), Points2(2, 2), Eigen::VectorXd::Ones(9)), GeometryError);
}

TEST(Distortion, TransportCostOfATranslationIsItsSquaredLength) {
  const TriangleMesh grid = gridMesh(3, 3);
  Points2 moved = flat(grid);
  moved.rowwise() += Eigen::RowVector2d(3, 4);
  EXPECT_NEAR(transportCost(flat(grid), moved, Eigen::VectorXd::Constant(16, 1.0 / 16)), 25, 1e-12);
}
