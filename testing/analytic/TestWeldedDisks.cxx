#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numeric>

#include "Core/base/Error.h"
#include "Core/conformal/RiemannMap.h"
#include "Core/conformal/SphereNormalisation.h"
#include "Core/conformal/WeldedDisks.h"
#include "Core/distortion/SphericalDistortion.h"
#include "Core/geometry/SphericalAreas.h"
#include "Core/topology/LevelSetCut.h"
#include "support/TestMeshes.h"

using namespace authalic;
using namespace authalic::testing;

namespace {

/// The sphere, turned so that no vertex lies at a pole or on the equator.
SphereMesh turnedSphere(int level) {
  const TriangleMesh mesh = sphereMesh(level);
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 0.5).normalized()).toRotationMatrix();
  return SphereMesh(TriangleMesh(mesh.points() * turn.transpose(), mesh.faces()));
}

/// Stereographic image of a half of the unit sphere, `sign` = 1 for the upper one; the seam onto the circle.
Points2 stereographic(const DiskMesh& half, double sign) {
  Points2 image(half.mesh().vertexCount(), 2);
  for (int i = 0; i < image.rows(); ++i) {
    const Eigen::Vector3d p = half.mesh().point(i).normalized();
    image.row(i) << p.x() / (1 + sign * p.z()), sign * p.y() / (1 + sign * p.z());
  }
  for (const int i : half.boundary()) image.row(i).normalize();
  return image;
}

LevelSetCutResult equator(const SphereMesh& sphere) { return levelSetCut(sphere, sphere.mesh().points().col(2)); }

/// The disk w ↦ e^{iφ} (w − a) / (1 − ā w).
Points2 moved(const Points2& points, std::complex<double> a, double phi) {
  Points2 image(points.rows(), 2);
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    const std::complex<double> w(points(i, 0), points(i, 1));
    const std::complex<double> z = std::polar(1.0, phi) * (w - a) / (1.0 - std::conj(a) * w);
    image.row(i) << z.real(), z.imag();
  }
  return image;
}

}  // namespace

TEST(WeldedDisks, TwoHemispheresAreTheSphereWhereverTheirMapsPutTheirCentres) {
  const LevelSetCutResult cut = equator(turnedSphere(4));
  const DiskMesh& above = cut.above.disk;
  const DiskMesh& below = cut.below.disk;
  const Points2 first = moved(stereographic(above, 1), {0.3, -0.2}, 1.1);
  const Points2 second = moved(stereographic(below, -1), {-0.1, 0.4}, 2.0);
  const WeldedDisks welded = weldDisks(above, first, below, second, matchByPlace(above, below));
  const TriangleMesh& surface = welded.surface.mesh();
  EXPECT_EQ(surface.faceCount(), above.mesh().faceCount() + below.mesh().faceCount());
  EXPECT_EQ(countFlippedOnSphere(welded.image, surface.faces()), 0);
  SphereNormalisationOptions toSurface;
  const Points3 onSphere = surface.points().rowwise().normalized();
  const Points3 here = normaliseSphere(surface, welded.image, toSurface).image;
  const Points3 there = normaliseSphere(surface, onSphere, toSurface).image;
  EXPECT_LT((here - there).rowwise().norm().maxCoeff(), 1e-6);
}

TEST(WeldedDisks, RiemannMapsOfTheHalvesGiveAConformalMapWhoseAngleErrorFallsWithTheMesh) {
  const auto angleError = [](int level) {
    const SphereMesh sphere(wavySphere(level));
    const LevelSetCutResult cut = levelSetCut(sphere, sphere.mesh().points().col(2));
    const DiskMesh& above = cut.above.disk;
    const DiskMesh& below = cut.below.disk;
    const WeldedDisks welded =
        weldDisks(above, riemannMap(above).image, below, riemannMap(below).image, matchByPlace(above, below));
    const Points3 image = normaliseSphere(welded.surface.mesh(), welded.image).image;
    const SphericalDistortion distortion = measureSphericalDistortion(welded.surface.mesh(), image);
    EXPECT_NEAR(distortion.coverage, 1, 1e-9);
    EXPECT_LT(welded.welding.accuracy().boundaryMismatch, 1e-10);
    return distortion.summary.angleDistortion - 2;
  };
  EXPECT_GT(angleError(3) / angleError(4), 2.5);
}

TEST(WeldedDisks, NumbersMatchWhatPlacesMatch) {
  const LevelSetCutResult cut = equator(turnedSphere(3));
  const auto numbers = [](const CutHalf& half) {
    std::vector<int> result(static_cast<std::size_t>(half.disk.mesh().vertexCount()), -1);
    for (std::size_t i = static_cast<std::size_t>(half.seamStart); i < result.size(); ++i) {
      result[i] = 100 + static_cast<int>(i) - half.seamStart;
    }
    return result;
  };
  EXPECT_EQ(matchByNumber(cut.above.disk, numbers(cut.above), cut.below.disk, numbers(cut.below)),
            matchByPlace(cut.above.disk, cut.below.disk));
  const std::vector<int> same(static_cast<std::size_t>(cut.below.disk.mesh().vertexCount()), 7);
  EXPECT_THROW((void)matchByNumber(cut.above.disk, numbers(cut.above), cut.below.disk, same), GeometryError);
  EXPECT_THROW((void)matchByNumber(cut.above.disk, {1, 2}, cut.below.disk, same), InvalidArgument);
}

TEST(WeldedDisks, RefusesDisksThatDoNotMeetAndSeamsThatTurnBack) {
  const LevelSetCutResult cut = equator(turnedSphere(3));
  const DiskMesh& above = cut.above.disk;
  const DiskMesh& below = cut.below.disk;
  const Points2 first = stereographic(above, 1), second = stereographic(below, -1);
  EXPECT_THROW((void)matchByPlace(above, DiskMesh(bumpyDisk(4))), GeometryError);
  const TriangleMesh away(below.mesh().points().rowwise() + Eigen::RowVector3d(5, 0, 0), below.mesh().faces());
  EXPECT_THROW((void)matchByPlace(above, DiskMesh(away)), GeometryError);
  const DiskMesh turned(TriangleMesh(below.mesh().points(), below.mesh().faces().rowwise().reverse()));
  EXPECT_THROW((void)weldDisks(above, first, turned, second, matchByPlace(above, turned)), GeometryError);
  const SeamPairs seam = matchByPlace(above, below);
  EXPECT_THROW((void)weldDisks(above, first.topRows(5), below, second, seam), InvalidArgument);
  EXPECT_THROW((void)weldDisks(above, 2 * first, below, second, seam), InvalidArgument);
  EXPECT_THROW((void)weldDisks(above, first, below, second, SeamPairs(seam.begin(), seam.end() - 1)), GeometryError);
  EXPECT_THROW((void)weldDisks(above, first, below, second, seam, Execution({}, [] { return true; })), CancelledError);
}
