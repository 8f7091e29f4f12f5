#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <random>

#include "Core/base/Error.h"
#include "Core/imaging/HomotopicGrowing.h"
#include "Core/imaging/IntensityClasses.h"
#include "Core/imaging/SurfaceLabels.h"
#include "Core/imaging/VolumeFilters.h"
#include "support/TestMeshes.h"

using namespace authalic;
using namespace authalic::testing;

namespace {

MaskVolume emptyMask(int n) {
  return MaskVolume({n, n, n}, Eigen::Matrix4d::Identity(), 0);
}

void fillBox(MaskVolume& mask, int low, int high, std::uint8_t value) {
  for (int k = low; k < high; ++k) {
    for (int j = low; j < high; ++j) {
      for (int i = low; i < high; ++i) mask.at(i, j, k) = value;
    }
  }
}

}  // namespace

TEST(SegmentationVolumes, DistanceEqualsBruteForceOnAnAnisotropicLattice) {
  std::mt19937 random(3);
  Eigen::Matrix4d affine = Eigen::Matrix4d::Identity();
  affine.diagonal().head<3>() << 0.5, 1.25, 2.0;
  MaskVolume mask({23, 9, 11}, affine, 0);
  for (auto& m : mask.values) m = random() % 60 == 0;
  const ScalarVolume distance = distanceTo(mask);
  for (int k = 0; k < 11; ++k) {
    for (int j = 0; j < 9; ++j) {
      for (int i = 0; i < 23; ++i) {
        double nearest = std::numeric_limits<double>::infinity();
        for (int w = 0; w < 11; ++w) {
          for (int v = 0; v < 9; ++v) {
            for (int u = 0; u < 23; ++u) {
              if (mask.at(u, v, w))
                nearest = std::min(nearest, (mask.world(i, j, k) - mask.world(u, v, w)).norm());
            }
          }
        }
        ASSERT_NEAR(distance.at(i, j, k), nearest, 1e-5);
      }
    }
  }
}

TEST(SegmentationVolumes, DistanceToNothingIsInfinite) {
  for (const float d : distanceTo(emptyMask(5)).values) EXPECT_TRUE(std::isinf(d));
}

TEST(SegmentationVolumes, BlurKeepsConstantsAndTheSecondMomentOfAPoint) {
  ScalarVolume constant({9, 9, 9}, Eigen::Matrix4d::Identity(), 3.0f);
  for (const float value : gaussianBlur(constant, 2).values) EXPECT_NEAR(value, 3, 1e-5);
  ScalarVolume point({31, 31, 31}, Eigen::Matrix4d::Identity(), 0.0f);
  point.at(15, 15, 15) = 1;
  const ScalarVolume blurred = gaussianBlur(point, 2);
  double sum = 0, moment = 0;
  for (int k = 0; k < 31; ++k) {
    for (int j = 0; j < 31; ++j) {
      for (int i = 0; i < 31; ++i) {
        sum += blurred.at(i, j, k);
        moment += blurred.at(i, j, k) * (i - 15) * (i - 15);
      }
    }
  }
  EXPECT_NEAR(sum, 1, 1e-5);
  EXPECT_NEAR(moment, 4, 0.15);  // cut at 3 sigma
}

TEST(SegmentationVolumes, FillsCavitiesButNotBays) {
  MaskVolume mask = emptyMask(12);
  fillBox(mask, 2, 10, 1);
  fillBox(mask, 4, 7, 0);
  MaskVolume bay = mask;
  bay.at(5, 5, 3) = bay.at(5, 5, 2) = 0;
  EXPECT_EQ(fillCavities(mask), 27u);
  EXPECT_EQ(mask.at(5, 5, 5), 1);
  EXPECT_EQ(fillCavities(bay), 0u);
}

TEST(SegmentationVolumes, KeepsTheLargestComponent) {
  MaskVolume mask = emptyMask(14);
  fillBox(mask, 1, 4, 1);
  fillBox(mask, 6, 11, 1);
  EXPECT_EQ(keepLargestComponent(mask), 27u);
  EXPECT_EQ(mask.at(2, 2, 2), 0);
  EXPECT_EQ(mask.at(8, 8, 8), 1);
  MaskVolume none = emptyMask(5);
  EXPECT_EQ(keepLargestComponent(none), 0u);
}

TEST(SegmentationVolumes, FloodsMeetInTheValleyBetweenTheirMarkers) {
  MaskVolume markers({21, 5, 5}, Eigen::Matrix4d::Identity(), 0);
  VolumeOf<std::int16_t> priority({21, 5, 5}, Eigen::Matrix4d::Identity(), 0);
  for (int i = 1; i < 20; ++i) priority.at(i, 2, 2) = static_cast<std::int16_t>(1 + std::abs(i - 13));
  markers.at(1, 2, 2) = 1;
  markers.at(19, 2, 2) = 2;
  const MaskVolume regions = floodFromMarkers(markers, priority);
  for (int i = 1; i < 13; ++i) EXPECT_EQ(regions.at(i, 2, 2), 1) << i;
  for (int i = 14; i < 20; ++i) EXPECT_EQ(regions.at(i, 2, 2), 2) << i;
  EXPECT_EQ(regions.at(10, 1, 2), 0);
}

TEST(SegmentationVolumes, CropMovesTheAffineAlongAndPads) {
  ScalarVolume volume({4, 4, 4}, Eigen::Matrix4d::Identity() * 1.0, 5.0f);
  volume.voxelToWorld(0, 0) = -2;
  const ScalarVolume crop = cropVolume(volume, {-1, 2, 0}, {3, 6, 2}, 9.0f);
  EXPECT_TRUE(crop.world(1, 0, 0).isApprox(volume.world(0, 2, 0)));
  EXPECT_EQ(crop.at(0, 0, 0), 9.0f);
  EXPECT_EQ(crop.at(1, 0, 0), 5.0f);
  EXPECT_EQ(crop.at(1, 2, 0), 9.0f);
}

TEST(SegmentationVolumes, FindsTheClassesOfAMixtureAndItsBias) {
  std::mt19937 random(1);
  std::normal_distribution<float> noise(0, 4);
  ScalarVolume t1({60, 20, 20}, Eigen::Matrix4d::Identity());
  const MaskVolume mask({60, 20, 20}, Eigen::Matrix4d::Identity(), 1);
  for (int k = 0; k < 20; ++k) {
    for (int j = 0; j < 20; ++j) {
      for (int i = 0; i < 60; ++i) t1.at(i, j, k) = ((i + j + k) % 2 ? 60.0f : 100.0f) + noise(random);
    }
  }
  const IntensityClasses classes = estimateIntensityClasses(t1, mask);
  EXPECT_NEAR(classes.grey, 60, 1.5);
  EXPECT_NEAR(classes.white, 100, 1.5);
  EXPECT_NEAR(classes.threshold, 80, 1.5);
  for (int k = 0; k < 20; ++k) {
    for (int j = 0; j < 20; ++j) {
      for (int i = 0; i < 60; ++i) t1.at(i, j, k) += 0.2f * static_cast<float>(i - 30);
    }
  }
  const ScalarVolume threshold = localThreshold(t1, mask, estimateIntensityClasses(t1, mask), 6);
  EXPECT_NEAR(threshold.at(12, 10, 10), 80 - 3.6, 1.0);
  EXPECT_NEAR(threshold.at(48, 10, 10), 80 + 3.6, 1.0);
}

TEST(SegmentationVolumes, RefusesTooFewOrConstantBrainVoxels) {
  const ScalarVolume t1({20, 20, 20}, Eigen::Matrix4d::Identity(), 50.0f);
  EXPECT_THROW(static_cast<void>(estimateIntensityClasses(t1, emptyMask(20))), GeometryError);
  EXPECT_THROW(static_cast<void>(estimateIntensityClasses(t1, MaskVolume(t1.dimensions, t1.voxelToWorld, 1))),
               GeometryError);
}

TEST(SegmentationVolumes, GrowthCutsARingAndSealsAPinhole) {
  VolumeOf<std::int16_t> ring({17, 17, 7}, Eigen::Matrix4d::Identity(), 0);
  std::size_t voxels = 0;
  for (int j = 1; j < 16; ++j) {
    for (int i = 1; i < 16; ++i) {
      const double r = std::hypot(i - 8, j - 8);
      if (r < 3.5 || r > 6.5) continue;
      for (int k = 2; k < 5; ++k, ++voxels)
        ring.at(i, j, k) = i == 8 && j > 8 ? 5 : 10;  // thinnest at i = 8, j > 8
    }
  }
  const HomotopicGrowth cut = growHomotopic(ring, {8, 3, 3});
  EXPECT_EQ(cut.kept + cut.rejected, voxels);
  EXPECT_GT(cut.rejected, 0u);
  EXPECT_LE(cut.rejected, 9u);
  for (int j = 9; j < 16; ++j) {
    for (int k = 2; k < 5; ++k) ring.at(8, j, k) = ring.at(8, j, k) ? 5 : 0;
  }
  VolumeOf<std::int16_t> sheet({15, 15, 5}, Eigen::Matrix4d::Identity(), 0);
  for (int j = 1; j < 14; ++j) {
    for (int i = 1; i < 14; ++i) sheet.at(i, j, 2) = 10;
  }
  sheet.at(7, 7, 2) = -1;
  const HomotopicGrowth sealed = growHomotopic(sheet, {3, 3, 2});
  EXPECT_EQ(sealed.rejected, 0u);
  EXPECT_EQ(sealed.added, 1u);
}

TEST(SegmentationVolumes, GrowthRefusesABadSeedAndStopsOnRequest) {
  VolumeOf<std::int16_t> priority({130, 130, 130}, Eigen::Matrix4d::Identity(), 1);
  EXPECT_THROW(static_cast<void>(growHomotopic(priority, {0, 3, 3})), InvalidArgument);
  priority.at(5, 5, 5) = 0;
  EXPECT_THROW(static_cast<void>(growHomotopic(priority, {5, 5, 5})), InvalidArgument);
  EXPECT_THROW(static_cast<void>(growHomotopic(priority, {6, 5, 5}, Execution({}, [] { return true; }))),
               CancelledError);
}

TEST(SegmentationVolumes, LabelsOnASurfaceEqualBruteForceOnAnObliqueGrid) {
  std::mt19937 random(2);
  LabelVolume labels({12, 11, 10}, Eigen::Matrix4d::Identity(), 0);
  labels.voxelToWorld.topLeftCorner<3, 3>() =
      Eigen::AngleAxisd(0.4, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix() *
      Eigen::Vector3d(0.3, 0.25, 0.4).asDiagonal();
  labels.voxelToWorld.topRightCorner<3, 1>() << -1.5, -1.5, -1.7;
  for (auto& label : labels.values) label = random() % 12 == 0 ? static_cast<int>(1 + random() % 90) : 0;
  const TriangleMesh sphere = sphereMesh(3);
  const double reach = 0.5;
  const auto found = labelsOnSurface(sphere, labels, reach);
  int none = 0;
  for (int v = 0; v < sphere.vertexCount(); ++v) {
    double nearest = reach;
    int label = 0;
    for (int k = 0; k < 10; ++k) {
      for (int j = 0; j < 11; ++j) {
        for (int i = 0; i < 12; ++i) {
          const double d = (labels.world(i, j, k) - sphere.point(v)).norm();
          if (labels.at(i, j, k) == 0 || d >= nearest) continue;
          nearest = d;
          label = labels.at(i, j, k);
        }
      }
    }
    EXPECT_EQ(found[static_cast<std::size_t>(v)], label) << v;
    none += label == 0;
  }
  EXPECT_GT(none, 0);
  EXPECT_LT(none, sphere.vertexCount() / 2);
  EXPECT_THROW(static_cast<void>(labelsOnSurface(sphere, labels, 0)), InvalidArgument);
}
