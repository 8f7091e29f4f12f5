#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "Core/authalic/SphericalAuthalicMap.h"
#include "Core/base/Error.h"
#include "Core/distortion/SphericalDistortion.h"
#include "Core/geometry/SphericalAreas.h"
#include "support/TestMeshes.h"

using namespace authalic;
using namespace authalic::testing;

namespace {

// A sphere with bumps and a long nose; no symmetry.
TriangleMesh bumpySphere(int levels, double nose = 1.5) {
  const TriangleMesh sphere = sphereMesh(levels);
  Points3 points = sphere.points();
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    const Eigen::RowVector3d p = points.row(i);
    const double bump = 0.2 * std::sin(4 * p[0] + 1) * std::cos(3 * p[1]) + nose * std::exp(8 * (p[2] - 1));
    points.row(i) *= 1 + bump;
  }
  return TriangleMesh(points, sphere.faces());
}

// A plus sign of nine square cells, `thickness` cells thick, two triangles per square.
TriangleMesh thickPlus(double thickness) {
  const auto inside = [](int i, int j) { return i >= 0 && j >= 0 && i < 5 && j < 5 && (i == 2 || j == 2); };
  std::map<std::array<int, 3>, int> numbers;
  std::vector<Eigen::RowVector3d> points;
  std::vector<Eigen::RowVector3i> faces;
  const auto number = [&](int i, int j, int layer) {
    const auto [found, fresh] = numbers.try_emplace({i, j, layer}, static_cast<int>(points.size()));
    if (fresh) points.emplace_back(i, j, thickness * layer);
    return found->second;
  };
  const auto square = [&](int a, int b, int c, int d) {
    faces.emplace_back(a, b, c);
    faces.emplace_back(a, c, d);
  };
  for (int i = 0; i < 5; ++i) {
    for (int j = 0; j < 5; ++j) {
      if (!inside(i, j)) continue;
      const auto wall = [&](int fromI, int fromJ, int toI, int toJ) {
        square(number(fromI, fromJ, 0), number(toI, toJ, 0), number(toI, toJ, 1), number(fromI, fromJ, 1));
      };
      square(number(i, j, 1), number(i + 1, j, 1), number(i + 1, j + 1, 1), number(i, j + 1, 1));
      square(number(i, j, 0), number(i, j + 1, 0), number(i + 1, j + 1, 0), number(i + 1, j, 0));
      if (!inside(i, j - 1)) wall(i, j, i + 1, j);
      if (!inside(i + 1, j)) wall(i + 1, j, i + 1, j + 1);
      if (!inside(i, j + 1)) wall(i + 1, j + 1, i, j + 1);
      if (!inside(i - 1, j)) wall(i, j + 1, i, j);
    }
  }
  Points3 allPoints(static_cast<Eigen::Index>(points.size()), 3);
  for (std::size_t v = 0; v < points.size(); ++v) allPoints.row(static_cast<Eigen::Index>(v)) = points[v];
  Faces allFaces(static_cast<Eigen::Index>(faces.size()), 3);
  for (std::size_t f = 0; f < faces.size(); ++f) allFaces.row(static_cast<Eigen::Index>(f)) = faces[f];
  return TriangleMesh(allPoints, allFaces);
}

AuthalicMapOptions coarse() {
  AuthalicMapOptions options;
  options.tolerance = 0.02;
  return options;
}

void expectExact(const TriangleMesh& surface, const SphericalAuthalicMapResult& result,
                 const Eigen::VectorXd& target = {}) {
  EXPECT_EQ(result.status, Status::Converged) << result.faceResidual << ' ' << result.vertexResidual;
  const SphericalDistortion distortion = measureSphericalDistortion(surface, result.image, target);
  EXPECT_LT(distortion.summary.vertexMaxAbsLog, 1e-9);
  EXPECT_LT(distortion.summary.areaDistortion, 2.0004);
  EXPECT_EQ(distortion.flippedByVolume, 0);
  EXPECT_NEAR(distortion.coverage, 1, 1e-12);
}

}  // namespace

TEST(SphericalAuthalicMap, IsExactAtEveryVertex) {
  for (const double nose : {0.0, 1.5, 4.0}) {
    const SphereMesh sphere(bumpySphere(4, nose));
    expectExact(sphere.mesh(), sphericalAuthalicMap(sphere, TargetMeasure(sphere.mesh()), coarse()));
  }
}

// The caps of the thickest stay folded; the conformal map, far from its targets, is a start all the same.
TEST(SphericalAuthalicMap, StartsFromTheConformalMapWhereCapsStayFolded) {
  for (const double thickness : {0.3, 1.0, 3.0}) {
    const SphereMesh sphere(thickPlus(thickness));
    AuthalicMapOptions options;
    options.tolerance = 0.05;
    const SphericalAuthalicMapResult result =
        sphericalAuthalicMap(sphere, TargetMeasure(sphere.mesh()), options);
    EXPECT_EQ(result.flippedFaces, 0) << thickness;
    EXPECT_EQ(result.status, Status::Converged) << thickness << ' ' << result.faceResidual << ' ' << result.iterations;
  }
}

// The harmonic map shrinks the tips to e^-15 … e^-22 of the middle.
TEST(SphericalAuthalicMap, TakesLongLimbs) {
  for (const auto& [around, length] : {std::pair(24, 2.5), std::pair(24, 3.0), std::pair(32, 3.5)}) {
    const SphereMesh sphere(capsuleMesh(around, length));
    const SphericalAuthalicMapResult result = sphericalAuthalicMap(sphere, TargetMeasure(sphere.mesh()));
    expectExact(sphere.mesh(), result);
    EXPECT_LT(result.iterations, 150) << around << ' ' << length;
  }
}

TEST(SphericalAuthalicMap, IsTheIdentityOnASphereWithSolidAnglesAsItsMeasure) {
  const TriangleMesh mesh = sphereMesh(3);
  const Eigen::VectorXd density = signedSolidAngles(mesh.points(), mesh.faces()).cwiseQuotient(
      signedChordAreas(mesh.points(), mesh.faces()));
  const SphericalAuthalicMapResult result = sphericalAuthalicMap(
      SphereMesh(mesh), TargetMeasure::fromFaceDensity(mesh, density), {}, mesh.points());
  EXPECT_EQ(result.status, Status::Converged);
  EXPECT_LT((result.image - mesh.points()).cwiseAbs().maxCoeff(), 1e-9);
}

TEST(SphericalAuthalicMap, GivesAHemisphereFourTimesItsDensity) {
  const SphereMesh sphere(bumpySphere(4));
  Eigen::VectorXd density(sphere.mesh().vertexCount());
  for (int v = 0; v < density.size(); ++v) density[v] = sphere.mesh().point(v)[0] > 0 ? 4 : 1;
  const TargetMeasure target = TargetMeasure::fromVertexDensity(sphere.mesh(), density);
  expectExact(sphere.mesh(), sphericalAuthalicMap(sphere, target, coarse()), target.faces());
}

TEST(SphericalAuthalicMap, TurnsWithTheSurface) {
  const TriangleMesh mesh = bumpySphere(3);
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(1.1, Eigen::Vector3d(1, -2, 0.5).normalized()).toRotationMatrix();
  const TriangleMesh turned((mesh.points() * turn.transpose() * 12.0).rowwise() + Eigen::RowVector3d(3, 4, 5),
                            mesh.faces());
  AuthalicMapOptions options;
  options.tolerance = 0.1;
  const Points3 one = sphericalAuthalicMap(SphereMesh(mesh), TargetMeasure(mesh), options).image;
  const Points3 other = sphericalAuthalicMap(SphereMesh(turned), TargetMeasure(turned), options).image;
  EXPECT_LT((one * turn.transpose() - other).cwiseAbs().maxCoeff(), 1e-6);
}

TEST(SphericalAuthalicMap, TakesAnInitialMapAndRefusesOneThatIsNotOnTheSphere) {
  const SphereMesh sphere(bumpySphere(3, 0.0));
  Points3 initial = sphereMesh(3).points();
  expectExact(sphere.mesh(), sphericalAuthalicMap(sphere, TargetMeasure(sphere.mesh()), coarse(), initial));
  initial.row(5) *= 1.5;
  EXPECT_THROW((void)sphericalAuthalicMap(sphere, TargetMeasure(sphere.mesh()), {}, initial), GeometryError);
  EXPECT_THROW((void)sphericalAuthalicMap(sphere, TargetMeasure(sphereMesh(2))), GeometryError);
}

TEST(SphericalAuthalicMap, GivesTheSameBitsOnOneThreadAndTwo) {
  const SphereMesh sphere(bumpySphere(3));
  const TargetMeasure target(sphere.mesh());
  EXPECT_EQ(sphericalAuthalicMap(sphere, target, coarse(), {}, Execution({}, {}, 1)).image,
            sphericalAuthalicMap(sphere, target, coarse(), {}, Execution({}, {}, 2)).image);
}

TEST(SphericalAuthalicMap, ReturnsAnUnfoldedIterateWhenCancelled) {
  const SphereMesh sphere(bumpySphere(3));
  bool solving = false;
  const Execution execution([&](double, std::string_view stage) { solving = solving || stage == "Matching faces"; },
                            [&] { return solving; });
  const SphericalAuthalicMapResult result =
      sphericalAuthalicMap(sphere, TargetMeasure(sphere.mesh()), {}, {}, execution);
  EXPECT_EQ(result.status, Status::Cancelled);
  EXPECT_EQ(countFlippedOnSphere(result.image, sphere.mesh().faces()), 0);
}

TEST(SphericalAuthalicMap, HoldsOnTheSmallestSpheres) {
  const Points3 corners = (Points3(4, 3) << 1, 1, 1, -1, -1, 1, -1, 1, -1, 1, -1, -1).finished();
  const Faces faces = (Faces(4, 3) << 0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3).finished();
  const SphereMesh tetrahedron(TriangleMesh(corners, faces));
  expectExact(tetrahedron.mesh(), sphericalAuthalicMap(tetrahedron, TargetMeasure(tetrahedron.mesh())));
  const SphereMesh octahedron(sphereMesh(0));
  expectExact(octahedron.mesh(), sphericalAuthalicMap(octahedron, TargetMeasure(octahedron.mesh())));
}
