#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numeric>
#include <random>

#include "Core/base/Error.h"
#include "Core/conformal/SphereNormalisation.h"
#include "Core/geometry/Areas.h"
#include "support/TestMeshes.h"

using namespace authalic;
using namespace authalic::testing;

namespace {

Eigen::Matrix3d turn(double angle, const Eigen::Vector3d& axis) {
  return Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix();
}

SphereMobius someMap(double strength = 0.7) {
  return {strength * Eigen::Vector3d(1, -2, 1.5).normalized(), turn(1.1, {0.3, 1, 0.2})};
}

/// A surface without symmetry over the sphere: its own radial image is the image.
TriangleMesh lopsidedSphere(int levels) {
  const TriangleMesh sphere = sphereMesh(levels);
  Points3 points = sphere.points();
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    const Eigen::RowVector3d x = points.row(i);
    points.row(i) *= 1 + 0.3 * x.x() + 0.2 * x.y() * x.z() + 0.25 * std::sin(2 * x.z() + 1) + 0.1 * std::cos(3 * x.y());
  }
  return TriangleMesh(points, sphere.faces());
}

double meanMassOf(const TriangleMesh& surface, const Points3& image) {
  const Eigen::VectorXd mass = vertexStars(faceAreas(surface), surface.faces(), surface.vertexCount());
  return (mass.transpose() * image).norm() / mass.sum();
}

}  // namespace

TEST(SphereMobius, InverseAndCompositionAreThoseOfMaps) {
  const SphereMobius f = someMap(), g({0.1, 0.8, -0.3}, turn(2, {1, 1, 0}));
  const Points3 x = sphereMesh(2).points();
  EXPECT_LT((f.inverse()(f(x)) - x).norm(), 1e-12);
  EXPECT_LT(((g * f)(x) - g(f(x))).norm(), 1e-12);
  EXPECT_LT(((f * f.inverse())(x) - x).norm(), 1e-12);
}

TEST(SphereMobius, KeepsCrossRatiosOfChords) {
  const SphereMobius f = someMap(0.9);
  const Points3 x = sphereMesh(1).points(), y = f(x);
  const auto ratio = [](const Points3& p) {
    return (p.row(0) - p.row(2)).norm() * (p.row(7) - p.row(9)).norm() /
           ((p.row(0) - p.row(9)).norm() * (p.row(7) - p.row(2)).norm());
  };
  EXPECT_NEAR(ratio(y) / ratio(x), 1, 1e-12);
}

TEST(SphereMobius, RefusesCentresOutsideTheBallAndReflections) {
  EXPECT_THROW(SphereMobius({1, 0, 0}, Eigen::Matrix3d::Identity()), GeometryError);
  EXPECT_THROW(SphereMobius({0, 0, 0}, -Eigen::Matrix3d::Identity()), GeometryError);
  EXPECT_THROW(SphereMobius({0, 0, 0}, 2 * Eigen::Matrix3d::Identity()), GeometryError);
}

TEST(SphereCentring, UndoesATranslationOfEvenMass) {
  const Points3 x = sphereMesh(3).points();
  const Eigen::VectorXd mass = Eigen::VectorXd::Ones(x.rows());
  for (const double strength : {0.3, 0.9, 0.999}) {
    const Points3 moved = someMap(strength)(x);
    const SphereCentring centring = centreOfSphericalMassToOrigin(moved, mass);
    EXPECT_EQ(centring.status, Status::Converged) << strength << " " << centring.residual;
    EXPECT_LE(centring.iterations, 20);
    EXPECT_LT((centring.map.centre() - someMap(strength).inverse().centre()).norm(), 1e-9);
  }
}

TEST(SphereCentring, ConvergesFromRandomClusters) {
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  for (int trial = 0; trial < 20; ++trial) {
    Points3 x(60, 3);
    Eigen::VectorXd mass(60);
    for (int i = 0; i < 60; ++i) {
      const double spread = i < 40 ? 1e-3 : 1;  // two thirds of the points in one spot
      x.row(i) = Eigen::RowVector3d(0, 0, 1) +
                 spread * Eigen::RowVector3d(normal(random), normal(random), normal(random));
      mass[i] = std::exp(normal(random));
    }
    x.rowwise().normalize();
    const SphereCentring centring = centreOfSphericalMassToOrigin(x, mass, 1e-11);
    EXPECT_EQ(centring.status, Status::Converged) << trial << " " << centring.residual;
    EXPECT_LT((mass.transpose() * centring.map(x)).norm() / mass.sum(), 2e-11);
  }
}

TEST(SphereCentring, SaysWhenOnePointHoldsHalfTheMass) {
  const Points3 x = sphereMesh(1).points();
  Eigen::VectorXd mass = Eigen::VectorXd::Ones(x.rows());
  mass[4] = 100;
  const SphereCentring centring = centreOfSphericalMassToOrigin(x, mass);
  EXPECT_NE(centring.status, Status::Converged);
  EXPECT_TRUE(centring.map.centre().allFinite());
}

TEST(SphereCentring, RefusesBadMassesAndPoints) {
  const Points3 x = sphereMesh(1).points();
  EXPECT_THROW((void)centreOfSphericalMassToOrigin(x, Eigen::VectorXd::Ones(3)), GeometryError);
  EXPECT_THROW((void)centreOfSphericalMassToOrigin(x, Eigen::VectorXd::Zero(x.rows())), GeometryError);
  EXPECT_THROW((void)centreOfSphericalMassToOrigin(x, -Eigen::VectorXd::Ones(x.rows())), GeometryError);
  EXPECT_THROW((void)centreOfSphericalMassToOrigin(2 * x, Eigen::VectorXd::Ones(x.rows())), GeometryError);
}

TEST(SphereNormalisation, PutsTheSurfaceMassAtTheCentre) {
  const TriangleMesh surface = lopsidedSphere(4);
  const Points3 image = surface.points().rowwise().normalized();
  EXPECT_GT(meanMassOf(surface, image), 0.1);
  for (const SphereRotation rotation : {SphereRotation::Surface, SphereRotation::PrincipalAxes, SphereRotation::None}) {
    SphereNormalisationOptions options;
    options.rotation = rotation;
    const SphereNormalisation normal = normaliseSphere(surface, image, options);
    EXPECT_EQ(normal.status, Status::Converged) << sphereRotationName(rotation);
    EXPECT_LT(meanMassOf(surface, normal.image), 1e-11);
    EXPECT_LT((normal.map(image) - normal.image).norm(), 1e-14);
  }
}

TEST(SphereNormalisation, ForgetsAMobiusTransformation) {
  const TriangleMesh surface = lopsidedSphere(4);
  const Points3 image = surface.points().rowwise().normalized();
  for (const SphereRotation rotation :
       {SphereRotation::Surface, SphereRotation::PrincipalAxes, SphereRotation::Landmarks}) {
    SphereNormalisationOptions options;
    options.rotation = rotation;
    if (rotation == SphereRotation::Landmarks) options.northVertex = 5, options.meridianVertex = 40;
    const Points3 before = normaliseSphere(surface, image, options).image;
    const Points3 after = normaliseSphere(surface, someMap(0.95)(image), options).image;
    EXPECT_LT((before - after).rowwise().norm().maxCoeff(), 1e-9) << sphereRotationName(rotation);
  }
}

TEST(SphereNormalisation, LandmarksGoToThePoleAndItsMeridian) {
  const TriangleMesh surface = lopsidedSphere(3);
  SphereNormalisationOptions options;
  options.rotation = SphereRotation::Landmarks;
  options.northVertex = 17;
  options.meridianVertex = 99;
  const Points3 image = normaliseSphere(surface, surface.points().rowwise().normalized(), options).image;
  EXPECT_LT((image.row(17) - Eigen::RowVector3d(0, 0, 1)).norm(), 1e-14);
  EXPECT_NEAR(image(99, 1), 0, 1e-14);
  EXPECT_GT(image(99, 0), 0);
}

TEST(SphereNormalisation, CommutesWithSimilaritiesAndRenumbering) {
  const TriangleMesh surface = lopsidedSphere(3);
  const Points3 image = surface.points().rowwise().normalized();
  const Eigen::Matrix3d r = turn(0.8, {1, 2, -1});
  Points3 moved = 7.0 * surface.points() * r.transpose();
  moved.rowwise() += Eigen::RowVector3d(10, -20, 30);
  const TriangleMesh similar(moved, surface.faces());
  const Points3 before = normaliseSphere(surface, image).image;
  EXPECT_LT((normaliseSphere(similar, image).image - before * r.transpose()).norm(),
            1e-9);  // it turns with the surface
  SphereNormalisationOptions axes;
  axes.rotation = SphereRotation::PrincipalAxes;
  EXPECT_LT((normaliseSphere(similar, image, axes).image - normaliseSphere(surface, image, axes).image).norm(), 1e-9);

  std::vector<int> order(static_cast<std::size_t>(surface.vertexCount()));
  std::iota(order.begin(), order.end(), 0);
  std::shuffle(order.begin(), order.end(), std::mt19937(3));
  Points3 shuffled(image.rows(), 3), shuffledImage(image.rows(), 3);
  for (int v = 0; v < surface.vertexCount(); ++v) {
    shuffled.row(order[static_cast<std::size_t>(v)]) = surface.points().row(v);
    shuffledImage.row(order[static_cast<std::size_t>(v)]) = image.row(v);
  }
  Faces faces = surface.faces();
  for (Eigen::Index k = 0; k < faces.size(); ++k) faces.data()[k] = order[static_cast<std::size_t>(faces.data()[k])];
  const Points3 after = normaliseSphere(TriangleMesh(shuffled, faces), shuffledImage).image;
  for (int v = 0; v < surface.vertexCount(); ++v)
    EXPECT_LT((after.row(order[static_cast<std::size_t>(v)]) - before.row(v)).norm(), 1e-9);
}

TEST(SphereNormalisation, RefusesBadOptionsAndLandmarks) {
  const TriangleMesh surface = lopsidedSphere(2);
  const Points3 image = surface.points().rowwise().normalized();
  const auto refuses = [&](SphereRotation rotation, int north, int meridian, double tolerance = 1e-12) {
    SphereNormalisationOptions options;
    options.rotation = rotation;
    options.northVertex = north;
    options.meridianVertex = meridian;
    options.tolerance = tolerance;
    EXPECT_THROW((void)normaliseSphere(surface, image, options), InvalidArgument);
  };
  refuses(SphereRotation::Landmarks, -1, -1);
  refuses(SphereRotation::Landmarks, 3, 3);
  refuses(SphereRotation::Landmarks, 3, surface.vertexCount());
  refuses(SphereRotation::Surface, 3, 4);
  refuses(SphereRotation::None, -1, -1, 0);
  SphereNormalisationOptions options;
  options.rotation = SphereRotation::Landmarks;
  options.northVertex = 0;
  options.meridianVertex = 1;
  Points3 opposite = image;
  opposite.row(0) << 0, 0, 1;
  opposite.row(1) << 0, 0, 1;
  EXPECT_THROW((void)normaliseSphere(surface, opposite, options), GeometryError);
  EXPECT_THROW((void)normaliseSphere(surface, 2 * image), GeometryError);
  EXPECT_THROW((void)normaliseSphere(surface, image.topRows(4)), GeometryError);
}
