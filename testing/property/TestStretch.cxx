#include <gtest/gtest.h>

#include <cmath>

#include "Core/authalic/AuthalicMap.h"
#include "Core/authalic/StretchEnergyMap.h"
#include "Core/base/Error.h"
#include "Core/distortion/Distortion.h"
#include "Core/geometry/Areas.h"
#include "Core/initial/BarycentricMap.h"
#include "Core/initial/StretchMinimisation.h"
#include "support/TestMeshes.h"

using namespace authalic;
using namespace authalic::testing;

namespace {

Points2 start(const DiskMesh& disk, const PlanarDomain& domain = {},
              BarycentricWeights weights = BarycentricWeights::Harmonic) {
  BarycentricMapOptions options;
  options.weights = weights;
  options.domain = domain;
  return barycentricMap(disk, options).image;
}

StretchMinimisationOptions with(BarycentricWeights weights) {
  StretchMinimisationOptions options;
  options.weights = weights;
  return options;
}

// (Σ A (Γ² + γ²)/2)^½ from the singular values of the distortion report, which are those towards the plane.
double stretchOf(const TriangleMesh& surface, const Points2& image) {
  const DistortionArrays arrays = measureDistortion(surface, image).arrays;
  const Eigen::ArrayXd share = faceAreas(surface).array() / faceAreas(surface).sum();
  return std::sqrt((share * 0.5 * (arrays.sigmaMax.array().pow(-2) + arrays.sigmaMin.array().pow(-2))).sum());
}

double areaDistortion(const DiskMesh& disk, const Points2& image) {
  return measureDistortion(disk.mesh(), image).summary.areaDistortion;
}

const BarycentricWeights kConvex[] = {BarycentricWeights::Uniform, BarycentricWeights::MeanValue};

}  // namespace

TEST(StretchMinimisation, LowersTheStretchOfItsFirstMapWithoutAFold) {
  const DiskMesh disk(bumpyDisk(16, 1.5));
  for (const BarycentricWeights weights : kConvex) {
    for (const PlanarDomain& domain : {PlanarDomain::disk(), PlanarDomain::square()}) {
      StretchMinimisationOptions options = with(weights);
      options.domain = domain;
      const StretchMinimisationResult result = stretchMinimisation(disk, options);
      EXPECT_EQ(result.status, Status::Converged);
      EXPECT_EQ(result.flippedFaces, 0);
      ASSERT_GE(result.history.size(), 2u);
      for (std::size_t k = 1; k < result.history.size(); ++k) EXPECT_LT(result.history[k], result.history[k - 1]);
      EXPECT_LT(result.stretch, 0.9 * result.history.front());
      EXPECT_LT(areaDistortion(disk, result.image), areaDistortion(disk, start(disk, domain, weights)));
    }
  }
}

TEST(StretchMinimisation, StretchIsThatOfTheSingularValuesOfTheReport) {
  const DiskMesh disk(bumpyDisk(10, 1.0));
  const StretchMinimisationResult result = stretchMinimisation(disk);
  EXPECT_NEAR(result.stretch, stretchOf(disk.mesh(), result.image), 1e-12);
  EXPECT_NEAR(result.history.front(), stretchOf(disk.mesh(), start(disk, {}, BarycentricWeights::MeanValue)), 1e-12);
}

TEST(StretchMinimisation, LeavesAnIsometryAlone) {
  const TriangleMesh flat = gridMesh(9, 9);
  StretchMinimisationOptions options = with(BarycentricWeights::Harmonic);
  options.domain = PlanarDomain::square();
  options.startVertex = 0;
  const StretchMinimisationResult result = stretchMinimisation(DiskMesh(flat), options);
  EXPECT_NEAR(result.stretch, 1, 1e-12);
  EXPECT_LT((result.image - flat.points().leftCols<2>()).cwiseAbs().maxCoeff(), 1e-10);
}

TEST(StretchMinimisation, KeepsTheBoundaryOfTheBarycentricMap) {
  const DiskMesh disk(bumpyDisk(8, 1.0));
  const Points2 first = start(disk, {}, BarycentricWeights::MeanValue);
  const StretchMinimisationResult result = stretchMinimisation(disk);
  for (const int v : disk.boundary()) EXPECT_EQ(result.image.row(v), first.row(v));
  EXPECT_GT((result.image - first).norm(), 1e-2);
}

TEST(StretchMinimisation, SaysWhenItWasCutShortAndRefusesBadOptions) {
  const DiskMesh disk(bumpyDisk(12, 1.5));
  StretchMinimisationOptions options;
  options.maxIterations = 1;
  const StretchMinimisationResult result = stretchMinimisation(disk, options);
  EXPECT_EQ(result.status, Status::NotConverged);
  EXPECT_EQ(result.iterations, 1);
  int asked = 0;
  const Execution stopping({}, [&] { return ++asked > 1; });
  EXPECT_EQ(stretchMinimisation(disk, {}, stopping).status, Status::Cancelled);
  options.maxIterations = -1;
  EXPECT_THROW((void)stretchMinimisation(disk, options), InvalidArgument);
  options = {};
  options.startVertex = -2;
  EXPECT_THROW((void)stretchMinimisation(disk, options), InvalidArgument);
}

TEST(StretchMinimisation, GivesTheSameBitsOnOneThreadAndTwo) {
  const DiskMesh disk(bumpyDisk(12));
  EXPECT_EQ(stretchMinimisation(disk, {}, Execution({}, {}, 1)).image,
            stretchMinimisation(disk, {}, Execution({}, {}, 2)).image);
}

TEST(StretchEnergyMap, ComesNearAreaPreservationAndNeverRaisesItsResidual) {
  const DiskMesh disk(bumpyDisk(16, 1.0));
  const TargetMeasure target(disk.mesh());
  for (const StretchEnergyBoundary boundary : {StretchEnergyBoundary::Inverted, StretchEnergyBoundary::Held}) {
    StretchEnergyMapOptions options;
    options.boundary = boundary;
    const StretchEnergyMapResult result = stretchEnergyMap(disk, start(disk), target, options);
    EXPECT_EQ(result.status, Status::Converged) << stretchEnergyBoundaryName(boundary);
    EXPECT_EQ(result.flippedFaces, 0);
    for (std::size_t k = 1; k < result.history.size(); ++k) EXPECT_LE(result.history[k], result.history[k - 1]);
    EXPECT_LT(result.residual, 0.1 * result.history.front()) << stretchEnergyBoundaryName(boundary);
    EXPECT_LT(areaDistortion(disk, result.image), 2.01) << stretchEnergyBoundaryName(boundary);
  }
}

TEST(StretchEnergyMap, ResidualIsTheSpreadOfTheAreaRatiosOfTheReport) {
  const DiskMesh disk(bumpyDisk(10, 1.0));
  const StretchEnergyMapResult result = stretchEnergyMap(disk, start(disk), TargetMeasure(disk.mesh()));
  EXPECT_NEAR(result.residual, measureDistortion(disk.mesh(), result.image).summary.faceStandardDeviation, 1e-12);
}

TEST(StretchEnergyMap, LeavesAMapThatIsAreaPreservingAlone) {
  const TriangleMesh flat = diskMesh(10);
  const Points2 image = flat.points().leftCols<2>();
  const StretchEnergyMapResult result = stretchEnergyMap(DiskMesh(flat), image, TargetMeasure(flat));
  EXPECT_LT((result.image - image).cwiseAbs().maxCoeff(), 1e-9);
}

TEST(StretchEnergyMap, KeepsTheBoundaryOnThatOfItsDomain) {
  const DiskMesh disk(bumpyDisk(12));
  const TargetMeasure target(disk.mesh());
  const Points2 image = stretchEnergyMap(disk, start(disk), target).image;
  for (const int v : disk.boundary()) EXPECT_NEAR(image.row(v).norm(), 1, 1e-12);
  StretchEnergyMapOptions options;
  options.domain = PlanarDomain::square();
  const Points2 first = start(disk, options.domain), square = stretchEnergyMap(disk, first, target, options).image;
  for (const int v : disk.boundary()) EXPECT_LT((square.row(v) - first.row(v)).norm(), 1e-12);
}

TEST(StretchEnergyMap, GivesARegionMoreOfTheDomain) {
  const DiskMesh disk(bumpyDisk(16));
  Eigen::VectorXd density(disk.mesh().vertexCount());
  for (int v = 0; v < density.size(); ++v) density[v] = disk.mesh().point(v)[0] > 0 ? 3 : 1;
  const TargetMeasure target = TargetMeasure::fromVertexDensity(disk.mesh(), density);
  const Points2 image = stretchEnergyMap(disk, start(disk), target).image;
  const Eigen::VectorXd areas = signedFaceAreas(image, disk.mesh().faces());
  const Eigen::VectorXd stars = vertexStars(areas / areas.sum(), disk.mesh().faces(), disk.mesh().vertexCount());
  const Eigen::VectorXd region = (density.array() > 1).cast<double>();
  EXPECT_NEAR(stars.dot(region), target.vertices().dot(region), 0.01);
}

TEST(StretchEnergyMap, IsAStartFromWhichTheAuthalicMapIsReached) {
  const DiskMesh disk(bumpyDisk(14, 1.0));
  const TargetMeasure target(disk.mesh());
  const Points2 near = stretchEnergyMap(disk, start(disk), target).image;
  AuthalicMapOptions options;
  options.tolerance = 0.05;
  const AuthalicMapResult exact = authalicMap(disk, target, options, near);
  EXPECT_EQ(exact.status, Status::Converged);
  const Points2 own = authalicMap(disk, target, options).image;
  EXPECT_LT((exact.image - near).norm(), (own - near).norm());
}

TEST(StretchEnergyMap, SaysWhenItWasCutShortAndRefusesBadOptions) {
  const DiskMesh disk(bumpyDisk(12));
  const TargetMeasure target(disk.mesh());
  StretchEnergyMapOptions options;
  options.maxIterations = 2;
  EXPECT_EQ(stretchEnergyMap(disk, start(disk), target, options).status, Status::NotConverged);
  const Execution stopping({}, [] { return true; });
  EXPECT_EQ(stretchEnergyMap(disk, start(disk), target, {}, stopping).status, Status::Cancelled);
  options.maxIterations = -1;
  EXPECT_THROW((void)stretchEnergyMap(disk, start(disk), target, options), InvalidArgument);
  options = {};
  options.tolerance = 0;
  EXPECT_THROW((void)stretchEnergyMap(disk, start(disk), target, options), InvalidArgument);
  EXPECT_THROW((void)stretchEnergyMap(disk, start(disk), TargetMeasure(diskMesh(5))), GeometryError);
  EXPECT_THROW((void)stretchEnergyMap(disk, start(disk) * 2, target), GeometryError);
}

TEST(StretchEnergyMap, GivesTheSameBitsOnOneThreadAndTwo) {
  const DiskMesh disk(bumpyDisk(12));
  const TargetMeasure target(disk.mesh());
  EXPECT_EQ(stretchEnergyMap(disk, start(disk), target, {}, Execution({}, {}, 1)).image,
            stretchEnergyMap(disk, start(disk), target, {}, Execution({}, {}, 2)).image);
}
