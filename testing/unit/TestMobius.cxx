#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "Core/base/Error.h"
#include "Core/numerics/Mobius.h"

using namespace authalic;

namespace {

using Complex = Mobius::Complex;

Points2 randomDisk(int count, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(0, 1);
  Points2 points(count, 2);
  for (int i = 0; i < count; ++i) {
    const Complex z = std::polar(std::sqrt(uniform(random)), 2 * M_PI * uniform(random));
    points.row(i) << z.real(), z.imag();
  }
  return points;
}

Eigen::VectorXd randomMasses(int count, unsigned seed) {
  std::mt19937 random(seed);
  Eigen::VectorXd masses(count);
  for (int i = 0; i < count; ++i) masses[i] = std::uniform_real_distribution<double>(0.1, 2)(random);
  return masses;
}

}  // namespace

TEST(Mobius, CarriesThreePointsToThreePointsAndKeepsTheCrossRatio) {
  const std::array<Complex, 3> from{Complex(0.3, -1), Complex(2, 0.5), Complex(-1, 1)},
      to{Complex(5, 1), Complex(-0.2, 0.1), Complex(0, -3)};
  const Mobius map = Mobius::throughThreePoints(from, to);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_LT(std::abs(map(from[i]) - to[i]), 1e-14);
  const auto crossRatio = [](Complex p, Complex q, Complex r, Complex s) {
    return (p - r) * (q - s) / ((q - r) * (p - s));
  };
  const Complex z(0.7, 0.2);
  EXPECT_LT(std::abs(crossRatio(z, from[0], from[1], from[2]) - crossRatio(map(z), to[0], to[1], to[2])), 1e-14);
}

TEST(Mobius, ComposesInvertsAndDifferentiates) {
  const Mobius f(Complex(1, 2), Complex(0, 1), Complex(0.5, -0.3), Complex(2, 0)),
      g = Mobius::similarity(Complex(0.4, 0.3), Complex(1, -1));
  const Complex z(0.3, -0.8);
  EXPECT_LT(std::abs((f * g)(z) - f(g(z))), 1e-15);
  EXPECT_LT(std::abs(f.inverse()(f(z)) - z), 1e-15);
  const double h = 1e-5;
  EXPECT_LT(std::abs(f.derivative(z) - (f(z + h) - f(z - h)) / (2 * h)), 1e-9);
  EXPECT_LT(std::abs(Mobius::rotation(0.7)(z) - z * std::polar(1.0, 0.7)), 1e-15);
  Points2 points(1, 2);
  points << z.real(), z.imag();
  EXPECT_EQ(f(points)(0, 0), f(z).real());
  EXPECT_EQ(f(points)(0, 1), f(z).imag());
}

TEST(Mobius, OfTheDiskKeepsTheCircleAndCarriesThePointToTheCentre) {
  const Complex p(0.6, -0.7);
  const Mobius map = Mobius::diskToOrigin(p);
  EXPECT_LT(std::abs(map(p)), 1e-15);
  for (int k = 0; k < 17; ++k) EXPECT_NEAR(std::abs(map(std::polar(1.0, 0.4 * k))), 1, 1e-14);
  EXPECT_NEAR(map.derivative(p).real(), 1 / (1 - std::norm(p)), 1e-12);
  EXPECT_NEAR(map.derivative(p).imag(), 0, 1e-14);
}

TEST(Mobius, CentresTheMassOfADiskWhateverMovedIt) {
  const Eigen::VectorXd masses = randomMasses(500, 2);
  const DiskCentring home = centreOfMassToOrigin(randomDisk(500, 1), masses);
  ASSERT_EQ(home.status, Status::Converged);
  const Points2 centred = home.map(randomDisk(500, 1));
  for (const Complex p : {Complex(0, 0), Complex(0.5, 0.2), Complex(-0.9, 0.1), Complex(0.7, 0.7141)}) {
    const DiskCentring back = centreOfMassToOrigin(Mobius::diskToOrigin(p)(centred), masses);
    EXPECT_EQ(back.status, Status::Converged) << p;
    EXPECT_LE(back.iterations, 30);
    const double magnified = 1 / (1 - std::norm(p));  // what rounding becomes near the circle
    EXPECT_LE((masses.transpose() * back.map(Mobius::diskToOrigin(p)(centred))).norm() / masses.sum(),
              1e-13 + 4e-15 * magnified);
    // Unique: the point that moved to −p comes back to 0.
    EXPECT_LT(std::abs((back.map * Mobius::diskToOrigin(p))(Complex(0))), 1e-13 * magnified) << p;
  }
}

TEST(Mobius, CentresMassOnTheCircleItself) {
  Points2 circle(3, 2);
  circle << 1, 0, std::cos(0.1), std::sin(0.1), std::cos(3), std::sin(3);
  const DiskCentring centring = centreOfMassToOrigin(circle, Eigen::Vector3d::Ones());
  ASSERT_EQ(centring.status, Status::Converged);
  const Points2 image = centring.map(circle);  // three equal masses on the circle: an equilateral triangle
  EXPECT_NEAR((image.row(0) - image.row(1)).norm(), std::sqrt(3.0), 1e-11);
  EXPECT_NEAR((image.row(1) - image.row(2)).norm(), std::sqrt(3.0), 1e-11);
}

TEST(Mobius, ReportsAnAtomOnTheCircleThatCannotBeCentred) {
  Points2 circle(2, 2);
  circle << 1, 0, 0, 1;
  EXPECT_EQ(centreOfMassToOrigin(circle, Eigen::Vector2d(3, 1)).status, Status::Stalled);
}

TEST(Mobius, RefusesConstantMapsEqualPointsAndMassesThatDoNotFit) {
  EXPECT_THROW(Mobius(1, 2, 2, 4), GeometryError);
  EXPECT_THROW(Mobius(1, std::nan(""), 0, 1), GeometryError);
  EXPECT_THROW(static_cast<void>(Mobius::diskToOrigin(Complex(1, 0))), GeometryError);
  EXPECT_THROW(static_cast<void>(Mobius::throughThreePoints({Complex(1), Complex(1), Complex(2)},
                                                            {Complex(1), Complex(2), Complex(3)})),
               GeometryError);
  const Points2 points = randomDisk(3, 1);
  EXPECT_THROW(static_cast<void>(centreOfMassToOrigin(points, Eigen::VectorXd::Ones(2))), GeometryError);
  EXPECT_THROW(static_cast<void>(centreOfMassToOrigin(points, Eigen::VectorXd::Zero(3))), GeometryError);
  EXPECT_THROW(static_cast<void>(centreOfMassToOrigin(3 * points, Eigen::VectorXd::Ones(3))), GeometryError);
}
