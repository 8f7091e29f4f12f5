/// Starts of the area solve with few faces that are folded, collapsed or much too small.
#include <gtest/gtest.h>

#include "Core/authalic/BalancedStart.h"
#include "Core/authalic/CircleDomainAreas.h"
#include "Core/authalic/NarrowFaces.h"
#include "Core/authalic/SolidAngles.h"
#include "Core/geometry/Areas.h"
#include "Core/geometry/SphericalAreas.h"
#include "Core/mesh/PolyAnnulusMesh.h"
#include "support/HoledMeshes.h"
#include "support/TestMeshes.h"

using namespace authalic;
using authalic::testing::diskMesh;
using authalic::testing::gridMesh;
using authalic::testing::holedDisk;
using authalic::testing::sphereMesh;

namespace {

// Smallest image share of a face by its target.
double narrowest(const DiskMesh& disk, const TargetMeasure& target, const Points2& image) {
  const Eigen::ArrayXd areas = signedFaceAreas(image, disk.mesh().faces());
  return (areas / (areas.sum() * target.faces().array())).minCoeff();
}

}  // namespace

TEST(NarrowFaces, AreOpenedInTheirPatchAndNothingElseMoves) {
  const DiskMesh disk(diskMesh(60));
  const TargetMeasure target(disk.mesh());
  const Points2 plain = disk.mesh().points().leftCols(2);
  const Eigen::RowVector2d centre(0.2, 0.1);
  const double radius = 0.1;
  Points2 image = plain;
  for (auto point : image.rowwise()) {
    const Eigen::RowVector2d arm = point - centre;
    if (arm.norm() < radius) point = centre + arm * std::pow(arm.norm() / radius, 3);
  }
  ASSERT_GT(narrowest(disk, target, image), 0);
  ASSERT_LT(narrowest(disk, target, image), 1e-4);
  const UnfoldResult opened = openNarrowFaces(disk, image, target, SolverBackend::Automatic, {});
  EXPECT_EQ(opened.flippedFaces, 0);
  EXPECT_GE(narrowest(disk, target, opened.image), 0.1);
  for (Eigen::Index v = 0; v < plain.rows(); ++v) {
    if ((plain.row(v) - centre).norm() < 0.5) continue;
    EXPECT_EQ(opened.image.row(v), image.row(v));
  }
}

// The unit sphere, drawn together around a point, and where that cannot be seen any more.
struct Pinched {
  SphereMesh sphere{sphereMesh(5)};
  TargetMeasure target{sphere.mesh()};
  Eigen::RowVector3d centre = Eigen::RowVector3d(0.2, 0.1, 1).normalized();
  Points3 image = sphere.mesh().points();

  explicit Pinched(double power, double radius = 0.15) {
    for (auto point : image.rowwise()) {
      const Eigen::RowVector3d arm = point - centre;
      if (arm.norm() < radius) point = (centre + arm * std::pow(arm.norm() / radius, power)).normalized();
    }
  }
  [[nodiscard]] Eigen::ArrayXd ratios(const Points3& x) const {
    return signedSolidAngles(x, sphere.mesh().faces()).array() / (4 * M_PI * target.faces().array());
  }
  void expectFarPlacesAsTheyWere(const Points3& x) const {
    for (Eigen::Index v = 0; v < x.rows(); ++v) {
      if ((sphere.mesh().points().row(v) - centre).norm() < 1) continue;
      EXPECT_EQ(x.row(v), image.row(v));
    }
  }
};

TEST(NarrowFaces, AreOpenedOnTheSphereInTheirPatchAndNothingElseMoves) {
  const Pinched pinched(3);
  ASSERT_GT(pinched.ratios(pinched.image).minCoeff(), 0);
  ASSERT_LT(pinched.ratios(pinched.image).minCoeff(), 1e-3);
  Points3 opened = pinched.image;
  openNarrowFacesOnSphere(pinched.sphere, pinched.target, SolverBackend::Automatic, opened);
  EXPECT_GE(pinched.ratios(opened).minCoeff(), 0.01);
  pinched.expectFarPlacesAsTheyWere(opened);
}

TEST(NarrowFaces, AreOpenedBesideHolesAndNothingElseMoves) {
  const PolyAnnulusMesh surface(holedDisk(30, {{{-0.4, 0.05}, 0.15}, {{0.1, -0.5}, 0.1}}));
  const TargetMeasure target(surface.mesh());
  std::vector<LoopOnCircle> loops(surface.loops().size());
  for (std::size_t k = 0; k < loops.size(); ++k) loops[k].vertices = surface.loops()[k];
  const CircleDomainAreas areas(surface.mesh().faces(), loops, surface.mesh().vertexCount());
  const Eigen::RowVector2d centre(0.4, 0.3);
  Coordinates image = surface.mesh().points().leftCols(2);
  for (auto point : image.rowwise()) {
    const Eigen::RowVector2d arm = point - centre;
    if (arm.norm() < 0.25) point = centre + arm * std::pow(arm.norm() / 0.25, 3);
  }
  const auto narrowest = [&](const Coordinates& x) {
    const Eigen::ArrayXd a = areas.areas(x).array();
    return (a / (a.sum() * target.faces().array())).minCoeff();
  };
  ASSERT_GT(narrowest(image), 0);
  ASSERT_LT(narrowest(image), 0.003);
  Coordinates opened = image;
  openNarrowFaces(areas, target, surface.mesh().points(), SolverBackend::Automatic, opened, kCollapsing);
  EXPECT_GE(narrowest(opened), kCollapsing.narrow);
  for (Eigen::Index v = 0; v < image.rows(); ++v) {
    if ((surface.mesh().points().row(v).head(2) - centre).norm() > 0.8) {
      EXPECT_EQ(opened.row(v), image.row(v));
    }
  }
}

TEST(NarrowFaces, FewFacesFarFromTheirTargetsAreMatchedInTheirPatch) {
  const Pinched pinched(1.5);
  const Faces& faces = pinched.sphere.mesh().faces();
  const SolidAngles areas(faces, pinched.sphere.mesh().vertexCount());
  const Eigen::VectorXd& targets = pinched.target.faces();
  const FaceFlags far = farFaces(areas, targets, pinched.image);
  ASSERT_TRUE(far.any());
  const auto excess = [&](const Points3& x) {
    const Eigen::ArrayXd r = pinched.ratios(x);
    return (targets.array() * (r + 1 / r - 2)).sum();
  };
  Coordinates image = pinched.image;
  ASSERT_TRUE(matchFarFaces(far, areas, targets, pinched.sphere.mesh().points(), SolverBackend::Automatic,
                            Shapes::First, image));
  const Points3 matched = image;
  EXPECT_LT(excess(matched), 0.1 * excess(pinched.image));
  EXPECT_FALSE(farFaces(areas, targets, matched).any());
  EXPECT_GT(pinched.ratios(matched).minCoeff(), 0.5);
  pinched.expectFarPlacesAsTheyWere(matched);
}

TEST(NarrowFaces, ManyFacesFarFromTheirTargetsAreLeftToAllSteps) {
  const Pinched pinched(1.5, 0.6);
  const SolidAngles areas(pinched.sphere.mesh().faces(), pinched.sphere.mesh().vertexCount());
  ASSERT_GT((pinched.ratios(pinched.image).log().abs() > 0.7).count(), 0);
  EXPECT_FALSE(farFaces(areas, pinched.target.faces(), pinched.image).any());
}

TEST(NarrowFaces, StayAsTheyAreWhereNoneIs) {
  const DiskMesh disk(diskMesh(12));
  const Points2 image = disk.mesh().points().leftCols(2);
  const UnfoldResult opened =
      openNarrowFaces(disk, image, TargetMeasure(disk.mesh()), SolverBackend::Automatic, {});
  EXPECT_EQ(opened.image, image);
}

TEST(NarrowFaces, ThatCollapseAreRevivedThoughOthersCannotBe) {
  const DiskMesh disk(gridMesh(21, 20));
  const TargetMeasure target(disk.mesh());
  Points2 image = disk.mesh().points().leftCols(2);
  const int corner = 21, middle = 10 * 22 + 10;
  image.row(corner) = 0.5 * (image.row(20) + image.row(43));  // the only face of the corner is flat, and held
  image(middle, 0) += 0.08;                                   // folds faces around it
  const Points2 revived = reviveCollapsedFaces(disk, image, target, SolverBackend::Automatic);
  EXPECT_EQ(revived.row(corner), image.row(corner));
  EXPECT_LE(narrowest(disk, target, revived), 0);
  const Eigen::VectorXd before = signedFaceAreas(image, disk.mesh().faces()),
                        after = signedFaceAreas(revived, disk.mesh().faces());
  ASSERT_LT(before.minCoeff(), -1e-6);
  EXPECT_EQ((after.array() <= 1e-12).count(), 1);
}
