#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "Core/base/Error.h"
#include "Core/distortion/SphericalDistortion.h"
#include "Core/geometry/SphericalAreas.h"
#include "support/TestMeshes.h"

using namespace authalic;
using namespace authalic::testing;

namespace {

/// A ball automorphism on the sphere: conformal, far from isometric.
Points3 boosted(const Points3& points, const Eigen::RowVector3d& a) {
  Points3 image(points.rows(), 3);
  const double rest = 1 - a.squaredNorm();
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    const Eigen::RowVector3d difference = points.row(i) - a;
    image.row(i) = rest * difference / difference.squaredNorm() - a;
  }
  return image.rowwise().normalized();
}

}  // namespace

TEST(SphericalAreas, OfAnOctantIsAnEighthOfTheSphere) {
  const Eigen::Vector3d x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
  EXPECT_NEAR(signedSolidAngle(x, y, z), M_PI / 2, 1e-15);
  EXPECT_NEAR(signedSolidAngle(y, x, z), -M_PI / 2, 1e-15);
}

TEST(SphericalAreas, StayBelowAHemisphere) {
  // Three points a little beside the equator: the triangle is the side of its plane that is less than a hemisphere.
  const auto at = [](double angle, double z) {
    return Eigen::Vector3d(std::cos(angle), std::sin(angle), z).normalized();
  };
  const auto area = [&at](double z) { return signedSolidAngle(at(0, z), at(2 * M_PI / 3, z), at(4 * M_PI / 3, z)); };
  EXPECT_GT(area(0.01), 1.9 * M_PI);
  EXPECT_LT(area(0.01), 2 * M_PI);
  EXPECT_NEAR(area(-0.01), -area(0.01), 1e-12);
}

TEST(SphericalAreas, OfTinyTrianglesKeepTheirRelativeAccuracy) {
  const Eigen::Vector3d a = Eigen::Vector3d(1, 2, 3).normalized();
  const Eigen::Vector3d u = a.unitOrthogonal(), v = a.cross(u);
  const double h = 1e-7;
  const Eigen::Vector3d b = (a + h * u).normalized(), c = (a + h * v).normalized();
  EXPECT_NEAR(signedSolidAngle(a, b, c) / (0.5 * h * h), 1, 1e-7);
}

TEST(SphericalAreas, TileTheSphere) {
  const TriangleMesh sphere = sphereMesh(4);
  EXPECT_NEAR(signedSolidAngles(sphere.points(), sphere.faces()).sum(), 4 * M_PI, 1e-11);
  EXPECT_LT(signedChordAreas(sphere.points(), sphere.faces()).sum(), 4 * M_PI);
  EXPECT_EQ(countFlippedOnSphere(sphere.points(), sphere.faces()), 0);
}

TEST(SphericalDistortion, OfTheIdentityIsIdealInFlatTriangles) {
  const TriangleMesh sphere = sphereMesh(3);
  const SphericalDistortion d = measureSphericalDistortion(sphere, sphere.points());
  EXPECT_NEAR(d.flatSummary.areaDistortion, 2, 1e-13);
  EXPECT_NEAR(d.summary.angleDistortion, 2, 1e-12);
  EXPECT_NEAR(d.summary.meanAngleError, 0, 1e-6);
  EXPECT_NEAR(d.coverage, 1, 1e-12);
  EXPECT_EQ(d.flippedBySolidAngle + d.flippedByVolume + d.summary.flippedFaces, 0);
  EXPECT_GT(d.summary.areaDistortion, 2);  // solid angles see the bulge of the faces
}

TEST(SphericalDistortion, OfTheIdentityConvergesBetweenFlatAndSphericalTrianglesQuadratically) {
  double previousArea = 0, previousAngle = 0;
  for (const int levels : {2, 3, 4}) {
    const TriangleMesh sphere = sphereMesh(levels);
    const SphericalDistortion d = measureSphericalDistortion(sphere, sphere.points());
    const double area = d.summary.faceMaxAbsLog, angle = d.sphericalAngleError;
    if (previousArea > 0) {
      EXPECT_GT(previousArea / area, 3.5);
      EXPECT_GT(previousAngle / angle, 3.5);
    }
    previousArea = area;
    previousAngle = angle;
  }
}

TEST(SphericalDistortion, OfAMobiusMapHasVanishingAngleErrorAndItsConformalFactor) {
  const Eigen::RowVector3d a(0.3, -0.2, 0.4);
  double previousAngle = 0, previousArea = 0;
  for (const int levels : {3, 4, 5}) {
    const TriangleMesh sphere = sphereMesh(levels);
    const SphericalDistortion d = measureSphericalDistortion(sphere, boosted(sphere.points(), a));
    double area = 0;  // the density of the image is ((1 − |a|²)/|x − a|²)²
    for (int f = 0; f < sphere.faceCount(); ++f) {
      const Eigen::RowVector3d centre =
          (sphere.corner(f, 0) + sphere.corner(f, 1) + sphere.corner(f, 2)).normalized().transpose();
      const double factor = (1 - a.squaredNorm()) / (centre - a).squaredNorm();
      area = std::max(area, std::abs(std::log(d.arrays.areaRatio[f] / (factor * factor))));
    }
    if (previousAngle > 0) {
      EXPECT_GT(previousAngle / (d.summary.angleDistortion - 2), 3.4);
      EXPECT_GT(previousArea / area, 1.9);  // first order: the map bends the edges, their images are great circles
    }
    previousAngle = d.summary.angleDistortion - 2;
    previousArea = area;
    EXPECT_EQ(d.summary.flippedFaces, 0);
  }
}

TEST(SphericalDistortion, OfAMirrorImageHasNoFlips) {
  const TriangleMesh sphere = sphereMesh(3);
  const SphericalDistortion d = measureSphericalDistortion(sphere, -sphere.points());
  EXPECT_EQ(d.summary.flippedFaces, 0);
  EXPECT_NEAR(d.coverage, 1, 1e-12);
  EXPECT_NEAR(d.summary.meanBeltrami, 0, 1e-12);
}

TEST(SphericalDistortion, CountsFoldedFacesAlikeByVolumeAndSolidAngle) {
  const TriangleMesh sphere = sphereMesh(3);
  Points3 image = sphere.points();
  image.row(100) = -image.row(100);
  const SphericalDistortion d = measureSphericalDistortion(sphere, image);
  EXPECT_GT(d.flippedBySolidAngle, 0);
  EXPECT_EQ(d.flippedBySolidAngle, d.flippedByVolume);
  EXPECT_EQ(d.flippedBySolidAngle, d.summary.flippedFaces);
  EXPECT_EQ(d.arrays.flipped.sum(), d.summary.flippedFaces);
  for (int f = 0; f < sphere.faceCount(); ++f) EXPECT_EQ(d.arrays.flipped[f] == 1, d.arrays.sigmaMin[f] < 0) << f;
}

TEST(SphericalDistortion, RefusesImagesOffTheSphereAndMismatchedSizes) {
  const TriangleMesh sphere = sphereMesh(1);
  EXPECT_THROW((void)measureSphericalDistortion(sphere, 2 * sphere.points()), GeometryError);
  EXPECT_THROW((void)measureSphericalDistortion(sphere, Points3::Zero(18, 3)), GeometryError);
  EXPECT_THROW((void)measureSphericalDistortion(sphere, Points3::Zero(5, 3)), GeometryError);
  EXPECT_THROW((void)measureSphericalDistortion(sphere, sphere.points(), Eigen::VectorXd::Ones(3)), GeometryError);
  Points3 broken = sphere.points();
  broken(3, 1) = NAN;
  EXPECT_THROW((void)measureSphericalDistortion(sphere, broken), GeometryError);
}
