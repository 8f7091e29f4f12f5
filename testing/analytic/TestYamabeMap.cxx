#include <gtest/gtest.h>

#include <cmath>

#include "Core/base/Error.h"
#include "Core/conformal/RiemannMap.h"
#include "Core/conformal/YamabeMap.h"
#include "Core/geometry/Areas.h"
#include "Core/numerics/CircleFit.h"
#include "support/TestMeshes.h"

using namespace authalic;
using namespace authalic::testing;

TEST(YamabeMap, OfAFlatSquareWithItsOwnCornersIsTheSquare) {
  const TriangleMesh square = gridMesh(10, 10);
  const DiskMesh disk(square);
  YamabeMapOptions options;
  options.curvature = Eigen::VectorXd::Zero(square.vertexCount());
  for (const int corner : {0, 10, 110, 120}) options.curvature[corner] = M_PI / 2;
  options.startVertex = 10;
  const YamabeMapResult result = yamabeMap(disk, options);
  ASSERT_EQ(result.status, Status::Converged);
  EXPECT_EQ(result.iterations, 0);
  EXPECT_NEAR(signedFaceAreas(result.image, square.faces()).sum(), 1, 1e-12);
  EXPECT_NEAR((result.image.row(0) - result.image.row(10)).norm(), 1, 1e-9);
  EXPECT_NEAR((result.image.row(0) - result.image.row(120)).norm(), std::sqrt(2), 1e-9);
  EXPECT_NEAR(result.image(10, 1), 0, 1e-12);
  EXPECT_GT(result.image(10, 0), 0);
}

TEST(YamabeMap, BendsADiskIntoARectangleWithStraightSides) {
  const TriangleMesh mesh = bumpyDisk(16);
  const DiskMesh disk(mesh);
  const std::vector<int>& loop = disk.boundary();
  YamabeMapOptions options;
  options.curvature = Eigen::VectorXd::Zero(mesh.vertexCount());
  const std::size_t corners[] = {0, 20, 50, 70};
  for (const std::size_t c : corners) options.curvature[loop[c]] = M_PI / 2;
  const YamabeMapResult result = yamabeMap(disk, options);
  ASSERT_EQ(result.status, Status::Converged);
  EXPECT_LT(result.holonomy, 1e-9);
  for (std::size_t side = 0; side < 4; ++side) {
    const Eigen::RowVector2d a = result.image.row(loop[corners[side]]),
                             b = result.image.row(loop[corners[(side + 1) % 4]]),
                             along = (b - a).normalized();
    const std::size_t end = side == 3 ? loop.size() : corners[side + 1];
    for (std::size_t k = corners[side]; k < end; ++k) {
      const Eigen::RowVector2d arm = result.image.row(loop[k]) - a;
      EXPECT_NEAR(arm[0] * along[1] - arm[1] * along[0], 0, 1e-9);
    }
    const Eigen::RowVector2d c = result.image.row(loop[corners[(side + 2) % 4]]);
    EXPECT_NEAR(along.dot((c - b).normalized()), 0, 1e-9);
  }
}

TEST(YamabeMap, SpreadsTheRoundingOfTargetsAndRefusesMore) {
  const DiskMesh disk(bumpyDisk(6));
  const auto& boundary = disk.boundary();
  YamabeMapOptions options;
  options.curvature = Eigen::VectorXd::Zero(disk.mesh().vertexCount());
  for (std::size_t k = 0; k < 3; ++k) options.curvature[boundary[k * boundary.size() / 3]] = 2.09440;
  const YamabeMapResult rounded = yamabeMap(disk, options);
  EXPECT_EQ(rounded.status, Status::Converged);
  EXPECT_NEAR(rounded.curvature.sum(), 2 * M_PI, 1e-12);
  EXPECT_NEAR(rounded.curvature[boundary[1]], 0, 1e-10);  // straight sides stay straight
  options.curvature[boundary[0]] = 2.095;
  EXPECT_THROW(static_cast<void>(yamabeMap(disk, options)), InvalidArgument);
}

TEST(YamabeMap, OntoACircleIsTheRiemannMapBeforeItsNormalisation) {
  const DiskMesh disk(bumpyDisk(12));
  const YamabeMapResult result = yamabeMap(disk);
  ASSERT_EQ(result.status, Status::Converged);
  const FittedCircle circle = fitCircle(result.image, disk.boundary());
  EXPECT_LT(circle.deviation, 1e-9);
  const Points2 unit = (result.image.rowwise() - circle.centre) / circle.radius;
  const Points2 normal = normaliseDisk(disk.mesh(), disk.topology(), disk.boundary(), unit, {});
  EXPECT_LT((normal - riemannMap(disk).image).cwiseAbs().maxCoeff(), 1e-9);
  EXPECT_NEAR(signedFaceAreas(result.image, disk.mesh().faces()).sum(), faceAreas(disk.mesh()).sum(), 1e-9);
}

TEST(YamabeMap, FollowsItsScaleFactorsAlongEdgesThatWereNotFlipped) {
  const DiskMesh disk(capMesh(8, 1.2));  // Delaunay from the start to the end
  const YamabeMapResult result = yamabeMap(disk);
  ASSERT_EQ(result.edgeFlips, 0);
  for (int h = 0; h < 3 * disk.mesh().faceCount(); ++h) {
    const int i = disk.topology().tail(h), j = disk.topology().head(h);
    const double ratio = (result.image.row(i) - result.image.row(j)).norm() /
                         (disk.mesh().point(i) - disk.mesh().point(j)).norm();
    EXPECT_NEAR(std::log(ratio), 0.5 * (result.logScale[i] + result.logScale[j]), 1e-8);
  }
}

TEST(YamabeMap, RefinesOnRequestAndAlsoRunsOnCirclePackings) {
  const DiskMesh disk(bumpyDisk(10));
  YamabeMapOptions options;
  options.refine = true;
  options.flow.metric = ConformalMetric::CirclePacking;
  const YamabeMapResult result = yamabeMap(disk, options);
  ASSERT_EQ(result.status, Status::Converged);
  ASSERT_TRUE(result.refinement.has_value());
  EXPECT_EQ(result.refinement->flippedFaces, 0);
  EXPECT_LT(fitCircle(result.image, disk.boundary()).deviation, 1e-9);
}

TEST(YamabeMap, RefusesConesInsideAndVerticesThatAreNone) {
  const DiskMesh disk(bumpyDisk(4));
  YamabeMapOptions options;
  options.startVertex = 0;
  EXPECT_THROW(static_cast<void>(yamabeMap(disk, options)), InvalidArgument);
  options = {};
  options.curvature = Eigen::VectorXd::Zero(disk.mesh().vertexCount());
  EXPECT_THROW(static_cast<void>(yamabeMap(disk, options)), InvalidArgument);  // Gauss–Bonnet
  options.curvature[0] = 2 * M_PI - 1;
  EXPECT_THROW(static_cast<void>(yamabeMap(disk, options)), InvalidArgument);
  options.curvature = Eigen::VectorXd::Zero(3);
  EXPECT_THROW(static_cast<void>(yamabeMap(disk, options)), GeometryError);
  EXPECT_EQ(yamabeMap(disk, {}, Execution({}, [] { return true; })).image.rows(), 0);
}
