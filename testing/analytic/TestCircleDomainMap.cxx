#include <gtest/gtest.h>

#include <cmath>

#include "Core/base/Error.h"
#include "Core/conformal/AnnulusMap.h"
#include "Core/conformal/CircleDomainMap.h"
#include "Core/conformal/RiemannMap.h"
#include "Core/distortion/Distortion.h"
#include "Core/geometry/Areas.h"
#include "Core/mesh/DiskMesh.h"
#include "Core/numerics/Mobius.h"
#include "support/HoledMeshes.h"
#include "support/OffFile.h"
#include "support/SharedData.h"

using namespace authalic;
using namespace authalic::testing;

namespace {

const std::vector<RoundHole>& twoHoles() {
  static const std::vector<RoundHole> holes{{{0.35, 0.2}, 0.21}, {{-0.3, -0.35}, 0.17}};
  return holes;
}

Points2 planar(const TriangleMesh& mesh) { return mesh.points().leftCols(2); }

TriangleMesh lifted(const Points2& points, const Faces& faces) {
  Points3 space = Points3::Zero(points.rows(), 3);
  space.leftCols(2) = points;
  return TriangleMesh(space, faces);
}

double rms(const Points2& a, const Points2& b) { return std::sqrt((a - b).squaredNorm() / static_cast<double>(a.rows())); }

// The domain with hills on it.
TriangleMesh hillyDomain(int rings) {
  const TriangleMesh domain = holedDisk(rings, twoHoles());
  Points3 points = domain.points();
  for (Eigen::Index v = 0; v < points.rows(); ++v) points(v, 2) = 0.4 * std::sin(3 * points(v, 0)) * std::cos(2 * points(v, 1));
  return TriangleMesh(points, domain.faces());
}

// Vertex `centre` of the image to 0, vertex `start` to angle 0.
Points2 normalised(const Points2& image, int centre, int start) {
  const Points2 centred = Mobius::diskToOrigin({image(centre, 0), image(centre, 1)})(image);
  return Mobius::rotation(-std::atan2(centred(start, 1), centred(start, 0)))(centred);
}

int innerVertex(const PolyAnnulusMesh& surface) {
  int v = surface.mesh().vertexCount() / 2;
  while (surface.topology().onBoundary()[static_cast<std::size_t>(v)]) ++v;
  return v;
}

CircleDomainOptions centredAt(int vertex, CircleDomainRoad road = CircleDomainRoad::Curvature) {
  CircleDomainOptions options;
  options.road = road;
  options.normalisation.centre = DiskCentre::Vertex;
  options.normalisation.centreId = vertex;
  return options;
}

}  // namespace

TEST(CircleDomainMap, TakesBackAMobiusTransformationOfACircleDomainExactly) {
  const TriangleMesh domain = holedDisk(16, twoHoles());
  ASSERT_EQ(countFlippedFaces(planar(domain), domain.faces()), 0);
  const Mobius map = Mobius::diskToOrigin({0.3, 0.4});
  const PolyAnnulusMesh surface(lifted(map(planar(domain)), domain.faces()));
  ASSERT_EQ(surface.loops().size(), 3u);
  const int centre = innerVertex(surface);
  const CircleDomainResult result = circleDomainMap(surface, centredAt(centre));
  ASSERT_EQ(result.status, Status::Converged);
  EXPECT_LT(result.roundness, 1e-8);
  EXPECT_LT(result.holonomy, 1e-9);
  const int start = surface.loops()[static_cast<std::size_t>(result.outerLoop)].front();
  EXPECT_LT((result.image - normalised(planar(domain), centre, start)).cwiseAbs().maxCoeff(), 1e-7);
}

TEST(CircleDomainMap, OfACircleDomainOnTheSphereIsStereographicProjection) {
  // Exactly so, but for the edges at the holes that the flow flips: the other diagonal is no chord of the sphere's
  // mesh.
  const TriangleMesh domain = holedDisk(16, twoHoles());
  Points3 points(domain.vertexCount(), 3);
  for (int v = 0; v < domain.vertexCount(); ++v) {
    const Eigen::RowVector2d z = 1.7 * domain.points().row(v).head(2);
    points.row(v) << 2 * z / (1 + z.squaredNorm()), (1 - z.squaredNorm()) / (1 + z.squaredNorm());
  }
  const PolyAnnulusMesh surface(TriangleMesh(points, domain.faces()));
  const int centre = innerVertex(surface);
  CircleDomainOptions options = centredAt(centre);
  for (std::size_t k = 0; k < surface.loops().size(); ++k) {  // the longest loop in space need not be the outer one
    if (domain.points().row(surface.loops()[k].front()).norm() > 0.99) options.outerLoop = static_cast<int>(k);
  }
  const CircleDomainResult result = circleDomainMap(surface, options);
  ASSERT_EQ(result.status, Status::Converged);
  const int start = surface.loops()[static_cast<std::size_t>(result.outerLoop)].front();
  EXPECT_LT((result.image - normalised(planar(domain), centre, start)).cwiseAbs().maxCoeff(), 1e-4);
}

TEST(CircleDomainMap, TakesBackAConformalMapAtSecondOrder) {
  // e^{0.8 z} is conformal and one-to-one on the disk; circles do not stay circles.
  const auto error = [](int rings) {
    const TriangleMesh domain = holedDisk(rings, twoHoles());
    Points2 bent(domain.vertexCount(), 2);
    for (int v = 0; v < domain.vertexCount(); ++v) {
      const double radius = std::exp(0.8 * domain.points()(v, 0)), angle = 0.8 * domain.points()(v, 1);
      bent.row(v) << radius * std::cos(angle), radius * std::sin(angle);
    }
    const PolyAnnulusMesh surface(lifted(bent, domain.faces()));
    int centre = 0;  // the same place at both levels
    while ((domain.points().row(centre).head(2) - Eigen::RowVector2d(0, 0.5)).norm() > 1e-9) ++centre;
    const CircleDomainResult result = circleDomainMap(surface, centredAt(centre));
    EXPECT_EQ(result.status, Status::Converged);
    EXPECT_LT(result.roundness, 1e-8);
    EXPECT_EQ(result.flippedFaces, 0);
    const int start = surface.loops()[static_cast<std::size_t>(result.outerLoop)].front();
    return rms(result.image, normalised(planar(domain), centre, start));
  };
  const double coarse = error(12), fine = error(24), finest = error(48);
  EXPECT_LT(finest, 1e-3);
  EXPECT_GT(coarse / finest, 8);  // irregular triangles at the holes: 16 in the mean of many meshes
  EXPECT_GT(fine / finest, 2.2);
}

TEST(CircleDomainMap, AgreesWithKoebesIteration) {
  const PolyAnnulusMesh surface(hillyDomain(14));
  const int centre = innerVertex(surface);
  const CircleDomainResult flow = circleDomainMap(surface, centredAt(centre)),
                           koebe = circleDomainMap(surface, centredAt(centre, CircleDomainRoad::Koebe));
  ASSERT_EQ(flow.status, Status::Converged);
  ASSERT_EQ(koebe.status, Status::Converged);
  EXPECT_LE(koebe.roundness, 1e-6);
  EXPECT_GE(koebe.rounds, 1);
  EXPECT_LT((flow.image - koebe.image).cwiseAbs().maxCoeff(), 1e-5);
}

TEST(CircleDomainMap, OfADiskIsItsRiemannMapAndOfAnAnnulusItsRing) {
  const TriangleMesh bumpy = bumpyDisk(10);
  EXPECT_LT((circleDomainMap(PolyAnnulusMesh(bumpy)).image - riemannMap(DiskMesh(bumpy)).image).cwiseAbs().maxCoeff(), 1e-9);
  const auto difference = [](int level) {
    const TriangleMesh mesh = revolutionMesh(20 * level, 6 * level, [](double t) { return 2 - t; }, [](double t) { return t; });
    const CircleDomainResult circles = circleDomainMap(PolyAnnulusMesh(mesh));
    const AnnulusMapResult ring = annulusMap(AnnulusMesh(mesh));
    // The modulus of the domain between two circles of radius 1 and r at distance d.
    const FittedCircle& inner = circles.circles[static_cast<std::size_t>(1 - circles.outerLoop)];
    const double d = inner.centre.norm(), r = inner.radius;
    return std::abs(std::acosh((1 + r * r - d * d) / (2 * r)) / (2 * M_PI) - ring.modulus);
  };
  const double coarse = difference(1), fine = difference(2);
  EXPECT_LT(fine, 1e-3);
  EXPECT_GT(coarse / fine, 3.3);
}

TEST(CircleDomainMap, PutsLoopsOnCirclesInsideTheUnitCircle) {
  const PolyAnnulusMesh surface(holedDisk(16, twoHoles()));
  CircleDomainOptions options;
  options.outerLoop = 1;  // a hole turned inside out
  const CircleDomainResult result = circleDomainMap(surface, options);
  ASSERT_EQ(result.status, Status::Converged);
  EXPECT_EQ(result.flippedFaces, 0);
  for (std::size_t k = 0; k < surface.loops().size(); ++k) {
    const FittedCircle& circle = result.circles[k];
    EXPECT_LT(circle.deviation, 1e-13);
    if (static_cast<int>(k) == result.outerLoop) {
      EXPECT_NEAR(circle.radius, 1, 1e-14);
    } else {
      EXPECT_LT(circle.centre.norm() + circle.radius, 1);
    }
  }
  const Eigen::VectorXd areas = vertexStars(faceAreas(surface.mesh()), surface.mesh().faces(), surface.mesh().vertexCount());
  EXPECT_LT((areas.transpose() * result.image).norm() / areas.sum(), 1e-12);
}

TEST(CircleDomainMap, RefusesOptionsOutsideTheirRange) {
  const PolyAnnulusMesh surface(hillyDomain(10));
  CircleDomainOptions options;
  options.outerLoop = 3;
  EXPECT_THROW(static_cast<void>(circleDomainMap(surface, options)), InvalidArgument);
  options = {};
  options.roundness = 0;
  EXPECT_THROW(static_cast<void>(circleDomainMap(surface, options)), InvalidArgument);
  options = {};
  options.maxRounds = -1;
  EXPECT_THROW(static_cast<void>(circleDomainMap(surface, options)), InvalidArgument);
  options = {};
  options.normalisation.startVertex = surface.loops()[1].front();
  EXPECT_THROW(static_cast<void>(circleDomainMap(surface, options)), InvalidArgument);
  options = {};
  options.road = CircleDomainRoad::Koebe;
  options.maxRounds = 0;
  EXPECT_EQ(circleDomainMap(surface, options).status, Status::NotConverged);
  for (const CircleDomainRoad road : {CircleDomainRoad::Curvature, CircleDomainRoad::Koebe}) {
    options = {};
    options.road = road;
    const CircleDomainResult cancelled = circleDomainMap(surface, options, Execution({}, [] { return true; }));
    EXPECT_EQ(cancelled.status, Status::Cancelled);
    EXPECT_EQ(cancelled.image.rows(), 0);
  }
}

TEST(CircleDomainMap, OfRealFacesIsConformalWithRoundHolesAndWithoutFolds) {
  for (const auto& [name, angle] : {std::pair{"sophie", 0.5}, std::pair{"alex_3", 1.0}}) {
    const std::string path = sharedData("meshes/poly_annulus/" + std::string(name) + ".off");
    AUTHALIC_NEEDS(path);
    const PolyAnnulusMesh surface(readOff(path));
    const CircleDomainResult result = circleDomainMap(surface);
    EXPECT_EQ(result.status, Status::Converged);
    EXPECT_EQ(result.flippedBeforeUnfolding, 0);
    EXPECT_LT(result.roundness, 1e-6);
    EXPECT_LT(result.holonomy, 1e-9);
    EXPECT_LT(measureDistortion(surface.mesh(), result.image).summary.meanAngleError, angle);
  }
}
