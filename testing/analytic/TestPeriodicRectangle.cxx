/// Area-preserving maps of tubes to the periodic rectangle.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "Core/authalic/FlowingMesh.h"
#include "Core/authalic/PeriodicRectangleAuthalicMap.h"
#include "Core/authalic/PeriodicRectangleLieFlow.h"
#include "Core/base/Error.h"
#include "Core/geometry/Areas.h"
#include "Core/geometry/Laplacian.h"
#include "Core/initial/Unfold.h"
#include "support/HoledMeshes.h"
#include "support/OffFile.h"
#include "support/SharedData.h"

namespace {

using namespace authalic;
using authalic::testing::fixture;
using authalic::testing::readOff;
using authalic::testing::revolutionMesh;

constexpr double kHeight = 0.8;

/// A cylinder of circumference 1 and height 0.8 with the density 1 + z/0.8.
struct Cylinder {
  AnnulusMesh surface;
  TargetMeasure target;

  explicit Cylinder(int rings)
      : surface(revolutionMesh(
            rings, rings, [](double) { return 0.5 / M_PI; }, [](double t) { return kHeight * t; })),
        target(TargetMeasure::fromFaceDensity(surface.mesh(), density())) {}

  [[nodiscard]] Eigen::VectorXd density() const {
    const TriangleMesh& mesh = surface.mesh();
    Eigen::VectorXd values(mesh.faceCount());
    for (int f = 0; f < mesh.faceCount(); ++f) {
      values[f] = 1 + (mesh.corner(f, 0).z() + mesh.corner(f, 1).z() + mesh.corner(f, 2).z()) / (3 * kHeight);
    }
    return values;
  }

  /// Mean difference of y / h from (t + t²/2) / 1.5, t = z / 0.8.
  [[nodiscard]] double error(const PeriodicRectangleImage& map) const {
    double sum = 0;
    for (int v = 0; v < surface.mesh().vertexCount(); ++v) {
      const double t = surface.mesh().point(v).z() / kHeight;
      sum += std::abs(map.image(v, 1) / map.height - (t + t * t / 2) / 1.5);
    }
    return sum / surface.mesh().vertexCount();
  }
};

/// Copies lie one period on, loops on their lines, the cut leads from one to the other.
void expectOpened(const AnnulusMesh& surface, const PeriodicRectangleImage& map) {
  const int n = surface.mesh().vertexCount();
  ASSERT_EQ(map.image.rows(), n + Eigen::Index(map.cut.size()));
  ASSERT_EQ(map.originalPointIds.size(), std::size_t(map.image.rows()));
  for (int v = n; v < map.image.rows(); ++v) {
    const int original = map.originalPointIds[std::size_t(v)];
    EXPECT_EQ(original, map.cut[std::size_t(v - n)]);
    EXPECT_NEAR(std::abs(map.image(v, 0) - map.image(original, 0)), 1, 1e-14);
    EXPECT_EQ(map.image(v, 1), map.image(original, 1));
  }
  for (std::size_t k = 0; k < 2; ++k) {
    for (const int v : surface.loops()[k]) {
      EXPECT_NEAR(map.image(v, 1), int(k) == map.outerLoop ? 0 : map.height, 1e-14 * (1 + map.height));
    }
  }
  EXPECT_EQ(countFlippedFaces(map.image, map.faces), 0);
  EXPECT_NEAR(signedFaceAreas(map.image, map.faces).sum(), map.height, 1e-12 * map.height);
}

/// A flat cylinder of circumference 1, its corners shifted where they cross x = 1.
struct Strip {
  TriangleMesh surface;
  Points2 points, shifts;

  explicit Strip(int around = 12, int along = 8)
      : surface(revolutionMesh(around, along, [](double) { return 0.5 / M_PI; }, [](double t) { return t; })),
        points(surface.vertexCount(), 2), shifts(Points2::Zero(3 * surface.faceCount(), 2)) {
    for (int v = 0; v < surface.vertexCount(); ++v) {
      const Eigen::Vector3d p = surface.point(v);
      const double turn = std::atan2(p.y(), p.x()) / (2 * M_PI);
      points.row(v) << turn - std::floor(turn + 1e-9), p.z();
    }
    for (int f = 0; f < surface.faceCount(); ++f) {
      for (int k = 1; k < 3; ++k) {
        const double step = points(surface.faces()(f, k), 0) - points(surface.faces()(f, 0), 0);
        shifts(3 * f + k, 0) = -std::round(step);
      }
    }
  }
};

}  // namespace

TEST(PeriodicRectangle, OfACylinderWithADensityConvergesToItsClosedForm) {
  // y/h = (t + t²/2)/1.5; the height that balances the two parts of the Dirichlet energy is 1.5 · 0.8 / (7/3)^½.
  const double height = 1.5 * kHeight / std::sqrt(7.0 / 3);
  double flowBefore = 0, solveBefore = 0;
  for (const int rings : {8, 16, 32}) {
    const Cylinder cylinder(rings);
    PeriodicRectangleLieFlowOptions flowing;
    flowing.flow.finish = LieFlowFinish::None;
    flowing.flow.tolerance = 1e-4;
    flowing.outerLoop = 0;  // both are as long but for rounding
    const auto flow = periodicRectangleLieFlow(cylinder.surface, cylinder.target, flowing);
    EXPECT_EQ(flow.flippedFaces, 0);
    expectOpened(cylinder.surface, flow);
    PeriodicRectangleAuthalicMapOptions solving;
    solving.solve.tolerance = 0.1;
    solving.outerLoop = 0;
    const auto solve = periodicRectangleAuthalicMap(cylinder.surface, cylinder.target, solving);
    EXPECT_EQ(solve.status, Status::Converged);
    EXPECT_LT(solve.vertexResidual, 1e-10);
    expectOpened(cylinder.surface, solve);
    if (rings > 8) { EXPECT_GT(flowBefore / cylinder.error(flow), 2.5) << rings; }
    if (rings > 8) { EXPECT_GT(solveBefore / cylinder.error(solve), 2) << rings; }
    flowBefore = cylinder.error(flow);
    solveBefore = cylinder.error(solve);
    if (rings == 32) { EXPECT_NEAR(flow.height, height, 2e-3); }
    if (rings == 32) { EXPECT_NEAR(solve.height, height, 2e-3); }
  }
  EXPECT_LT(flowBefore, 1e-3);
  EXPECT_LT(solveBefore, 1e-3);
}

TEST(PeriodicRectangle, OfABentTubeIsExactAtEveryVertexAlsoOnTheCut) {
  const AnnulusMesh surface(readOff(fixture("bent_tube.off")));
  for (const int outer : {0, 1}) {
    PeriodicRectangleAuthalicMapOptions options;
    options.outerLoop = outer;
    const auto map = periodicRectangleAuthalicMap(surface, TargetMeasure(surface.mesh()), options);
    EXPECT_EQ(map.status, Status::Converged);
    EXPECT_EQ(map.outerLoop, outer);
    expectOpened(surface, map);
    const Eigen::VectorXd areas = signedFaceAreas(map.image, map.faces) / map.height;
    const Eigen::VectorXd stars = vertexStars(areas, surface.mesh().faces(), surface.mesh().vertexCount());
    const Eigen::VectorXd target = TargetMeasure(surface.mesh()).vertices();
    EXPECT_LT((stars.array() / target.array()).log().abs().maxCoeff(), 1e-9);
  }
}

TEST(PeriodicRectangle, LieFlowOfABentTubePreservesAreasOnTheInputsFaces) {
  const AnnulusMesh surface(readOff(fixture("bent_tube.off")));
  const auto map = periodicRectangleLieFlow(surface, TargetMeasure(surface.mesh()));
  EXPECT_EQ(map.status, Status::Converged);
  EXPECT_GT(map.edgeFlips, 0);
  EXPECT_LE(map.residual, 5e-3);
  expectOpened(surface, map);
}

TEST(PeriodicRectangle, GivesARegionTheShareThatIsAskedFor) {
  const Cylinder cylinder(16);
  const TriangleMesh& mesh = cylinder.surface.mesh();
  Eigen::VectorXd density = Eigen::VectorXd::Ones(mesh.faceCount());
  for (int f = 0; f < mesh.faceCount(); ++f) {
    if (mesh.corner(f, 0).x() > 0.08) density[f] = 4;
  }
  const auto target = TargetMeasure::fromFaceDensity(mesh, density);
  for (const bool flows : {false, true}) {
    PeriodicRectangleLieFlowOptions flowing;
    PeriodicRectangleAuthalicMapOptions solving;
    solving.solve.tolerance = 0.1;
    const PeriodicRectangleImage map =
        flows ? PeriodicRectangleImage(periodicRectangleLieFlow(cylinder.surface, target, flowing))
              : PeriodicRectangleImage(periodicRectangleAuthalicMap(cylinder.surface, target, solving));
    expectOpened(cylinder.surface, map);
    const Eigen::VectorXd stars =
        vertexStars(signedFaceAreas(map.image, map.faces) / map.height, mesh.faces(), mesh.vertexCount());
    if (!flows) { EXPECT_LT((stars.array() / target.vertices().array()).log().abs().maxCoeff(), 1e-9); }
    double difference = 0;  // of the region's share: at most the residual, whatever the region
    for (int v = 0; v < mesh.vertexCount(); ++v) {
      if (mesh.point(v).x() > 0.08) difference += stars[v] - target.vertices()[v];
    }
    EXPECT_LT(std::abs(difference), flowing.flow.tolerance);
  }
}

TEST(PeriodicRectangle, RefusesOptionsOutsideTheirRangeAndStopsWhenAsked) {
  const Cylinder cylinder(8);
  PeriodicRectangleAuthalicMapOptions solving;
  solving.outerLoop = 2;
  EXPECT_THROW((void)periodicRectangleAuthalicMap(cylinder.surface, cylinder.target, solving), InvalidArgument);
  solving = {};
  solving.solve.tolerance = 0;
  EXPECT_THROW((void)periodicRectangleAuthalicMap(cylinder.surface, cylinder.target, solving), InvalidArgument);
  PeriodicRectangleLieFlowOptions flowing;
  flowing.outerLoop = -2;
  EXPECT_THROW((void)periodicRectangleLieFlow(cylinder.surface, cylinder.target, flowing), InvalidArgument);
  flowing = {};
  flowing.flow.stepRatio = 1;
  EXPECT_THROW((void)periodicRectangleLieFlow(cylinder.surface, cylinder.target, flowing), InvalidArgument);
  const TargetMeasure other(Cylinder(6).surface.mesh());
  EXPECT_THROW((void)periodicRectangleLieFlow(cylinder.surface, other), GeometryError);
  const Execution stop({}, [] { return true; });
  EXPECT_EQ(periodicRectangleAuthalicMap(cylinder.surface, cylinder.target, {}, stop).status, Status::Cancelled);
  EXPECT_EQ(periodicRectangleLieFlow(cylinder.surface, cylinder.target, {}, stop).image.rows(), 0);
}

TEST(FlowingMesh, FlipsEdgesAcrossTheCutOfACylinderLikeAnyOther) {
  Strip strip;
  strip.points.col(0) += 3.7 * strip.points.col(1);  // sheared: far from Delaunay everywhere
  FlowingMesh mesh(strip.surface.faces(), strip.surface.vertexCount(), {}, strip.shifts);
  EXPECT_GT(mesh.makeDelaunay(strip.points), strip.surface.faceCount());
  const Eigen::VectorXd areas = periodicFaceAreas(strip.points, mesh.shifts(), mesh.faces());
  EXPECT_GT(areas.minCoeff(), 0);
  EXPECT_NEAR(areas.sum(), 1, 1e-12);
  const HalfEdgeWeights weights = cotangentWeights(strip.points, mesh.faces(), mesh.shifts());
  const SurfaceTopology topology(mesh.faces(), strip.surface.vertexCount());
  for (int h = 0; h < 3 * int(mesh.faces().rows()); ++h) {
    const int g = topology.opposite(h);
    if (g < 0) continue;
    EXPECT_GE(weights(h / 3, h % 3) + weights(g / 3, g % 3), -1e-9);
    const Eigen::RowVector2d there = mesh.shifts().row(SurfaceTopology::next(h)) - mesh.shifts().row(h),
                             back = mesh.shifts().row(SurfaceTopology::next(g)) - mesh.shifts().row(g);
    EXPECT_EQ(there, -back);
  }
}

TEST(PeriodicImage, HasTheGradientOfAHeightAtEveryVertexAlsoOnTheCut) {
  const Strip strip;
  const Points2 gradients = vertexGradients(strip.points, strip.surface.faces(), strip.points.col(1), strip.shifts);
  EXPECT_LT((gradients.rowwise() - Eigen::RowVector2d(0, 1)).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(PeriodicImage, IsUnfoldedOnTheCutAndKeptWhereNothingIsFolded) {
  const Strip strip;
  const SurfaceTopology topology(strip.surface.faces(), strip.surface.vertexCount());
  const int onCut = 4 * 12;  // x = 0
  for (const int v : {onCut, onCut + 5}) {
    Points2 image = strip.points;
    image.row(v) += Eigen::RowVector2d(-0.3, 0.2);
    const UnfoldResult result = unfold(topology, image, {}, UnfoldReach::WholeMesh, strip.shifts);
    EXPECT_GT(result.movedVertices, 0);
    EXPECT_EQ(result.flippedFaces, 0);
    EXPECT_GT(periodicFaceAreas(result.image, strip.shifts, strip.surface.faces()).minCoeff(), 0);
  }
  const UnfoldResult kept = unfold(topology, strip.points, {}, UnfoldReach::WholeMesh, strip.shifts);
  EXPECT_EQ(kept.image, strip.points);
}
