#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "Core/base/Error.h"
#include "Core/geometry/Areas.h"
#include "Core/topology/LevelSetCut.h"
#include "support/TestMeshes.h"

using namespace authalic;
using namespace authalic::testing;

namespace {

LevelSetCutOptions atLevel(double level, double clearance = LevelSetCutOptions().clearance) {
  LevelSetCutOptions options;
  options.level = level;
  options.clearance = clearance;
  return options;
}

/// What every cut must satisfy; DiskMesh itself has checked that the halves are disks.
void expectWellCut(const SphereMesh& surface, const LevelSetCutResult& cut) {
  const TriangleMesh& mesh = surface.mesh();
  EXPECT_NEAR(cut.above.area + cut.below.area, faceAreas(mesh).sum(), 1e-12 * faceAreas(mesh).sum());
  const int n = static_cast<int>(cut.seam.size());
  EXPECT_EQ(cut.above.disk.mesh().vertexCount() + cut.below.disk.mesh().vertexCount(), mesh.vertexCount() + 2 * n);
  EXPECT_EQ(cut.above.disk.mesh().faceCount() + cut.below.disk.mesh().faceCount(), mesh.faceCount() + 2 * n);
  for (const CutHalf* half : {&cut.above, &cut.below}) {
    std::vector<int> boundary = half->disk.boundary();  // starts at the smallest id
    if (half == &cut.below) std::reverse(boundary.begin() + 1, boundary.end());
    ASSERT_EQ(static_cast<int>(boundary.size()), n);
    for (int k = 0; k < n; ++k) EXPECT_EQ(boundary[static_cast<std::size_t>(k)], half->seamStart + k);
    for (int i = 0; i < half->disk.mesh().vertexCount(); ++i) {
      const int original = half->originalPointIds[static_cast<std::size_t>(i)];
      EXPECT_EQ(original < 0, i >= half->seamStart);
      if (original >= 0) {
        EXPECT_EQ(half->disk.mesh().point(i), mesh.point(original));
      }
    }
    Eigen::VectorXd covered = Eigen::VectorXd::Zero(mesh.faceCount());
    for (std::size_t f = 0; f < half->originalFaceIds.size(); ++f) {  // inside its face and with its orientation
      const int face = half->originalFaceIds[f];
      const auto normal = [](const TriangleMesh& m, int g) -> Eigen::Vector3d {
        return 0.5 * (m.corner(g, 1) - m.corner(g, 0)).cross(m.corner(g, 2) - m.corner(g, 0));
      };
      const Eigen::Vector3d whole = normal(mesh, face);
      const double share = normal(half->disk.mesh(), static_cast<int>(f)).dot(whole) / whole.squaredNorm();
      EXPECT_GT(share, 0);
      covered[face] += share;
    }
    EXPECT_LT(covered.maxCoeff(), 1 + 1e-9);
  }
}

}  // namespace

TEST(LevelSetCut, HalvesTheSphereAtItsEquator) {
  const SphereMesh sphere(sphereMesh(4));
  const Eigen::VectorXd z = sphere.mesh().points().col(2);
  const LevelSetCutResult cut = levelSetCut(sphere, z.array() - 0.01);
  expectWellCut(sphere, cut);
  EXPECT_EQ(cut.mergedPieces, 0);
  EXPECT_NEAR(cut.seamLength, 2 * M_PI, 0.02);
  EXPECT_NEAR(cut.above.area / cut.below.area, (1 - 0.01) / (1 + 0.01), 5e-3);
  for (const SeamPoint& point : cut.seam) {
    EXPECT_GT(z[point.above], 0.01);
    EXPECT_LE(z[point.below], 0.01);
  }
}

TEST(LevelSetCut, PassesVerticesOnTheLevelAtADistance) {
  const SphereMesh sphere(sphereMesh(3));  // has vertices at z = 0
  for (const double clearance : {0.01, 0.2, 0.5}) {
    const LevelSetCutResult cut = levelSetCut(sphere, sphere.mesh().points().col(2), atLevel(0, clearance));
    expectWellCut(sphere, cut);
    for (const SeamPoint& point : cut.seam) {
      EXPECT_GE(point.parameter, clearance);
      EXPECT_LE(point.parameter, 1 - clearance);
    }
    EXPECT_GT(faceAreas(cut.above.disk.mesh()).minCoeff(), 0);
    EXPECT_GT(faceAreas(cut.below.disk.mesh()).minCoeff(), 0);
  }
}

TEST(LevelSetCut, MergesIslandsAndLakes) {
  const SphereMesh sphere(sphereMesh(4));
  Eigen::VectorXd values = sphere.mesh().points().col(2).array() + 1e-3;
  const auto nearest = [&](const Eigen::Vector3d& point) {
    Eigen::Index index = 0;
    (sphere.mesh().points().rowwise() - point.transpose()).rowwise().norm().minCoeff(&index);
    return index;
  };
  values[nearest({0, 0.6, 0.8})] = -1;   // a lake
  values[nearest({0.6, 0, -0.8})] = 1;   // an island
  const LevelSetCutResult cut = levelSetCut(sphere, values);
  EXPECT_EQ(cut.mergedPieces, 2);
  expectWellCut(sphere, cut);
  EXPECT_NEAR(cut.above.area / cut.below.area, 1, 0.01);
}

TEST(LevelSetCut, LeavesTwoDisksForAnyFunction) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int trial = 0; trial < 20; ++trial) {
    const SphereMesh sphere(sphereMesh(1 + trial % 3));
    Eigen::VectorXd values(sphere.mesh().vertexCount());
    for (double& value : values) value = uniform(random);
    if (values.maxCoeff() <= 0 || values.minCoeff() > 0) continue;
    expectWellCut(sphere, levelSetCut(sphere, values));
  }
}

TEST(LevelSetCut, CutsOffASingleVertex) {
  const SphereMesh sphere(sphereMesh(0));
  const LevelSetCutResult cut = levelSetCut(sphere, sphere.mesh().points().col(0), atLevel(0.5));
  expectWellCut(sphere, cut);
  EXPECT_EQ(cut.above.seamStart, 1);
  EXPECT_EQ(cut.seam.size(), 4u);
}

TEST(LevelSetCut, RefusesLevelsAndValuesThatCannotCut) {
  const SphereMesh sphere(sphereMesh(1));
  const Eigen::VectorXd z = sphere.mesh().points().col(2);
  EXPECT_THROW((void)levelSetCut(sphere, z, atLevel(1)), GeometryError);
  EXPECT_THROW((void)levelSetCut(sphere, z, atLevel(-1.5)), GeometryError);
  EXPECT_THROW((void)levelSetCut(sphere, z.head(5)), GeometryError);
  EXPECT_THROW((void)levelSetCut(sphere, z * std::nan("")), GeometryError);
  EXPECT_THROW((void)levelSetCut(sphere, z, atLevel(0, 0.6)), InvalidArgument);
  EXPECT_THROW((void)levelSetCut(sphere, z, atLevel(0, 0)), InvalidArgument);
  EXPECT_THROW((void)levelSetCut(sphere, z, {}, Execution({}, [] { return true; })), CancelledError);
}
