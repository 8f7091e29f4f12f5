#include <gtest/gtest.h>

#include <cmath>

#include "Core/base/Error.h"
#include "Core/geometry/Areas.h"
#include "Core/geometry/GaussianCurvature.h"
#include "Core/geometry/SurfaceDistance.h"
#include "support/TestMeshes.h"

using namespace authalic;
using namespace authalic::testing;

namespace {

double worstOnFlatDisk(int rings) {
  const TriangleMesh mesh = diskMesh(rings);
  const Eigen::VectorXd distance = surfaceDistance(mesh, {0});
  return (distance - mesh.points().rowwise().norm()).cwiseAbs().maxCoeff();
}

}  // namespace

TEST(SurfaceDistance, ConvergesToTheRadiusOnAFlatDisk) {
  const double coarse = worstOnFlatDisk(10), middle = worstOnFlatDisk(20), fine = worstOnFlatDisk(40);
  EXPECT_LT(coarse, 0.029);
  EXPECT_LT(middle, 0.0185);
  EXPECT_LT(fine, 0.0114);
}

TEST(SurfaceDistance, IsExactForAStraightFront) {
  const TriangleMesh mesh = gridMesh(8, 5, 2.0, 1.0);
  std::vector<int> left;
  for (int v = 0; v < mesh.vertexCount(); ++v) {
    if (mesh.points()(v, 0) == 0) left.push_back(v);
  }
  EXPECT_LT((surfaceDistance(mesh, left) - mesh.points().col(0)).cwiseAbs().maxCoeff(), 1e-14);
}

TEST(SurfaceDistance, ConvergesToTheArcOnASphere) {
  double before = 1;
  for (const int level : {3, 4, 5}) {
    const TriangleMesh mesh = sphereMesh(level);
    const Eigen::VectorXd distance = surfaceDistance(mesh, {0});
    double worst = 0;
    for (int v = 0; v < mesh.vertexCount(); ++v) {
      worst = std::max(
          worst, std::abs(distance[v] - std::acos(std::clamp(mesh.point(v).dot(mesh.point(0)), -1.0, 1.0))));
    }
    EXPECT_LT(worst, 0.75 * before);
    before = worst;
  }
  EXPECT_LT(before, 0.05);
}

TEST(SurfaceDistance, IsInfiniteWhereNoWayLeads) {
  const TriangleMesh one = gridMesh(1, 1);
  Points3 points(8, 3);
  points << one.points(), one.points().rowwise() + Eigen::RowVector3d(9, 0, 0);
  Faces faces(4, 3);
  faces << one.faces(), (one.faces().array() + 4).matrix();
  const Eigen::VectorXd distance = surfaceDistance(TriangleMesh(points, faces), {0});
  EXPECT_TRUE(distance.head(4).allFinite());
  EXPECT_TRUE((distance.tail(4).array() == std::numeric_limits<double>::infinity()).all());
  EXPECT_THROW((void)surfaceDistance(one, {4}), InvalidArgument);
}

TEST(GaussianCurvature, FulfilsGaussBonnetAndHasMeanOneOverHalfTheUnitSphere) {
  const TriangleMesh sphere = sphereMesh(4);
  const Eigen::VectorXd curvature = gaussianCurvature(sphere, SurfaceTopology(sphere.faces(), sphere.vertexCount()));
  const Eigen::VectorXd stars = vertexStars(faceAreas(sphere), sphere.faces(), sphere.vertexCount());
  EXPECT_NEAR(curvature.dot(stars), 4 * M_PI, 1e-11);
  const Eigen::VectorXd upper = (sphere.points().col(2).array() > 0).cast<double>();
  EXPECT_NEAR(curvature.cwiseProduct(stars).dot(upper) / stars.dot(upper), 1, 0.02);
  const TriangleMesh flat = diskMesh(5);
  EXPECT_LT(gaussianCurvature(flat, SurfaceTopology(flat.faces(), flat.vertexCount())).cwiseAbs().maxCoeff(), 1e-11);
}
