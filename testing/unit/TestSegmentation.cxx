#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <limits>
#include <string>

#include "Core/base/Error.h"
#include "Core/imaging/CorticalSurface.h"
#include "Core/imaging/SurfaceLabels.h"
#include "Core/mesh/SurfaceTopology.h"
#include "support/BrainPhantom.h"

using namespace authalic;
using namespace authalic::testing;

namespace {

template <class Exception, class Call>
std::string messageOf(const Call& call) {
  try {
    call();
  } catch (const Exception& error) {
    return error.what();
  } catch (const std::exception& error) {
    return std::string("another exception: ") + error.what();
  }
  return "no exception";
}

void expectSphere(const HemisphereSurface& h) {
  const SurfaceTopology topology(h.mesh.faces(), h.mesh.vertexCount());
  EXPECT_TRUE(topology.manifold());
  EXPECT_TRUE(topology.boundaryLoops().empty());
  EXPECT_EQ(topology.componentCount(), 1);
  EXPECT_EQ(topology.eulerCharacteristic(), 2);
  EXPECT_EQ(h.eulerCharacteristic, 2);
  EXPECT_TRUE(topology.isolatedVertices().empty());
}

double whiteVolumeOfOneHemisphere(double spacing) {
  const ScalarVolume t1 = brainPhantom(spacing);
  double count = 0;
  for (int k = 0; k < t1.dimensions[2]; ++k) {
    for (int j = 0; j < t1.dimensions[1]; ++j) {
      for (int i = 0; i < t1.dimensions[0]; ++i) {
        const Eigen::Vector3d p = t1.world(i, j, k);
        const bool ventricle = (Eigen::Vector3d(std::abs(p[0]), p[1], p[2]) - Eigen::Vector3d(10, 0, 18))
                                   .cwiseQuotient(Eigen::Vector3d(6, 22, 7))
                                   .norm() < 1;
        count += p[2] > -11 && (t1.at(i, j, k) > 100 || ventricle);
      }
    }
  }
  return 0.5 * count * t1.voxelVolume();
}

class Segmentation : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    result_ = new CorticalSurfaceResult(extractCorticalSurfaces(brainPhantom(2), nullptr));
  }
  static void TearDownTestSuite() { delete result_; }
  static const CorticalSurfaceResult& result() { return *result_; }

 private:
  static CorticalSurfaceResult* result_;
};

CorticalSurfaceResult* Segmentation::result_ = nullptr;

}  // namespace

TEST_F(Segmentation, ExtractsTwoSpheresFromAPhantom) {
  expectSphere(result().left);
  expectSphere(result().right);
}

TEST_F(Segmentation, WarnsThatASmoothBrainHasTooLittleSurface) {
  ASSERT_EQ(result().warnings.size(), 2u);
  EXPECT_NE(result().warnings[0].find("left white surface"), std::string::npos) << result().warnings[0];
}

TEST_F(Segmentation, FindsTheIntensitiesOfThePhantom) {
  EXPECT_NEAR(result().classes.grey, 80, 2);
  EXPECT_NEAR(result().classes.white, 110, 2);
}

TEST_F(Segmentation, PutsLeftToTheLeftAndHalvesTheBrain) {
  EXPECT_LT(result().left.mesh.points().col(0).maxCoeff(), 2.5);
  EXPECT_GT(result().right.mesh.points().col(0).minCoeff(), -2.5);
  EXPECT_NEAR(result().left.volume / result().right.volume, 1.0, 0.02);
}

TEST_F(Segmentation, RemovesHindbrainAndFillsVentricles) {
  const double expected = whiteVolumeOfOneHemisphere(1);
  for (const HemisphereSurface* h : {&result().left, &result().right}) {
    EXPECT_GT(h->mesh.points().col(2).minCoeff(), -18.0);
    EXPECT_NEAR(h->volume / expected, 1.0, 0.04);
    EXPECT_GT(h->filledVoxels, 300u);
  }
}

TEST_F(Segmentation, FlagsOneMedialWallAtTheMidline) {
  for (const HemisphereSurface* h : {&result().left, &result().right}) {
    EXPECT_GT(h->medialWallShare, 0.02);
    EXPECT_LT(h->medialWallShare, 0.2);
    int wall = 0, callosal = 0, missed = 0;
    for (int v = 0; v < h->mesh.vertexCount(); ++v) {
      const Eigen::Vector3d p = h->mesh.point(v);
      wall += h->medialWall[static_cast<std::size_t>(v)];
      if (h->medialWall[static_cast<std::size_t>(v)]) {
        EXPECT_LT(std::abs(p[0]), 30) << "vertex " << v;
      }
      const bool inside = std::abs(p[0]) < 2.5 && p[1] > -24 && p[1] < 20 && p[2] > 0 && p[2] < 21;
      callosal += inside;
      missed += inside && !h->medialWall[static_cast<std::size_t>(v)];
    }
    EXPECT_GT(wall, 50);
    EXPECT_GT(callosal, 50);
    EXPECT_EQ(missed, 0);
  }
}

TEST_F(Segmentation, GivesTheSameBitsOnOneAndOnTwoThreads) {
  const CorticalSurfaceResult one =
      extractCorticalSurfaces(brainPhantom(2), nullptr, {}, Execution({}, {}, 1));
  const CorticalSurfaceResult two =
      extractCorticalSurfaces(brainPhantom(2), nullptr, {}, Execution({}, {}, 2));
  EXPECT_TRUE(one.left.mesh.points() == two.left.mesh.points());
  EXPECT_TRUE(one.right.mesh.faces() == two.right.mesh.faces());
  EXPECT_TRUE(one.left.medialWall == two.left.medialWall);
}

// Not exactly the same: the diagonal of the cubes runs another way on the mirrored lattice.
TEST_F(Segmentation, HardlyDependsOnTheDirectionOfTheAxes) {
  ScalarVolume t1 = brainPhantom(2);
  ScalarVolume mirrored = t1;
  for (int k = 0; k < t1.dimensions[2]; ++k) {
    for (int j = 0; j < t1.dimensions[1]; ++j) {
      for (int i = 0; i < t1.dimensions[0]; ++i) mirrored.at(t1.dimensions[0] - 1 - i, j, k) = t1.at(i, j, k);
    }
  }
  mirrored.voxelToWorld.col(3) += (t1.dimensions[0] - 1) * t1.voxelToWorld.col(0);
  mirrored.voxelToWorld.col(0) *= -1;
  const CorticalSurfaceResult other = extractCorticalSurfaces(mirrored, nullptr);
  expectSphere(other.left);
  EXPECT_GT(other.left.volume, 0);
  EXPECT_NEAR(other.left.volume / result().left.volume, 1, 0.01);
  EXPECT_NEAR(other.left.area / result().left.area, 1, 0.02);
}

TEST_F(Segmentation, FollowsATurnedAndShiftedHead) {
  Eigen::Matrix4d turn = Eigen::Matrix4d::Identity();
  turn.topLeftCorner<3, 3>() =
      (Eigen::AngleAxisd(0.12, Eigen::Vector3d::UnitZ()) * Eigen::AngleAxisd(0.1, Eigen::Vector3d::UnitY()))
          .toRotationMatrix();
  turn.topRightCorner<3, 1>() << 12, -7, 30;
  const CorticalSurfaceResult other = extractCorticalSurfaces(brainPhantom(2, turn), nullptr);
  expectSphere(other.left);
  expectSphere(other.right);
  EXPECT_NEAR(other.left.volume / other.right.volume, 1, 0.04);
  EXPECT_NEAR(other.left.volume / result().left.volume, 1, 0.04);
  const Eigen::RowVector3d normal = other.frame.worldToFrame.row(0).head<3>().normalized();
  EXPECT_GT(normal.dot(turn.topLeftCorner<3, 1>()), std::cos(0.03));
}

TEST_F(Segmentation, SurvivesASmoothBiasField) {
  ScalarVolume t1 = brainPhantom(2);
  for (int k = 0; k < t1.dimensions[2]; ++k) {
    for (int j = 0; j < t1.dimensions[1]; ++j) {
      for (int i = 0; i < t1.dimensions[0]; ++i)
        t1.at(i, j, k) *= static_cast<float>(1 + 0.06 * t1.world(i, j, k)[1] / 90);
    }
  }
  const CorticalSurfaceResult other = extractCorticalSurfaces(t1, nullptr);
  EXPECT_NEAR(other.left.volume / result().left.volume, 1, 0.03);
}

TEST_F(Segmentation, TakesLabelsOnAnotherGrid) {
  LabelVolume labels({50, 63, 52}, Eigen::Matrix4d::Identity(), 0);
  labels.voxelToWorld.diagonal().head<3>().setConstant(3);
  labels.voxelToWorld.topRightCorner<3, 1>() << -75, -111, -70;
  for (int k = 0; k < 52; ++k) {
    for (int j = 0; j < 63; ++j) {
      for (int i = 0; i < 50; ++i) {
        const Eigen::Vector3d p = labels.world(i, j, k);
        if (phantomIntensity(p) != 80) continue;
        labels.at(i, j, k) = p[2] < -18 ? 95 : p[0] < 0 ? 7 : 8;
      }
    }
  }
  const CorticalSurfaceResult other = extractCorticalSurfaces(brainPhantom(2), &labels);
  expectSphere(other.left);
  EXPECT_NEAR(other.left.volume / result().left.volume, 1, 0.05);
  EXPECT_GT(other.right.mesh.points().col(2).minCoeff(), -18.0);
  labels.voxelToWorld(0, 3) += 500;
  EXPECT_NE(messageOf<GeometryError>([&] {
              return extractCorticalSurfaces(brainPhantom(2), &labels);
            }).find("share one space"),
            std::string::npos);
}

TEST_F(Segmentation, DecimatesToTheTargetOrNotAtAll) {
  CorticalSurfaceOptions options;
  options.targetFaces = 5000;
  const CorticalSurfaceResult coarse = extractCorticalSurfaces(brainPhantom(2), nullptr, options);
  EXPECT_LE(coarse.left.mesh.faceCount(), 5000);
  EXPECT_GT(coarse.left.mesh.faceCount(), 4900);
  expectSphere(coarse.left);
  EXPECT_NEAR(coarse.left.volume / result().left.volume, 1, 0.005);
  options.targetFaces = 0;
  const CorticalSurfaceResult fine = extractCorticalSurfaces(brainPhantom(2), nullptr, options);
  EXPECT_EQ(fine.left.mesh.faceCount(), fine.left.extractedFaces - fine.left.prunedFaces + fine.left.prunedSpikes);
}

TEST_F(Segmentation, RefusesWhatIsNoBrain) {
  const ScalarVolume constant({40, 40, 40}, Eigen::Matrix4d::Identity() * 1.0, 7.0f);
  EXPECT_THROW(static_cast<void>(extractCorticalSurfaces(constant, nullptr)), GeometryError);
  const ScalarVolume zero({40, 40, 40}, Eigen::Matrix4d::Identity(), 0.0f);
  EXPECT_NE(messageOf<GeometryError>([&] { return extractCorticalSurfaces(zero, nullptr); }).find("positive"),
            std::string::npos);
  const ScalarVolume nan({40, 40, 40}, Eigen::Matrix4d::Identity(), std::numeric_limits<float>::quiet_NaN());
  EXPECT_THROW(static_cast<void>(extractCorticalSurfaces(nan, nullptr)), GeometryError);
  EXPECT_THROW(static_cast<void>(extractCorticalSurfaces(ScalarVolume(), nullptr)), InvalidArgument);
  ScalarVolume small = brainPhantom(2);
  small.voxelToWorld.topLeftCorner<3, 3>() *= 0.3;
  EXPECT_NE(messageOf<GeometryError>([&] { return extractCorticalSurfaces(small, nullptr); }).find("mm wide"),
            std::string::npos);
  ScalarVolume head = brainPhantom(2);
  for (float& value : head.values) value = std::max(value, 60.0f);
  EXPECT_NE(messageOf<GeometryError>([&] { return extractCorticalSurfaces(head, nullptr); }).find("skull"),
            std::string::npos);
}

TEST_F(Segmentation, ToleratesNaNOutsideTheBrain) {
  ScalarVolume t1 = brainPhantom(2);
  for (float& value : t1.values) {
    if (value == 0) value = std::numeric_limits<float>::quiet_NaN();
  }
  const CorticalSurfaceResult other = extractCorticalSurfaces(t1, nullptr);
  EXPECT_NEAR(other.left.volume / result().left.volume, 1, 0.01);
}

TEST_F(Segmentation, NamesTheOptionThatIsOutOfRange) {
  const auto refused = [](auto change) {
    CorticalSurfaceOptions options;
    change(options);
    EXPECT_THROW(options.validate(), InvalidArgument);
  };
  refused([](auto& o) { o.sealing = -1; });
  refused([](auto& o) { o.targetFaces = 10; });
  refused([](auto& o) { o.medialWallReach = 0; });
  refused([](auto& o) { o.smoothing.iterations = -1; });
  refused([](auto& o) { o.smoothing.passBand = 2; });
  refused([](auto& o) { o.whiteMatter.biasScale = -2; });
  refused([](auto& o) { o.whiteMatter.midlineBand = 0; });
  refused([](auto& o) { o.whiteMatter.threshold = std::numeric_limits<double>::infinity(); });
}

TEST_F(Segmentation, ReportsGrowingProgressAndStopsOnRequest) {
  double last = 0;
  const Execution watch([&last](double fraction, const std::string&) {
    EXPECT_GE(fraction, last - 1e-12);
    last = fraction;
  });
  static_cast<void>(extractCorticalSurfaces(brainPhantom(2), nullptr, {}, watch));
  EXPECT_DOUBLE_EQ(last, 1.0);
  for (const int allowed : {0, 3, 12, 25}) {
    int calls = 0;
    const Execution stop({}, [&calls, allowed] { return ++calls > allowed; });
    EXPECT_THROW(static_cast<void>(extractCorticalSurfaces(brainPhantom(2), nullptr, {}, stop)),
                 CancelledError)
        << allowed;
  }
}

TEST_F(Segmentation, LabelConventionsNameBothHemispheresAlike) {
  for (const LabelConvention& c : {LabelConvention::aal(), LabelConvention::freeSurfer()}) {
    EXPECT_EQ(c.left.size(), c.right.size());
    EXPECT_FALSE(c.remove.empty());
    EXPECT_FALSE(c.fill.empty());
  }
}
