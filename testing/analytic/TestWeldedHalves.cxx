#include <gtest/gtest.h>

#include <cmath>
#include <complex>

#include "Core/base/Error.h"
#include "Core/conformal/SphereNormalisation.h"
#include "Core/conformal/WeldedHalves.h"
#include "Core/geometry/SphericalAreas.h"
#include "Core/numerics/Mobius.h"
#include "support/EllipseMaps.h"
#include "support/TestMeshes.h"

using namespace authalic;
using namespace authalic::testing;

namespace {

using Complex = std::complex<double>;

/// Stereographic coordinate of a point of the sphere (or of the direction of one near it), 0 at the north pole.
Complex stereographic(const Eigen::Vector3d& point) {
  const Eigen::Vector3d p = point.normalized();
  return Complex(p.x(), p.y()) / (1 + p.z());
}

/// The sphere, turned so that no vertex lies at a pole or on the equator.
TriangleMesh turnedSphere(int level) {
  const TriangleMesh mesh = sphereMesh(level);
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 0.5).normalized()).toRotationMatrix();
  return TriangleMesh(mesh.points() * turn.transpose(), mesh.faces());
}

template <class Inside, class Seam>
Points2 halfImage(const CutHalf& half, const Inside& inside, const Seam& onSeam) {
  Points2 image(half.disk.mesh().vertexCount(), 2);
  for (int i = 0; i < image.rows(); ++i) {
    const Complex w = stereographic(half.disk.mesh().point(i)), z = i < half.seamStart ? inside(w) : onSeam(w);
    image.row(i) << z.real(), z.imag();
  }
  return image;
}

LevelSetCutResult cutAtEquator(const SphereMesh& sphere) {
  return levelSetCut(sphere, sphere.mesh().points().col(2));
}

Complex onCircle(Complex z) { return z / std::abs(z); }

/// max |image − surface| after both are normalised; the surface is the sphere itself.
double distanceFromIdentity(const SphereMesh& sphere, const Points3& image) {
  const Points3 here = normaliseSphere(sphere.mesh(), image).image;
  const Points3 there = normaliseSphere(sphere.mesh(), sphere.mesh().points()).image;
  return (here - there).rowwise().norm().maxCoeff();
}

}  // namespace

TEST(WeldedHalves, OfTwoHemispheresByTheIdentityAreTheSphere) {
  const SphereMesh sphere(turnedSphere(4));
  const LevelSetCutResult cut = cutAtEquator(sphere);
  const Points2 above = halfImage(cut.above, [](Complex w) { return w; }, onCircle);
  const Points2 below = halfImage(cut.below, [](Complex w) { return 1.0 / w; },
                                  [](Complex w) { return std::conj(onCircle(w)); });
  const WeldedHalves welded = weldHalves(cut, above, below);
  EXPECT_EQ(countFlippedOnSphere(welded.image, sphere.mesh().faces()), 0);
  EXPECT_LT(distanceFromIdentity(sphere, welded.image), 1e-10);
}

TEST(WeldedHalves, OfHemispheresInAnyDiskPositionAreTheSphere) {
  const SphereMesh sphere(turnedSphere(4));
  const LevelSetCutResult cut = cutAtEquator(sphere);
  const Mobius first = Mobius::rotation(1) * Mobius::diskToOrigin({0.6, 0.3});
  const Mobius second = Mobius::diskToOrigin({-0.2, 0.7});
  const Points2 above = halfImage(cut.above, first, [&](Complex w) { return first(onCircle(w)); });
  const Points2 below = halfImage(cut.below, [&](Complex w) { return second(1.0 / w); },
                                  [&](Complex w) { return second(std::conj(onCircle(w))); });
  EXPECT_LT(distanceFromIdentity(sphere, weldHalves(cut, above, below).image), 1e-9);
}

TEST(WeldedHalves, OfTheTwoSidesOfAnEllipseConvergeToTheSphere) {
  const double m = 0.3;
  const EllipseMaps ellipse(m);
  const auto error = [&](int level) {
    const SphereMesh sphere(turnedSphere(level));
    Eigen::VectorXd values(sphere.mesh().vertexCount());
    for (int i = 0; i < values.size(); ++i) {
      const Complex w = stereographic(sphere.mesh().point(i));
      values[i] = 1 - std::hypot(w.real() / (1 + m), w.imag() / (1 - m));
    }
    const LevelSetCutResult cut = levelSetCut(sphere, values);
    const auto parameter = [m](Complex w) { return std::atan2(w.imag() / (1 - m), w.real() / (1 + m)); };
    const Points2 above = halfImage(cut.above, [&](Complex w) { return ellipse.inside(w); },
                                    [&](Complex w) { return std::polar(1.0, ellipse.innerAngle(parameter(w))); });
    const Points2 below = halfImage(cut.below, [&](Complex w) { return ellipse.outside(w); },
                                    [&](Complex w) { return std::polar(1.0, -parameter(w)); });
    const WeldedHalves welded = weldHalves(cut, above, below);
    EXPECT_EQ(countFlippedOnSphere(welded.image, sphere.mesh().faces()), 0);
    return distanceFromIdentity(sphere, welded.image);
  };
  const double coarse = error(4), fine = error(6);
  EXPECT_LT(fine, 2e-4);
  EXPECT_GT(coarse / fine, 16);  // at least second order
}

TEST(WeldedHalves, RefuseImagesThatDoNotFit) {
  const SphereMesh sphere(turnedSphere(2));
  const LevelSetCutResult cut = cutAtEquator(sphere);
  const Points2 above = halfImage(cut.above, [](Complex w) { return w; }, onCircle);
  const Points2 below = halfImage(cut.below, [](Complex w) { return 1.0 / w; },
                                  [](Complex w) { return std::conj(onCircle(w)); });
  EXPECT_NO_THROW((void)weldHalves(cut, above, below));
  EXPECT_THROW((void)weldHalves(cut, above.topRows(5), below), InvalidArgument);
  EXPECT_THROW((void)weldHalves(cut, above, below.topRows(5)), InvalidArgument);
  Points2 mirrored = below;
  mirrored.col(1) *= -1;
  EXPECT_THROW((void)weldHalves(cut, above, mirrored), InvalidArgument);
  Points2 outside = above;
  outside.row(0) << 2, 0;
  EXPECT_THROW((void)weldHalves(cut, outside, below), InvalidArgument);
}
