#include <gtest/gtest.h>

#include <random>

#include "Core/base/Error.h"
#include "Core/mesh/DiskMesh.h"
#include "Core/mesh/MeshReport.h"
#include "Core/topology/CutToDisk.h"
#include "support/TestMeshes.h"

using namespace authalic;
using namespace authalic::testing;

namespace {

std::vector<char> beyondX(const TriangleMesh& mesh, double x) {
  return verticesBeyondPlane(mesh, {x, 0, 0}, Eigen::Vector3d::UnitX());
}

}  // namespace

TEST(CutToDisk, OpensASphereByAPlane) {
  const TriangleMesh sphere = sphereMesh(5);
  const CutToDiskResult result = cutToDisk(sphere, beyondX(sphere, 0.8));
  const MeshReport report = inspect(result.mesh);
  EXPECT_EQ(report.eulerCharacteristic, 1);
  EXPECT_EQ(report.loops.size(), 1u);
  EXPECT_NEAR(result.keptArea + result.removedArea, inspect(sphere).area, 1e-12);
  EXPECT_GT(result.loopLength, 2 * M_PI * 0.6);  // along edges: longer than the circle, by less than a fifth
  EXPECT_LT(result.loopLength, 1.2 * 2 * M_PI * 0.6);
}

TEST(CutToDisk, WithoutSmoothingKeepsExactlyTheFacesWithoutAMarkedVertex) {
  const TriangleMesh sphere = sphereMesh(4);
  const std::vector<char> remove = beyondX(sphere, 0.5);
  CutToDiskOptions options;
  options.loopSmoothing = 0;
  const CutToDiskResult result = cutToDisk(sphere, remove, options);
  int expected = 0;
  for (int f = 0; f < sphere.faceCount(); ++f) {
    bool keep = true;
    for (int k = 0; k < 3; ++k) keep = keep && !remove[static_cast<std::size_t>(sphere.faces()(f, k))];
    expected += keep;
  }
  EXPECT_EQ(result.mesh.faceCount(), expected);
}

TEST(CutToDisk, OriginalIdsLeadBackToTheInputBitForBit) {
  const TriangleMesh sphere = sphereMesh(4);
  const CutToDiskResult result = cutToDisk(sphere, beyondX(sphere, 0.3));
  ASSERT_EQ(static_cast<int>(result.originalPointIds.size()), result.mesh.vertexCount());
  for (int i = 0; i < result.mesh.vertexCount(); ++i) {
    ASSERT_EQ(result.mesh.point(i), sphere.point(result.originalPointIds[static_cast<std::size_t>(i)]));
  }
  for (int f = 0; f < result.mesh.faceCount(); ++f) {
    for (int k = 0; k < 3; ++k) {
      ASSERT_EQ(result.originalPointIds[static_cast<std::size_t>(result.mesh.faces()(f, k))],
                sphere.faces()(result.originalFaceIds[static_cast<std::size_t>(f)], k));
    }
  }
}

TEST(CutToDisk, KeepsSmallerRegionsAsSurface) {
  const TriangleMesh sphere = sphereMesh(5);
  std::vector<char> remove = beyondX(sphere, 0.7);
  for (int i = 0; i < sphere.vertexCount(); ++i) {
    if (sphere.point(i).x() < -0.9) remove[static_cast<std::size_t>(i)] = 1;
  }
  const CutToDiskResult result = cutToDisk(sphere, remove);
  EXPECT_EQ(result.ignoredRegions, 1);
  EXPECT_LT(result.mesh.points().col(0).minCoeff(), -0.99);
}

TEST(CutToDisk, RemovesIslandsInsideTheRegion) {
  const TriangleMesh sphere = sphereMesh(5);
  std::vector<char> remove = beyondX(sphere, 0.2);
  for (int i = 0; i < sphere.vertexCount(); ++i) {
    if (sphere.point(i).x() > 0.9) remove[static_cast<std::size_t>(i)] = 0;
  }
  const CutToDiskResult result = cutToDisk(sphere, remove);
  EXPECT_EQ(result.filledIslands, 1);
  EXPECT_LT(result.mesh.points().col(0).maxCoeff(), 0.3);
}

TEST(CutToDisk, AlwaysGivesADiskFromRaggedRegionsOfASphere) {
  const TriangleMesh sphere = sphereMesh(4);
  for (unsigned seed = 1; seed <= 40; ++seed) {
    std::mt19937 random(seed);
    std::vector<char> remove(static_cast<std::size_t>(sphere.vertexCount()));
    for (int i = 0; i < sphere.vertexCount(); ++i) {
      const double noise = static_cast<double>(random() % 1000) / 1000.0 - 0.5;
      remove[static_cast<std::size_t>(i)] = sphere.point(i).x() + noise > 0.3;
    }
    for (const int passes : {0, 3}) {
      CutToDiskOptions options;
      options.loopSmoothing = passes;
      EXPECT_NO_THROW(DiskMesh(cutToDisk(sphere, remove, options).mesh)) << "seed " << seed << " passes " << passes;
    }
  }
}

TEST(CutToDisk, SmoothingShortensARaggedLoop) {
  const TriangleMesh sphere = sphereMesh(5);
  std::mt19937 random(7);
  std::vector<char> remove(static_cast<std::size_t>(sphere.vertexCount()));
  for (int i = 0; i < sphere.vertexCount(); ++i) {
    remove[static_cast<std::size_t>(i)] = sphere.point(i).x() + 0.2 * (random() % 1000 / 1000.0 - 0.5) > 0.5;
  }
  CutToDiskOptions ragged;
  ragged.loopSmoothing = 0;
  EXPECT_LT(cutToDisk(sphere, remove).loopLength, 0.8 * cutToDisk(sphere, remove, ragged).loopLength);
}

TEST(CutToDisk, RefusesEmptyFullAndMismatchedRegions) {
  const TriangleMesh sphere = sphereMesh(2);
  EXPECT_THROW((void)cutToDisk(sphere, beyondX(sphere, 5)), GeometryError);
  EXPECT_THROW((void)cutToDisk(sphere, beyondX(sphere, -5)), GeometryError);
  EXPECT_THROW((void)cutToDisk(sphere, std::vector<char>(3, 1)), GeometryError);
  EXPECT_THROW((void)verticesBeyondPlane(sphere, {0, 0, 0}, {0, 0, 0}), InvalidArgument);
  CutToDiskOptions options;
  options.loopSmoothing = -1;
  EXPECT_THROW((void)cutToDisk(sphere, beyondX(sphere, 0), options), InvalidArgument);
}

TEST(CutToDisk, CanBeCancelled) {
  const TriangleMesh sphere = sphereMesh(3);
  const Execution cancelled({}, [] { return true; });
  EXPECT_THROW((void)cutToDisk(sphere, beyondX(sphere, 0.5), {}, cancelled), CancelledError);
}
