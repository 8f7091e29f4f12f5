#include <gtest/gtest.h>

#include <random>

#include "Core/conformal/SphericalUnfold.h"
#include "Core/geometry/SphericalAreas.h"
#include "support/TestMeshes.h"

using namespace authalic;
using namespace authalic::testing;

TEST(SphericalUnfold, LeavesAnImageWithoutFoldsAlone) {
  const TriangleMesh sphere = sphereMesh(3);
  const SphericalUnfoldResult result = unfoldOnSphere(sphere.faces(), sphere.points());
  EXPECT_EQ(result.rounds, 0);
  EXPECT_EQ(result.movedVertices, 0);
  EXPECT_EQ(result.image, sphere.points());
}

TEST(SphericalUnfold, RemovesScatteredFoldsAndMovesNothingElse) {
  const TriangleMesh sphere = sphereMesh(4);
  Points3 image = sphere.points();
  std::mt19937 random(3);
  std::normal_distribution<double> normal(0, 0.1);
  for (Eigen::Index v = 0; v < image.rows(); v += 97) {
    for (int k = 0; k < 3; ++k) image(v, k) += normal(random);
    image.row(v).normalize();
  }
  ASSERT_GT(countFlippedOnSphere(image, sphere.faces()), 10);
  const SphericalUnfoldResult result = unfoldOnSphere(sphere.faces(), image);
  EXPECT_EQ(result.flippedFaces, 0);
  EXPECT_EQ(countFlippedOnSphere(result.image, sphere.faces()), 0);
  EXPECT_LT(result.movedVertices, sphere.vertexCount());
  EXPECT_LT((result.image.rowwise().norm().array() - 1).abs().maxCoeff(), 1e-14);
}

TEST(SphericalUnfold, SaysWhatIsLeftWhereNoPatchFits) {
  const TriangleMesh octahedron = sphereMesh(0);
  Points3 image = octahedron.points();
  image.row(0) = image.row(1);
  const SphericalUnfoldResult result = unfoldOnSphere(octahedron.faces(), image);
  EXPECT_EQ(result.flippedFaces, countFlippedOnSphere(result.image, octahedron.faces()));
  EXPECT_GT(result.flippedFaces, 0);
}
