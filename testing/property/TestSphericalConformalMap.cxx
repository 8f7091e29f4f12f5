#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numeric>
#include <random>

#include "Core/base/Error.h"
#include "Core/conformal/SphereStarts.h"
#include "Core/conformal/SphericalConformalMap.h"
#include "Core/conformal/UnfoldOnSphere.h"
#include "Core/distortion/SphericalDistortion.h"
#include "Core/geometry/Areas.h"
#include "Core/geometry/SphericalAreas.h"
#include "support/TestMeshes.h"

using namespace authalic;
using namespace authalic::testing;

namespace {

const SphereRoad kRoads[] = {SphereRoad::Harmonic, SphereRoad::Stereographic, SphereRoad::MeanCurvatureFlow,
                              SphereRoad::Welding};

TriangleMesh foldedSphere(int levels) {
  const TriangleMesh sphere = sphereMesh(levels);
  Points3 points = sphere.points();
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    const Eigen::RowVector3d x = points.row(i);
    points.row(i) *= 1 + 0.3 * std::sin(5 * x.x() + 1) * std::cos(4 * x.y()) + 0.2 * x.z();
  }
  return TriangleMesh(points, sphere.faces());
}

SphericalConformalMapOptions byRoad(SphereRoad road) {
  SphericalConformalMapOptions options;
  options.road = road;
  options.puncturedFace = 20;
  return options;
}

double centreOfMass(const TriangleMesh& surface, const Points3& image) {
  const Eigen::VectorXd mass = vertexStars(faceAreas(surface), surface.faces(), surface.vertexCount());
  return (mass.transpose() * image).norm() / mass.sum();
}

/// The mesh with its vertices in another order, its faces as before.
struct Renumbered {
  TriangleMesh mesh;
  std::vector<int> place;  // new number of every vertex
};

Renumbered renumber(const TriangleMesh& mesh, unsigned seed) {
  std::vector<int> place(static_cast<std::size_t>(mesh.vertexCount()));
  std::iota(place.begin(), place.end(), 0);
  std::shuffle(place.begin(), place.end(), std::mt19937(seed));
  Points3 points(mesh.vertexCount(), 3);
  for (int v = 0; v < mesh.vertexCount(); ++v) points.row(place[static_cast<std::size_t>(v)]) = mesh.points().row(v);
  Faces faces = mesh.faces();
  for (Eigen::Index k = 0; k < faces.size(); ++k) faces.data()[k] = place[static_cast<std::size_t>(faces.data()[k])];
  return {TriangleMesh(points, faces), place};
}

}  // namespace

TEST(SphericalConformalMap, IsUnfoldedOfDegreeOneAndCentred) {
  const TriangleMesh mesh = foldedSphere(4);
  for (const SphereRoad road : kRoads) {
    const SphericalMapResult result = sphericalConformalMap(SphereMesh(mesh), byRoad(road));
    EXPECT_EQ(result.status, Status::Converged) << sphereRoadName(road);
    EXPECT_EQ(result.flippedFaces, 0) << sphereRoadName(road);
    EXPECT_LE(result.centreOfMass, 1e-10);
    EXPECT_NEAR(centreOfMass(mesh, result.image), result.centreOfMass, 1e-15);
    const SphericalDistortion distortion = measureSphericalDistortion(mesh, result.image);
    EXPECT_NEAR(distortion.coverage, 1, 1e-12);
    EXPECT_EQ(distortion.flippedByVolume, 0);
  }
}

TEST(SphericalConformalMap, AngleErrorIsAboveTheBoundOfTheAngleDefects) {
  const TriangleMesh mesh = foldedSphere(3);
  Eigen::VectorXd defect = Eigen::VectorXd::Constant(mesh.vertexCount(), 360);
  for (int f = 0; f < mesh.faceCount(); ++f) {
    for (int k = 0; k < 3; ++k) {
      const Eigen::Vector3d a = mesh.corner(f, k), b = mesh.corner(f, (k + 1) % 3) - a,
                            c = mesh.corner(f, (k + 2) % 3) - a;
      defect[mesh.faces()(f, k)] -= std::atan2(b.cross(c).norm(), b.dot(c)) * 180 / M_PI;
    }
  }
  const double bound = defect.cwiseAbs().sum() / (3.0 * mesh.faceCount());
  for (const SphereRoad road : kRoads) {
    const Points3 image = sphericalConformalMap(SphereMesh(mesh), byRoad(road)).image;
    EXPECT_GE(measureSphericalDistortion(mesh, image).sphericalAngleError, bound) << sphereRoadName(road);
  }
}

TEST(SphericalConformalMap, TurnsWithTheSurfaceAndForgetsItsSize) {
  const TriangleMesh mesh = foldedSphere(3);
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(1.0, Eigen::Vector3d(1, -1, 2).normalized()).toRotationMatrix();
  Points3 points = 60 * mesh.points() * turn.transpose();
  points.rowwise() += Eigen::RowVector3d(-30, 5, 90);
  for (const SphereRoad road : kRoads) {
    const Points3 before = sphericalConformalMap(SphereMesh(mesh), byRoad(road)).image;
    const Points3 after = sphericalConformalMap(SphereMesh(TriangleMesh(points, mesh.faces())), byRoad(road)).image;
    EXPECT_LT((after - before * turn.transpose()).rowwise().norm().maxCoeff(), 1e-8) << sphereRoadName(road);
  }
}

TEST(SphericalConformalMap, CommutesWithRenumbering) {
  const TriangleMesh mesh = foldedSphere(3);
  const Renumbered other = renumber(mesh, 4);
  for (const SphereRoad road : kRoads) {
    const Points3 before = sphericalConformalMap(SphereMesh(mesh), byRoad(road)).image;
    const Points3 after = sphericalConformalMap(SphereMesh(other.mesh), byRoad(road)).image;
    for (int v = 0; v < mesh.vertexCount(); ++v) {
      EXPECT_LT((after.row(other.place[static_cast<std::size_t>(v)]) - before.row(v)).norm(), 1e-8)
          << sphereRoadName(road);
    }
  }
}

TEST(SphericalConformalMap, GivesTheSameBitsOnOneThreadAndTwo) {
  const SphereMesh mesh(foldedSphere(4));
  for (const SphereRoad road : kRoads) {
    const Points3 one = sphericalConformalMap(mesh, byRoad(road), Execution({}, {}, 1)).image;
    EXPECT_TRUE(sphericalConformalMap(mesh, byRoad(road), Execution({}, {}, 2)).image == one) << sphereRoadName(road);
  }
}

TEST(SphericalConformalMap, PutsLandmarksWhereTheyAreAsked) {
  const SphereMesh mesh(foldedSphere(3));
  SphericalConformalMapOptions options;
  options.normalisation.rotation = SphereRotation::Landmarks;
  options.normalisation.northVertex = 7;
  options.normalisation.meridianVertex = 60;
  const Points3 image = sphericalConformalMap(mesh, options).image;
  EXPECT_LT((image.row(7) - Eigen::RowVector3d(0, 0, 1)).norm(), 1e-13);
  EXPECT_NEAR(image(60, 1), 0, 1e-13);
}

TEST(SphericalConformalMap, SaysWhenItHasNotConvergedOrWasStopped) {
  const SphereMesh mesh(foldedSphere(3));
  SphericalConformalMapOptions options;
  options.harmonic.maxIterations = 1;
  options.flow.maxIterations = 1;
  EXPECT_EQ(sphericalConformalMap(mesh, options).status, Status::NotConverged);
  options.road = SphereRoad::MeanCurvatureFlow;
  const SphericalMapResult flow = sphericalConformalMap(mesh, options);
  EXPECT_EQ(flow.status, Status::NotConverged);
  EXPECT_EQ(flow.history.size(), 1u);
  EXPECT_TRUE(flow.image.allFinite());

  int calls = 0;
  const Execution stopping({}, [&calls] { return ++calls > 3; });
  EXPECT_EQ(sphericalConformalMap(mesh, {}, stopping).status, Status::Cancelled);
  const Execution stopped({}, [] { return true; });
  EXPECT_THROW((void)sphericalConformalMap(mesh, {}, stopped), CancelledError);
  EXPECT_THROW((void)sphericalConformalMap(mesh, byRoad(SphereRoad::Stereographic), stopped), CancelledError);
}

TEST(SphericalConformalMap, UnfoldsWhatObtuseFacesFold) {
  const TriangleMesh smooth = sphereMesh(5);
  std::mt19937 random(1);
  std::normal_distribution<double> noise(0, 0.04);
  Points3 points = smooth.points();
  for (Eigen::Index k = 0; k < points.size(); ++k) points.data()[k] += noise(random);
  const SphereMesh rough(TriangleMesh(points, smooth.faces()));
  SphericalConformalMapOptions options;
  options.unfold = false;
  const SphericalMapResult folded = sphericalConformalMap(rough, options);
  EXPECT_GT(folded.flippedFaces, 0);
  EXPECT_EQ(folded.status, Status::Stalled);
  options.unfold = true;
  const SphericalMapResult unfolded = sphericalConformalMap(rough, options);
  EXPECT_EQ(unfolded.flippedBeforeUnfolding, folded.flippedFaces);
  EXPECT_EQ(unfolded.flippedFaces, 0);
  EXPECT_EQ(unfolded.status, Status::Converged);
  EXPECT_LT(unfolded.unfoldedVertices, 1000);
}

TEST(SphericalConformalMap, OfTheSmallestSpheresIsUnfolded) {
  Points3 points(4, 3);
  points << 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1;
  Faces faces(4, 3);
  faces << 0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3;
  for (const SphereRoad road : kRoads) {
    for (const TriangleMesh& mesh : {TriangleMesh(points, faces), sphereMesh(0), sphereMesh(1)}) {
      SphericalConformalMapOptions options;
      options.road = road;
      const SphericalMapResult result = sphericalConformalMap(SphereMesh(mesh), options);
      EXPECT_EQ(result.flippedFaces, 0) << sphereRoadName(road) << " " << mesh.faceCount();
      EXPECT_EQ(result.status, Status::Converged) << sphereRoadName(road) << " " << mesh.faceCount();
    }
  }
}

TEST(SphericalConformalMap, SaysThatANeedleIsTooLongForIt) {
  // Conformally a needle of 1 : 100 is a cylinder of length e^157 against its width.
  const TriangleMesh sphere = sphereMesh(4);
  Points3 points = sphere.points();
  points.col(2) *= 100;
  const SphericalMapResult result = sphericalConformalMap(SphereMesh(TriangleMesh(points, sphere.faces())));
  EXPECT_EQ(result.status, Status::Stalled);
  EXPECT_GT(result.flippedFaces, 0);
  EXPECT_TRUE(result.image.allFinite());
}

TEST(HarmonicSphereMap, KeepsTheDegreeOfItsStart) {
  const TriangleMesh sphere = sphereMesh(4);
  Points3 points = sphere.points();
  points.row(0) *= 30;  // four faces hold most of the surface
  const SphereMesh spike(TriangleMesh(points, sphere.faces()));
  const SphericalMapResult result = harmonicSphereMap(spike, tutteSphereMap(spike, 100));
  EXPECT_NEAR(signedSolidAngles(result.image, sphere.faces()).sum(), 4 * M_PI, 1e-9);
}

TEST(SphericalConformalMap, RefusesBadOptions) {
  const SphereMesh mesh(foldedSphere(2));
  const auto refuses = [&mesh](const SphericalConformalMapOptions& options) {
    EXPECT_THROW((void)sphericalConformalMap(mesh, options), InvalidArgument);
  };
  SphericalConformalMapOptions options;
  options.puncturedFace = mesh.mesh().faceCount();
  refuses(options);
  options = {};
  options.puncturedFace = -2;
  refuses(options);
  options = {};
  options.stereographic.puncturedFace = 3;
  refuses(options);
  options = {};
  options.stereographic.correctedShare = 1;
  refuses(options);
  options = {};
  options.harmonic.tolerance = 0;
  refuses(options);
  options = {};
  options.flow.timeStep = 0;
  refuses(options);
  options = {};
  options.normalisation.northVertex = 3;
  refuses(options);
}

TEST(SphericalConformalMap, KeepsItsEnergyFallingFromTheGaussMap) {
  const SphereMesh mesh(foldedSphere(4));
  const SphereLaplacian laplacian(mesh);
  double previous = laplacian.energy(gaussSphereMap(mesh));
  for (int iterations = 1; iterations < 8; ++iterations) {
    HarmonicSphereMapOptions options;
    options.maxIterations = iterations;
    const double energy = laplacian.energy(harmonicSphereMap(mesh, laplacian, gaussSphereMap(mesh), options).image);
    EXPECT_LE(energy, previous * (1 + 1e-12)) << iterations;
    previous = energy;
  }
}

TEST(HarmonicSphereMap, RefusesAStartOffTheSphere) {
  const SphereMesh mesh(foldedSphere(2));
  EXPECT_THROW((void)harmonicSphereMap(mesh, 2 * gaussSphereMap(mesh)), GeometryError);
  EXPECT_THROW((void)harmonicSphereMap(mesh, Points3::Zero(3, 3)), GeometryError);
}

TEST(SphereStarts, TutteIsUnfoldedAndTheGaussMapOfDegreeOne) {
  const SphereMesh mesh(foldedSphere(4));
  EXPECT_EQ(countFlippedOnSphere(tutteSphereMap(mesh, 0), mesh.mesh().faces()), 0);
  const Points3 gauss = gaussSphereMap(mesh);
  EXPECT_NEAR(signedSolidAngles(gauss, mesh.mesh().faces()).sum(), 4 * M_PI, 1e-9);
}

TEST(UnfoldOnSphere, RepairsAFoldAndLeavesTheRestAlone) {
  const SphereMesh mesh(sphereMesh(4));
  Points3 image = mesh.mesh().points();
  image.row(200) = (image.row(200) + 0.3 * Eigen::RowVector3d(0.3, -0.2, 0.5)).normalized();
  const int folds = countFlippedOnSphere(image, mesh.mesh().faces());
  ASSERT_GT(folds, 0);
  const SphereUnfolding unfolded = unfoldOnSphere(mesh, image);
  EXPECT_EQ(unfolded.flippedFaces, 0);
  EXPECT_EQ(countFlippedOnSphere(unfolded.image, mesh.mesh().faces()), 0);
  int moved = 0;
  for (Eigen::Index v = 0; v < image.rows(); ++v) moved += unfolded.image.row(v) != image.row(v);
  EXPECT_EQ(moved, unfolded.movedVertices);
  EXPECT_LT(moved, 300);
  const SphereUnfolding again = unfoldOnSphere(mesh, unfolded.image);
  EXPECT_TRUE(again.image == unfolded.image);
}

TEST(UnfoldOnSphere, RepairsFoldsInSeveralPlacesAtOnce) {
  const SphereMesh mesh(sphereMesh(5));
  Points3 image = mesh.mesh().points();
  std::mt19937 random(9);
  std::normal_distribution<double> normal(0, 0.2);
  for (const int v : {300, 1500, 2200, 3100}) {
    image.row(v) = (image.row(v) + Eigen::RowVector3d(normal(random), normal(random), normal(random))).normalized();
  }
  ASSERT_GT(countFlippedOnSphere(image, mesh.mesh().faces()), 4);
  EXPECT_EQ(unfoldOnSphere(mesh, image).flippedFaces, 0);
}

// A ring of vertices beyond the next one: a patch around its folds goes around the sphere.
TEST(UnfoldOnSphere, RepairsFoldsThatGoAroundTheSphere) {
  const SphereMesh mesh(capsuleMesh(8, 1));
  const auto image = [&mesh](double rise) {
    Points3 result(mesh.mesh().vertexCount(), 3);
    for (int v = 0; v < result.rows(); ++v) {
      const Eigen::Vector3d p = mesh.mesh().point(v);
      const double angle = std::atan2(p[1], p[0]),
                   height = p[2] / (2 * M_PI + 1) + (std::abs(p[2]) < 0.3 ? rise : 0),
                   radius = std::sqrt(std::max(0.0, 1 - height * height));
      result.row(v) << radius * std::cos(angle), radius * std::sin(angle), height;
    }
    return result;
  };
  ASSERT_EQ(countFlippedOnSphere(image(0), mesh.mesh().faces()), 0);
  const Points3 folded = image(0.2);
  ASSERT_GT(countFlippedOnSphere(folded, mesh.mesh().faces()), 10);
  const SphereUnfolding unfolded = unfoldOnSphere(mesh, folded);
  EXPECT_EQ(unfolded.flippedFaces, 0);
  EXPECT_EQ(countFlippedOnSphere(unfolded.image, mesh.mesh().faces()), 0);
  EXPECT_LT((unfolded.image.rowwise().norm().array() - 1).abs().maxCoeff(), 1e-12);
}

TEST(UnfoldOnSphere, CountsWhatItCannotRepair) {
  const SphereMesh mesh(sphereMesh(2));
  const SphereUnfolding mirrored = unfoldOnSphere(mesh, -mesh.mesh().points());  // every face is folded
  EXPECT_EQ(mirrored.flippedFaces, mesh.mesh().faceCount());
  EXPECT_EQ(mirrored.movedVertices, 0);
  EXPECT_THROW((void)unfoldOnSphere(mesh, Points3::Ones(4, 3)), GeometryError);
}
