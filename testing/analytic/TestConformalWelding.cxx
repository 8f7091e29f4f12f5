#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <Eigen/QR>

#include <cmath>
#include <complex>
#include <limits>
#include <random>

#include "Core/base/Error.h"
#include "Core/conformal/ConformalWelding.h"
#include "support/EllipseMaps.h"

using namespace authalic;
using namespace authalic::testing;

namespace {

using Complex = std::complex<double>;

Points2 randomDiskPoints(int count, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(0, 1);
  Points2 points(count, 2);
  for (int i = 0; i < count; ++i) {
    const Complex z = std::polar(std::sqrt(uniform(random)), 2 * M_PI * uniform(random));
    points.row(i) << z.real(), z.imag();
  }
  return points;
}

Complex at(const Points2& points, Eigen::Index i) { return {points(i, 0), points(i, 1)}; }

/// n arcs of sum 2π whose lengths spread over `decades` powers of ten.
Eigen::VectorXd randomArcs(int n, double decades, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(0, 1);
  Eigen::VectorXd arcs(n);
  for (double& arc : arcs) arc = std::pow(10.0, -decades * uniform(random));
  return arcs * (2 * M_PI / arcs.sum());
}

/// The signature of the disk automorphism φ with tan ½φ = s tan ½θ on the circle, θ seen from `centre`.
WeldingSignature mobiusSignature(const Eigen::VectorXd& arcs, double s) {
  WeldingSignature signature{arcs, arcs, 0, 0};
  double from = 0;
  for (Eigen::Index k = 0; k < arcs.size(); ++k) {
    const double to = from + arcs[k];
    signature.secondArcs[k] =
        2 * std::atan2(s * std::sin(arcs[k] / 2),
                       std::cos(from / 2) * std::cos(to / 2) + s * s * std::sin(from / 2) * std::sin(to / 2));
    from = to;
  }
  return signature;
}

ConformalWelding onItsCircle(const WeldingSignature& signature) {
  const Eigen::VectorXd angles = signature.firstAngles();
  const int n = static_cast<int>(angles.size());
  const std::array<int, 3> ids{0, n / 3, 2 * n / 3};
  std::array<Complex, 3> places;
  for (std::size_t i = 0; i < 3; ++i) places[i] = std::polar(1.0, angles[ids[i]]);
  return ConformalWelding(signature).withCurvePointsAt(ids, places);
}

WeldingSignature smoothSignature(int n, double start = 0) {
  Eigen::VectorXd alpha(n), beta(n);
  for (int k = 0; k < n; ++k) {
    const double t = alpha[k] = start + 2 * M_PI * k / n;
    beta[k] = -(t + 0.45 * std::sin(t + 1) + 0.1 * std::sin(2 * t));
  }
  return WeldingSignature::fromAngles(alpha, beta);
}

}  // namespace

TEST(ConformalWelding, ByTheIdentityGivesTheCircleAndTheIdentity) {
  for (const int n : {3, 4, 17, 600}) {
    const Eigen::VectorXd arcs = randomArcs(n, 3, 7);
    const ConformalWelding welding(WeldingSignature{arcs, arcs, 0.4, -0.4});
    const Eigen::VectorXcd curve = welding.curve();
    EXPECT_LT((curve.cwiseAbs().array() - 1).abs().maxCoeff(), 1e-11) << n;
    const Points2 points = randomDiskPoints(100, 3);
    const Eigen::VectorXcd inner = welding.mapFirst(points), outer = welding.mapSecond(points);
    for (Eigen::Index i = 0; i < points.rows(); ++i) {
      EXPECT_LT(std::abs(inner[i] - at(points, i) * std::polar(1.0, -0.4)), 1e-10) << n;
      EXPECT_LT(std::abs(1.0 / outer[i] - at(points, i) * std::polar(1.0, 0.4)), 1e-10) << n;
    }
  }
}

TEST(ConformalWelding, ByAMobiusMapOfTheCircleGivesTheCircleWhateverTheArcs) {
  for (const double decades : {0.0, 4.0, 8.0}) {
    for (const double s : {0.1, 3.0}) {
      const WeldingSignature signature = mobiusSignature(randomArcs(1500, decades, 11), s);
      const ConformalWelding welding = onItsCircle(signature);
      const Eigen::VectorXcd curve = welding.curve();
      const Eigen::VectorXd angles = signature.firstAngles();
      double worst = 0;
      for (Eigen::Index k = 0; k < curve.size(); ++k) {
        worst = std::max(worst, std::abs(curve[k] - std::polar(1.0, angles[k])));
      }
      EXPECT_LT(worst, 1e-9) << decades << " decades, s = " << s;
      // Φ1 = 1 and Φ2(w) = φ⁻¹(1/w): tan ½θ = tan ½φ / s.
      const Points2 points = randomDiskPoints(50, 5);
      const Eigen::VectorXcd inner = welding.mapFirst(points), outer = welding.mapSecond(points);
      const double r = (1 / s - 1) / (1 / s + 1);
      for (Eigen::Index i = 0; i < points.rows(); ++i) {
        const Complex z = at(points, i), inverse = (z - r) / (1.0 - r * z);  // 1/φ⁻¹(1/z)
        EXPECT_LT(std::abs(inner[i] - z), 1e-8);
        EXPECT_LT(std::abs(1.0 / outer[i] - inverse), 1e-8);
      }
    }
  }
}

TEST(ConformalWelding, OfAnEllipseConvergesAtOrderTwoAndAHalf) {
  const double m = 0.4;
  const EllipseMaps ellipse(m);
  const auto boundary = [m](double t) { return std::polar(1.0, t) + m * std::polar(1.0, -t); };
  const auto error = [&](int n) {
    Eigen::VectorXd alpha(n), beta(n);
    for (int k = 0; k < n; ++k) {
      const double t = 2 * M_PI * (k + 0.3) / n;
      alpha[k] = ellipse.innerAngle(t);
      beta[k] = -t;
    }
    const std::array<int, 3> ids{0, n / 3, 2 * n / 3};
    const ConformalWelding welding =
        ConformalWelding(WeldingSignature::fromAngles(alpha, beta))
            .withCurvePointsAt(ids, {boundary(-beta[ids[0]]), boundary(-beta[ids[1]]), boundary(-beta[ids[2]])});
    const Eigen::VectorXcd curve = welding.curve();
    double worst = 0;
    for (int k = 0; k < n; ++k) worst = std::max(worst, std::abs(curve[k] - boundary(-beta[k])));
    const Points2 points = randomDiskPoints(200, 1);
    const Eigen::VectorXcd outer = welding.mapSecond(points);
    for (Eigen::Index i = 0; i < points.rows(); ++i) {
      const Complex w = at(points, i);
      worst = std::max(worst, std::abs(1.0 / outer[i] - 1.0 / (1.0 / w + m * w)));
    }
    const Eigen::VectorXcd axis = welding.mapFirst(Points2::Zero(1, 2));
    return std::max(worst, std::abs(axis[0]));  // the centre of the ellipse
  };
  const double coarse = error(200), fine = error(800);
  EXPECT_LT(fine, 2e-6);
  EXPECT_GT(coarse / fine, std::pow(4, 2.3));
}

TEST(ConformalWelding, OfAWedgeFollowsItsPowerLaws) {
  // The wedge 0 < arg z < ⅔π is the image of the half-plane under z^⅔; its outside, of the lower half-plane under
  // z^(4/3): x ~ y when x^⅔ = y^(4/3), on both sides. Corners at 0 and ∞.
  const auto error = [](int n) {
    const int side = n / 2;  // x = ±e^u, u from −16 to 16; with 0 and ∞
    std::vector<double> x{0.0};
    for (int k = 0; k <= side; ++k) x.push_back(std::exp(-16 + 32.0 * k / side));
    x.push_back(std::numeric_limits<double>::infinity());
    for (int k = side; k >= 0; --k) x.push_back(-std::exp(-16 + 32.0 * k / side));
    Eigen::VectorXd alpha(static_cast<Eigen::Index>(x.size())), beta(alpha.size());
    Eigen::VectorXcd exact(alpha.size());
    for (Eigen::Index k = 0; k < alpha.size(); ++k) {
      const double at = x[static_cast<std::size_t>(k)], y = std::copysign(std::sqrt(std::abs(at)), at);
      alpha[k] = std::isinf(at) ? M_PI : 2 * std::atan(at);
      beta[k] = std::isinf(at) ? -M_PI : -2 * std::atan(y);
      exact[k] = std::isinf(at) ? 1e300 : std::polar(std::pow(std::abs(at), 2.0 / 3), at < 0 ? 2 * M_PI / 3 : 0);
    }
    const std::array<int, 3> ids{0, side / 2 + 1, 3 * side / 2 + 3};
    const ConformalWelding welding =
        ConformalWelding(WeldingSignature::fromAngles(alpha, beta))
            .withCurvePointsAt(ids, {exact[ids[0]], exact[ids[1]], exact[ids[2]]});
    const Eigen::VectorXcd curve = welding.curve();
    double worst = 0;
    for (Eigen::Index k = 1; k < curve.size(); ++k) {
      const double u = std::log(std::abs(exact[k]));
      if (std::abs(u) < 4) worst = std::max(worst, std::abs(curve[k] / exact[k] - 1.0));
    }
    return worst;
  };
  const double coarse = error(200), fine = error(800);
  EXPECT_LT(fine, 2e-3);
  EXPECT_GT(coarse / fine, 4);
}

TEST(ConformalWelding, AgreesWithTheLinearSystemOnTheCircle) {
  // F1 = Σ d_k z^k inside, F2 = 1/w + Σ c_k w^k outside, F1(e^{iα}) = F2(e^{iβ}) in the least-squares sense.
  const int modes = 90, samples = 720;
  const WeldingSignature dense = smoothSignature(samples);
  const Eigen::VectorXd alpha = dense.firstAngles(), beta = dense.secondAngles();
  Eigen::MatrixXcd system(samples, 2 * modes - 1);
  Eigen::VectorXcd pole(samples);
  for (int j = 0; j < samples; ++j) {
    for (int k = 0; k < modes; ++k) system(j, k) = std::polar(1.0, k * alpha[j]);
    for (int k = 1; k < modes; ++k) system(j, modes + k - 1) = -std::polar(1.0, k * beta[j]);
    pole[j] = std::polar(1.0, -beta[j]);
  }
  const Eigen::VectorXcd solution = system.householderQr().solve(pole);
  ASSERT_LT((system * solution - pole).cwiseAbs().maxCoeff(), 1e-9);
  const auto inside = [&](Complex z) {
    Complex value = 0;
    for (int k = modes - 1; k > 0; --k) value = (value + solution[k]) * z;
    return value;
  };
  const Complex scale = inside(1.0);
  const Points2 points = randomDiskPoints(100, 9);
  const auto error = [&](int n) {
    const Eigen::VectorXcd images = ConformalWelding(smoothSignature(n)).mapFirst(points);
    double worst = 0;
    for (Eigen::Index i = 0; i < points.rows(); ++i) {
      worst = std::max(worst, std::abs(images[i] - inside(at(points, i)) / scale));
    }
    return worst;
  };
  const double coarse = error(250), fine = error(1000);
  EXPECT_LT(fine, 1e-6);
  EXPECT_GT(coarse / fine, std::pow(4, 2.3));
}

TEST(ConformalWelding, DoesNotDependOnRotationsOfTheDisks) {
  WeldingSignature signature = smoothSignature(300);
  const Points2 points = randomDiskPoints(50, 4);
  const Eigen::VectorXcd images = ConformalWelding(signature).mapFirst(points);
  signature.firstStart += 0.7;
  signature.secondStart -= 2.1;
  Points2 turned(points);
  const Eigen::Rotation2Dd turn(0.7);
  for (Eigen::Index i = 0; i < points.rows(); ++i) turned.row(i) = (turn * points.row(i).transpose()).transpose();
  EXPECT_LT((ConformalWelding(signature).mapFirst(turned) - images).cwiseAbs().maxCoeff(), 1e-11);
}

TEST(ConformalWelding, OfExchangedDisksIsTheReflectedInverse) {
  const WeldingSignature signature = smoothSignature(300);
  const WeldingSignature exchanged{signature.secondArcs, signature.firstArcs, -signature.secondStart,
                                   -signature.firstStart};
  const Eigen::VectorXcd curve = ConformalWelding(signature).curve();
  const Eigen::VectorXcd other = ConformalWelding(exchanged).curve();
  EXPECT_LT((other - curve.conjugate().cwiseInverse()).cwiseAbs().maxCoeff(), 1e-11);
}

TEST(ConformalWelding, DependsOnTheStartOnlyWithinItsAccuracy) {
  const auto difference = [](int n) {
    const Points2 points = randomDiskPoints(50, 4);
    const Eigen::VectorXcd here = ConformalWelding(smoothSignature(n)).mapFirst(points);
    const ConformalWelding there(smoothSignature(n, M_PI));  // started at the opposite point
    const Complex one = there.curve()[n / 2];
    return (there.mapFirst(points) / one - here).cwiseAbs().maxCoeff();
  };
  EXPECT_LT(difference(800), 1e-6);
  EXPECT_GT(difference(200) / difference(800), std::pow(4, 2.3));
}

TEST(ConformalWelding, MeasuresItsOwnAccuracy) {
  const WeldingAccuracy coarse = ConformalWelding(smoothSignature(250)).accuracy();
  const WeldingAccuracy fine = ConformalWelding(smoothSignature(1000)).accuracy();
  EXPECT_LT(coarse.boundaryMismatch, 1e-10);
  EXPECT_LT(fine.boundaryMismatch, 1e-10);
  EXPECT_LT(fine.midpointMismatch, 1e-5);
  EXPECT_GT(coarse.midpointMismatch / fine.midpointMismatch, std::pow(4, 2.3));
}

TEST(ConformalWelding, StaysAccurateForFiveThousandUnevenPoints) {
  const ConformalWelding welding = onItsCircle(mobiusSignature(randomArcs(5000, 3, 2), 0.3));
  const Eigen::VectorXd angles = welding.signature().firstAngles();
  const Eigen::VectorXcd curve = welding.curve();
  double worst = 0;
  for (Eigen::Index k = 0; k < curve.size(); ++k) {
    const double spacing = std::min(welding.signature().firstArcs[k], welding.signature().firstArcs[(k + 4999) % 5000]);
    worst = std::max(worst, std::abs(curve[k] - std::polar(1.0, angles[k])) / spacing);
  }
  EXPECT_LT(worst, 1e-4);  // of the distance to the next point, which itself is 1e-8 … 1e-3
}

TEST(ConformalWelding, MapsEveryPairToItsCurvePointAlsoWhereRoundingLeavesTheCircle) {
  for (int start = 0; start < 40; ++start) {
    WeldingSignature signature = smoothSignature(60);
    signature.firstStart = 0.37 * start;
    signature.secondStart = 1 - 0.61 * start;
    const ConformalWelding welding(signature);
    EXPECT_LT(welding.accuracy().boundaryMismatch, 1e-11) << start;
    Points2 first(2, 2);  // point 0, just inside and just outside the disk
    first << std::cos(signature.firstStart), std::sin(signature.firstStart), 0, 0;
    first.row(1) = first.row(0) * (1 + 3e-16);
    first.row(0) *= 1 - 3e-16;
    EXPECT_LT((welding.mapFirst(first).array() - 1.0).abs().maxCoeff(), 1e-11) << start;
  }
}

TEST(ConformalWelding, InvertsBothMaps) {
  const ConformalWelding welding(smoothSignature(400));
  const Points2 points = randomDiskPoints(200, 8);
  const WeldingPreimages inner = welding.inverse(welding.mapFirst(points));
  const WeldingPreimages outer = welding.inverse(welding.mapSecond(points));
  for (std::size_t i = 0; i < 200; ++i) {
    EXPECT_EQ(inner.second[i], 0);
    EXPECT_EQ(outer.second[i], 1);
  }
  EXPECT_LT((inner.points - points).cwiseAbs().maxCoeff(), 1e-9);
  EXPECT_LT((outer.points - points).cwiseAbs().maxCoeff(), 1e-9);
  Eigen::VectorXcd ends(2);
  ends << Complex(0), Complex(std::numeric_limits<double>::infinity(), 0);
  const WeldingPreimages centres = welding.inverse(ends);
  EXPECT_LT(centres.points.cwiseAbs().maxCoeff(), 1e-9);
  EXPECT_EQ(centres.second[1], 1);
}

TEST(ConformalWelding, MapsCentresToThePolesOfTheSphere) {
  const ConformalWelding welding(smoothSignature(100));
  const Points2 centre = Points2::Zero(1, 2);
  EXPECT_LT((welding.mapFirstToSphere(centre) - Points3(Eigen::RowVector3d(0, 0, 1))).norm(), 1e-12);
  EXPECT_LT((welding.mapSecondToSphere(centre) - Points3(Eigen::RowVector3d(0, 0, -1))).norm(), 1e-12);
  EXPECT_LT((welding.curveOnSphere().rowwise().norm().array() - 1).abs().maxCoeff(), 1e-14);
}

TEST(ConformalWelding, GivesTheSameBitsOnAnyNumberOfThreads) {
  const ConformalWelding welding(smoothSignature(200));
  const Points2 points = randomDiskPoints(1000, 6);
  const Points3 one = welding.mapSecondToSphere(points, Execution({}, {}, 1));
  EXPECT_EQ(one, welding.mapSecondToSphere(points, Execution({}, {}, 3)));
}

TEST(ConformalWelding, RefusesSignaturesThatAreNone) {
  Eigen::VectorXd alpha(4), beta(4);
  alpha << 0, 1, 2, 4;
  beta << 0, -1, -2, -4;
  EXPECT_NO_THROW((void)WeldingSignature::fromAngles(alpha, beta));
  EXPECT_THROW((void)WeldingSignature::fromAngles(alpha, alpha), InvalidArgument);
  EXPECT_THROW((void)WeldingSignature::fromAngles(alpha.head(2), beta.head(2)), InvalidArgument);
  EXPECT_THROW((void)WeldingSignature::fromAngles(alpha, beta.head(3)), InvalidArgument);
  alpha[2] = 1;
  EXPECT_THROW((void)WeldingSignature::fromAngles(alpha, beta), InvalidArgument);
  alpha[2] = std::nan("");
  EXPECT_THROW((void)WeldingSignature::fromAngles(alpha, beta), InvalidArgument);
  EXPECT_THROW((void)WeldingSignature::fromPoints(Points2::Zero(4, 2), Points2::Ones(4, 2)), InvalidArgument);
  WeldingSignature signature = smoothSignature(10);
  signature.firstArcs[3] += 0.1;
  EXPECT_THROW(ConformalWelding{signature}, InvalidArgument);
}

TEST(ConformalWelding, RefusesPointsOutsideTheDiskAndPlacesThatCoincide) {
  const ConformalWelding welding(smoothSignature(20));
  EXPECT_THROW((void)welding.mapFirst(Points2::Ones(1, 2)), InvalidArgument);
  EXPECT_THROW((void)welding.mapSecond(Points2::Constant(1, 2, std::nan(""))), InvalidArgument);
  EXPECT_THROW((void)welding.inverse(Eigen::VectorXcd::Constant(1, Complex(std::nan(""), 0))), InvalidArgument);
  EXPECT_THROW((void)welding.withCurvePointsAt({0, 1, 1}, {0, 1, 2}), InvalidArgument);
  EXPECT_THROW((void)welding.withCurvePointsAt({0, 1, 20}, {0, 1, 2}), InvalidArgument);
  EXPECT_THROW((void)welding.withCurvePointsAt({0, 1, 2}, {0, 1, 1}), InvalidArgument);
}

TEST(ConformalWelding, StopsOnRequest) {
  EXPECT_THROW(ConformalWelding(smoothSignature(50), Execution({}, [] { return true; })), CancelledError);
}
