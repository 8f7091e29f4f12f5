/// Transport of surfaces with holes: closed forms of rotational symmetry, masses, refusals.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "Core/authalic/CircleDomainFinish.h"
#include "Core/authalic/TargetMeasure.h"
#include "Core/base/Error.h"
#include "Core/distortion/Distortion.h"
#include "Core/geometry/Areas.h"
#include "Core/transport/PolyAnnulusTransportMap.h"
#include "support/HoledMeshes.h"
#include "support/OffFile.h"
#include "support/SharedData.h"

namespace {

using namespace authalic;
using authalic::testing::holedDisk;
using authalic::testing::packed;
using authalic::testing::readOff;
using authalic::testing::revolutionMesh;
using authalic::testing::sharedData;

class PolyAnnulusTransport : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!PowerDiagram::available()) GTEST_SKIP() << "CGAL was not built in";
  }
};

constexpr double kHole = 0.4;  // radius of the hole of the flat ring; of its rim: 1

// The flat ring kHole ≤ r ≤ 1, rings in geometric progression so that faces keep their shape; wider loop first in size.
PolyAnnulusMesh flatRing(int around) {
  const int along = 2 * static_cast<int>(std::lround(-std::log(kHole) * around / (2 * M_PI * std::sqrt(3) / 2) / 2));
  return PolyAnnulusMesh(revolutionMesh(
      around, along, [](double t) { return std::pow(kHole, t); }, [](double) { return 0.0; }));
}

// Where the optimal map takes the circle of radius r of the ring, when the hole gets the share `hole` of the disk:
// as much of the disk lies within.
double radiusOfImage(double r, double hole) {
  return std::sqrt(hole + (1 - hole) * (r * r - kHole * kHole) / (1 - kHole * kHole));
}

// ∫ |x − T(x)|² of it: the hole to its centre, circles to circles.
double costOfClosedForm(double hole) {
  double cost = M_PI * hole * hole / 2;
  constexpr int kSteps = 20000;
  for (int k = 0; k < kSteps; ++k) {
    const double r = kHole + (1 - kHole) * (k + 0.5) / kSteps, s = radiusOfImage(r, hole);
    const double mass = 2 * M_PI * r * (1 - hole) / (1 - kHole * kHole) * (1 - kHole) / kSteps;
    cost += (s - r) * (s - r) * mass;
  }
  return cost;
}

struct RadialErrors {
  double image = 0, cost = 0;  // root mean square of the radii; of the cost
};

RadialErrors radialErrors(int around, double hole) {
  const PolyAnnulusMesh ring = flatRing(around);
  PolyAnnulusTransportOptions options;
  options.holeShare = hole;
  const auto result = polyAnnulusTransportMap(ring, TargetMeasure(ring.mesh()).vertices(), options);
  EXPECT_EQ(result.status, Status::Converged);
  EXPECT_EQ(result.flippedFaces, 0);
  EXPECT_EQ(result.emptyCells, 0);
  RadialErrors errors;
  for (int v = 0; v < ring.mesh().vertexCount(); ++v) {
    const double off = result.image.row(v).norm() - radiusOfImage(ring.mesh().point(v).head<2>().norm(), hole);
    errors.image += off * off / ring.mesh().vertexCount();
  }
  errors.image = std::sqrt(errors.image);
  errors.cost = std::abs(result.transportCost - costOfClosedForm(hole));
  return errors;
}

Eigen::VectorXd equalShares(const PolyAnnulusMesh& surface) {
  return TargetMeasure(surface.mesh()).vertices();
}

// Of the finish: how far circles have moved away from the middles of their cells.
double farthestFromCells(const PolyAnnulusTransportResult& moved, const CircleDomainAuthalicMapResult& finished) {
  double farthest = 0;
  for (std::size_t k = 0, hole = 0; k < finished.circles.size(); ++k) {
    if (static_cast<int>(k) == moved.outerLoop) continue;
    const Eigen::RowVector2d cell = moved.holeCentres.row(static_cast<Eigen::Index>(hole++));
    farthest = std::max(farthest, (finished.circles[k].centre - cell).norm());
  }
  return farthest;
}

CircleDomainAuthalicMapResult finish(const PolyAnnulusMesh& surface, const PolyAnnulusTransportResult& moved,
                                     double tolerance) {
  AuthalicMapOptions solve;
  solve.tolerance = tolerance;
  return finishCircleDomain(surface, TargetMeasure(surface.mesh()), moved.image,
                            {moved.outerLoop, moved.holeCentres, moved.holeAreas, moved.pockets}, solve);
}

// A closed surface without the faces within `radius` of some of its vertices, each as far from the others as can be.
PolyAnnulusMesh punched(const TriangleMesh& closed, int holes, double radius) {
  const Points3& points = closed.points();
  Eigen::VectorXd away = (points.rowwise() - points.colwise().mean()).rowwise().norm();
  Eigen::VectorXd nearest = Eigen::VectorXd::Constant(away.size(), std::numeric_limits<double>::infinity());
  for (int hole = 0; hole < holes; ++hole) {
    Eigen::Index seed = 0;
    (void)(hole == 0 ? away : nearest).maxCoeff(&seed);
    nearest = nearest.cwiseMin((points.rowwise() - points.row(seed)).rowwise().norm());
  }
  std::vector<Eigen::RowVector3i> kept;
  for (Eigen::Index f = 0; f < closed.faces().rows(); ++f) {
    const Eigen::RowVector3i t = closed.faces().row(f);
    if (std::min({nearest[t[0]], nearest[t[1]], nearest[t[2]]}) > radius) kept.push_back(t);
  }
  return PolyAnnulusMesh(packed(points, kept));
}

}  // namespace

TEST_F(PolyAnnulusTransport, OfAFlatRingIsTheRadialMapOfClosedFormToSecondOrder) {
  for (const double hole : {0.04, kHole * kHole, 0.45}) {
    const RadialErrors coarse = radialErrors(48, hole), fine = radialErrors(96, hole);
    EXPECT_GT(std::log2(coarse.image / fine.image), 1.7) << hole << ": " << coarse.image << ", " << fine.image;
    EXPECT_GT(std::log2(coarse.cost / fine.cost), 1.7) << hole << ": " << coarse.cost << ", " << fine.cost;
    EXPECT_LT(fine.image, 2e-3) << hole;
  }
}

TEST_F(PolyAnnulusTransport, GivesCellsOfHolesAndVerticesTheirMasses) {
  const PolyAnnulusMesh surface(holedDisk(24, {{{0.45, 0.1}, 0.15}, {{-0.3, -0.35}, 0.2}}));
  const double area = faceAreas(surface.mesh()).sum();
  const Eigen::Index n = surface.mesh().vertexCount();
  Eigen::VectorXd density = Eigen::VectorXd::Ones(n);
  for (int v = 0; v < n; ++v) {
    if (surface.mesh().point(v).x() < -0.4) density[v] = 3;
  }
  const TargetMeasure target = TargetMeasure::fromVertexDensity(surface.mesh(), density);
  PolyAnnulusTransportOptions options;
  options.holeAreas = {0.4, 0.1};
  const auto result = polyAnnulusTransportMap(surface, target.vertices(), options);
  ASSERT_EQ(result.status, Status::Converged);
  const Eigen::VectorXd wanted = M_PI * area / (area + 0.5) * target.vertices();
  const double mean = M_PI / static_cast<double>(n + 2);
  EXPECT_LT((result.cellAreas.head(n) - wanted).cwiseAbs().maxCoeff(), 1e-9 * mean);
  EXPECT_NEAR(result.cellAreas[n], M_PI * 0.4 / (area + 0.5), 1e-9 * mean);
  EXPECT_NEAR(result.cellAreas[n + 1], M_PI * 0.1 / (area + 0.5), 1e-9 * mean);
}

TEST_F(PolyAnnulusTransport, DividesAShareOfTheDiskAmongTheHolesAsTheirDisksOrAreas) {
  const PolyAnnulusMesh surface(holedDisk(20, {{{0.45, 0.1}, 0.15}, {{-0.3, -0.35}, 0.2}}));
  const Eigen::Index n = surface.mesh().vertexCount();
  PolyAnnulusTransportOptions options;
  options.holeShare = 0.3;
  const auto disks = polyAnnulusTransportMap(surface, equalShares(surface), options);
  const std::size_t first = disks.outerLoop == 0 ? 1 : 0, second = disks.outerLoop == 2 ? 1 : 2;
  const double ratio = std::pow(disks.circles[first].radius / disks.circles[second].radius, 2);
  EXPECT_NEAR(disks.masses.tail(2).sum(), 0.3 * M_PI, 1e-12);
  EXPECT_NEAR(disks.masses[n] / disks.masses[n + 1], ratio, 1e-12);
  options.holeAreas = {2, 1};
  const auto areas = polyAnnulusTransportMap(surface, equalShares(surface), options);
  EXPECT_NEAR(areas.masses[n], 0.2 * M_PI, 1e-12);
  EXPECT_NEAR(areas.masses[n + 1], 0.1 * M_PI, 1e-12);
  EXPECT_NEAR(areas.holeAreas[0] / faceAreas(surface.mesh()).sum(), 0.2 / 0.7, 1e-12);
}

TEST_F(PolyAnnulusTransport, KeepsTheLoopsOnTheCircleAndOnTheOutlinesOfTheHoles) {
  const PolyAnnulusMesh surface(holedDisk(20, {{{0.45, 0.1}, 0.15}, {{-0.3, -0.35}, 0.2}}));
  const auto result = polyAnnulusTransportMap(surface, equalShares(surface));
  for (const int v : surface.loops()[static_cast<std::size_t>(result.outerLoop)]) {
    EXPECT_NEAR(result.image.row(v).norm(), 1, 1e-15);
  }
  const std::size_t n = static_cast<std::size_t>(surface.mesh().vertexCount());
  for (std::size_t k = 0, hole = 0; k < 3; ++k) {
    if (static_cast<int>(k) == result.outerLoop) continue;
    const auto outline = result.cells.corners.middleRows(result.cells.starts[n + hole],
                                                         result.cells.starts[n + hole + 1] -
                                                             result.cells.starts[n + hole]);
    ++hole;
    for (const int v : surface.loops()[k]) {
      double off = 1;  // from the nearest line through a side
      for (Eigen::Index c = 0; c < outline.rows(); ++c) {
        const Eigen::RowVector2d a = outline.row(c), along = outline.row((c + 1) % outline.rows()) - a;
        const Eigen::RowVector2d arm = result.image.row(v) - a;
        if (along.norm() > 1e-12) off = std::min(off, std::abs(along[0] * arm[1] - along[1] * arm[0]) / along.norm());
      }
      EXPECT_LT(off, 1e-12);
    }
  }
}

TEST_F(PolyAnnulusTransport, IsFinishedToExactStarsAndRoundHoles) {
  const PolyAnnulusMesh surface(holedDisk(20, {{{0.45, 0.1}, 0.15}, {{-0.3, -0.35}, 0.2}}));
  PolyAnnulusTransportOptions options;
  options.holeAreas = {0.2, 0.05};
  const auto moved = polyAnnulusTransportMap(surface, equalShares(surface), options);
  const auto finished = finish(surface, moved, 0.05);
  EXPECT_EQ(finished.status, Status::Converged);
  EXPECT_EQ(finished.flippedFaces, 0);
  EXPECT_LT(finished.vertexResidual, 1e-9);
  EXPECT_LT(finished.holeResidual, 1e-12);
  for (const FittedCircle& circle : finished.circles) EXPECT_LT(circle.deviation, 1e-12);
  EXPECT_LT(farthestFromCells(moved, finished), 1e-12);
}

TEST_F(PolyAnnulusTransport, FinishMovesHolesApartThatAreTooLargeToBeRoundInTheirCells) {
  const PolyAnnulusMesh surface(holedDisk(24, {{{0.22, 0.0}, 0.15}, {{-0.22, 0.0}, 0.15}, {{0.0, 0.6}, 0.15}}));
  PolyAnnulusTransportOptions options;
  options.holeShare = 0.4;
  const auto moved = polyAnnulusTransportMap(surface, equalShares(surface), options);
  const auto finished = finish(surface, moved, 0.1);
  EXPECT_EQ(finished.status, Status::Converged);
  EXPECT_EQ(finished.flippedFaces, 0);
  EXPECT_LT(finished.holeResidual, 1e-12);
  EXPECT_GT(farthestFromCells(moved, finished), 1e-6);
  for (const FittedCircle& circle : finished.circles) EXPECT_LT(circle.deviation, 1e-12);
}

TEST_F(PolyAnnulusTransport, OfAHeadWithSevenPatchesCutOutIsFinished) {
  const std::string path = sharedData("meshes/closed_g0/david.off");
  AUTHALIC_NEEDS(path);
  const PolyAnnulusMesh surface = punched(readOff(path), 7, 0.15);
  const auto moved = polyAnnulusTransportMap(surface, equalShares(surface));
  const auto finished = finish(surface, moved, 2e-2);
  EXPECT_EQ(surface.loops().size(), 7U);
  EXPECT_EQ(finished.status, Status::Converged);
  EXPECT_EQ(finished.flippedFaces, 0);
  EXPECT_LT(finished.vertexResidual, 1e-10);
  EXPECT_LT(finished.holeResidual, 1e-12);
  EXPECT_GT(farthestFromCells(moved, finished), 1e-6);
}

TEST_F(PolyAnnulusTransport, OfRealFacesIsExactWithinTenSteps) {
  for (const char* name : {"sophie", "alex_3"}) {
    const std::string path = sharedData("meshes/poly_annulus/" + std::string(name) + ".off");
    AUTHALIC_NEEDS(path);
    const PolyAnnulusMesh surface(readOff(path));
    const auto result = polyAnnulusTransportMap(surface, equalShares(surface));
    EXPECT_EQ(result.status, Status::Converged);
    EXPECT_LE(result.iterations, 10);
    EXPECT_EQ(result.emptyCells, 0);
    for (const TransportIteration& step : result.history) EXPECT_GT(step.smallestCell, 0);
  }
}

TEST_F(PolyAnnulusTransport, OfADiskIsTransportFromTheConformalMap) {
  const PolyAnnulusMesh surface(authalic::testing::bumpyDisk(10));
  const auto result = polyAnnulusTransportMap(surface, equalShares(surface));
  EXPECT_EQ(result.status, Status::Converged);
  EXPECT_EQ(result.holeCentres.rows(), 0);
  EXPECT_EQ(result.cellAreas.size(), surface.mesh().vertexCount());
}

TEST_F(PolyAnnulusTransport, RefusesAreasAndSharesThatDoNotBelong) {
  const PolyAnnulusMesh surface(holedDisk(12, {{{0.45, 0.1}, 0.15}, {{-0.3, -0.35}, 0.2}}));
  const Eigen::VectorXd shares = equalShares(surface);
  PolyAnnulusTransportOptions options;
  const auto map = [&] { (void)polyAnnulusTransportMap(surface, shares, options); };
  for (const std::vector<double>& areas : {std::vector<double>{1}, {1, -1}, {1, std::nan("")}}) {
    options.holeAreas = areas;
    EXPECT_THROW(map(), InvalidArgument);
  }
  options.holeAreas.clear();
  for (const double share : {-0.1, 1.0, std::nan("")}) {
    options.holeShare = share;
    EXPECT_THROW(map(), InvalidArgument);
  }
  options.holeShare = 0;
  options.outerLoop = 3;
  EXPECT_THROW(map(), InvalidArgument);
  options.outerLoop = -1;
  EXPECT_THROW((void)polyAnnulusTransportMap(surface, shares.head(5), options), GeometryError);
  EXPECT_THROW((void)polyAnnulusTransportMap(surface, -shares, options), GeometryError);
  const PolyAnnulusMesh disk(authalic::testing::diskMesh(4));
  options.holeShare = 0.2;
  EXPECT_THROW((void)polyAnnulusTransportMap(disk, equalShares(disk), options), InvalidArgument);
}

TEST_F(PolyAnnulusTransport, FinishRefusesHolesThatDoNotBelongOrDoNotFit) {
  const PolyAnnulusMesh surface(holedDisk(12, {{{0.45, 0.1}, 0.15}, {{-0.3, -0.35}, 0.2}}));
  const TargetMeasure target(surface.mesh());
  const auto moved = polyAnnulusTransportMap(surface, target.vertices());
  HolesInDisk holes{moved.outerLoop, moved.holeCentres, moved.holeAreas, moved.pockets};
  EXPECT_THROW((void)finishCircleDomain(surface, target, moved.image.topRows(4), holes), GeometryError);
  holes.areas.pop_back();
  EXPECT_THROW((void)finishCircleDomain(surface, target, moved.image, holes), GeometryError);
  holes.areas = {1e4, 1e4};
  EXPECT_THROW((void)finishCircleDomain(surface, target, moved.image, holes), GeometryError);
}

TEST_F(PolyAnnulusTransport, StopsWhenAskedAndSaysSo) {
  const PolyAnnulusMesh surface(holedDisk(12, {{{0.45, 0.1}, 0.15}, {{-0.3, -0.35}, 0.2}}));
  const Execution execution({}, [] { return true; });
  const auto result = polyAnnulusTransportMap(surface, equalShares(surface), {}, execution);
  EXPECT_EQ(result.status, Status::Cancelled);
}
