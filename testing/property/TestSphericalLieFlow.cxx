#include <gtest/gtest.h>

#include <atomic>
#include <cmath>

#include <Eigen/Geometry>

#include "Core/authalic/FlowingMesh.h"
#include "Core/authalic/SphericalLieFlow.h"
#include "Core/base/Error.h"
#include "Core/distortion/SphericalDistortion.h"
#include "Core/geometry/Areas.h"
#include "Core/geometry/Laplacian.h"
#include "Core/geometry/SphericalAreas.h"
#include "support/TestMeshes.h"

using namespace authalic;
using namespace authalic::testing;

namespace {

// A sphere with bumps and a nose; no symmetry.
SphereMesh bumpySphere(int levels, double nose = 1) {
  const TriangleMesh sphere = sphereMesh(levels);
  Points3 points = sphere.points();
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    const Eigen::RowVector3d p = points.row(i);
    points.row(i) *= 1 + 0.2 * std::sin(4 * p[0] + 1) * std::cos(3 * p[1]) + nose * std::exp(8 * (p[2] - 1));
  }
  return SphereMesh(TriangleMesh(points, sphere.faces()));
}

LieAdvectionOptions inSteps(int steps) {
  LieAdvectionOptions options;
  options.steps = steps;
  return options;
}

}  // namespace

TEST(SphericalLieFlow, PreservesAreasWithoutFolds) {
  for (const double nose : {0.0, 1.0, 4.0}) {
    const SphereMesh sphere = bumpySphere(4, nose);
    const SphericalLieFlowResult result = sphericalLieFlow(sphere, TargetMeasure(sphere.mesh()));
    EXPECT_EQ(result.status, Status::Converged) << nose << ' ' << result.residual;
    EXPECT_LE(result.residual, 5e-3);
    const SphericalDistortion distortion = measureSphericalDistortion(sphere.mesh(), result.image);
    EXPECT_LT(distortion.summary.areaDistortion, 2.002);
    EXPECT_EQ(distortion.flippedByVolume, 0);
    EXPECT_NEAR(distortion.coverage, 1, 1e-12);
    EXPECT_LT((result.image.rowwise().norm().array() - 1).abs().maxCoeff(), 1e-14);
  }
}

TEST(SphericalLieFlow, LeavesASphereWithItsOwnSolidAnglesAlone) {
  const TriangleMesh mesh = sphereMesh(3);
  const Eigen::VectorXd density = signedSolidAngles(mesh.points(), mesh.faces()).cwiseQuotient(
      signedChordAreas(mesh.points(), mesh.faces()));
  const TargetMeasure target = TargetMeasure::fromFaceDensity(mesh, density);
  const SphericalLieFlowResult flow = sphericalLieFlow(SphereMesh(mesh), target, {}, mesh.points());
  EXPECT_EQ(flow.status, Status::Converged);
  EXPECT_EQ(flow.iterations, 0);
  EXPECT_LT((flow.image - mesh.points()).cwiseAbs().maxCoeff(), 1e-12);
  const auto advected = sphericalLieAdvection(SphereMesh(mesh), target, inSteps(5), mesh.points());
  EXPECT_EQ(advected.status, Status::Converged);
  EXPECT_LT((advected.image - mesh.points()).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(SphericalLieFlow, OfAZonalDensityConvergesToItsClosedForm) {
  // The density 1 + z/2 moves parallels only: the share south of z is (z + 1)/2 + (z² − 1)/8.
  double before = 0;
  for (const int levels : {2, 3, 4}) {
    const TriangleMesh mesh = sphereMesh(levels);
    const Eigen::VectorXd solid = signedSolidAngles(mesh.points(), mesh.faces()).cwiseQuotient(
        signedChordAreas(mesh.points(), mesh.faces()));
    Eigen::VectorXd density(mesh.faceCount());
    for (int f = 0; f < mesh.faceCount(); ++f) {
      const Eigen::Vector3d middle = (mesh.corner(f, 0) + mesh.corner(f, 1) + mesh.corner(f, 2)).normalized();
      density[f] = solid[f] * (1 + 0.5 * middle[2]);
    }
    DiscreteLieFlowOptions options;
    options.finish = LieFlowFinish::None;
    options.tolerance = 1e-3;
    const auto result = sphericalLieFlow(SphereMesh(mesh), TargetMeasure::fromFaceDensity(mesh, density), options,
                                         mesh.points());
    double error = 0;
    for (int v = 0; v < mesh.vertexCount(); ++v) {
      const double z = mesh.points()(v, 2), exact = 2 * ((z + 1) / 2 + (z * z - 1) / 8) - 1;
      error += std::abs(result.image(v, 2) - exact) / mesh.vertexCount();
    }
    if (levels > 2) { EXPECT_GT(before / error, 2.5) << levels; }
    before = error;
  }
  EXPECT_LT(before, 1e-3);
}

TEST(SphericalLieFlow, GivesAHemisphereFourTimesItsDensity) {
  const SphereMesh sphere = bumpySphere(4);
  Eigen::VectorXd density(sphere.mesh().vertexCount());
  for (int v = 0; v < density.size(); ++v) density[v] = sphere.mesh().point(v)[0] > 0 ? 4 : 1;
  const TargetMeasure target = TargetMeasure::fromVertexDensity(sphere.mesh(), density);
  const SphericalLieFlowResult result = sphericalLieFlow(sphere, target);
  EXPECT_EQ(result.status, Status::Converged) << result.residual;
  EXPECT_EQ(result.flippedFaces, 0);
  EXPECT_LT(measureSphericalDistortion(sphere.mesh(), result.image, target.faces()).summary.areaDistortion, 2.005);
}

TEST(SphericalLieFlow, StartsWithTwoCapsWhereTheConformalMapIsTooFarOff) {
  const SphericalLieFlowResult near = sphericalLieFlow(bumpySphere(4, 1), TargetMeasure(bumpySphere(4, 1).mesh()));
  EXPECT_FALSE(near.balancedStart);
  EXPECT_GT(near.iterations, 0);
  const SphereMesh sphere = bumpySphere(4, 1);
  Points3 shrunk = sphereMesh(4).points();  // towards the poles, whose surroundings lose nearly all of their area
  for (Eigen::Index v = 0; v < shrunk.rows(); ++v) {
    const double z = shrunk(v, 2), r = shrunk.row(v).head<2>().norm();
    if (r < 1e-9) continue;
    const double height = std::copysign(1 - std::pow(1 - std::abs(z), 4), z);
    shrunk.row(v) << shrunk.row(v).head<2>() * (std::sqrt(1 - height * height) / r), height;
  }
  const SphericalLieFlowResult result = sphericalLieFlow(sphere, TargetMeasure(sphere.mesh()), {}, shrunk);
  EXPECT_TRUE(result.balancedStart);
  EXPECT_EQ(result.flippedFaces, 0);
}

TEST(SphericalLieFlow, GivesTheSameBitsOnOneThreadAndTwo) {
  const SphereMesh sphere = bumpySphere(3);
  const TargetMeasure target(sphere.mesh());
  EXPECT_EQ(sphericalLieFlow(sphere, target, {}, {}, Execution({}, {}, 1)).image,
            sphericalLieFlow(sphere, target, {}, {}, Execution({}, {}, 2)).image);
}

TEST(SphericalLieFlow, ReturnsAnUnfoldedIterateWhenCancelled) {
  const SphereMesh sphere = bumpySphere(4);
  std::atomic<int> asked{0};
  DiscreteLieFlowOptions options;
  options.flowTolerance = options.tolerance = 1e-9;
  const auto result = sphericalLieFlow(sphere, TargetMeasure(sphere.mesh()), options, {},
                                       Execution({}, [&] { return ++asked > 30; }));
  EXPECT_EQ(result.status, Status::Cancelled);
  EXPECT_TRUE(result.image.allFinite());
}

TEST(SphericalLieFlow, RefusesStartsOffTheSphereForeignTargetsAndOptions) {
  const SphereMesh sphere = bumpySphere(2);
  const TargetMeasure target(sphere.mesh());
  const Points3 off = 2 * sphereMesh(2).points();
  EXPECT_THROW((void)sphericalLieFlow(sphere, target, {}, off), GeometryError);
  EXPECT_THROW((void)sphericalLieFlow(sphere, TargetMeasure(sphereMesh(3))), GeometryError);
  DiscreteLieFlowOptions options;
  options.stepRatio = 0;
  EXPECT_THROW((void)sphericalLieFlow(sphere, target, options), InvalidArgument);
  EXPECT_THROW((void)sphericalLieAdvection(sphere, target, inSteps(0)), InvalidArgument);
  EXPECT_THROW((void)sphericalLieAdvection(sphere, target, inSteps(2), off), GeometryError);
}

TEST(SphericalLieAdvection, ComesCloserWithMoreStepsAndNeverFolds) {
  const SphereMesh sphere = bumpySphere(4);
  const TargetMeasure target(sphere.mesh());
  double before = 1e300;
  for (const int steps : {1, 4, 16}) {
    const auto result = sphericalLieAdvection(sphere, target, inSteps(steps));
    EXPECT_EQ(result.iterations, steps);
    EXPECT_LT(result.residual, before) << steps;
    EXPECT_EQ(countFlippedOnSphere(result.image, sphere.mesh().faces()), result.flippedFaces);
    EXPECT_EQ(result.flippedFaces, 0);
    before = result.residual;
  }
  EXPECT_LT(before, 0.1);
}

TEST(FlowingMesh, OnTheSphereIsTheConvexHullAfterItsFlips) {
  const TriangleMesh sphere = sphereMesh(3);
  Coordinates points = sphere.points();
  for (Eigen::Index v = 0; v < points.rows(); ++v) {  // twisted, so that other triangles are Delaunay
    points.row(v).head<2>() =
        (Eigen::Rotation2Dd(1.2 * points(v, 2)) * points.row(v).head<2>().transpose()).transpose();
  }
  FlowingMesh mesh(sphere.faces(), sphere.vertexCount());
  EXPECT_GT(mesh.makeDelaunay(points), 0);
  EXPECT_EQ(mesh.makeDelaunay(points), 0);
  EXPECT_EQ(countFlippedOnSphere(Points3(points), mesh.faces()), 0);
  for (Eigen::Index f = 0; f < mesh.faces().rows(); ++f) {
    const Eigen::Vector3d a = points.row(mesh.faces()(f, 0)), b = points.row(mesh.faces()(f, 1)),
                          c = points.row(mesh.faces()(f, 2)), normal = (b - a).cross(c - a);
    EXPECT_LT((points * normal).maxCoeff() - a.dot(normal), 1e-12);
  }
}

TEST(VertexGradients, OnASphereAreTheTangentialPartOfALinearFunctionsGradient) {
  double before = 0;
  for (const int levels : {2, 3, 4}) {
    const TriangleMesh mesh = sphereMesh(levels);
    const Points3 gradients = vertexGradients(mesh.points(), mesh.faces(), mesh.points().col(2));
    double error = 0;
    for (int v = 0; v < mesh.vertexCount(); ++v) {
      const Eigen::Vector3d p = mesh.point(v), g = gradients.row(v);
      const Eigen::Vector3d exact = Eigen::Vector3d::UnitZ() - p[2] * p;
      error += ((g - g.dot(p) * p) - exact).norm() / mesh.vertexCount();
    }
    if (levels > 2) { EXPECT_GT(before / error, 3); }
    before = error;
  }
}
