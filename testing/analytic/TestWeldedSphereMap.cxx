#include <gtest/gtest.h>

#include <cmath>

#include "Core/base/Error.h"
#include "Core/conformal/SphereNormalisation.h"
#include "Core/conformal/WeldedSphereMap.h"
#include "Core/distortion/SphericalDistortion.h"
#include "support/TestMeshes.h"

using namespace authalic;
using namespace authalic::testing;

namespace {

/// Root mean square distance of two images, both in their normal position.
double distance(const TriangleMesh& surface, const Points3& one, const Points3& other) {
  const Points3 difference = normaliseSphere(surface, one).image - normaliseSphere(surface, other).image;
  return std::sqrt(difference.rowwise().squaredNorm().mean());
}

Points3 imageOf(const TriangleMesh& surface) { return weldedSphereMap(SphereMesh(surface)).image; }

}  // namespace

TEST(WeldedSphereMap, OfTheSphereIsAMobiusTransformation) {
  const auto error = [](int level) {
    const TriangleMesh sphere = sphereMesh(level);
    return distance(sphere, imageOf(sphere), sphere.points());
  };
  EXPECT_LT(error(5), 5e-6);
  EXPECT_GT(error(3) / error(5), 16);
}

TEST(WeldedSphereMap, OfASpheroidIsItsIsometricLatitude) {
  // z = c s, s = sin of the parametric latitude: tanh⁻¹ sin χ = tanh⁻¹(s/R) + k sin⁻¹(k s/√(1 + k²)),
  // R² = 1 + k² (1 − s²), k² = c² − 1.
  const double k = 1.5;
  const auto error = [k](int level) {
    const TriangleMesh sphere = sphereMesh(level);
    Points3 points = sphere.points(), exact = points;
    points.col(2) *= std::sqrt(1 + k * k);
    for (Eigen::Index i = 0; i < points.rows(); ++i) {
      const double s = sphere.points()(i, 2), root = std::sqrt(1 + k * k * (1 - s * s));
      if (std::abs(s) > 1 - 1e-12) continue;  // the poles stay
      const double height = std::tanh(std::atanh(s / root) + k * std::asin(k * s / std::sqrt(1 + k * k)));
      exact.row(i).head<2>() *= std::sqrt((1 - height * height) / (1 - s * s));
      exact(i, 2) = height;
    }
    const TriangleMesh spheroid(points, sphere.faces());
    return distance(spheroid, imageOf(spheroid), exact);
  };
  const double coarse = error(3), fine = error(5);
  EXPECT_LT(fine, 1e-3) << coarse;
  EXPECT_GT(coarse / fine, 14);
}

TEST(WeldedSphereMap, KeepsAnglesBetterOnFinerMeshesAndFoldsNothing) {
  const auto angleError = [](int level) {
    const SphereMesh surface(wavySphere(level));
    const WeldedSphereMapResult result = weldedSphereMap(surface);
    EXPECT_EQ(result.status, Status::Converged);
    EXPECT_EQ(result.flippedFaces, 0);
    EXPECT_EQ(result.flippedBeforeUnfolding, 0);
    EXPECT_LT(result.accuracy.boundaryMismatch, 1e-10);
    EXPECT_GT(result.seamPoints, 40);
    EXPECT_EQ(result.mergedPieces, 0);
    const SphericalDistortion distortion = measureSphericalDistortion(surface.mesh(), result.image);
    EXPECT_NEAR(distortion.coverage, 1, 1e-9);
    return distortion.summary.meanAngleError;
  };
  const double coarse = angleError(3), fine = angleError(5);
  EXPECT_LT(fine, 0.5);
  EXPECT_GT(coarse / fine, 3);
}

TEST(WeldedSphereMap, CommutesWithSimilaritiesAndRenumbering) {
  const TriangleMesh surface = wavySphere(3);
  const Points3 image = imageOf(surface);
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(2, Eigen::Vector3d(1, -1, 0.3).normalized()).toRotationMatrix();
  const TriangleMesh moved((7 * surface.points() * turn.transpose()).rowwise() + Eigen::RowVector3d(1, 2, 3),
                           surface.faces());
  EXPECT_LT(distance(surface, image, imageOf(moved)), 1e-4);
  const int n = surface.vertexCount();
  const Points3 reversed = surface.points().colwise().reverse();
  const Faces faces = n - 1 - surface.faces().array();
  EXPECT_LT(distance(surface, image, imageOf(TriangleMesh(reversed, faces)).colwise().reverse()), 1e-4);
}

TEST(WeldedSphereMap, HardlyDependsOnWhereTheSeamRuns) {
  const auto difference = [](int level, double clearance) {
    const SphereMesh surface(wavySphere(level));
    WeldedSphereMapOptions here, elsewhere;
    here.cut.clearance = elsewhere.cut.clearance = clearance;
    elsewhere.cut.level = 0.1;
    return distance(surface.mesh(), weldedSphereMap(surface, here).image, weldedSphereMap(surface, elsewhere).image);
  };
  const double smooth = LevelSetCutOptions().clearance, fine = difference(5, smooth);
  EXPECT_LT(fine, 5e-5);
  EXPECT_GT(difference(3, smooth) / fine, 16);
  EXPECT_GT(difference(5, 0.5) / fine, 50);  // a seam with corners costs accuracy
}

TEST(WeldedSphereMap, SeparatesVerticesAtTheSamePlace) {
  TriangleMesh surface = wavySphere(3);
  Points3 points = surface.points();
  points.row(surface.faces()(100, 1)) = points.row(surface.faces()(100, 0));
  const WeldedSphereMapResult result = weldedSphereMap(SphereMesh(TriangleMesh(points, surface.faces())));
  EXPECT_EQ(result.separatedVertices, 2);
  EXPECT_EQ(result.degenerateFaces, 2);
  EXPECT_EQ(result.status, Status::Converged);
  EXPECT_EQ(result.flippedFaces, 0);
  EXPECT_EQ(weldedSphereMap(SphereMesh(surface)).separatedVertices, 0);
}

TEST(WeldedSphereMap, GivesTheSameBitsOnAnyNumberOfThreads) {
  const SphereMesh surface(wavySphere(3));
  const Points3 one = weldedSphereMap(surface, {}, Execution({}, {}, 1)).image;
  EXPECT_EQ(one, weldedSphereMap(surface, {}, Execution({}, {}, 4)).image);
}

TEST(WeldedSphereMap, ReportsFlowsThatDidNotConverge) {
  WeldedSphereMapOptions options;
  options.riemann.flow.maxIterations = 1;
  const WeldedSphereMapResult result = weldedSphereMap(SphereMesh(wavySphere(3)), options);
  EXPECT_NE(result.status, Status::Converged);
  EXPECT_GT(result.residual, options.riemann.flow.tolerance);
  EXPECT_EQ(result.image.rows(), wavySphere(3).vertexCount());
}

TEST(WeldedSphereMap, RefusesBadOptionsAndStopsOnRequest) {
  const SphereMesh surface(wavySphere(2));
  WeldedSphereMapOptions options;
  options.eigenTolerance = 0;
  EXPECT_THROW((void)weldedSphereMap(surface, options), InvalidArgument);
  options = {};
  options.cut.clearance = 0.7;
  EXPECT_THROW((void)weldedSphereMap(surface, options), InvalidArgument);
  options = {};
  options.cut.level = 100;
  EXPECT_THROW((void)weldedSphereMap(surface, options), GeometryError);
  EXPECT_THROW((void)weldedSphereMap(surface, {}, Execution({}, [] { return true; })), CancelledError);
}
