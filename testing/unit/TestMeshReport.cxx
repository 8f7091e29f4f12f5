#include <gtest/gtest.h>

#include <string>

#include "Core/base/Error.h"
#include "Core/mesh/DiskMesh.h"
#include "Core/mesh/MeshReport.h"
#include "support/TestMeshes.h"

using namespace authalic;
using namespace authalic::testing;

namespace {

std::string refusal(const TriangleMesh& mesh) {
  try {
    DiskMesh checked(mesh);
  } catch (const TopologyError& error) {
    return error.what();
  }
  return {};
}

/// A torus of rings × sides quads, each split in two.
TriangleMesh torusMesh(int rings, int sides) {
  Points3 points(rings * sides, 3);
  Faces faces(2 * rings * sides, 3);
  for (int i = 0; i < rings; ++i) {
    for (int j = 0; j < sides; ++j) {
      const double u = 2 * M_PI * i / rings, v = 2 * M_PI * j / sides, r = 3 + std::cos(v);
      const auto id = [&](int a, int b) { return (a % rings) * sides + b % sides; };
      points.row(id(i, j)) << r * std::cos(u), r * std::sin(u), std::sin(v);
      faces.row(2 * id(i, j)) << id(i, j), id(i + 1, j), id(i + 1, j + 1);
      faces.row(2 * id(i, j) + 1) << id(i, j), id(i + 1, j + 1), id(i, j + 1);
    }
  }
  return TriangleMesh(points, faces);
}

/// Two meshes side by side as one.
TriangleMesh together(const TriangleMesh& a, const TriangleMesh& b, double shift) {
  Points3 points(a.vertexCount() + b.vertexCount(), 3);
  points << a.points(), b.points();
  points.bottomRows(b.vertexCount()).col(0).array() += shift;
  Faces faces(a.faceCount() + b.faceCount(), 3);
  faces << a.faces(), (b.faces().array() + a.vertexCount()).matrix();
  return TriangleMesh(points, faces);
}

}  // namespace

TEST(MeshReport, MeasuresAGrid) {
  const MeshReport report = inspect(gridMesh(4, 2, 2.0, 1.0));
  EXPECT_NEAR(report.area, 2.0, 1e-14);
  EXPECT_EQ(report.eulerCharacteristic, 1);
  EXPECT_EQ(report.genus, 0);
  ASSERT_EQ(report.loops.size(), 1u);
  EXPECT_NEAR(report.loops[0].length, 6.0, 1e-14);
  EXPECT_EQ(report.upper, Eigen::Vector3d(2, 1, 0));
}

TEST(MeshReport, FindsTheGenusOfATorusAndOfTwoComponents) {
  EXPECT_EQ(inspect(torusMesh(12, 7)).genus, 1);
  const MeshReport two = inspect(together(torusMesh(12, 7), sphereMesh(2), 10));
  EXPECT_EQ(two.genus, 1);
  ASSERT_EQ(two.components.size(), 2u);
  EXPECT_GT(two.components[0].area, two.components[1].area);
  EXPECT_NEAR(two.components[1].place.x(), 10, 1e-9);
}

TEST(MeshReport, EnclosedVolumeOfASphereConvergesAtSecondOrder) {
  const double exact = 4 * M_PI / 3;
  const double coarse = exact - inspect(sphereMesh(3)).volume, fine = exact - inspect(sphereMesh(4)).volume;
  EXPECT_GT(fine, 0);
  EXPECT_NEAR(coarse / fine, 4.0, 0.2);
}

TEST(MeshReport, ListsDegenerateAndDuplicateFacesWithTheirPlace) {
  Points3 points(5, 3);
  points << 0, 0, 0, 1, 0, 0, 0, 1, 0, 2, 0, 0, 5, 5, 5;
  Faces faces(3, 3);
  faces << 0, 1, 2, 2, 0, 1, 0, 3, 1;
  const MeshReport report = inspect(TriangleMesh(points, faces));
  ASSERT_EQ(report.duplicateFaces.size(), 1u);
  EXPECT_EQ(report.duplicateFaces[0].ids, std::vector<int>{1});
  ASSERT_EQ(report.degenerateFaces.size(), 1u);
  EXPECT_NEAR(report.degenerateFaces[0].place.x(), 1.0, 1e-14);
  ASSERT_EQ(report.isolatedVertices.size(), 1u);
  EXPECT_EQ(report.isolatedVertices[0].place, Eigen::Vector3d(5, 5, 5));
  EXPECT_EQ(report.genus, -1);
}

TEST(DiskMesh, AcceptsADisk) {
  const DiskMesh disk(diskMesh(3));
  EXPECT_EQ(disk.boundary().size(), 18u);
}

TEST(DiskMesh, RefusesEveryOtherTopologyInWords) {
  EXPECT_NE(refusal(sphereMesh(2)).find("no boundary"), std::string::npos);
  EXPECT_NE(refusal(torusMesh(8, 5)).find("genus 1"), std::string::npos);
  EXPECT_NE(refusal(together(diskMesh(3), diskMesh(2), 7)).find("second component"), std::string::npos);
  Points3 points = diskMesh(2).points();
  points.conservativeResize(points.rows() + 1, 3);
  points.bottomRows(1).setZero();
  EXPECT_NE(refusal(TriangleMesh(points, diskMesh(2).faces())).find("no face uses"), std::string::npos);
  Faces holed = diskMesh(4).faces().bottomRows(diskMesh(4).faceCount() - 6);  // the faces around the centre are gone
  Faces shifted = holed.array() - 1;
  EXPECT_NE(refusal(TriangleMesh(diskMesh(4).points().bottomRows(60), shifted)).find("2 boundary loops"),
            std::string::npos);
}

TEST(DiskMesh, RefusesAMoebiusBand) {
  const int n = 12;
  Points3 points(2 * n, 3);
  Faces faces(2 * n, 3);
  for (int i = 0; i < n; ++i) {
    const double u = 2 * M_PI * i / n;
    for (int s = 0; s < 2; ++s) {
      const double w = s == 0 ? -0.4 : 0.4, r = 2 + w * std::cos(u / 2);
      points.row(2 * i + s) << r * std::cos(u), r * std::sin(u), w * std::sin(u / 2);
    }
    const int a = 2 * i, b = 2 * i + 1, c = i + 1 < n ? a + 2 : 1, d = i + 1 < n ? b + 2 : 0;
    faces.row(a) << a, c, b;
    faces.row(b) << b, c, d;
  }
  EXPECT_NE(refusal(TriangleMesh(points, faces)).find("Möbius"), std::string::npos);
}
