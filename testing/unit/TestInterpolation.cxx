#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>

#include "Core/base/Error.h"
#include "Core/imaging/Interpolation.h"

using namespace authalic;

namespace {

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

Eigen::Matrix4d oblique() {
  Eigen::Matrix4d affine = Eigen::Matrix4d::Identity();
  const Eigen::Matrix3d turn =
      (Eigen::AngleAxisd(0.3, Eigen::Vector3d(1, 2, 3).normalized())).toRotationMatrix();
  affine.topLeftCorner<3, 3>() = turn * Eigen::Vector3d(-1.5, 0.7, 2.0).asDiagonal();
  affine.topRightCorner<3, 1>() << 11, -7, 3;
  return affine;
}

template <class F>
VolumeOf<double> filled(const std::array<int, 3>& size, const Eigen::Matrix4d& affine, const F& f) {
  VolumeOf<double> volume(size, affine);
  for (int k = 0; k < size[2]; ++k)
    for (int j = 0; j < size[1]; ++j)
      for (int i = 0; i < size[0]; ++i)
        volume.at(i, j, k) = f(volume.world(i, j, k), Eigen::Vector3d(i, j, k));
  return volume;
}

}  // namespace

TEST(Interpolation, ReproducesALinearFieldInAnObliqueVolume) {
  const auto field = [](const Eigen::Vector3d& x) { return 3 - 2 * x[0] + 0.5 * x[1] + 7 * x[2]; };
  const auto volume = filled({6, 5, 4}, oblique(), [&](const auto& x, const auto&) { return field(x); });
  const Interpolator<double> valueAt(volume);
  for (int k = 0; k < 50; ++k) {
    const Eigen::Vector3d x =
        volume.world(5 * ((k * 7) % 50) / 50.0, 4 * ((k * 11) % 50) / 50.0, 3 * k / 50.0);
    ASSERT_TRUE(valueAt(x).has_value());
    EXPECT_NEAR(*valueAt(x), field(x), 1e-11);
  }
}

TEST(Interpolation, ReproducesTheProductOfCoordinates) {
  const auto product = [](const auto&, const Eigen::Vector3d& c) { return c[0] * c[1] * c[2]; };
  const auto volume = filled({4, 4, 4}, Eigen::Matrix4d::Identity(), product);
  EXPECT_NEAR(*Interpolator<double>(volume)({1.25, 2.5, 0.75}), 1.25 * 2.5 * 0.75, 1e-13);
}

TEST(Interpolation, ConvergesWithSecondOrderForASmoothField) {
  double coarse = 0;
  for (const int n : {9, 17, 33}) {
    Eigen::Matrix4d affine = Eigen::Matrix4d::Identity();
    affine.topLeftCorner<3, 3>() *= 1.0 / (n - 1);
    const auto smooth = [](const Eigen::Vector3d& x) { return std::sin(2 * x[0] + x[1]) * std::exp(x[2]); };
    const auto volume = filled({n, n, n}, affine, [&](const auto& x, const auto&) { return smooth(x); });
    const Interpolator<double> valueAt(volume);
    double error = 0;
    for (int k = 0; k < 1000; ++k) {
      const Eigen::Vector3d x(std::fmod(k * 0.618, 1.0), std::fmod(k * 0.414, 1.0),
                              std::fmod(k * 0.732, 1.0));
      error = std::max(error, std::abs(*valueAt(x) - smooth(x)));
    }
    if (coarse > 0) {
      EXPECT_NEAR(coarse / error, 4.0, 0.8) << n;
    }
    coarse = error;
  }
}

TEST(Interpolation, EndsAtTheOutermostVoxelCentres) {
  const VolumeOf<double> volume({3, 3, 3}, oblique(), 5.0);
  const Interpolator<double> valueAt(volume);
  EXPECT_EQ(valueAt(volume.world(0, 0, 0)), std::optional<double>(5.0));
  EXPECT_EQ(valueAt(volume.world(2, 2, 2)), std::optional<double>(5.0));
  EXPECT_EQ(valueAt(volume.world(2 + 1e-7, 1, 1)), std::optional<double>(5.0));
  for (int axis = 0; axis < 3; ++axis) {
    Eigen::Vector3d low(1, 1, 1), high(1, 1, 1);
    low[axis] = -1e-4;
    high[axis] = 2 + 1e-4;
    EXPECT_FALSE(valueAt(volume.world(low[0], low[1], low[2])).has_value());
    EXPECT_FALSE(valueAt(volume.world(high[0], high[1], high[2])).has_value());
  }
}

TEST(Interpolation, HasNoValueAtPointsThatAreNotFinite) {
  const VolumeOf<double> volume({3, 3, 3}, Eigen::Matrix4d::Identity(), 5.0);
  for (const Interpolation kind : {Interpolation::Trilinear, Interpolation::Nearest}) {
    const Interpolator<double> valueAt(volume, kind);
    EXPECT_FALSE(valueAt({kNaN, 1, 1}).has_value());
    EXPECT_FALSE(valueAt({1, std::numeric_limits<double>::infinity(), 1}).has_value());
  }
}

TEST(Interpolation, IsNotAvailableBesideAVoxelWithoutData) {
  ScalarVolume volume({3, 3, 3}, Eigen::Matrix4d::Identity(), 1.0F);
  volume.at(2, 1, 1) = kNaN;
  const Interpolator<float> valueAt(volume);
  EXPECT_FALSE(valueAt({1.5, 1, 1}).has_value());
  EXPECT_FALSE(valueAt({1.01, 0.5, 1.9}).has_value());
  EXPECT_EQ(valueAt({1, 1, 1}), std::optional<double>(1.0)) << "a corner without weight does not matter";
  EXPECT_EQ(valueAt({0.5, 1, 1}), std::optional<double>(1.0));
  EXPECT_FALSE(Interpolator<float>(volume, Interpolation::Nearest)({1.6, 1, 1}).has_value());
}

TEST(Interpolation, TakesTheHigherVoxelOnATieOfTheNearest) {
  const auto number = [](const auto&, const Eigen::Vector3d& c) { return c[0] + 10 * c[1] + 100 * c[2]; };
  const auto volume = filled({4, 4, 4}, Eigen::Matrix4d::Identity(), number);
  const Interpolator<double> valueAt(volume, Interpolation::Nearest);
  EXPECT_EQ(valueAt({0.5, 1.5, 2.5}), std::optional<double>(321.0));
  EXPECT_EQ(valueAt({0.499, 1.499, 2.499}), std::optional<double>(210.0));
}

TEST(Interpolation, ReachesHalfAVoxelBeyondTheCentresWhenNearest) {
  const LabelVolume volume({2, 2, 2}, Eigen::Matrix4d::Identity(), 7);
  const Interpolator<std::int32_t> valueAt(volume, Interpolation::Nearest);
  EXPECT_EQ(valueAt({-0.5, 0, 0}), std::optional<double>(7.0));
  EXPECT_EQ(valueAt({1.4999, 0, 0}), std::optional<double>(7.0));
  EXPECT_FALSE(valueAt({1.5, 0, 0}).has_value());
  EXPECT_FALSE(valueAt({0, -0.5001, 0}).has_value());
}

TEST(Interpolation, ReadsASingleSlice) {
  const VolumeOf<double> volume({3, 3, 1}, Eigen::Matrix4d::Identity(), 2.0);
  const Interpolator<double> valueAt(volume);
  EXPECT_EQ(valueAt({1.5, 0.5, 0}), std::optional<double>(2.0));
  EXPECT_FALSE(valueAt({1.5, 0.5, 0.1}).has_value());
}

TEST(Interpolation, RefusesASingularMatrixAndMissingVoxels) {
  VolumeOf<double> volume({2, 2, 2}, Eigen::Matrix4d::Zero());
  EXPECT_THROW(Interpolator<double>{volume}, InvalidArgument);
  volume.voxelToWorld = Eigen::Matrix4d::Identity();
  volume.voxelToWorld(0, 3) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(Interpolator<double>{volume}, InvalidArgument);
  volume.voxelToWorld = Eigen::Matrix4d::Identity();
  volume.values.pop_back();
  EXPECT_THROW(Interpolator<double>{volume}, InvalidArgument);
  EXPECT_THROW(Interpolator<double>{VolumeOf<double>()}, InvalidArgument);
}
