#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "Core/base/Error.h"
#include "Core/sampling/VolumeSampling.h"
#include "support/TestMeshes.h"

using namespace authalic;
using namespace authalic::testing;

namespace {

using Field = std::function<double(const Eigen::Vector3d&)>;

/// Voxels of side `spacing` centred on `origin` + spacing·(i, j, k).
VolumeOf<double> volumeOf(const Field& field, const Eigen::Vector3d& origin, int n, double spacing) {
  Eigen::Matrix4d affine = Eigen::Matrix4d::Identity();
  affine.topLeftCorner<3, 3>() *= spacing;
  affine.topRightCorner<3, 1>() = origin;
  VolumeOf<double> volume({n, n, n}, affine);
  for (int k = 0; k < n; ++k)
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i) volume.at(i, j, k) = field(volume.world(i, j, k));
  return volume;
}

/// Its faces look up (+z), so that inward is down.
TriangleMesh plateau(double z) {
  Points3 points = gridMesh(3, 3, 2.0, 2.0).points();
  points.col(2).setConstant(z);
  return TriangleMesh(points, gridMesh(3, 3).faces());
}

const Field kHeight = [](const Eigen::Vector3d& x) { return x[2]; };

VolumeSamplingOptions alongNormal(double to, double step, SamplingReducer reducer = SamplingReducer::Mean) {
  VolumeSamplingOptions options;
  options.mode = SamplingMode::AlongNormal;
  options.depthTo = to;
  options.depthStep = step;
  options.reducer = reducer;
  return options;
}

void expectAll(const std::vector<double>& values, double expected) {
  for (const double value : values) EXPECT_NEAR(value, expected, 1e-12);
}

}  // namespace

TEST(VolumeSampling, ReadsTheVolumeAtEachVertex) {
  const TriangleMesh mesh = gridMesh(4, 4, 5.0, 5.0);
  const auto volume = volumeOf([](const auto& x) { return x[0] + 10 * x[1]; }, {-1, -1, -1}, 8, 1.0);
  const VolumeSamples samples = sampleVolume(mesh, volume);
  EXPECT_EQ(samples.samplesPerVertex, 1);
  EXPECT_EQ(samples.verticesWithoutValue, 0);
  for (int v = 0; v < mesh.vertexCount(); ++v) {
    EXPECT_NEAR(samples.values[static_cast<std::size_t>(v)], mesh.point(v)[0] + 10 * mesh.point(v)[1], 1e-12);
    EXPECT_EQ(samples.coverage[static_cast<std::size_t>(v)], 1.0);
  }
}

TEST(VolumeSampling, ReducesTheProfileBelowThePlateau) {
  const auto volume = volumeOf(kHeight, {-1, -1, 0}, 20, 1.0);
  const TriangleMesh top = plateau(10);  // depths 0 … 4 read 10, 9, 8, 7, 6
  expectAll(sampleVolume(top, volume, alongNormal(4, 1)).values, 8);
  expectAll(sampleVolume(top, volume, alongNormal(4, 1, SamplingReducer::Median)).values, 8);
  expectAll(sampleVolume(top, volume, alongNormal(4, 1, SamplingReducer::Maximum)).values, 10);
  expectAll(sampleVolume(top, volume, alongNormal(4, 1, SamplingReducer::Minimum)).values, 6);
  expectAll(sampleVolume(top, volume, alongNormal(3, 1, SamplingReducer::Median)).values, 8.5);
}

TEST(VolumeSampling, GoesInwardWhichIsAgainstTheNormal) {
  const auto volume = volumeOf(kHeight, {-1, -1, 0}, 20, 1.0);
  const TriangleMesh top = plateau(10);
  Faces reversed = top.faces();
  reversed.col(1).swap(reversed.col(2));
  VolumeSamplingOptions options = alongNormal(3, 1);
  options.depthFrom = 3;
  expectAll(sampleVolume(top, volume, options).values, 7);
  expectAll(sampleVolume(TriangleMesh(top.points(), reversed), volume, options).values, 13);
  Points3 normals = Points3::Zero(top.vertexCount(), 3);
  normals.col(2).setConstant(-5.0);  // length does not matter
  expectAll(sampleVolume(top, normals, volume, options).values, 13);
}

TEST(VolumeSampling, CountsTheLastDepthOnceDespiteRounding) {
  const auto volume = volumeOf(kHeight, {-1, -1, 0}, 20, 1.0);
  EXPECT_EQ(sampleVolume(plateau(10), volume, alongNormal(1, 0.1)).samplesPerVertex, 11);
  EXPECT_EQ(sampleVolume(plateau(10), volume, alongNormal(1, 0.3)).samplesPerVertex, 4);
  EXPECT_EQ(sampleVolume(plateau(10), volume, alongNormal(0, 1)).samplesPerVertex, 1);
  EXPECT_EQ(
      sampleVolume(plateau(10), volume, VolumeSamplingOptions{SamplingMode::AlongNormal}).samplesPerVertex,
      11);
}

TEST(VolumeSampling, IsNotAvailableOutsideTheFieldAndNeverZero) {
  const auto volume = volumeOf([](const auto&) { return 4.0; }, {-1, -1, 6}, 10, 1.0);  // z from 6 to 15
  const VolumeSamples partly =
      sampleVolume(plateau(10), volume, alongNormal(10, 1));  // 10 … 6 inside, 5 … 0 not
  expectAll(partly.values, 4.0);
  expectAll(partly.coverage, 5.0 / 11.0);
  const VolumeSamples never = sampleVolume(plateau(30), volume, alongNormal(10, 1));
  EXPECT_EQ(never.verticesWithoutValue, 16);
  for (const double value : never.values) EXPECT_TRUE(std::isnan(value));
  expectAll(never.coverage, 0.0);
}

TEST(VolumeSampling, LeavesOutVoxelsWithoutData) {
  const auto volume =
      volumeOf([](const auto& x) { return x[2] < 7.5 ? std::nan("") : x[2]; }, {-1, -1, 0}, 20, 1.0);
  const VolumeSamples samples = sampleVolume(plateau(10), volume, alongNormal(4, 1));  // 10, 9, 8 remain
  expectAll(samples.values, 9);
  expectAll(samples.coverage, 0.6);
}

TEST(VolumeSampling, TakesTheMostFrequentLabel) {
  LabelVolume labels({4, 4, 20}, Eigen::Matrix4d::Identity());
  const int column[] = {9, 9, 9, 9, 9, 9, 0, 0, 0, 5, 5};  // z = 0 … 10
  for (int k = 0; k <= 10; ++k)
    for (int p = 0; p < 16; ++p) labels.at(p % 4, p / 4, k) = column[k];
  VolumeSamplingOptions options = alongNormal(5, 1, SamplingReducer::Mode);  // 5, 5, 0, 0, 0, 9
  options.interpolation = Interpolation::Nearest;
  expectAll(sampleVolume(plateau(10), labels, options).values, 0);
  options.skipZero = true;
  const VolumeSamples samples = sampleVolume(plateau(10), labels, options);
  expectAll(samples.values, 5);
  expectAll(samples.coverage, 0.5);
  options.depthTo = 6;  // 5, 5, 9, 9: a tie goes to the smallest
  expectAll(sampleVolume(plateau(10), labels, options).values, 5);
}

TEST(VolumeSampling, ReadsBetweenTwoSurfaces) {
  const auto volume = volumeOf(kHeight, {-1, -1, 0}, 20, 1.0);
  VolumeSamplingOptions options;
  options.mode = SamplingMode::BetweenSurfaces;
  expectAll(sampleVolumeBetween(plateau(4), plateau(8).points(), volume, options).values, 6);
  options.fractionFrom = options.fractionTo = 0.25;
  const VolumeSamples quarter = sampleVolumeBetween(plateau(4), plateau(8).points(), volume, options);
  EXPECT_EQ(quarter.samplesPerVertex, 1);
  expectAll(quarter.values, 5);
}

TEST(VolumeSampling, HasNoValueAlongTheNormalOfAVertexWithoutFaces) {
  Points3 points(4, 3);
  points << 0, 0, 5, 1, 0, 5, 0, 1, 5, 1, 1, 5;
  Faces faces(1, 3);
  faces << 0, 1, 2;
  const auto volume = volumeOf(kHeight, {-1, -1, 0}, 10, 1.0);
  const VolumeSamples samples = sampleVolume(TriangleMesh(points, faces), volume, alongNormal(2, 1));
  EXPECT_NEAR(samples.values[0], 4.0, 1e-12);
  EXPECT_TRUE(std::isnan(samples.values[3]));
  EXPECT_EQ(samples.coverage[3], 0.0);
  EXPECT_EQ(sampleVolume(TriangleMesh(points, faces), volume).values[3], 5.0) << "at the vertex it has one";
}

TEST(VolumeSampling, GivesTheSameBitsOnAnyNumberOfThreads) {
  const TriangleMesh ball = sphereMesh(6);
  const auto volume =
      volumeOf([](const auto& x) { return std::sin(5 * x[0]) + x[1] * x[2]; }, {-2, -2, -2}, 41, 0.1);
  const VolumeSamplingOptions options = alongNormal(0.7, 0.05);
  const VolumeSamples one = sampleVolume(ball, volume, options, Execution({}, {}, 1));
  const VolumeSamples four = sampleVolume(ball, volume, options, Execution({}, {}, 4));
  EXPECT_EQ(one.values, four.values);
  EXPECT_EQ(one.coverage, four.coverage);
}

TEST(VolumeSampling, RefusesBadRanges) {
  VolumeSamplingOptions options;
  options.depthStep = 0;
  EXPECT_THROW(options.validate(), InvalidArgument);
  options = {};
  options.depthFrom = 11;
  EXPECT_THROW(options.validate(), InvalidArgument);
  options = {};
  options.depthTo = std::nan("");
  EXPECT_THROW(options.validate(), InvalidArgument);
  options = {};
  options.fractionStep = -0.1;
  EXPECT_THROW(options.validate(), InvalidArgument);
  options = {};
  options.depthStep = 1e-6;
  EXPECT_THROW(options.validate(), InvalidArgument);
  EXPECT_NO_THROW(VolumeSamplingOptions{}.validate());
}

TEST(VolumeSampling, RefusesSurfacesThatDoNotMatch) {
  const auto volume = volumeOf(kHeight, {-1, -1, 0}, 20, 1.0);
  VolumeSamplingOptions options;
  options.mode = SamplingMode::BetweenSurfaces;
  EXPECT_THROW(static_cast<void>(sampleVolume(plateau(4), volume, options)), InvalidArgument);
  EXPECT_THROW(static_cast<void>(sampleVolumeBetween(plateau(4), gridMesh(5, 5).points(), volume, options)),
               GeometryError);
  Points3 broken = plateau(8).points();
  broken(3, 1) = std::nan("");
  EXPECT_THROW(static_cast<void>(sampleVolumeBetween(plateau(4), broken, volume, options)), GeometryError);
  EXPECT_THROW(static_cast<void>(sampleVolume(plateau(4), Points3(3, 3), volume, alongNormal(1, 1))),
               GeometryError);
}

TEST(VolumeSampling, StopsOnRequest) {
  const auto volume = volumeOf(kHeight, {-1, -1, 0}, 5, 1.0);
  const Execution stop({}, [] { return true; });
  EXPECT_THROW(static_cast<void>(sampleVolume(plateau(4), volume, {}, stop)), CancelledError);
}

TEST(VolumeSampling, NamesItsChoices) {
  EXPECT_STREQ(samplingModeName(SamplingMode::AlongNormal), "along-normal");
  EXPECT_STREQ(samplingReducerName(SamplingReducer::Median), "median");
  EXPECT_STREQ(interpolationName(Interpolation::Nearest), "nearest");
}

TEST(VertexNormals, PointOutwardOnASphereAndConverge) {
  double coarse = 0;
  for (const int levels : {2, 3, 4}) {
    const TriangleMesh ball = sphereMesh(levels);
    const Points3 normals = angleWeightedNormals(ball);
    const double error = (normals - ball.points()).rowwise().norm().maxCoeff();
    if (coarse > 0) {
      EXPECT_GT(coarse / error, 1.95);  // first order, as stars on the octahedron are not symmetric
    }
    coarse = error;
  }
  EXPECT_LT(coarse, 0.011);
}
