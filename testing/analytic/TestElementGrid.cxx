#include <gtest/gtest.h>

#include <cmath>

#include "Core/sampling/ElementGrid.h"
#include "support/TestMeshes.h"

using namespace authalic;
using namespace authalic::testing;

namespace {

Points2 flatImage(const TriangleMesh& mesh) {
  return mesh.points().leftCols<2>();
}

}  // namespace

TEST(ElementGrid, DividesAFlatSquareIntoExactlyEqualCells) {
  const TriangleMesh square = gridMesh(7, 13);
  const ElementGrid grid = elementGrid(square, flatImage(square), {100});
  ASSERT_EQ(grid.elements.size(), 100u);
  EXPECT_EQ(grid.lines.columns, 10);
  EXPECT_EQ(grid.lines.rows, 10);
  for (const Element& element : grid.elements) {
    EXPECT_NEAR(element.area, 0.01, 1e-15);
    EXPECT_NEAR(element.targetArea, 0.01, 1e-15);
    EXPECT_TRUE(element.interior);
    EXPECT_NEAR(element.centroid[0], (element.i + 0.5) / 10, 1e-14);
    EXPECT_NEAR(element.centroid[1], (element.j + 0.5) / 10, 1e-14);
  }
  EXPECT_EQ(grid.deviation.interiorElements, 100);
  EXPECT_LT(grid.deviation.interiorMaximum, 1e-12);
}

TEST(ElementGrid, DividesARectangleIntoNearlySquareCells) {
  const TriangleMesh rectangle = gridMesh(11, 9, 2.0, 1.0);
  const ElementGrid grid = elementGrid(rectangle, flatImage(rectangle), {200});
  EXPECT_EQ(grid.lines.columns, 20);
  EXPECT_EQ(grid.lines.rows, 10);
  EXPECT_EQ(grid.elements.size(), 200u);
  EXPECT_LT(grid.deviation.maximum, 1e-12);
}

TEST(ElementGrid, MeetsTheWantedNativeArea) {
  const TriangleMesh rectangle = gridMesh(8, 8, 40.0, 20.0);
  ElementGridOptions options;
  options.elementArea = 4.0;
  const ElementGrid grid = elementGrid(rectangle, flatImage(rectangle) / 40.0, options);
  EXPECT_EQ(grid.elements.size(), 200u);
  for (const Element& element : grid.elements) EXPECT_NEAR(element.area, 4.0, 1e-11);
}

TEST(ElementGrid, CutsADiskIntoCongruentInteriorCellsAndARim) {
  const TriangleMesh disk = diskMesh(40);
  const ElementGrid grid = elementGrid(disk, flatImage(disk), {300});
  EXPECT_EQ(grid.lines.lower[0], -1.0);
  EXPECT_EQ(grid.lines.upper[1], 1.0);
  EXPECT_EQ(grid.lines.columns, grid.lines.rows);
  EXPECT_NEAR(grid.imageArea / grid.lines.cellArea(), 300.0, 15.0);  // whole cells; the rim is in parts
  EXPECT_GT(grid.deviation.interiorElements, 200);
  EXPECT_LT(grid.deviation.maximum, 1e-11);
  for (const Element& element : grid.elements) {
    EXPECT_GE(element.imageArea, 0.25 * grid.lines.cellArea());
    const double corner = std::hypot(std::max(std::abs(element.lower[0]), std::abs(element.upper[0])),
                                     std::max(std::abs(element.lower[1]), std::abs(element.upper[1])));
    EXPECT_TRUE(!element.interior || corner < 1.0);
  }
}

/// Lambert's azimuthal equal-area map of a spherical cap: r = sin(θ/2) / sin(opening/2).
TEST(ElementGrid, ApproachesEqualAreasOnLambertsMapWithSecondOrder) {
  constexpr double kOpening = 1.5;
  double coarse = 0;
  for (const int rings : {20, 40, 80}) {
    const TriangleMesh cap = capMesh(rings, kOpening);
    Points2 image(cap.vertexCount(), 2);
    for (int v = 0; v < cap.vertexCount(); ++v) {
      const Eigen::Vector3d p = cap.point(v);
      const double rim = std::hypot(p[0], p[1]),
                   radius = std::sin(std::atan2(rim, p[2]) / 2) / std::sin(kOpening / 2);
      image.row(v) << (rim > 0 ? p[0] / rim * radius : 0), (rim > 0 ? p[1] / rim * radius : 0);
    }
    const ElementGrid grid = elementGrid(cap, image, {100});
    EXPECT_GT(grid.deviation.interiorElements, 60);
    if (coarse > 0) {
      EXPECT_GT(coarse / grid.deviation.interiorMean, 3.5) << rings;
    }
    coarse = grid.deviation.interiorMean;
  }
  EXPECT_LT(coarse, 1e-3);
}

TEST(ElementGrid, KeepsTheFrameOfASquareFromWhichAnEarBulges) {
  const TriangleMesh square = gridMesh(20, 20);
  Points2 image = flatImage(square);
  image(10, 1) = -0.004;          // on the lower side
  image(21 * 5, 0) = -0.002;      // on the left side
  image(21 * 20 + 7, 1) = 1.003;  // on the upper side
  const ElementGrid grid = elementGrid(square, image, {100});
  EXPECT_EQ(grid.lines.lower, (std::array<double, 2>{0, 0}));
  EXPECT_EQ(grid.lines.upper, (std::array<double, 2>{1, 1}));
  EXPECT_EQ(grid.deviation.interiorElements, 100);
  ElementGridOptions box{100};
  box.frame = GridFrame::BoundingBox;
  EXPECT_EQ(elementGrid(square, image, box).lines.lower[1], -0.004);
}

TEST(ElementGrid, DividesAThinStripIntoTheWantedNumber) {
  for (const bool upright : {false, true}) {
    const TriangleMesh strip = upright ? gridMesh(1, 100, 1.0, 1000.0) : gridMesh(100, 1, 1000.0, 1.0);
    const ElementGrid grid = elementGrid(strip, flatImage(strip), {4});
    EXPECT_EQ(grid.lines.columns, upright ? 1 : 4);
    EXPECT_EQ(grid.lines.rows, upright ? 4 : 1);
    EXPECT_LT(grid.deviation.interiorMaximum, 1e-11);
  }
}
