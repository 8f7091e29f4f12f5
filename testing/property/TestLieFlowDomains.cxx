#include <gtest/gtest.h>

#include <cmath>

#include "Core/authalic/CircleDomainLieFlow.h"
#include "Core/authalic/DiscreteLieFlow.h"
#include "Core/authalic/LieAdvection.h"
#include "Core/authalic/PolygonMesh.h"
#include "Core/base/Error.h"
#include "Core/distortion/Distortion.h"
#include "Core/geometry/Areas.h"
#include "Core/initial/BarycentricMap.h"
#include "Core/initial/Untangle.h"
#include "support/HoledMeshes.h"
#include "support/TestMeshes.h"

using namespace authalic;
using namespace authalic::testing;

namespace {

PlanarDomain letterL() {
  Points2 corners(6, 2);
  corners << 0, 0, 2, 0, 2, 1, 1, 1, 1, 2, 0, 2;
  return PlanarDomain::polygon(corners);
}

PlanarDomain letterU() {
  Points2 corners(8, 2);
  corners << 0, 0, 3, 0, 3, 3, 2, 3, 2, 1, 1, 1, 1, 3, 0, 3;
  return PlanarDomain::polygon(corners);
}

PlanarDomain star() {
  Points2 corners(10, 2);
  for (int k = 0; k < 10; ++k) {
    const double radius = k % 2 == 0 ? 1 : 0.45, angle = k * M_PI / 5;
    corners.row(k) << radius * std::cos(angle), radius * std::sin(angle);
  }
  return PlanarDomain::polygon(corners);
}

Points2 tutte(const DiskMesh& disk, const PlanarDomain& domain) {
  BarycentricMapOptions options;
  options.domain = domain;
  options.weights = BarycentricWeights::Uniform;
  return barycentricMap(disk, options).image;
}

double distanceToSides(const PlanarDomain& domain, const Eigen::RowVector2d& p) {
  double nearest = 1e300;
  const Points2& c = domain.corners();
  for (Eigen::Index k = 0; k < c.rows(); ++k) {
    const Eigen::RowVector2d a = c.row(k), along = c.row((k + 1) % c.rows()) - a;
    const double t = std::clamp((p - a).dot(along) / along.squaredNorm(), 0.0, 1.0);
    nearest = std::min(nearest, (a + t * along - p).norm());
  }
  return nearest;
}

// An annulus of inner radius 0.4, of nearly equilateral triangles, with the density 1 + r.
struct RadialCase {
  PolyAnnulusMesh surface;
  TargetMeasure target;

  explicit RadialCase(int rings)
      : surface(revolutionMesh(
            6 * rings, rings, [](double t) { return std::pow(0.4, t); }, [](double) { return 0.0; })),
        target(TargetMeasure::fromFaceDensity(surface.mesh(), density())) {}

  [[nodiscard]] Eigen::VectorXd density() const {
    const TriangleMesh& mesh = surface.mesh();
    Eigen::VectorXd values(mesh.faceCount());
    for (int f = 0; f < mesh.faceCount(); ++f) {
      values[f] = 1 + ((mesh.corner(f, 0) + mesh.corner(f, 1) + mesh.corner(f, 2)) / 3).norm();
    }
    return values;
  }
};

}  // namespace

TEST(DiscreteLieFlow, PreservesAreasOnPolygonsThatAreNotConvexWithoutFolds) {
  const DiskMesh disk(bumpyDisk(24, 0.8));
  for (const PlanarDomain& domain : {letterL(), letterU(), star()}) {
    DiscreteLieFlowOptions options;
    options.domain = domain;
    options.tolerance = 0.02;
    const Points2 start = tutte(disk, domain);
    EXPECT_GT(countFlippedFaces(start, disk.mesh().faces()), 0);
    const DiscreteLieFlowResult result = discreteLieFlow(disk, start, TargetMeasure(disk.mesh()), options);
    EXPECT_EQ(result.status, Status::Converged) << result.residual;
    EXPECT_EQ(countFlippedFaces(result.image, disk.mesh().faces()), 0);
    EXPECT_LT(measureDistortion(disk.mesh(), result.image).summary.areaDistortion, 2.01);
    for (const int v : disk.boundary()) EXPECT_LT(distanceToSides(domain, result.image.row(v)), 1e-12);
    EXPECT_NEAR(signedFaceAreas(result.image, disk.mesh().faces()).sum(), domain.area(), 1e-9);
  }
}

TEST(LieAdvection, ReachesPolygonsThatAreNotConvex) {
  const DiskMesh disk(bumpyDisk(24, 0.8));
  LieAdvectionOptions options;
  options.domain = letterL();
  options.steps = 30;
  const auto result = lieAdvection(disk, tutte(disk, options.domain), TargetMeasure(disk.mesh()), options);
  EXPECT_EQ(result.flippedFaces, countFlippedFaces(result.image, disk.mesh().faces()));
  EXPECT_EQ(result.flippedFaces, 0);
  EXPECT_LT(result.residual, 0.1);
}

TEST(DiscreteLieFlow, RefusesAPolygonWhereNoMapOfTheMeshIsWithoutFolds) {
  const DiskMesh fan(bumpyDisk(1, 0.1));  // from no place does its one inner vertex see the whole of a Z
  Points2 corners(6, 2);
  corners << 0, 3, 2.7, 2.9, 0, 0, 3, 0, 0.3, 0.1, 3, 3;
  DiscreteLieFlowOptions options;
  options.domain = PlanarDomain::polygon(corners);
  EXPECT_THROW((void)discreteLieFlow(fan, tutte(fan, options.domain), TargetMeasure(fan.mesh()), options),
               GeometryError);
}

TEST(PolygonMesh, CoversItsPolygonWithTheGivenBoundary) {
  Points2 boundary(8, 2);
  boundary << 0, 0, 1, 0, 2, 0, 2, 1, 1, 1, 1, 2, 0, 2, 0, 1;
  const PolygonMesh mesh = polygonMesh(boundary, {0, 2, 3, 4, 5, 6}, 0.01);
  EXPECT_EQ(mesh.points.topRows(8), boundary);
  const Eigen::VectorXd areas = signedFaceAreas(mesh.points, mesh.faces);
  EXPECT_GT(areas.minCoeff(), 0);
  EXPECT_LE(areas.maxCoeff(), 0.01);
  EXPECT_NEAR(areas.sum(), 3, 1e-12);
  const SurfaceTopology topology(mesh.faces, static_cast<int>(mesh.points.rows()));
  EXPECT_TRUE(topology.manifold());
  ASSERT_EQ(topology.boundaryLoops().size(), 1u);
  EXPECT_EQ(topology.boundaryLoops().front().size(), 8u);
}

TEST(Untangle, PutsAVertexBackIntoTheKernelOfItsStarAndLeavesTheRestAlone) {
  const TriangleMesh flat = diskMesh(6);
  Points2 image = flat.points().leftCols(2);
  image.row(0) << 0.6, 0.5;
  ASSERT_GT(countFlippedFaces(image, flat.faces()), 0);
  const UnfoldResult result = untangle(SurfaceTopology(flat.faces(), flat.vertexCount()), image);
  EXPECT_EQ(result.flippedFaces, 0);
  EXPECT_EQ(result.image.bottomRows(6), image.bottomRows(6));
  EXPECT_GT(signedFaceAreas(result.image, flat.faces()).minCoeff(), 0);
}

TEST(Untangle, CountsWhatItCannotRepair) {
  Points2 image(4, 2);  // a vertex that sees only a part of the notched triangle around it, which has no kernel
  image << 0, 0, 1, 0, 0.5, -1, 0.5, 1;
  Faces faces(2, 3);
  faces << 0, 1, 3, 1, 0, 2;
  faces.row(0) << 0, 3, 1;  // all vertices are on the boundary: nothing may move
  const UnfoldResult result = untangle(SurfaceTopology(faces, 4), image);
  EXPECT_EQ(result.image, image);
  EXPECT_EQ(result.flippedFaces, countFlippedFaces(image, faces));
}

TEST(CircleDomainLieFlow, OfARadialDensityConvergesToItsClosedForm) {
  // r'² = a² + (1 − a²) (M(r) − M(a))/(M(1) − M(a)), M = r²/2 + r³/3, where the hole keeps its share a² of the disk.
  constexpr double a = 0.4;
  const auto measure = [](double r) { return r * r / 2 + r * r * r / 3; };
  double before = 0;
  for (const int rings : {4, 8, 16}) {
    const RadialCase radial(rings);
    CircleDomainLieFlowOptions options;
    options.concentric = true;
    options.holeAreas = {M_PI * a * a};
    options.flow.finish = LieFlowFinish::None;
    options.flow.tolerance = 1e-4;
    const auto result = circleDomainLieFlow(radial.surface, radial.target, options);
    EXPECT_EQ(result.flippedFaces, 0);
    EXPECT_LT(result.residual, 0.03);
    EXPECT_LT(result.holeResidual, 1e-12);
    double error = 0;
    const int n = radial.surface.mesh().vertexCount();
    for (int v = 0; v < n; ++v) {
      const double r = radial.surface.mesh().point(v).norm();
      const double exact = std::sqrt(
          a * a + (1 - a * a) * (measure(r) - measure(a)) / (measure(1) - measure(a)));
      error += std::abs(result.image.row(v).norm() - exact) / n;
    }
    if (rings > 4) { EXPECT_GT(before / error, 2) << rings; }
    before = error;
  }
  EXPECT_LT(before, 1e-3);
}

TEST(CircleDomainLieFlow, KeepsEveryLoopOnItsCircleAndEveryHoleAtItsArea) {
  const PolyAnnulusMesh surface(holedDisk(24, {{{0.45, 0.1}, 0.15}, {{-0.3, -0.35}, 0.2}}));
  Eigen::VectorXd density = Eigen::VectorXd::Ones(surface.mesh().faceCount());
  for (int f = 0; f < surface.mesh().faceCount(); ++f) {
    if (surface.mesh().corner(f, 0).x() < -0.4) density[f] = 3;
  }
  const auto target = TargetMeasure::fromFaceDensity(surface.mesh(), density);
  CircleDomainLieFlowOptions options;
  options.holeAreas = {0.2, 0.1};
  const auto result = circleDomainLieFlow(surface, target, options);
  EXPECT_EQ(result.status, Status::Converged) << result.residual;
  EXPECT_EQ(countFlippedFaces(result.image, surface.mesh().faces()), 0);
  EXPECT_LT(result.holeResidual, 1e-12);
  EXPECT_LT(measureDistortion(surface.mesh(), result.image, target.faces()).summary.areaDistortion, 2.005);
  for (std::size_t k = 0; k < 3; ++k) {
    for (const int v : surface.loops()[k]) {
      EXPECT_NEAR((result.image.row(v) - result.circles[k].centre).norm(), result.circles[k].radius, 1e-12);
    }
  }
}

TEST(CircleDomainLieFlow, RefusesHolesThatDoNotFitAndStopsWhenAsked) {
  const PolyAnnulusMesh surface(holedDisk(12, {{{0.45, 0.1}, 0.15}, {{-0.3, -0.35}, 0.2}}));
  const TargetMeasure target(surface.mesh());
  CircleDomainLieFlowOptions options;
  options.concentric = true;
  EXPECT_THROW((void)circleDomainLieFlow(surface, target, options), TopologyError);
  options = {};
  options.holeAreas = {1};
  EXPECT_THROW((void)circleDomainLieFlow(surface, target, options), InvalidArgument);
  options.holeAreas = {90, 90};
  EXPECT_THROW((void)circleDomainLieFlow(surface, target, options), GeometryError);
  options = {};
  options.flow.tolerance = 0;
  EXPECT_THROW((void)circleDomainLieFlow(surface, target, options), InvalidArgument);
  const auto result = circleDomainLieFlow(surface, target, {}, Execution({}, [] { return true; }));
  EXPECT_EQ(result.status, Status::Cancelled);
}
