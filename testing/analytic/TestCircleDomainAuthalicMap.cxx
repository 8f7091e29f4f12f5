/// Area-preserving maps of surfaces with holes.
#include <gtest/gtest.h>

#include <cmath>

#include "Core/authalic/CircleDomainAuthalicMap.h"
#include "Core/base/Error.h"
#include "Core/distortion/Distortion.h"
#include "Core/geometry/Areas.h"
#include "support/HoledMeshes.h"
#include "support/OffFile.h"
#include "support/SharedData.h"

namespace {

using namespace authalic;
using authalic::testing::fixture;
using authalic::testing::holedDisk;
using authalic::testing::readOff;
using authalic::testing::sharedData;

/// Area of a polygon, whichever way round.
double polygon(const Points2& image, const std::vector<int>& loop) {
  double twice = 0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const auto p = image.row(loop[i]), q = image.row(loop[(i + 1) % loop.size()]);
    twice += p[0] * q[1] - p[1] * q[0];
  }
  return std::abs(twice) / 2;
}

}  // namespace


TEST(CircleDomainAuthalicMap, OfRealFacesIsExactAtVerticesAndHoles) {
  for (const char* name : {"sophie", "alex_3"}) {
    const std::string path = sharedData("meshes/poly_annulus/" + std::string(name) + ".off");
    AUTHALIC_NEEDS(path);
    const PolyAnnulusMesh surface(readOff(path));
    CircleDomainAuthalicMapOptions options;
    const auto result = circleDomainAuthalicMap(surface, TargetMeasure(surface.mesh()), options);
    EXPECT_EQ(result.status, Status::Converged);
    EXPECT_EQ(result.flippedFaces, 0);
    const DistortionSummary summary = measureDistortion(surface.mesh(), result.image).summary;
    EXPECT_LT(summary.areaDistortion, 2 + 1e-4);
    EXPECT_LT(summary.faceMeanAbsLog, 5e-3);
    EXPECT_LT(summary.vertexMaxAbsLog, 1e-9);
    const double area = faceAreas(surface.mesh()).sum();
    for (std::size_t k = 1; k < surface.loops().size(); ++k) {
      const double ratio = polygon(result.image, surface.loops()[k]) /
                           signedFaceAreas(result.image, surface.mesh().faces()).sum();
      EXPECT_NEAR(std::log(ratio * area / result.holeAreas[k - 1]), 0, 1e-9);
      EXPECT_LT(result.circles[k].deviation, 1e-12);
    }
  }
}

TEST(CircleDomainAuthalicMap, OfASphericalZoneHasNearlyTheRadiiOfLambert) {
  // Rotations of one ring against the next preserve areas too, so that second order is not to be expected.
  // r² = ρ² + (1 − ρ²) · share of the area nearer to the hole; the hole has the area of the cap that it lacks: r is
  // then the chord from the pole, over that of the rim.
  constexpr double kHole = 0.3, kRim = 1.2;  // of the radius; polar angle
  for (const bool concentric : {false, true}) {
    double before = 0;
    for (const int rings : {10, 20}) {
      const TriangleMesh flat = holedDisk(rings, {{{0, 0}, kHole}});
      Points3 points = flat.points();
      for (Eigen::Index v = 0; v < points.rows(); ++v) {
        const double r = flat.points().row(v).norm(), theta = kRim * r;
        points.row(v) << flat.points().row(v).head(2) * std::sin(theta) / r, std::cos(theta);
      }
      const PolyAnnulusMesh surface(TriangleMesh(points, flat.faces()));
      CircleDomainAuthalicMapOptions options;
      options.concentric = concentric;
      options.solve.tolerance = 0.1;
      options.holeAreas = {2 * M_PI * (1 - std::cos(kRim * kHole))};
      const auto result = circleDomainAuthalicMap(surface, TargetMeasure(surface.mesh()), options);
      EXPECT_EQ(result.status, Status::Converged);
      EXPECT_LT(result.vertexResidual, 1e-10);
      double worst = 0;
      for (int v = 0; v < surface.mesh().vertexCount(); ++v) {
        const double chord = std::sin(0.5 * kRim * flat.points().row(v).norm()) / std::sin(0.5 * kRim);
        worst = std::max(worst, std::abs(result.image.row(v).norm() - chord));
      }
      if (rings == 20) { EXPECT_LT(worst, before) << concentric; }
      before = worst;
    }
    EXPECT_LT(before, 0.015);
  }
}

TEST(CircleDomainAuthalicMap, GivesHolesTheAreasAndRegionsTheSharesThatAreAskedFor) {
  const PolyAnnulusMesh surface(holedDisk(24, {{{0.45, 0.1}, 0.15}, {{-0.3, -0.35}, 0.2}}));
  ASSERT_EQ(surface.loops().size(), 3u);
  Eigen::VectorXd density = Eigen::VectorXd::Ones(surface.mesh().faceCount());
  for (int f = 0; f < surface.mesh().faceCount(); ++f) {
    if (surface.mesh().corner(f, 0).x() < -0.4) density[f] = 3;
  }
  const auto target = TargetMeasure::fromFaceDensity(surface.mesh(), density);
  CircleDomainAuthalicMapOptions options;
  options.holeAreas = {0.2, 0.1};
  options.solve.tolerance = 0.1;
  const auto result = circleDomainAuthalicMap(surface, target, options);
  EXPECT_EQ(result.status, Status::Converged);
  EXPECT_EQ(result.flippedFaces, 0);
  const Eigen::VectorXd areas = signedFaceAreas(result.image, surface.mesh().faces());
  const Eigen::VectorXd stars = vertexStars(areas, surface.mesh().faces(), surface.mesh().vertexCount()) / areas.sum();
  EXPECT_LT((stars.array() / target.vertices().array()).log().abs().maxCoeff(), 1e-9);
  const double area = faceAreas(surface.mesh()).sum();
  std::size_t hole = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    if (int(k) == result.outerLoop) continue;
    EXPECT_NEAR(polygon(result.image, surface.loops()[k]) / areas.sum(), options.holeAreas[hole++] / area, 1e-12);
  }
}

TEST(CircleDomainAuthalicMap, OfALongTubeHasAHoleOfTheRightSize) {
  const std::string path = fixture("bent_tube.off");
  const PolyAnnulusMesh surface(readOff(path));
  CircleDomainAuthalicMapOptions options;
  options.concentric = true;
  options.solve.tolerance = 0.05;
  const auto result = circleDomainAuthalicMap(surface, TargetMeasure(surface.mesh()), options);
  EXPECT_EQ(result.status, Status::Converged);
  EXPECT_EQ(result.flippedFaces, 0);
  EXPECT_LT(result.vertexResidual, 1e-9);
  EXPECT_LT(result.circles[1 - std::size_t(result.outerLoop)].centre.norm(), 1e-12);
}

TEST(CircleDomainAuthalicMap, BringsADiskWithHolesBackWhereCentresMove) {
  // The conformal map puts the holes of a flat disk elsewhere (a Möbius transformation of the disk is left free), so
  // that only moving circles find the isometry. Free radii have to come back as well.
  const std::vector<authalic::testing::RoundHole> holes = {{{0.5, 0.1}, 0.15}, {{-0.1, -0.45}, 0.25}};
  const PolyAnnulusMesh surface(holedDisk(20, holes));
  const TargetMeasure target(surface.mesh());
  CircleDomainAuthalicMapOptions options;
  options.solve.tolerance = 1e-3;
  const auto angles = [&] {
    const auto result = circleDomainAuthalicMap(surface, target, options);
    EXPECT_EQ(result.status, Status::Converged);
    EXPECT_LT(result.vertexResidual, 1e-9);
    EXPECT_LT(result.holeResidual, 1e-12);
    for (std::size_t k = 0, hole = 0; k < 3 && !options.holdCentres; ++k) {
      if (static_cast<int>(k) == result.outerLoop) continue;
      const double radius = options.freeRadii ? result.circles[k].radius : 0;
      const auto& truth = std::abs(result.holeAreas[hole++] - M_PI * 0.15 * 0.15) < 0.05 ? holes[0] : holes[1];
      EXPECT_NEAR(result.circles[k].centre.norm(), truth.centre.norm(), 0.01);
      if (options.freeRadii) { EXPECT_NEAR(radius, truth.radius, 0.01); }
    }
    return measureDistortion(surface.mesh(), result.image).summary.meanAngleError;
  };
  const double moving = angles();
  options.freeRadii = true;
  const double free = angles();
  options.freeRadii = false;
  options.holdCentres = true;
  const double held = angles();
  EXPECT_LT(moving, 0.7);  // degrees
  EXPECT_LT(free, 0.7);
  EXPECT_GT(held, 5 * moving);
}

TEST(CircleDomainAuthalicMap, ReachesHolesBehindALongNeck) {
  // A finger: a cap with two holes on a tube that is 10 radii long. The conformal map shrinks the cap by e^-10.
  const TriangleMesh flat = holedDisk(30, {{{0.25, 0.05}, 0.1}, {{-0.2, -0.15}, 0.08}});
  Points3 points = flat.points();
  for (Eigen::Index v = 0; v < points.rows(); ++v) {
    const double r = flat.points().row(v).norm(), cap = std::min(r / 0.5, 1.0) * M_PI / 2;
    points.row(v) << flat.points().row(v).head(2) * (std::sin(cap) / r), std::cos(cap) - 20 * std::max(r - 0.5, 0.0);
    if (r == 0) points.row(v) << 0, 0, 1;
  }
  const PolyAnnulusMesh surface(TriangleMesh(points, flat.faces()));
  CircleDomainAuthalicMapOptions options;
  options.solve.tolerance = 0.05;
  const TargetMeasure target(surface.mesh());
  const auto result = circleDomainAuthalicMap(surface, target, options);
  EXPECT_EQ(result.status, Status::Converged);
  EXPECT_EQ(result.flippedFaces, 0);
  EXPECT_LT(result.vertexResidual, 1e-9);
  EXPECT_LT(result.holeResidual, 1e-9);
  EXPECT_EQ(circleDomainAuthalicMap(surface, target, options).image, result.image);  // the same bits
}

TEST(CircleDomainAuthalicMap, RefusesHolesThatDoNotFitAndListsThatDoNotBelong) {
  const PolyAnnulusMesh surface(holedDisk(12, {{{0.45, 0.1}, 0.15}, {{-0.3, -0.35}, 0.2}}));
  const TargetMeasure target(surface.mesh());
  CircleDomainAuthalicMapOptions options;
  const auto map = [&] { (void)circleDomainAuthalicMap(surface, target, options); };
  options.holeAreas = {1};
  EXPECT_THROW(map(), InvalidArgument);
  options.holeAreas = {1, -1};
  EXPECT_THROW(map(), InvalidArgument);
  options.holeAreas = {1, std::nan("")};
  EXPECT_THROW(map(), InvalidArgument);
  options.holeAreas = {100, 100};
  EXPECT_THROW(map(), GeometryError);
  options.holeAreas = {0.1, 0.1};
  options.freeRadii = true;
  EXPECT_THROW(map(), InvalidArgument);
  options.freeRadii = false;
  options.holeAreas.clear();
  options.concentric = true;
  EXPECT_THROW(map(), TopologyError);
  options.concentric = false;
  options.outerLoop = 3;
  EXPECT_THROW(map(), InvalidArgument);
  options.outerLoop = -1;
  options.solve.tolerance = 0;
  EXPECT_THROW(map(), InvalidArgument);
}

TEST(CircleDomainAuthalicMap, NamesThePeriodicRectangleWhereALongTubeShrinksItsHoleToAPoint) {
  const PolyAnnulusMesh tube(authalic::testing::revolutionMesh(
      12, 160, [](double) { return 1.0; }, [](double t) { return 80 * t; }));
  try {
    (void)circleDomainAuthalicMap(tube, TargetMeasure(tube.mesh()));
    FAIL() << "a tube 80 radii long was mapped";
  } catch (const GeometryError& refused) {
    EXPECT_NE(std::string(refused.what()).find("periodic-rectangle"), std::string::npos) << refused.what();
  }
}

TEST(CircleDomainAuthalicMap, StopsWhenAskedAndSaysSo) {
  const PolyAnnulusMesh surface(holedDisk(12, {{{0.45, 0.1}, 0.15}}));
  const Execution execution({}, [] { return true; });
  const auto result = circleDomainAuthalicMap(surface, TargetMeasure(surface.mesh()), {}, execution);
  EXPECT_EQ(result.status, Status::Cancelled);
}
