#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "Core/base/Error.h"
#include "Core/conformal/AnnulusMap.h"
#include "Core/geometry/Areas.h"
#include "support/HoledMeshes.h"
#include "support/LegacyVtkFile.h"
#include "support/SharedData.h"

using namespace authalic;
using namespace authalic::testing;

namespace {

TriangleMesh cylinder(int around, int along, double height) {
  return revolutionMesh(around, along, [](double) { return 1.0; }, [height](double t) { return height * t; });
}

TriangleMesh frustum(int around, int along, double lower, double upper, double height) {
  return revolutionMesh(around, along, [=](double t) { return lower + t * (upper - lower); },
                        [height](double t) { return height * t; });
}

}  // namespace

TEST(AnnulusMap, OfACylinderHasTheModulusHeightOverCircumferenceExactly) {
  const int around = 24;
  const AnnulusMesh mesh(cylinder(around, 10, 2.5));
  const AnnulusMapResult result = annulusMap(mesh);
  ASSERT_EQ(result.status, Status::Converged);
  // The mesh is a prism of 24 sides with rings turned by half a side: flat, but for the sagging of its sides.
  const double chord = 2 * std::sin(M_PI / around), sag = 1 - std::cos(M_PI / around);
  const double ring = std::hypot(0.25, sag);
  EXPECT_NEAR(result.modulus, 10 * ring / (around * chord), 1e-9);
  EXPECT_NEAR(result.innerRadius, std::exp(-2 * M_PI * result.modulus), 1e-14);
  EXPECT_LT(result.holonomy, 1e-9);
  EXPECT_EQ(result.flippedFaces, 0);
  EXPECT_EQ(result.flippedRectangleFaces, 0);
}

TEST(AnnulusMap, OfConeFrustaConvergesToTheModulusAtSecondOrder) {
  const double lower = 2, upper = 0.7, height = 1.4, slant = std::hypot(height, lower - upper);
  const double modulus = slant / (lower - upper) * std::log(lower / upper) / (2 * M_PI);
  const auto error = [&](int level) {
    const AnnulusMesh mesh(frustum(20 * level, 6 * level, lower, upper, height));
    const AnnulusMapResult result = annulusMap(mesh);
    EXPECT_EQ(result.status, Status::Converged);
    EXPECT_LT(result.holonomy, 1e-9);
    EXPECT_LT(result.straightness, 1e-9);
    EXPECT_EQ(result.flippedFaces + result.flippedRectangleFaces, 0);
    return std::abs(result.modulus - modulus);
  };
  const double coarse = error(1), fine = error(2), finest = error(4);
  EXPECT_LT(finest, 1e-3 * modulus);
  EXPECT_GT(coarse / fine, 3.5);
  EXPECT_GT(fine / finest, 3.5);
}

TEST(AnnulusMap, MapsEveryVertexOfAConeFrustumToItsOwnRadiusAndAngle) {
  const double lower = 2, upper = 0.7, height = 1.4, slant = std::hypot(height, lower - upper);
  const AnnulusMesh mesh(frustum(96, 30, lower, upper, height));
  const AnnulusMapResult result = annulusMap(mesh);
  for (int v = 0; v < mesh.mesh().vertexCount(); ++v) {
    const Eigen::Vector3d p = mesh.mesh().point(v);
    const double radius = std::pow(std::hypot(p.x(), p.y()) / lower, slant / (lower - upper));
    const double angle = std::atan2(p.y(), p.x());
    EXPECT_NEAR(result.image(v, 0), radius * std::cos(angle), 2e-3);
    EXPECT_NEAR(result.image(v, 1), radius * std::sin(angle), 2e-3);
  }
}

TEST(AnnulusMap, OpensTheRectangleAlongTheCutAndNowhereElse) {
  const AnnulusMesh mesh(frustum(30, 12, 1, 2, 1));
  const AnnulusMapResult result = annulusMap(mesh);
  const PeriodicRectangle& r = result.rectangle;
  const int n = mesh.mesh().vertexCount();
  EXPECT_EQ(r.points.rows(), n + static_cast<Eigen::Index>(result.cut.size()));
  for (Eigen::Index k = 0; k < r.faces.size(); ++k) {
    EXPECT_EQ(r.originalPointIds[static_cast<std::size_t>(r.faces.data()[k])], mesh.mesh().faces().data()[k]);
  }
  for (std::size_t i = static_cast<std::size_t>(n); i < r.originalPointIds.size(); ++i) {
    const Eigen::RowVector2d shift = r.points.row(static_cast<Eigen::Index>(i)) - r.points.row(r.originalPointIds[i]);
    EXPECT_NEAR(std::abs(shift[0]), 1, 1e-14);
    EXPECT_EQ(shift[1], 0);
  }
  const SurfaceTopology topology(r.faces, static_cast<int>(r.points.rows()));
  EXPECT_EQ(topology.boundaryLoops().size(), 1u);
  EXPECT_EQ(topology.eulerCharacteristic(), 1);
  EXPECT_NEAR(signedFaceAreas(r.points, r.faces).sum(), result.modulus, 1e-12);  // 1 × modulus, oriented
  const std::set<int> onCut(result.cut.begin(), result.cut.end());
  EXPECT_EQ(onCut.size(), result.cut.size());
}

TEST(AnnulusMap, PutsTheChosenLoopOutsideAndTheChosenVertexAtAngleZero) {
  const AnnulusMesh mesh(frustum(20, 8, 1, 2, 1));  // loop 0 is the shorter one
  AnnulusMapOptions options;
  const AnnulusMapResult longest = annulusMap(mesh, options);
  EXPECT_NEAR(longest.image.row(mesh.loops()[1][3]).norm(), 1, 1e-15);
  options.outerLoop = 0;
  options.startVertex = mesh.loops()[0][5];
  const AnnulusMapResult chosen = annulusMap(mesh, options);
  EXPECT_NEAR(chosen.image(options.startVertex, 0), 1, 1e-15);
  EXPECT_NEAR(chosen.image(options.startVertex, 1), 0, 1e-15);
  EXPECT_NEAR(chosen.image.row(mesh.loops()[1][3]).norm(), chosen.innerRadius, 1e-15);
  EXPECT_NEAR(chosen.modulus, longest.modulus, 1e-9);
  EXPECT_EQ(chosen.flippedFaces, 0);  // oriented either way round
  EXPECT_EQ(longest.flippedFaces, 0);
}

TEST(AnnulusMap, RefusesLoopsAndVerticesThatAreNone) {
  const AnnulusMesh mesh(cylinder(12, 4, 1));
  AnnulusMapOptions options;
  options.outerLoop = 2;
  EXPECT_THROW(static_cast<void>(annulusMap(mesh, options)), InvalidArgument);
  options.outerLoop = 0;
  options.startVertex = mesh.loops()[1].front();
  EXPECT_THROW(static_cast<void>(annulusMap(mesh, options)), InvalidArgument);
  EXPECT_EQ(annulusMap(mesh, {}, Execution({}, [] { return true; })).status, Status::Cancelled);
}

TEST(AnnulusMap, BulgesAnEarOfTheInnerLoopIntoTheHole) {
  const TriangleMesh plain = frustum(20, 6, 2, 1, 1);
  const int n = plain.vertexCount();
  Points3 points(n + 1, 3);
  points.topRows(n) = plain.points();
  const int a = 6 * 20 + 3, b = 6 * 20 + 4;  // an edge of the upper, inner loop gets an ear
  points.row(n) = 0.5 * (points.row(a) + points.row(b)) + Eigen::RowVector3d(0, 0, 0.2);
  Faces faces(plain.faceCount() + 1, 3);
  faces.topRows(plain.faceCount()) = plain.faces();
  faces.row(plain.faceCount()) << a, b, n;
  const AnnulusMesh mesh(TriangleMesh(points, faces));
  AnnulusMapOptions options;
  options.unfold = false;
  const AnnulusMapResult folded = annulusMap(mesh, options);
  EXPECT_EQ(folded.flippedFaces, 1);
  EXPECT_EQ(folded.flippedRectangleFaces, 1);
  const AnnulusMapResult result = annulusMap(mesh);
  EXPECT_EQ(result.flippedBeforeUnfolding, 2);
  EXPECT_EQ(result.flippedFaces, 0);
  EXPECT_EQ(result.flippedRectangleFaces, 0);
  EXPECT_EQ(result.pockets, 1);
  EXPECT_EQ(result.rectanglePockets, 1);
  EXPECT_LT(result.image.row(n).norm(), result.innerRadius);
  EXPECT_GT(result.rectangle.points(n, 1), result.modulus);
}

TEST(AnnulusMap, OfRealColonSegmentsHasNoFoldsAndClosesByATranslation) {
  const std::string folder = "colon/EdinGCA_3D_00020_CTC_inflated/large-intestine-";
  for (const char* segment : {"DSJ-SF-", "HF-HF+", "SF-SF+"}) {
    const std::string path = sharedData(folder + segment + ".vtk");
    AUTHALIC_NEEDS(path);
    const AnnulusMesh mesh(readLegacyVtk(path, {0.808594, 0.808594, 0.7}));
    const AnnulusMapResult result = annulusMap(mesh);
    EXPECT_EQ(result.status, Status::Converged) << segment;
    EXPECT_LT(result.holonomy, 1e-9) << segment;
    EXPECT_LT(result.straightness, 1e-9) << segment;
    EXPECT_EQ(result.flippedFaces, 0) << segment;
    EXPECT_EQ(result.flippedRectangleFaces, 0) << segment;
  }
}
