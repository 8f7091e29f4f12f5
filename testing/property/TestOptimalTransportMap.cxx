#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>

#include "Core/authalic/AuthalicMap.h"
#include "Core/base/Error.h"
#include "Core/distortion/Distortion.h"
#include "Core/geometry/Areas.h"
#include "Core/initial/BarycentricMap.h"
#include "Core/initial/BoundaryPlacement.h"
#include "Core/transport/OptimalTransportMap.h"
#include "support/TestMeshes.h"

using namespace authalic;
using namespace authalic::testing;

namespace {

class OptimalTransportMap : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!PowerDiagram::available()) GTEST_SKIP() << "CGAL was not built in";
  }
};

OptimalTransportMapResult transported(const DiskMesh& disk, const PlanarDomain& domain = {}) {
  OptimalTransportMapOptions options;
  options.domain = domain;
  return optimalTransportMap(disk, TargetMeasure(disk.mesh()).vertices(), options);
}

// Root mean square of how far vertices move from the density that their own harmonic map has.
double distanceFromOwnDensity(int rings) {
  const DiskMesh disk(bumpyDisk(rings));
  BarycentricMapOptions harmonic;
  harmonic.weights = BarycentricWeights::Harmonic;
  const Points2 sites = barycentricMap(disk, harmonic).image;
  const Eigen::VectorXd shares = TargetMeasure(disk.mesh()).vertices();
  const Eigen::VectorXd image = vertexStars(signedFaceAreas(sites, disk.mesh().faces()), disk.mesh().faces(),
                                            disk.mesh().vertexCount());
  Points3 places = Points3::Zero(sites.rows(), 3);
  places.leftCols(2) = sites;
  OptimalTransportMapOptions options;
  options.source = std::make_shared<const PiecewiseLinearDensity>(
      PlanarDomain::disk(), DiskMesh(TriangleMesh(places, disk.mesh().faces())), shares.cwiseQuotient(image));
  const OptimalTransportMapResult map = optimalTransportMap(disk, shares, options, sites);
  EXPECT_EQ(map.status, Status::Converged);
  return (map.image - sites).norm() / std::sqrt(disk.mesh().vertexCount());
}

double distanceFromFlat(int rings) {
  const DiskMesh disk(diskMesh(rings));
  const OptimalTransportMapResult map = transported(disk);
  EXPECT_EQ(map.flippedFaces, 0);
  return (map.image - Points2(disk.mesh().points().leftCols(2))).norm() / std::sqrt(disk.mesh().vertexCount());
}

}  // namespace

TEST_F(OptimalTransportMap, GivesEveryCellItsShareAndKeepsTheBoundary) {
  Points2 triangle(3, 2);
  triangle << 0, 0, 2, 0, 0.5, 1.5;
  for (const PlanarDomain& domain :
       {PlanarDomain::disk(), PlanarDomain::square(), PlanarDomain::rectangle(3), PlanarDomain::polygon(triangle)}) {
    const DiskMesh disk(bumpyDisk(12, 1.5));
    const OptimalTransportMapResult map = transported(disk, domain);
    EXPECT_EQ(map.status, Status::Converged);
    EXPECT_EQ(map.emptyCells, 0);
    const double mean = domain.area() / disk.mesh().vertexCount();
    EXPECT_LE((map.cellAreas - map.masses).cwiseAbs().maxCoeff(), 1e-9 * mean);
    EXPECT_NEAR(map.masses.sum(), domain.area(), 1e-12);
    EXPECT_NO_THROW((void)recogniseBoundary(disk, domain, map.image));
    EXPECT_GT(map.transportCost, 0);
  }
}

TEST_F(OptimalTransportMap, OfAFlatDiskApproachesTheIdentity) {
  const double coarse = distanceFromFlat(8), fine = distanceFromFlat(16);
  EXPECT_GT(coarse / fine, 2.0) << coarse << ' ' << fine;  // boundary cells have their middles half a cell inside
  EXPECT_LT(fine, 0.01);
}

TEST_F(OptimalTransportMap, HasAConvexPotentialWithTheSitesAsGradients) {
  const DiskMesh disk(bumpyDisk(10, 1.0));
  const OptimalTransportMapResult map = transported(disk);
  for (Eigen::Index i = 0; i < map.sites.rows(); ++i) {  // plane i is the highest at the middle of cell i
    if (disk.topology().onBoundary()[static_cast<std::size_t>(i)]) continue;
    const double highest = (map.sites * map.image.row(i).transpose() + map.heights.cast<double>()).maxCoeff();
    EXPECT_NEAR(map.potential[i], highest, 1e-14);
  }
}

TEST_F(OptimalTransportMap, MovesMassesForLessThanTheAuthalicMapDoes) {
  const DiskMesh disk(bumpyDisk(14, 1.5));
  const TargetMeasure target(disk.mesh());
  const OptimalTransportMapResult map = transported(disk);
  const AuthalicMapResult finished = authalicMap(disk, target, {}, map.image);
  EXPECT_EQ(finished.status, Status::Converged);
  EXPECT_EQ(finished.flippedFaces, 0);
  const DistortionSummary bare = measureDistortion(disk.mesh(), map.image).summary;
  const DistortionSummary exact = measureDistortion(disk.mesh(), finished.image).summary;
  EXPECT_LT(exact.areaDistortion, bare.areaDistortion);
  const double before = displacementCost(map.masses, map.sites, map.image);
  EXPECT_LE(before, map.transportCost);  // Jensen: the middle of a cell is nearer than its points on average
  EXPECT_LT(before, displacementCost(map.masses, map.sites, finished.image));
}

TEST_F(OptimalTransportMap, FollowsAMeasureAndAGivenStart) {
  const DiskMesh disk(diskMesh(10));
  Eigen::VectorXd density = Eigen::VectorXd::Ones(disk.mesh().vertexCount());
  density.head(37).setConstant(4);
  const Eigen::VectorXd shares = TargetMeasure::fromVertexDensity(disk.mesh(), density).vertices();
  const OptimalTransportMapResult map = optimalTransportMap(disk, shares, {}, disk.mesh().points().leftCols(2));
  EXPECT_EQ(map.status, Status::Converged);
  EXPECT_LT((map.sites - Points2(disk.mesh().points().leftCols(2))).cwiseAbs().maxCoeff(), 1e-15);
  EXPECT_NEAR(map.cellAreas.head(37).sum(), M_PI * shares.head(37).sum(), 1e-9);
}

TEST_F(OptimalTransportMap, RefusesWhatDoesNotBelongTogether) {
  const DiskMesh disk(diskMesh(4));
  const Eigen::VectorXd shares = TargetMeasure(disk.mesh()).vertices();
  EXPECT_THROW((void)optimalTransportMap(disk, shares.head(5)), GeometryError);
  EXPECT_THROW((void)optimalTransportMap(disk, 2 * shares), GeometryError);
  EXPECT_THROW((void)optimalTransportMap(disk, shares, {}, Points2::Zero(3, 2)), GeometryError);
  Points2 collapsed = disk.mesh().points().leftCols(2);
  collapsed.row(3) = collapsed.row(1);
  try {
    (void)optimalTransportMap(disk, shares, {}, collapsed);
    FAIL() << "a collapsed map was taken";
  } catch (const GeometryError& error) {
    EXPECT_NE(std::string(error.what()).find("vertices 1 and 3"), std::string::npos) << error.what();
  }
  Points2 arrow(4, 2);
  arrow << 0, 0, 2, 1, 0, 2, 1, 1;
  OptimalTransportMapOptions options;
  options.domain = PlanarDomain::polygon(arrow);
  EXPECT_THROW((void)optimalTransportMap(disk, shares, options), InvalidArgument);
}

TEST_F(OptimalTransportMap, GivesEveryCellItsShareOfASourceDensity) {
  Points2 triangle(3, 2);
  triangle << 0, 0, 2, 0, 0.5, 1.5;
  for (const PlanarDomain& domain : {PlanarDomain::disk(), PlanarDomain::square(), PlanarDomain::polygon(triangle)}) {
    const TriangleMesh grid = gridMesh(20, 20, 4, 4);
    const TriangleMesh mesh(grid.points().rowwise() - Eigen::RowVector3d(1.5, 1.5, 0), grid.faces());
    const Eigen::VectorXd values = (2 * mesh.points().leftCols(2).rowwise().norm().array()).cos() + 1.1;
    OptimalTransportMapOptions options;
    options.domain = domain;
    options.source = std::make_shared<const PiecewiseLinearDensity>(domain, DiskMesh(mesh), values);
    const DiskMesh disk(bumpyDisk(12, 1.5));
    const Eigen::VectorXd shares = TargetMeasure(disk.mesh()).vertices();
    const OptimalTransportMapResult map = optimalTransportMap(disk, shares, options);
    EXPECT_EQ(map.status, Status::Converged);
    EXPECT_EQ(map.emptyCells, 0);
    const int n = disk.mesh().vertexCount();
    EXPECT_LE((map.cellMasses / options.source->total() - shares).cwiseAbs().maxCoeff() * n, 1e-9);
    EXPECT_NEAR(map.cellAreas.sum(), domain.area(), 1e-12);
    EXPECT_GT((map.cellAreas / domain.area() - shares).cwiseAbs().maxCoeff() * n, 0.1);
    EXPECT_NO_THROW((void)recogniseBoundary(disk, domain, map.image));
    options.domain = PlanarDomain::rectangle(3);
    EXPECT_THROW((void)optimalTransportMap(disk, shares, options), InvalidArgument);
  }
}

TEST_F(OptimalTransportMap, FromTheDensityOfItsOwnInitialMapApproachesTheIdentity) {
  const double coarse = distanceFromOwnDensity(8), middle = distanceFromOwnDensity(16);
  const double fine = distanceFromOwnDensity(32);
  EXPECT_GT(coarse / middle, 2.0) << coarse << ' ' << middle;
  EXPECT_GT(middle / fine, 2.0) << middle << ' ' << fine;
  EXPECT_LT(fine, 0.01);
}
