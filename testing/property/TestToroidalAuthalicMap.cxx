#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <cmath>

#include "Core/authalic/ToroidalAuthalicMap.h"
#include "Core/base/Error.h"
#include "Core/distortion/Distortion.h"
#include "Core/geometry/Areas.h"
#include "support/TestMeshes.h"
#include "support/TorusMeshes.h"

using namespace authalic;
using namespace authalic::testing;

namespace {

// A torus with bumps; no symmetry.
TriangleMesh bumpyTorus(int ring, int tube) {
  const TriangleMesh torus = torusMesh(ring, tube);
  Points3 points = torus.points();
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    points(i, 0) += 0.3 * std::sin(2 * points(i, 1) + 1);
    points(i, 2) *= 1 + 0.4 * std::cos(points(i, 0) - 0.5);
  }
  return TriangleMesh(points, torus.faces());
}

AuthalicMapOptions coarse() {
  AuthalicMapOptions options;
  options.tolerance = 0.03;
  return options;
}

TriangleMesh opened(const TriangleMesh& surface, const CutGraph& cut) {
  return TriangleMesh(surface.points()(cut.originalPointIds, Eigen::all), cut.faces);
}

Distortion expectExact(const TriangleMesh& surface, const ToroidalAuthalicMapResult& result,
                       const Eigen::VectorXd& target = {}) {
  EXPECT_EQ(result.status, Status::Converged) << result.faceResidual << ' ' << result.vertexResidual;
  EXPECT_EQ(result.flippedFaces, 0);
  EXPECT_LT(result.seamError, 1e-12);
  EXPECT_NEAR(result.lattice.determinant(), 1, 1e-12);
  EXPECT_NEAR(result.lattice(1, 0), 0, 1e-12);
  Distortion distortion =
      measureDistortion(opened(surface, result.cut), result.cut.originalPointIds, result.image, target);
  EXPECT_LT(distortion.summary.vertexMaxAbsLog, 1e-9);
  EXPECT_LT(distortion.summary.areaDistortion, 2.0009);
  EXPECT_EQ(distortion.summary.flippedFaces, 0);
  return distortion;
}

}  // namespace

TEST(ToroidalAuthalicMap, IsExactAtEveryVertexAcrossTheSeam) {
  const TorusMesh torus(bumpyTorus(36, 18));
  expectExact(torus.mesh(), toroidalAuthalicMap(torus, TargetMeasure(torus.mesh()), coarse()));
}

TEST(ToroidalAuthalicMap, GivesHalfOfTheTorusFourTimesItsDensity) {
  const TorusMesh torus(bumpyTorus(36, 18));
  Eigen::VectorXd density(torus.mesh().vertexCount());
  for (int v = 0; v < density.size(); ++v) density[v] = torus.mesh().point(v)[0] > 0 ? 4 : 1;
  const TargetMeasure target = TargetMeasure::fromVertexDensity(torus.mesh(), density);
  expectExact(torus.mesh(), toroidalAuthalicMap(torus, target, coarse()), target.faces());
}

TEST(ToroidalAuthalicMap, OfEqualTargetsOnARegularGridIsTheGrid) {
  // Every vertex of a regular grid has the same share, in the start already; only the lattice comes from the surface.
  const int ring = 20, tube = 16;
  const TorusMesh torus(torusMesh(ring, tube));
  const Eigen::VectorXd density = faceAreas(torus.mesh()).cwiseInverse();
  const ToroidalAuthalicMapResult result =
      toroidalAuthalicMap(torus, TargetMeasure::fromFaceDensity(torus.mesh(), density));
  EXPECT_EQ(result.status, Status::Converged);
  EXPECT_LT(result.faceResidual, 1e-9);
  const Eigen::Matrix2d unit = result.lattice.inverse();
  for (int v = 0; v < torus.mesh().vertexCount(); ++v) {
    const Eigen::Vector2d periods = unit * (result.points.row(v) - result.points.row(0)).transpose();
    for (int k = 0; k < 2; ++k) {
      const double steps = periods[k] * ring * tube;  // of either grid, whichever generator comes first
      EXPECT_NEAR(steps, std::round(steps), 1e-6);
    }
  }
}

TEST(ToroidalAuthalicMap, DoesNotDependOnPositionAndScale) {
  const TriangleMesh mesh = bumpyTorus(24, 12);
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(1.1, Eigen::Vector3d(1, -2, 0.5).normalized()).toRotationMatrix();
  const TriangleMesh moved((mesh.points() * turn.transpose() * 12.0).rowwise() + Eigen::RowVector3d(3, 4, 5),
                           mesh.faces());
  const ToroidalAuthalicMapResult one = toroidalAuthalicMap(TorusMesh(mesh), TargetMeasure(mesh), coarse());
  const ToroidalAuthalicMapResult other = toroidalAuthalicMap(TorusMesh(moved), TargetMeasure(moved), coarse());
  EXPECT_LT((one.lattice - other.lattice).cwiseAbs().maxCoeff(), 1e-6);
  EXPECT_LT((one.image - other.image).cwiseAbs().maxCoeff(), 1e-6);
}

TEST(ToroidalAuthalicMap, GivesTheSameBitsOnOneThreadAndTwo) {
  const TorusMesh torus(bumpyTorus(24, 12));
  const TargetMeasure target(torus.mesh());
  EXPECT_EQ(toroidalAuthalicMap(torus, target, coarse(), Execution({}, {}, 1)).image,
            toroidalAuthalicMap(torus, target, coarse(), Execution({}, {}, 2)).image);
}

TEST(ToroidalAuthalicMap, ReturnsAnUnfoldedIterateWhenCancelled) {
  const TorusMesh torus(bumpyTorus(24, 12));
  bool solving = false;
  const Execution execution([&](double, const std::string& stage) { solving = solving || stage == "Matching faces"; },
                            [&] { return solving; });
  const ToroidalAuthalicMapResult result = toroidalAuthalicMap(torus, TargetMeasure(torus.mesh()), {}, execution);
  EXPECT_EQ(result.status, Status::Cancelled);
  EXPECT_EQ(result.flippedFaces, 0);
}

TEST(ToroidalAuthalicMap, RefusesATargetOfAnotherSurface) {
  EXPECT_THROW((void)toroidalAuthalicMap(TorusMesh(torusMesh(9, 9)), TargetMeasure(torusMesh(8, 8))), GeometryError);
}
