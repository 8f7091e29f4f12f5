#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "Core/base/Error.h"
#include "Core/statistics/ElementTable.h"
#include "Core/statistics/WeightedStatistics.h"
#include "support/TestMeshes.h"

using namespace authalic;
using namespace authalic::testing;

namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

Points2 flatImage(const TriangleMesh& mesh) {
  return mesh.points().leftCols<2>();
}

template <class F>
SurfaceField fieldOf(const TriangleMesh& mesh, const char* name, const F& value) {
  SurfaceField field{name, {}, {}, "mm", ""};
  for (int v = 0; v < mesh.vertexCount(); ++v) field.values.push_back(value(mesh.point(v)));
  return field;
}

}  // namespace

TEST(WeightedStatistics, AreTheOrdinaryOnesForEqualWeights) {
  const WeightedStatistics s = weightedStatistics({{4, 2}, {1, 2}, {3, 2}, {2, 2}});
  EXPECT_EQ(s.n, 4);
  EXPECT_DOUBLE_EQ(s.mean, 2.5);
  EXPECT_DOUBLE_EQ(s.median, 2.5);
  EXPECT_DOUBLE_EQ(s.sd, std::sqrt(1.25));
  EXPECT_EQ(s.minimum, 1);
  EXPECT_EQ(s.maximum, 4);
  EXPECT_DOUBLE_EQ(weightedStatistics({{4, 1}, {1, 1}, {3, 1}}).median, 3);
}

TEST(WeightedStatistics, TreatAWeightAsARepetition) {
  std::mt19937 random(2);
  for (int trial = 0; trial < 50; ++trial) {
    std::vector<WeightedValue> weighted, repeated;
    for (int k = 0; k < 8; ++k) {
      const double value = static_cast<double>(random() % 20);
      const int times = 1 + static_cast<int>(random() % 5);
      weighted.push_back({value, static_cast<double>(times)});
      repeated.insert(repeated.end(), static_cast<std::size_t>(times), {value, 1.0});
    }
    const WeightedStatistics a = weightedStatistics(weighted), b = weightedStatistics(repeated);
    EXPECT_NEAR(a.mean, b.mean, 1e-12);
    EXPECT_NEAR(a.sd, b.sd, 1e-12);
    EXPECT_EQ(a.median, b.median);
  }
}

TEST(WeightedStatistics, PutTheMedianWhereHalfTheWeightIsReached) {
  EXPECT_EQ(weightedStatistics({{1, 1}, {2, 10}, {3, 1}}).median, 2);
  EXPECT_EQ(weightedStatistics({{1, 7}, {2, 1}, {3, 1}}).median, 1);
  EXPECT_EQ(weightedStatistics({{1, 3}, {2, 1}, {5, 2}}).median, 1.5) << "exactly half lies at or below 1";
  EXPECT_EQ(weightedStatistics({{1, 0.1}, {2, 0.2}, {5, 0.3}}).median, 3.5)
      << "despite rounding of 0.1 + 0.2";
}

TEST(WeightedStatistics, LeaveOutValuesThatAreNotAvailable) {
  const WeightedStatistics s = weightedStatistics({{kNaN, 5}, {2, 1}, {9, 0}, {7, -1}, {4, 1}});
  EXPECT_EQ(s.n, 2);
  EXPECT_EQ(s.mean, 3);
  EXPECT_EQ(s.maximum, 4);
  const WeightedStatistics none = weightedStatistics({{kNaN, 1}});
  EXPECT_EQ(none.n, 0);
  for (const double x : {none.mean, none.sd, none.median, none.minimum, none.maximum})
    EXPECT_TRUE(std::isnan(x));
}

TEST(WeightedStatistics, GiveOneValueNoSpread) {
  const WeightedStatistics s = weightedStatistics({{0.1, 0.3}, {0.1, 0.7}, {0.1, 1e-9}});
  EXPECT_EQ(s.mean, 0.1);
  EXPECT_EQ(s.sd, 0.0);
  EXPECT_EQ(s.median, 0.1);
}

TEST(ElementTable, HasTheExactMeanOfALinearField) {
  const TriangleMesh mesh = gridMesh(13, 9);
  const ElementGrid grid = elementGrid(mesh, flatImage(mesh), {64});
  const ElementTable table =
      elementTable(mesh, grid, {fieldOf(mesh, "x", [](const auto& p) { return p[0] - 4 * p[1]; })});
  ASSERT_EQ(table.rows.size(), 64u);
  for (const ElementRow& row : table.rows) {
    EXPECT_NEAR(row.fields[0].mean, (row.i + 0.5) / 8 - 4 * (row.j + 0.5) / 8, 1e-12);
    EXPECT_NEAR(row.area, 1.0 / 64, 1e-14);
    EXPECT_NEAR(row.areaRatio, 1.0, 1e-12);
    EXPECT_NEAR(row.uMax - row.uMin, 1.0 / 8, 1e-14);
    EXPECT_EQ(row.fields[0].coverage, 1.0);
    EXPECT_EQ(row.fields[0].n, row.vertices);
    EXPECT_LE(row.fields[0].minimum, row.fields[0].median);
    EXPECT_LE(row.fields[0].median, row.fields[0].maximum);
  }
  EXPECT_EQ(table.rows.front().id, 1);
}

TEST(ElementTable, KeepsConstantFieldsConstant) {
  const TriangleMesh mesh = bumpyDisk(14);
  const ElementGrid grid = elementGrid(mesh, flatImage(mesh), {90});
  const ElementTable table = elementTable(mesh, grid, {fieldOf(mesh, "c", [](const auto&) { return 0.7; })});
  for (const ElementRow& row : table.rows) {
    EXPECT_EQ(row.fields[0].mean, 0.7);
    EXPECT_EQ(row.fields[0].sd, 0.0);
    EXPECT_EQ(row.fields[0].median, 0.7);
  }
}

TEST(ElementTable, AddsUpToTheWholeSurface) {
  const TriangleMesh mesh = bumpyDisk(17);
  const SurfaceField field = fieldOf(mesh, "wave", [](const auto& p) { return std::sin(4 * p[0]) + p[2]; });
  const ElementTable table = elementTable(mesh, elementGrid(mesh, flatImage(mesh), {70}), {field});
  const SurfaceLabels all{std::vector<int>(static_cast<std::size_t>(mesh.vertexCount()), 1), {{1, "all"}}};
  const RegionRow whole = regionTable(mesh, all, {field}).rows.at(0);
  double area = 0, sum = 0, squares = 0;
  for (const ElementRow& row : table.rows) {
    area += row.area;
    sum += row.area * row.fields[0].mean;
    squares += row.area * (row.fields[0].sd * row.fields[0].sd + row.fields[0].mean * row.fields[0].mean);
  }
  EXPECT_NEAR(area, whole.area, 1e-12);
  EXPECT_NEAR(sum / area, whole.fields[0].mean, 1e-12);
  EXPECT_NEAR(std::sqrt(squares / area - sum / area * sum / area), whole.fields[0].sd, 1e-11);
  EXPECT_NEAR(whole.fraction, 1.0, 1e-12);
}

TEST(ElementTable, LeavesOutVerticesWithoutValueAndLowersTheCoverage) {
  const TriangleMesh mesh = gridMesh(20, 20);
  const ElementGrid grid = elementGrid(mesh, flatImage(mesh), {4});
  SurfaceField half = fieldOf(mesh, "half", [](const auto& p) { return p[0] < 0.5 - 1e-9 ? kNaN : 3.0; });
  const ElementTable table = elementTable(mesh, grid, {half});
  EXPECT_LT(table.rows[0].fields[0].coverage, 0.06) << "only the vertices on the border";
  EXPECT_EQ(table.rows[0].fields[0].mean, 3.0);
  EXPECT_NEAR(table.rows[1].fields[0].coverage, 1.0, 1e-12);
  EXPECT_LT(table.rows[0].fields[0].n, table.rows[0].vertices);
  half.values.assign(half.values.size(), kNaN);
  const FieldStatistics none = elementTable(mesh, grid, {half}).rows[2].fields[0];
  EXPECT_EQ(none.n, 0);
  EXPECT_EQ(none.coverage, 0.0);
  EXPECT_TRUE(std::isnan(none.mean));
}

TEST(ElementTable, AveragesTheCoverageOfSamples) {
  const TriangleMesh mesh = gridMesh(8, 8);
  SurfaceField field = fieldOf(mesh, "pet", [](const auto&) { return 1.0; });
  field.coverage.assign(field.values.size(), 0.25);
  const ElementGrid grid = elementGrid(mesh, flatImage(mesh), {16});
  for (const ElementRow& row : elementTable(mesh, grid, {field}).rows)
    EXPECT_NEAR(row.fields[0].coverage, 0.25, 1e-12);
}

TEST(ElementTable, NamesTheLabelWithTheLargestArea) {
  const TriangleMesh mesh = gridMesh(60, 60);
  SurfaceLabels labels{{}, {{7, "left"}, {3, "right"}}};
  for (int v = 0; v < mesh.vertexCount(); ++v)
    labels.labels.push_back(mesh.point(v)[0] < 0.4 ? 7 : mesh.point(v)[0] < 0.8 ? 3 : 99);
  const ElementTable table = elementTable(mesh, elementGrid(mesh, flatImage(mesh), {4}), {}, labels);
  EXPECT_EQ(table.regions[static_cast<std::size_t>(table.rows[0].majority)].name, "left");
  EXPECT_NEAR(table.rows[0].majorityFraction, 0.8, 0.02);
  EXPECT_EQ(table.regions[static_cast<std::size_t>(table.rows[1].majority)].name, "right");
  EXPECT_NEAR(table.rows[1].majorityFraction, 0.6, 0.02) << "the unlabelled rest counts in the area";
}

TEST(ElementTable, HasNoMajorityWithoutNamedLabels) {
  const TriangleMesh mesh = gridMesh(6, 6);
  const ElementGrid grid = elementGrid(mesh, flatImage(mesh), {4});
  EXPECT_EQ(elementTable(mesh, grid, {}).rows[0].majority, -1);
  EXPECT_TRUE(std::isnan(elementTable(mesh, grid, {}).rows[0].majorityFraction));
  const SurfaceLabels unnamed{std::vector<int>(49, 5), {{1, "one"}}};
  EXPECT_EQ(elementTable(mesh, grid, {}, unnamed).rows[0].majority, -1);
  EXPECT_EQ(elementTable(mesh, grid, {}, unnamed).rows[0].majorityFraction, 0.0);
}

TEST(RegionTable, SplitsTheSurfaceByTheLabelsOfVertices) {
  const TriangleMesh mesh = gridMesh(10, 10, 10.0, 10.0);
  SurfaceLabels labels{{}, {{1, "west"}, {2, "east"}, {3, "nowhere"}}};
  for (int v = 0; v < mesh.vertexCount(); ++v) labels.labels.push_back(mesh.point(v)[0] < 4.5 ? 1 : 2);
  const RegionTable table =
      regionTable(mesh, labels, {fieldOf(mesh, "x", [](const auto& p) { return p[0]; })});
  ASSERT_EQ(table.rows.size(), 3u);
  EXPECT_NEAR(table.rows[0].area, 45.0, 1e-11);
  EXPECT_NEAR(table.rows[1].area, 55.0, 1e-11);
  EXPECT_EQ(table.rows[0].vertices, 55);
  EXPECT_NEAR(table.rows[0].fields[0].mean, table.rows[0].centroid[0], 1e-12);
  EXPECT_NEAR(table.rows[0].fields[0].mean, (0 * 0.5 + 1 + 2 + 3 + 4) / 4.5, 1e-12);
  EXPECT_EQ(table.rows[2].area, 0.0);
  EXPECT_EQ(table.rows[2].fields[0].n, 0);
  EXPECT_TRUE(std::isnan(table.rows[2].centroid[0]));
}

TEST(ElementTable, DoesNotDependOnTheDensityOfTheMesh) {
  const TriangleMesh coarse = gridMesh(6, 6), fine = gridMesh(36, 36);
  const auto plane = [](const Eigen::Vector3d& p) { return 1 + p[0] + 2 * p[1]; };
  const ElementTable a =
      elementTable(coarse, elementGrid(coarse, flatImage(coarse), {25}), {fieldOf(coarse, "f", plane)});
  const ElementTable b =
      elementTable(fine, elementGrid(fine, flatImage(fine), {25}), {fieldOf(fine, "f", plane)});
  for (std::size_t e = 0; e < 25; ++e) EXPECT_NEAR(a.rows[e].fields[0].mean, b.rows[e].fields[0].mean, 1e-12);
}

TEST(ElementTable, RefusesDataOfAnotherSurface) {
  const TriangleMesh mesh = gridMesh(6, 6), other = gridMesh(7, 6);
  const ElementGrid grid = elementGrid(mesh, flatImage(mesh), {4});
  const SurfaceField field = fieldOf(mesh, "f", [](const auto& p) { return p[0]; });
  EXPECT_THROW(static_cast<void>(elementTable(other, grid, {})), GeometryError);
  EXPECT_THROW(
      static_cast<void>(elementTable(mesh, grid, {fieldOf(other, "f", [](const auto&) { return 0.0; })})),
      GeometryError);
  EXPECT_THROW(static_cast<void>(elementTable(mesh, grid, {field, field})), InvalidArgument);
  SurfaceField wrongCoverage = field;
  wrongCoverage.coverage = {1.0};
  EXPECT_THROW(static_cast<void>(elementTable(mesh, grid, {wrongCoverage})), GeometryError);
  wrongCoverage.coverage.assign(field.values.size(), 1.5);
  EXPECT_THROW(static_cast<void>(elementTable(mesh, grid, {wrongCoverage})), InvalidArgument);
  EXPECT_THROW(static_cast<void>(elementTable(mesh, grid, {}, {{1, 2}, {}})), GeometryError);
  EXPECT_THROW(static_cast<void>(regionTable(mesh, {std::vector<int>(49, 1), {{1, "a"}, {1, "b"}}}, {})),
               InvalidArgument);
}
