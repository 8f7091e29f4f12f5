#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "Core/conformal/SphericalConformalMap.h"
#include "Core/distortion/SphericalDistortion.h"
#include "support/TestMeshes.h"

using namespace authalic;
using namespace authalic::testing;

namespace {

const SphereRoad kRoads[] = {SphereRoad::Harmonic, SphereRoad::Stereographic, SphereRoad::MeanCurvatureFlow,
                              SphereRoad::Welding};

/// Error ratio that a halving of the edges must reach: nearly 4, the dipole's place in its face nearly 2.
double leastRatio(SphereRoad road) {
  if (road == SphereRoad::Stereographic) return 1.9;
  return road == SphereRoad::Welding ? 3.0 : 3.2;  // where the seam meets the edges differs from level to level
}

SphericalMapResult byRoad(const TriangleMesh& mesh, SphereRoad road) {
  SphericalConformalMapOptions options;
  options.road = road;
  return sphericalConformalMap(SphereMesh(mesh), options);
}

double rootMeanSquare(const Points3& difference) {
  return difference.norm() / std::sqrt(static_cast<double>(difference.rows()));
}

/// x² + y² = 1 and z = c at the pole.
TriangleMesh ellipsoid(int levels, double c) {
  const TriangleMesh sphere = sphereMesh(levels);
  Points3 points = sphere.points();
  points.col(2) *= c;
  return TriangleMesh(points, sphere.faces());
}

/// ∫ (√(cos² s + c² sin² s) − 1)/sin s ds from π/2 to t by Simpson's rule; the integrand vanishes at both poles.
double isothermalExcess(double t, double c) {
  const auto integrand = [c](double s) {
    const double sine = std::sin(s), cosine = std::cos(s);
    return (c * c - 1) * sine / (std::sqrt(cosine * cosine + c * c * sine * sine) + 1);
  };
  const int steps = 200;
  const double h = (t - M_PI / 2) / steps;
  double sum = integrand(M_PI / 2) + integrand(t);
  for (int k = 1; k < steps; ++k) sum += (k % 2 == 1 ? 4 : 2) * integrand(M_PI / 2 + k * h);
  return sum * h / 3;
}

/// The conformal map of the ellipsoid that keeps meridians and the equator. With z = c cos t and radius sin t the
/// metric is (cos² t + c² sin² t) dt² + sin² t dφ², that of the sphere dτ² + sin² τ dφ²; both are conformal to du²
/// + dφ², so that ln tan(τ/2) = ln tan(t/2) + isothermalExcess(t).
Points3 conformalImageOfEllipsoid(const TriangleMesh& mesh, double c) {
  Points3 image(mesh.vertexCount(), 3);
  for (int v = 0; v < mesh.vertexCount(); ++v) {
    const Eigen::Vector3d p = mesh.point(v);
    const double radius = std::hypot(p.x(), p.y()), t = std::atan2(radius, p.z() / c);
    const double tau = 2 * std::atan(std::tan(t / 2) * std::exp(isothermalExcess(t, c)));
    if (radius > 0) {
      image.row(v) << std::sin(tau) * p.x() / radius, std::sin(tau) * p.y() / radius, std::cos(tau);
    } else {
      image.row(v) << 0, 0, std::copysign(1.0, p.z());
    }
  }
  return image;
}

TriangleMesh bumpySphere(int levels) {
  const TriangleMesh sphere = sphereMesh(levels);
  Points3 points = sphere.points();
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    const Eigen::RowVector3d x = points.row(i);
    points.row(i) *= 1 + 0.2 * x.x() * x.y() + 0.15 * std::sin(3 * x.z() + x.x()) + 0.1 * std::cos(4 * x.y());
  }
  return TriangleMesh(points, sphere.faces());
}

}  // namespace

TEST(SphericalConformalMap, OfTheSphereIsTheIdentityUnderRefinement) {
  for (const SphereRoad road : kRoads) {
    double previous = 0;
    for (const int levels : {3, 4, 5}) {
      const TriangleMesh sphere = sphereMesh(levels);
      const double error = rootMeanSquare(byRoad(sphere, road).image - sphere.points());
      if (previous > 0) {
        EXPECT_GT(previous / error, leastRatio(road)) << sphereRoadName(road) << " " << levels;
      }
      EXPECT_LT(error, 0.02) << sphereRoadName(road);
      previous = error;
    }
  }
}

TEST(SphericalConformalMap, OfAnEllipsoidConvergesToIsothermalCoordinates) {
  for (const double c : {0.5, 2.0}) {
    for (const SphereRoad road : kRoads) {
      double previous = 0;
      for (const int levels : {3, 4, 5}) {
        const TriangleMesh mesh = ellipsoid(levels, c);
        const SphericalMapResult result = byRoad(mesh, road);
        const double error = rootMeanSquare(result.image - conformalImageOfEllipsoid(mesh, c));
        EXPECT_EQ(result.flippedFaces, 0);
        if (previous > 0) {
          EXPECT_GT(previous / error, leastRatio(road)) << sphereRoadName(road) << " c = " << c << " " << error;
        }
        previous = error;
      }
      EXPECT_LT(previous, 5e-3);
    }
  }
}

TEST(SphericalConformalMap, RoadsToTheBumpySphereAgreeUnderRefinement) {
  double previousFlow = 0, previousStereographic = 0, previousWelding = 0;
  for (const int levels : {3, 4, 5}) {
    const TriangleMesh mesh = bumpySphere(levels);
    const Points3 harmonic = byRoad(mesh, SphereRoad::Harmonic).image;
    const double flow = rootMeanSquare(byRoad(mesh, SphereRoad::MeanCurvatureFlow).image - harmonic);
    const double stereographic = rootMeanSquare(byRoad(mesh, SphereRoad::Stereographic).image - harmonic);
    const double welding = rootMeanSquare(byRoad(mesh, SphereRoad::Welding).image - harmonic);
    if (previousFlow > 0) {
      EXPECT_GT(previousFlow / flow, 3.0) << levels << " " << flow;
      EXPECT_GT(previousStereographic / stereographic, 2.0) << levels << " " << stereographic;
      EXPECT_GT(previousWelding / welding, 3.0) << levels << " " << welding;
    }
    previousFlow = flow;
    previousStereographic = stereographic;
    previousWelding = welding;
  }
}

TEST(SphericalConformalMap, HarmonicRoadEndsAtTheSameMapFromEveryStart) {
  const SphereMesh mesh(bumpySphere(4));
  SphericalConformalMapOptions options;
  options.harmonic.tolerance = 1e-9;
  const Points3 fromDipole = sphericalConformalMap(mesh, options).image;
  for (const HarmonicStart start : {HarmonicStart::Tutte, HarmonicStart::GaussMap}) {
    options.start = start;
    const SphericalMapResult result = sphericalConformalMap(mesh, options);
    EXPECT_EQ(result.status, Status::Converged) << harmonicStartName(start);
    EXPECT_LT((result.image - fromDipole).rowwise().norm().maxCoeff(), 1e-7) << harmonicStartName(start);
  }
}

TEST(SphericalConformalMap, BecomesConformalUnderRefinement) {
  for (const SphereRoad road : kRoads) {
    double previous = 0;
    for (const int levels : {3, 4, 5}) {
      const TriangleMesh mesh = bumpySphere(levels);
      const double distortion = measureSphericalDistortion(mesh, byRoad(mesh, road).image).summary.angleDistortion - 2;
      if (previous > 0) {
        EXPECT_GT(previous / distortion, 2.8) << sphereRoadName(road);
      }
      previous = distortion;
    }
  }
}
