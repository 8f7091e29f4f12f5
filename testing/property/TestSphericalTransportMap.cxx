#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "Core/authalic/SphericalAuthalicMap.h"
#include "Core/authalic/TargetMeasure.h"
#include "Core/base/Error.h"
#include "Core/distortion/SphericalDistortion.h"
#include "Core/transport/SphericalTransportMap.h"
#include "support/TestMeshes.h"

using namespace authalic;
using namespace authalic::testing;

namespace {

class SphericalTransportMap : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!PowerDiagram::available()) GTEST_SKIP() << "CGAL was not built in";
  }
};

double distanceFromRound(int levels) {
  const SphereMesh sphere(sphereMesh(levels));
  const SphericalTransportMapResult map =
      sphericalTransportMap(sphere, TargetMeasure(sphere.mesh()).vertices(), {}, sphere.mesh().points());
  EXPECT_EQ(map.status, Status::Converged);
  EXPECT_EQ(map.flippedFaces, 0);
  return (map.image - sphere.mesh().points()).norm() / std::sqrt(sphere.mesh().vertexCount());
}

}  // namespace

TEST_F(SphericalTransportMap, GivesEveryCellItsShare) {
  const SphereMesh sphere(wavySphere(4));
  const SphericalTransportMapResult map = sphericalTransportMap(sphere, TargetMeasure(sphere.mesh()).vertices());
  EXPECT_EQ(map.status, Status::Converged);
  EXPECT_EQ(map.emptyCells, 0);
  EXPECT_LE(map.iterations, 25);
  const double mean = 4 * M_PI / sphere.mesh().vertexCount();
  EXPECT_LE((map.cellAreas - map.masses).cwiseAbs().maxCoeff(), 1e-9 * mean);
  EXPECT_LT((map.image.rowwise().norm().array() - 1).abs().maxCoeff(), 1e-14);
  EXPECT_EQ(map.cells.starts.size(), static_cast<std::size_t>(sphere.mesh().vertexCount()) + 1);
  for (Eigen::Index i = 0; i < map.sites.rows(); ++i) {  // the middle of cell i belongs to cell i
    const Eigen::VectorXd products = map.sites * map.image.row(i).transpose();
    double highest = -INFINITY;
    for (Eigen::Index j = 0; j < products.size(); ++j) {
      if (products[j] > 0) highest = std::max(highest, std::log(products[j]) + static_cast<double>(map.heights[j]));
    }
    EXPECT_NEAR(map.potential[i], highest, 1e-13);
  }
}

TEST_F(SphericalTransportMap, OfARoundSphereApproachesTheIdentity) {
  const double coarse = distanceFromRound(3), fine = distanceFromRound(4);
  EXPECT_GT(coarse / fine, 2.0) << coarse << ' ' << fine;
}

TEST_F(SphericalTransportMap, IsFinishedByTheAuthalicMap) {
  const SphereMesh sphere(wavySphere(4));
  const TargetMeasure target(sphere.mesh());
  const SphericalTransportMapResult map = sphericalTransportMap(sphere, target.vertices());
  const SphericalAuthalicMapResult finished = sphericalAuthalicMap(sphere, target, {}, map.image);
  EXPECT_EQ(finished.status, Status::Converged);
  EXPECT_EQ(finished.flippedFaces, 0);
  EXPECT_LT(measureSphericalDistortion(sphere.mesh(), finished.image).summary.areaDistortion,
            measureSphericalDistortion(sphere.mesh(), map.image).summary.areaDistortion);
}

TEST_F(SphericalTransportMap, InAStereographicPlaneGivesEveryCellItsShareAndDependsOnThePole) {
  const SphereMesh sphere(wavySphere(4));
  const Eigen::VectorXd shares = TargetMeasure(sphere.mesh()).vertices();
  SphericalTransportMapOptions options;
  options.formulation = SphereFormulation::Stereographic;
  const SphericalTransportMapResult map = sphericalTransportMap(sphere, shares, options);
  EXPECT_EQ(map.status, Status::Converged);
  EXPECT_LE((map.cellAreas - map.masses).cwiseAbs().maxCoeff(), 1e-9 * 4 * M_PI / sphere.mesh().vertexCount());
  EXPECT_NEAR(map.cellAreas.sum(), 4 * M_PI, 1e-12);
  EXPECT_LT((map.image.rowwise().norm().array() - 1).abs().maxCoeff(), 1e-14);
  EXPECT_LT((map.pole - defaultPole(map.sites, sphere.mesh().faces())).norm(), 1e-15);
  options.pole = -map.pole;
  const SphericalTransportMapResult other = sphericalTransportMap(sphere, shares, options, map.sites);
  EXPECT_EQ(other.status, Status::Converged);
  EXPECT_GT((other.image - map.image).rowwise().norm().maxCoeff(), 0.1);
}

TEST_F(SphericalTransportMap, InAStereographicPlaneTurnsWithTheSphereAndItsPole) {
  const SphereMesh sphere(wavySphere(3));
  const Eigen::VectorXd shares = TargetMeasure(sphere.mesh()).vertices();
  SphericalTransportMapOptions options;
  options.formulation = SphereFormulation::Stereographic;
  options.pole = Eigen::Vector3d(0.2, 0.3, -2);
  const SphericalTransportMapResult map = sphericalTransportMap(sphere, shares, options);
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(1.1, Eigen::Vector3d(1, 2, 2) / 3).matrix();
  options.pole = turn * options.pole;
  const Points3 turned = map.sites * turn.transpose();
  const SphericalTransportMapResult other = sphericalTransportMap(sphere, shares, options, turned);
  EXPECT_LT((other.image - map.image * turn.transpose()).cwiseAbs().maxCoeff(), 1e-8);
}

TEST_F(SphericalTransportMap, InAStereographicPlaneIsFinishedByTheAuthalicMap) {
  const SphereMesh sphere(wavySphere(4));
  const TargetMeasure target(sphere.mesh());
  SphericalTransportMapOptions options;
  options.formulation = SphereFormulation::Stereographic;
  const SphericalTransportMapResult map = sphericalTransportMap(sphere, target.vertices(), options);
  const SphericalAuthalicMapResult finished = sphericalAuthalicMap(sphere, target, {}, map.image);
  EXPECT_EQ(finished.status, Status::Converged);
  EXPECT_EQ(finished.flippedFaces, 0);
}

TEST_F(SphericalTransportMap, RefusesAPoleAtAVertexOrWithoutAProjection) {
  const SphereMesh sphere(sphereMesh(2));
  const Eigen::VectorXd shares = TargetMeasure(sphere.mesh()).vertices();
  SphericalTransportMapOptions options;
  options.pole = Eigen::Vector3d(0, 0, 1);
  EXPECT_THROW((void)sphericalTransportMap(sphere, shares, options), InvalidArgument);
  options.formulation = SphereFormulation::Stereographic;
  options.pole = sphere.mesh().points().row(7).transpose();
  EXPECT_THROW((void)sphericalTransportMap(sphere, shares, options, sphere.mesh().points()), GeometryError);
  options.pole = Eigen::Vector3d(0, NAN, 1);
  EXPECT_THROW((void)sphericalTransportMap(sphere, shares, options), InvalidArgument);
}

TEST_F(SphericalTransportMap, RefusesWhatDoesNotBelongTogether) {
  const SphereMesh sphere(sphereMesh(2));
  const Eigen::VectorXd shares = TargetMeasure(sphere.mesh()).vertices();
  EXPECT_THROW((void)sphericalTransportMap(sphere, shares.head(5)), GeometryError);
  EXPECT_THROW((void)sphericalTransportMap(sphere, shares, {}, Points3::Zero(3, 3)), GeometryError);
  EXPECT_THROW((void)sphericalTransportMap(sphere, shares, {}, 2 * sphere.mesh().points()), GeometryError);
  SphericalTransportMapOptions options;
  options.tolerance = -1;
  EXPECT_THROW((void)sphericalTransportMap(sphere, shares, options), InvalidArgument);
}
