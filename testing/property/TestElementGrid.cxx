#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include "Core/base/Error.h"
#include "Core/sampling/ElementGrid.h"
#include "support/TestMeshes.h"

using namespace authalic;
using namespace authalic::testing;

namespace {

Points2 flatImage(const TriangleMesh& mesh) {
  return mesh.points().leftCols<2>();
}

/// A smooth bijection of the disk that is not area-preserving, plus noise below half an edge.
Points2 warpedImage(const TriangleMesh& mesh, double noise, unsigned seed) {
  std::mt19937 random(seed);
  Points2 image = flatImage(mesh);
  for (Eigen::Index v = 0; v < image.rows(); ++v) {
    const double radius = image.row(v).norm();
    if (radius > 1 - 1e-9) continue;
    image.row(v) *= 0.6 + 0.4 * radius;
    for (int k = 0; k < 2; ++k) image(v, k) += noise * (static_cast<double>(random()) / 4294967295.0 - 0.5);
  }
  return image;
}

double areaOf(const TriangleMesh& mesh, int f) {
  return 0.5 * (mesh.corner(f, 1) - mesh.corner(f, 0)).cross(mesh.corner(f, 2) - mesh.corner(f, 0)).norm();
}

void expectPartition(const TriangleMesh& mesh, const ElementGrid& grid) {
  std::vector<double> fractions(static_cast<std::size_t>(mesh.faceCount()), 0.0);
  for (const ElementOverlap& overlap : grid.overlaps) {
    fractions[static_cast<std::size_t>(overlap.face)] += overlap.fraction;
    EXPECT_GT(overlap.fraction, 0.0);
    EXPECT_NEAR(overlap.corner[0] + overlap.corner[1] + overlap.corner[2], 1.0, 1e-9);
  }
  for (const double fraction : fractions) EXPECT_NEAR(fraction, 1.0, 1e-12);
  double elements = 0, target = 0, surface = 0;
  for (const Element& element : grid.elements) {
    elements += element.area;
    target += element.targetArea;
  }
  for (int f = 0; f < mesh.faceCount(); ++f) surface += areaOf(mesh, f);
  EXPECT_NEAR(elements / surface, 1.0, 1e-12);
  EXPECT_NEAR(target / surface, 1.0, 1e-12);
  EXPECT_NEAR(grid.surfaceArea / surface, 1.0, 1e-12);
}

}  // namespace

TEST(ElementGrid, PartitionsEveryFaceOfRandomMaps) {
  for (unsigned seed = 1; seed <= 5; ++seed) {
    const TriangleMesh mesh = bumpyDisk(12 + static_cast<int>(seed));
    for (const int elements : {1, 7, 60, 3000}) {
      for (const double merge : {0.0, 0.25, 0.5}) {
        ElementGridOptions options{elements};
        options.mergeBelow = merge;
        expectPartition(mesh, elementGrid(mesh, warpedImage(mesh, 0.02, seed), options));
      }
    }
  }
}

TEST(ElementGrid, PartitionsFacesThatAreFlippedAndListsThem) {
  const TriangleMesh mesh = bumpyDisk(15);
  const Points2 image = warpedImage(mesh, 0.25, 3);
  const ElementGrid grid = elementGrid(mesh, image, {200});
  EXPECT_GT(grid.flippedFaces.size(), 10u);
  expectPartition(mesh, grid);
  for (const int f : grid.flippedFaces) {
    const Eigen::RowVector2d a = image.row(mesh.faces()(f, 1)) - image.row(mesh.faces()(f, 0));
    const Eigen::RowVector2d b = image.row(mesh.faces()(f, 2)) - image.row(mesh.faces()(f, 0));
    EXPECT_LE(a[0] * b[1] - a[1] * b[0], 0.0);
  }
}

TEST(ElementGrid, PartitionsFacesWhoseImageHasCollapsed) {
  const TriangleMesh mesh = gridMesh(6, 6);
  Points2 image = flatImage(mesh);
  for (Eigen::Index v = 0; v < image.rows(); ++v)
    image(v, 0) = std::max(image(v, 0), 1.0 / 3);  // two columns collapse
  const ElementGrid grid = elementGrid(mesh, image, {50});
  EXPECT_EQ(grid.zeroAreaFaces.size(), 24u);
  EXPECT_TRUE(grid.flippedFaces.empty());
  expectPartition(mesh, grid);
}

TEST(ElementGrid, CountsNoFlipsInAMirroredImage) {
  const TriangleMesh mesh = bumpyDisk(10);
  Points2 image = flatImage(mesh);
  image.col(0) *= -1.0;
  const ElementGrid grid = elementGrid(mesh, image, {100});
  EXPECT_TRUE(grid.flippedFaces.empty());
  EXPECT_GT(grid.deviation.interiorElements, 40);
  expectPartition(mesh, grid);
}

TEST(ElementGrid, AgreesWithAMonteCarloCount) {
  const TriangleMesh mesh = bumpyDisk(14);
  const Points2 image = warpedImage(mesh, 0.02, 9);
  ElementGridOptions options{40};
  options.mergeBelow = 0.0;
  const ElementGrid grid = elementGrid(mesh, image, options);
  std::vector<double> cumulative;
  double total = 0;
  for (int f = 0; f < mesh.faceCount(); ++f) cumulative.push_back(total += areaOf(mesh, f));
  std::mt19937_64 random(12);
  const auto uniform = [&] { return static_cast<double>(random() >> 11u) / 9007199254740992.0; };
  constexpr int kPoints = 400000;
  std::vector<int> hits(grid.elements.size(), 0);
  for (int p = 0; p < kPoints; ++p) {
    const int f = static_cast<int>(std::upper_bound(cumulative.begin(), cumulative.end(), uniform() * total) -
                                   cumulative.begin());
    const double r = std::sqrt(uniform()), s = uniform(), b[3] = {1 - r, r * (1 - s), r * s};
    Eigen::RowVector2d uv(0, 0);
    for (int k = 0; k < 3; ++k) uv += b[k] * image.row(mesh.faces()(f, k));
    const int cell = grid.lines.locate(0, uv[0]) + grid.lines.columns * grid.lines.locate(1, uv[1]);
    ++hits[static_cast<std::size_t>(grid.cellElement[static_cast<std::size_t>(cell)])];
  }
  for (std::size_t e = 0; e < hits.size(); ++e) {
    const double share = grid.elements[e].area / total;
    const double sigma = std::sqrt(share * (1 - share) / kPoints);
    EXPECT_NEAR(hits[e] / static_cast<double>(kPoints), share, 5 * sigma + 1e-9) << e;
  }
}

namespace {

/// Keeps the side sign·(x[axis] − line) ≥ 0 of a polygon.
std::vector<Eigen::Vector2d> clipped(const std::vector<Eigen::Vector2d>& polygon, int axis, double line,
                                     double sign) {
  std::vector<Eigen::Vector2d> result;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Eigen::Vector2d &here = polygon[k], &next = polygon[(k + 1) % polygon.size()];
    const double a = sign * (here[axis] - line), b = sign * (next[axis] - line);
    if (a >= 0) result.push_back(here);
    if (a * b < 0) result.push_back(here + a / (a - b) * (next - here));
  }
  return result;
}

double shoelace(const std::vector<Eigen::Vector2d>& polygon) {
  double sum = 0;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Eigen::Vector2d &here = polygon[k], &next = polygon[(k + 1) % polygon.size()];
    sum += here[0] * next[1] - here[1] * next[0];
  }
  return std::abs(sum) / 2;
}

}  // namespace

/// Each cell cuts each face on its own, in the plane, and areas are compared by the shoelace formula.
TEST(ElementGrid, AgreesWithClippingFaceByCellInThePlane) {
  const TriangleMesh mesh = bumpyDisk(9);
  const Points2 image = warpedImage(mesh, 0.02, 21);
  ElementGridOptions options{60};
  options.mergeBelow = 0.0;
  const ElementGrid grid = elementGrid(mesh, image, options);
  for (const Element& element : grid.elements) {
    double area = 0;
    for (int f = 0; f < mesh.faceCount(); ++f) {
      std::vector<Eigen::Vector2d> whole;
      for (int k = 0; k < 3; ++k) whole.emplace_back(image.row(mesh.faces()(f, k)).transpose());
      std::vector<Eigen::Vector2d> part = whole;
      for (int axis = 0; axis < 2; ++axis) {
        part = clipped(part, axis, element.lower[static_cast<std::size_t>(axis)], 1);
        part = clipped(part, axis, element.upper[static_cast<std::size_t>(axis)], -1);
      }
      area += areaOf(mesh, f) * shoelace(part) / shoelace(whole);
    }
    EXPECT_NEAR(element.area, area, 1e-12);
  }
}

TEST(ElementGrid, DoesNotDependOnTheOrderOfVerticesAndFaces) {
  const TriangleMesh mesh = bumpyDisk(13);
  const Points2 image = warpedImage(mesh, 0.02, 4);
  std::mt19937 random(5);
  std::vector<int> vertexOrder(static_cast<std::size_t>(mesh.vertexCount())),
      faceOrder(static_cast<std::size_t>(mesh.faceCount()));
  std::iota(vertexOrder.begin(), vertexOrder.end(), 0);
  std::iota(faceOrder.begin(), faceOrder.end(), 0);
  std::shuffle(vertexOrder.begin(), vertexOrder.end(), random);
  std::shuffle(faceOrder.begin(), faceOrder.end(), random);
  Points3 points(mesh.vertexCount(), 3);
  Points2 shuffledImage(mesh.vertexCount(), 2);
  Faces faces(mesh.faceCount(), 3);
  for (int v = 0; v < mesh.vertexCount(); ++v) {
    points.row(vertexOrder[static_cast<std::size_t>(v)]) = mesh.points().row(v);
    shuffledImage.row(vertexOrder[static_cast<std::size_t>(v)]) = image.row(v);
  }
  for (int f = 0; f < mesh.faceCount(); ++f) {
    for (int k = 0; k < 3; ++k) {
      faces(faceOrder[static_cast<std::size_t>(f)], k) =
          vertexOrder[static_cast<std::size_t>(mesh.faces()(f, (k + f) % 3))];
    }
  }
  const ElementGrid one = elementGrid(mesh, image, {150}),
                    two = elementGrid(TriangleMesh(points, faces), shuffledImage, {150});
  ASSERT_EQ(one.elements.size(), two.elements.size());
  for (std::size_t e = 0; e < one.elements.size(); ++e) {
    EXPECT_NEAR(one.elements[e].area, two.elements[e].area, 1e-13);
    EXPECT_LT((one.elements[e].centroid - two.elements[e].centroid).norm(), 1e-11);
    EXPECT_EQ(one.elements[e].interior, two.elements[e].interior);
  }
  int different = 0;
  for (int v = 0; v < mesh.vertexCount(); ++v) {
    different += one.vertexElement[static_cast<std::size_t>(v)] !=
                 two.vertexElement[static_cast<std::size_t>(vertexOrder[static_cast<std::size_t>(v)])];
  }
  EXPECT_LE(different, 2) << "but for exact ties";
}

TEST(ElementGrid, ScalesWithTheSurface) {
  const TriangleMesh mesh = bumpyDisk(10);
  const Points2 image = warpedImage(mesh, 0.02, 4);
  const ElementGrid one = elementGrid(mesh, image, {100}),
                    ten = elementGrid(TriangleMesh(10 * mesh.points(), mesh.faces()), image, {100});
  for (std::size_t e = 0; e < one.elements.size(); ++e)
    EXPECT_NEAR(ten.elements[e].area, 100 * one.elements[e].area, 1e-11);
  EXPECT_NEAR(one.deviation.interiorMaximum, ten.deviation.interiorMaximum, 1e-12);
}

TEST(ElementGrid, MergesSliversIntoCoveredNeighbours) {
  const TriangleMesh disk = diskMesh(30);
  for (const double merge : {0.0, 0.1, 0.25, 0.5}) {
    ElementGridOptions options{500};
    options.mergeBelow = merge;
    const ElementGrid grid = elementGrid(disk, flatImage(disk), options);
    for (const Element& element : grid.elements) {
      EXPECT_GE(element.imageArea, merge * grid.lines.cellArea() * (1 - 1e-12));
      EXPECT_LT(element.imageArea, (1 + 5 * merge) * grid.lines.cellArea() * (1 + 1e-12));
    }
  }
}

TEST(ElementGrid, AssignsDominantElementsByArea) {
  const TriangleMesh mesh = gridMesh(40, 40);
  const ElementGrid grid = elementGrid(mesh, flatImage(mesh), {25});
  for (int v = 0; v < mesh.vertexCount(); ++v) {
    const double x = mesh.point(v)[0] * 5, y = mesh.point(v)[1] * 5;
    if (std::abs(x - std::round(x)) < 0.1 || std::abs(y - std::round(y)) < 0.1) continue;  // near a line
    EXPECT_EQ(grid.vertexElement[static_cast<std::size_t>(v)], static_cast<int>(x) + 5 * static_cast<int>(y));
  }
  for (const int element : grid.faceElement) EXPECT_GE(element, 0);
}

TEST(ElementGrid, GivesVertexWeightsThatIntegrateLinearFieldsExactly) {
  const TriangleMesh mesh = gridMesh(9, 11);
  const ElementGrid grid = elementGrid(mesh, flatImage(mesh), {49});
  for (int e = 0; e < static_cast<int>(grid.elements.size()); ++e) {
    double area = 0, integral = 0;
    for (const VertexWeight& weight : vertexWeights(mesh, grid, e)) {
      area += weight.area;
      integral += weight.area * (2 + 3 * mesh.point(weight.vertex)[0] - mesh.point(weight.vertex)[1]);
    }
    const Element& element = grid.elements[static_cast<std::size_t>(e)];
    EXPECT_NEAR(area, element.area, 1e-15);
    EXPECT_NEAR(integral / area, 2 + 3 * (element.i + 0.5) / 7 - (element.j + 0.5) / 7, 1e-12);
  }
}

TEST(ElementOutline, DrawsEveryInnerLineOnce) {
  for (const int n : {7, 10, 20}) {  // lines through faces, on edges of the mesh, and both
    const TriangleMesh mesh = gridMesh(n, n);
    const ElementGrid grid = elementGrid(mesh, flatImage(mesh), {100});
    const ElementOutline outline = elementOutline(mesh, flatImage(mesh), grid);
    double length = 0;
    for (Eigen::Index s = 0; s < outline.points.rows(); s += 2) {
      length += (outline.points.row(s) - outline.points.row(s + 1)).norm();
      const Eigen::RowVector2d middle = 5 * (outline.image.row(s) + outline.image.row(s + 1));  // in cells
      EXPECT_LT(
          std::min(std::abs(middle[0] - std::round(middle[0])), std::abs(middle[1] - std::round(middle[1]))),
          1e-12);
    }
    EXPECT_NEAR(length, 2 * 9, 1e-11) << n;
    EXPECT_EQ(static_cast<Eigen::Index>(2 * outline.face.size()), outline.points.rows());
  }
}

TEST(ElementOutline, LiesInItsFacesAndSeparatesItsElements) {
  const TriangleMesh mesh = bumpyDisk(12);
  const Points2 image = warpedImage(mesh, 0.02, 6);
  const ElementGrid grid = elementGrid(mesh, image, {120});
  const ElementOutline outline = elementOutline(mesh, image, grid);
  ASSERT_GT(outline.face.size(), 300u);
  for (std::size_t s = 0; s < outline.face.size(); ++s) {
    const int f = outline.face[s];
    const Eigen::Vector3d normal =
        (mesh.corner(f, 1) - mesh.corner(f, 0)).cross(mesh.corner(f, 2) - mesh.corner(f, 0)).normalized();
    for (int end = 0; end < 2; ++end) {
      const Eigen::Vector3d p = outline.points.row(2 * static_cast<Eigen::Index>(s) + end).transpose();
      EXPECT_NEAR(normal.dot(p - mesh.corner(f, 0)), 0.0, 1e-12);
    }
    EXPECT_NE(outline.elements[s][0], outline.elements[s][1]);
  }
}

TEST(ElementGrid, RefusesImagesThatDoNotFit) {
  const TriangleMesh mesh = gridMesh(4, 4);
  EXPECT_THROW(static_cast<void>(elementGrid(mesh, Points2::Zero(3, 2))), GeometryError);
  EXPECT_THROW(static_cast<void>(elementGrid(mesh, Points2::Zero(25, 2))), GeometryError);
  Points2 broken = flatImage(mesh);
  broken(7, 1) = std::nan("");
  EXPECT_THROW(static_cast<void>(elementGrid(mesh, broken)), GeometryError);
  Points2 line = flatImage(mesh);
  line.col(1).setZero();
  EXPECT_THROW(static_cast<void>(elementGrid(mesh, line)), GeometryError);
  ElementGridOptions disk;
  disk.frame = GridFrame::UnitDisk;
  EXPECT_THROW(static_cast<void>(elementGrid(mesh, 3 * flatImage(mesh), disk)), GeometryError);
}

TEST(ElementGrid, RefusesBadOptions) {
  ElementGridOptions options;
  options.elements = 0;
  EXPECT_THROW(options.validate(), InvalidArgument);
  options.elementArea = 3.0;  // decides, so the number no longer matters
  EXPECT_NO_THROW(options.validate());
  options.elementArea = -1.0;
  EXPECT_THROW(options.validate(), InvalidArgument);
  options = {};
  options.mergeBelow = 0.6;
  EXPECT_THROW(options.validate(), InvalidArgument);
  const TriangleMesh mesh = gridMesh(4, 4);
  EXPECT_THROW(static_cast<void>(elementGrid(mesh, flatImage(mesh), {100000000})), InvalidArgument);
}

TEST(ElementGrid, StopsOnRequest) {
  const TriangleMesh mesh = gridMesh(4, 4);
  EXPECT_THROW(static_cast<void>(elementGrid(mesh, flatImage(mesh), {}, Execution({}, [] { return true; }))),
               CancelledError);
}
