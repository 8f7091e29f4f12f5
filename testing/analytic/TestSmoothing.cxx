#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

#include "Core/base/Error.h"
#include "Core/geometry/Areas.h"
#include "Core/geometry/Decimation.h"
#include "Core/geometry/SurfaceSmoothing.h"
#include "Core/imaging/Isosurface.h"
#include "Core/mesh/SurfaceTopology.h"
#include "support/TestMeshes.h"

using namespace authalic;
using namespace authalic::testing;

namespace {

constexpr double kPi = 3.14159265358979323846;

// Zero surface of a function of mm on a lattice of the given spacing over [-14, 14]³.
TriangleMesh surfaceOf(double spacing, const std::function<double(const Eigen::Vector3d&)>& f,
                       bool mirrored = false) {
  const int n = static_cast<int>(28 / spacing) + 1;
  Eigen::Matrix4d affine = Eigen::Matrix4d::Identity();
  affine.diagonal().head<3>().setConstant(spacing);
  affine.topRightCorner<3, 1>().setConstant(-14 + 0.1 * spacing);
  if (mirrored) affine.row(0) *= -1;
  ScalarVolume field({n, n, n}, affine);
  for (int k = 0; k < n; ++k) {
    for (int j = 0; j < n; ++j) {
      for (int i = 0; i < n; ++i) field.at(i, j, k) = static_cast<float>(f(field.world(i, j, k)));
    }
  }
  return extractIsosurface(field);
}

double ball(const Eigen::Vector3d& p) {
  return 10 - p.norm();
}
double torus(const Eigen::Vector3d& p) {
  return 3 - std::hypot(std::hypot(p[0], p[1]) - 8, p[2]);
}

int euler(const TriangleMesh& mesh) {
  return SurfaceTopology(mesh.faces(), mesh.vertexCount()).eulerCharacteristic();
}

TriangleMesh noisySphere() {
  std::mt19937 random(4);
  std::normal_distribution<double> noise(0, 0.01);
  const TriangleMesh sphere = sphereMesh(5);
  Points3 points = sphere.points();
  for (Eigen::Index v = 0; v < points.rows(); ++v) points.row(v) *= 1 + noise(random);
  return TriangleMesh(points, sphere.faces());
}

}  // namespace

TEST(Isosurface, OfABallConvergesWithSecondOrderInVolumeAndArea) {
  double volumeError[3], areaError[3];
  for (int level = 0; level < 3; ++level) {
    const TriangleMesh mesh = surfaceOf(2.0 / (1 << level), ball);
    volumeError[level] = std::abs(enclosedVolume(mesh) / (4 * kPi * 1000 / 3) - 1);
    areaError[level] = std::abs(faceAreas(mesh).sum() / (4 * kPi * 100) - 1);
    EXPECT_EQ(euler(mesh), 2);
  }
  for (int level = 0; level < 2; ++level) {
    EXPECT_GT(volumeError[level] / volumeError[level + 1], 3.5);
    EXPECT_GT(areaError[level] / areaError[level + 1], 3.0);
  }
  EXPECT_LT(volumeError[2], 2e-3);
}

TEST(Isosurface, FacesOutwardAlsoWhenTheAffineMirrors) {
  EXPECT_GT(enclosedVolume(surfaceOf(1, ball)), 0);
  EXPECT_NEAR(enclosedVolume(surfaceOf(1, ball, true)), enclosedVolume(surfaceOf(1, ball)), 1e-6 * 4189);
}

TEST(Isosurface, KeepsTheHandleOfATorus) {
  EXPECT_EQ(euler(surfaceOf(1, torus)), 0);
}

TEST(Isosurface, RefusesEmptyThinAndUnpaddedFields) {
  ScalarVolume field({5, 5, 5}, Eigen::Matrix4d::Identity(), -1.0f);
  EXPECT_THROW(static_cast<void>(extractIsosurface(field)), InvalidArgument);
  field.at(0, 2, 2) = 1;
  EXPECT_THROW(static_cast<void>(extractIsosurface(field)), InvalidArgument);
  EXPECT_THROW(static_cast<void>(extractIsosurface(ScalarVolume({2, 5, 5}, Eigen::Matrix4d::Identity()))),
               InvalidArgument);
}

TEST(Smoothing, RestoresTheVolumeAndTheAreaOfANoisySphere) {
  const TriangleMesh noisy = noisySphere();
  const SmoothedSurface smooth = smoothSurface(noisy);
  EXPECT_NEAR(smooth.volumeAfter / smooth.volumeBefore, 1, 1e-9);
  EXPECT_GT(smooth.areaBefore / (4 * kPi), 1.02);
  EXPECT_NEAR(smooth.areaAfter / (4 * kPi), 1, 2e-3);
  EXPECT_EQ(smooth.turnedFaces, 0);
  EXPECT_TRUE(smooth.mesh.faces() == noisy.faces());
}

TEST(Smoothing, ChangesASmoothSphereLessAndLessAsItIsRefined) {
  double deviation[3];
  for (int level = 0; level < 3; ++level) {
    const SmoothedSurface smooth = smoothSurface(sphereMesh(4 + level));
    deviation[level] = (smooth.mesh.points().rowwise().norm().array() - 1).abs().maxCoeff();
  }
  EXPECT_LT(deviation[1], 0.6 * deviation[0]);
  EXPECT_LT(deviation[2], 0.6 * deviation[1]);
  EXPECT_LT(deviation[2], 1e-3);
}

TEST(Smoothing, DoesNothingInNoIterations) {
  SmoothingOptions options;
  options.restoreVolume = false;
  options.iterations = 0;
  const TriangleMesh sphere = sphereMesh(3);
  EXPECT_TRUE(smoothSurface(sphere, options).mesh.points() == sphere.points());
}

TEST(Smoothing, GivesTheSameBitsOnOneAndOnTwoThreads) {
  const TriangleMesh noisy = noisySphere();
  EXPECT_TRUE(smoothSurface(noisy, {}, Execution({}, {}, 1)).mesh.points() ==
              smoothSurface(noisy, {}, Execution({}, {}, 2)).mesh.points());
}

TEST(Smoothing, RefusesOpenSurfacesAndHonoursCancel) {
  EXPECT_THROW(static_cast<void>(smoothSurface(diskMesh(4))), TopologyError);
  EXPECT_THROW(static_cast<void>(smoothSurface(sphereMesh(2), {}, Execution({}, [] { return true; }))),
               CancelledError);
}

TEST(Decimation, KeepsTheTopologyOfSphereTorusAndDisk) {
  const TriangleMesh sphere = decimate(sphereMesh(5), 500);
  EXPECT_EQ(sphere.faceCount(), 500);
  EXPECT_EQ(euler(sphere), 2);
  const TriangleMesh ring = decimate(surfaceOf(1, torus), 600);
  EXPECT_LE(ring.faceCount(), 600);
  EXPECT_EQ(euler(ring), 0);
  const TriangleMesh disk = decimate(bumpyDisk(30), 1500);
  const SurfaceTopology topology(disk.faces(), disk.vertexCount());
  EXPECT_LE(disk.faceCount(), 1500);
  EXPECT_EQ(topology.eulerCharacteristic(), 1);
  ASSERT_EQ(topology.boundaryLoops().size(), 1u);
  EXPECT_EQ(topology.boundaryLoops()[0].size(), 180u);
  EXPECT_TRUE(topology.manifold() && topology.isolatedVertices().empty());
}

TEST(Decimation, StaysNearTheSphereWithEvenTriangles) {
  const TriangleMesh coarse = decimate(surfaceOf(0.5, ball), 4000);
  const Eigen::VectorXd radii = coarse.points().rowwise().norm();
  EXPECT_NEAR(radii.minCoeff(), 10, 0.1);
  EXPECT_NEAR(radii.maxCoeff(), 10, 0.1);
  EXPECT_NEAR(enclosedVolume(coarse) / (4 * kPi * 1000 / 3), 1, 4e-3);
  const Eigen::VectorXd areas = faceAreas(coarse);
  EXPECT_LT(areas.maxCoeff() / areas.mean(), 5);
}

TEST(Decimation, StopsWhereTopologyForbidsMore) {
  const TriangleMesh tetrahedron = decimate(sphereMesh(2), 4);
  EXPECT_EQ(euler(tetrahedron), 2);
  EXPECT_GE(tetrahedron.faceCount(), 4);
}

TEST(Decimation, ReturnsASmallMeshUnchangedAndRefusesBadInput) {
  const TriangleMesh sphere = sphereMesh(2);
  EXPECT_TRUE(decimate(sphere, 1000).points() == sphere.points());
  EXPECT_THROW(static_cast<void>(decimate(sphere, 3)), InvalidArgument);
  Faces twisted = sphere.faces();
  std::swap(twisted(0, 0), twisted(0, 1));
  EXPECT_THROW(static_cast<void>(decimate(TriangleMesh(sphere.points(), twisted), 20)), TopologyError);
}
