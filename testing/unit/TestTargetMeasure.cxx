#include <gtest/gtest.h>

#include <limits>

#include "Core/authalic/TargetMeasure.h"
#include "Core/base/Error.h"
#include "Core/geometry/Areas.h"
#include "support/TestMeshes.h"

using namespace authalic;
using namespace authalic::testing;

TEST(TargetMeasure, BlendsWithTheAreasOfAnImage) {
  const TriangleMesh mesh = authalic::testing::bumpyDisk(4);
  const TargetMeasure target(mesh);
  Eigen::VectorXd areas = Eigen::VectorXd::LinSpaced(mesh.faceCount(), 1, 3);
  EXPECT_LT((target.blended(mesh, areas, 1).faces() - target.faces()).cwiseAbs().maxCoeff(), 1e-15);
  EXPECT_LT((target.blended(mesh, areas, 0).faces() - areas / areas.sum()).cwiseAbs().maxCoeff(), 1e-15);
  const TargetMeasure half = target.blended(mesh, areas, 0.5);
  EXPECT_LT((2 * half.faces() - target.faces() - areas / areas.sum()).cwiseAbs().maxCoeff(), 1e-15);
  EXPECT_NEAR(half.vertices().sum(), 1, 1e-14);
  EXPECT_THROW((void)target.blended(mesh, areas, 1.5), InvalidArgument);
  areas[3] = -1;
  EXPECT_THROW((void)target.blended(mesh, areas, 0.5), GeometryError);
}

TEST(TargetMeasure, IsTheAreaShareForUniformDensity) {
  const TriangleMesh mesh = bumpyDisk(6);
  const TargetMeasure target(mesh);
  const Eigen::VectorXd areas = faceAreas(mesh);
  EXPECT_LT((target.faces() - areas / areas.sum()).cwiseAbs().maxCoeff(), 1e-15);
  EXPECT_NEAR(target.faces().sum(), 1, 1e-14);
  EXPECT_NEAR(target.vertices().sum(), 1, 1e-14);
  EXPECT_EQ(target.clampedFaces(), 0);
}

TEST(TargetMeasure, GivesARegionItsFactorPerArea) {
  const TriangleMesh mesh = bumpyDisk(6);
  const Eigen::VectorXd areas = faceAreas(mesh);
  const TargetMeasure target = TargetMeasure::fromFaceDensity(mesh, regionDensity(mesh.faceCount(), {3, 4, 5}, 4));
  EXPECT_NEAR(target.faces()[3] / areas[3], 4 * target.faces()[20] / areas[20], 1e-12);
}

TEST(TargetMeasure, TakesTheMeanOfVertexDensitiesOnAFace) {
  const TriangleMesh mesh = gridMesh(2, 2);
  Eigen::VectorXd density = Eigen::VectorXd::Ones(9);
  density[0] = 4;  // corners of face 0: 4, 1, 1
  const TargetMeasure target = TargetMeasure::fromVertexDensity(mesh, density);
  EXPECT_NEAR(target.faces()[0], 2 * target.faces()[3], 1e-14);
}

TEST(TargetMeasure, DoesNotChangeWithTheScaleOfTheDensity) {
  const TriangleMesh mesh = bumpyDisk(4);
  Eigen::VectorXd density = Eigen::VectorXd::LinSpaced(mesh.vertexCount(), 1, 3);
  const TargetMeasure a = TargetMeasure::fromVertexDensity(mesh, density);
  const TargetMeasure b = TargetMeasure::fromVertexDensity(mesh, 1000 * density);
  EXPECT_LT((a.faces() - b.faces()).cwiseAbs().maxCoeff(), 1e-16);
}

TEST(TargetMeasure, ClampsFacesWithoutAreaAndCountsThem) {
  Points3 points(4, 3);
  points << 0, 0, 0, 1, 0, 0, 2, 0, 0, 1, 1, 0;
  Faces faces(2, 3);
  faces << 0, 1, 2, 0, 2, 3;
  const TargetMeasure target{TriangleMesh(points, faces)};
  EXPECT_EQ(target.clampedFaces(), 1);
  EXPECT_GT(target.faces()[0], 0);
  EXPECT_NEAR(target.faces().sum(), 1, 1e-14);
}

TEST(TargetMeasure, KeepsStarsExactBesideFacesWithoutArea) {
  Points3 points(4, 3);
  points << 0, 0, 0, 1, 0, 0, 2, 0, 0, 1, 1, 0;
  Faces faces(2, 3);
  faces << 0, 1, 2, 0, 2, 3;
  const TargetMeasure target{TriangleMesh(points, faces)};
  EXPECT_EQ(target.shares()[0], 0);
  EXPECT_EQ(target.shares()[1], 1);
  for (const int v : {0, 2, 3}) EXPECT_NEAR(target.vertices()[v], 1.0 / 3, 1e-5);
  EXPECT_GT(target.vertices()[1], 0);  // nothing can be mapped to a point
  EXPECT_NEAR(target.vertices().sum(), 1, 1e-14);
}

TEST(TargetMeasure, RefusesZeroNegativeNaNAndWrongLengthsInWords) {
  const TriangleMesh mesh = gridMesh(2, 2);
  Eigen::VectorXd density = Eigen::VectorXd::Ones(9);
  for (const double bad :
       {0.0, -1.0, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    density[5] = bad;
    try {
      static_cast<void>(TargetMeasure::fromVertexDensity(mesh, density));
      FAIL() << bad;
    } catch (const InvalidArgument& error) {
      EXPECT_NE(std::string(error.what()).find("vertex 5"), std::string::npos) << error.what();
    }
  }
  EXPECT_THROW(static_cast<void>(TargetMeasure::fromVertexDensity(mesh, Eigen::VectorXd::Ones(8))), GeometryError);
  EXPECT_THROW(static_cast<void>(TargetMeasure::fromFaceDensity(mesh, Eigen::VectorXd::Ones(9))), GeometryError);
  EXPECT_THROW(static_cast<void>(regionDensity(9, {9}, 2)), InvalidArgument);
  EXPECT_THROW(static_cast<void>(regionDensity(9, {1}, 0)), InvalidArgument);
}

TEST(TargetMeasure, RefusesASurfaceWithoutArea) {
  Points3 points(3, 3);
  points << 0, 0, 0, 1, 0, 0, 2, 0, 0;
  Faces faces(1, 3);
  faces << 0, 1, 2;
  const TriangleMesh line(points, faces);
  EXPECT_THROW(TargetMeasure{line}, GeometryError);
}

TEST(TargetMeasure, BlendsByAWeightPerVertex) {
  const TriangleMesh mesh = bumpyDisk(6);
  const TargetMeasure target(mesh);
  const Eigen::VectorXd areas = Eigen::VectorXd::LinSpaced(mesh.faceCount(), 1, 3);
  Eigen::VectorXd t = (mesh.points().col(0).array() > 0).cast<double>();
  const Eigen::VectorXd blended = target.blended(mesh, areas, t).faces();
  double scale = 0;  // one normalisation for all of it
  for (int f = 0; f < mesh.faceCount(); ++f) {
    const double mean = (t[mesh.faces()(f, 0)] + t[mesh.faces()(f, 1)] + t[mesh.faces()(f, 2)]) / 3;
    const double wanted = (1 - mean) * areas[f] / areas.sum() + mean * target.faces()[f];
    if (f == 0) scale = blended[f] / wanted;
    EXPECT_NEAR(blended[f] / wanted, scale, 1e-12);
  }
  EXPECT_NEAR(blended.sum(), 1, 1e-14);
  t[4] = 1.5;
  EXPECT_THROW((void)target.blended(mesh, areas, t), InvalidArgument);
  EXPECT_THROW((void)target.blended(mesh, areas, t.head(3).eval()), GeometryError);
}
