#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <cmath>
#include <numeric>
#include <random>

#include "Core/base/Error.h"
#include "Core/distortion/Distortion.h"
#include "Core/geometry/Areas.h"
#include "Core/initial/ConformalEnergy.h"
#include "Core/initial/LeastSquaresConformalMap.h"
#include "support/OffFile.h"
#include "support/SharedData.h"
#include "support/TestMeshes.h"

using namespace authalic;
using namespace authalic::testing;

namespace {

LeastSquaresConformalMapOptions withPins(ConformalPins pins, int first = -1, int second = -1) {
  LeastSquaresConformalMapOptions options;
  options.pins = pins;
  options.firstPin = first;
  options.secondPin = second;
  return options;
}

const ConformalPins kBoth[] = {ConformalPins::TwoVertices, ConformalPins::Spectral};

}  // namespace

TEST(ConformalEnergy, IsPositiveSemiDefiniteAlsoOnDegenerateFaces) {
  TriangleMesh mesh = roughDisk(3, 2);
  Points3 points = mesh.points();
  points.row(3) = points.row(4);  // a vanished edge
  points.row(7) = 0.5 * (points.row(1) + points.row(2));
  const ConformalEnergy energy(DiskMesh(TriangleMesh(points, mesh.faces())));
  const Eigen::MatrixXd dense = Eigen::MatrixXd(energy.matrix()).selfadjointView<Eigen::Lower>();
  const Eigen::VectorXd values = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(dense).eigenvalues();
  EXPECT_GT(values.minCoeff(), -1e-12 * values.maxCoeff());
}

TEST(ConformalEnergy, IsTheDirichletEnergyLessTheArea) {
  const TriangleMesh mesh = bumpyDisk(6);
  const DiskMesh disk(mesh);
  const ConformalEnergy energy(disk);
  const Points2 image = mesh.points().leftCols<2>();
  EXPECT_NEAR(energy.area(image), signedFaceAreas(image, mesh.faces()).sum(), 1e-12);
  const SparseMatrix stiffness = cotangentStiffness(mesh);
  double dirichlet = 0;
  for (int c = 0; c < 2; ++c)
    dirichlet += 0.5 * image.col(c).dot(stiffness.selfadjointView<Eigen::Lower>() * image.col(c));
  EXPECT_NEAR(energy.dirichlet(image), dirichlet, 1e-12);
}

TEST(LeastSquaresConformalMap, HasTheSurfacesAreaAndItsCentroidAtTheOrigin) {
  const DiskMesh disk(bumpyDisk(10));
  for (const ConformalPins pins : kBoth) {
    const LeastSquaresConformalMapResult result = leastSquaresConformalMap(disk, withPins(pins));
    EXPECT_EQ(result.flippedFaces, 0);
    const Eigen::VectorXd areas = signedFaceAreas(result.image, disk.mesh().faces());
    EXPECT_NEAR(areas.sum(), faceAreas(disk.mesh()).sum(), 1e-11);
    Eigen::RowVector2d moment(0, 0);
    for (int f = 0; f < disk.mesh().faceCount(); ++f) {
      for (int k = 0; k < 3; ++k) moment += areas[f] / 3 * result.image.row(disk.mesh().faces()(f, k));
    }
    EXPECT_LT(moment.norm(), 1e-11);
    EXPECT_NEAR(result.image(result.firstPin, 1), result.image(result.secondPin, 1), 1e-11);
    EXPECT_LT(result.image(result.firstPin, 0), result.image(result.secondPin, 0));
  }
}

TEST(LeastSquaresConformalMap, SpectralPinsHaveNoMoreEnergyPerBoundarySpreadThanTwoPins) {
  const DiskMesh disk(bumpyDisk(10, 1.0));
  const double two = leastSquaresConformalMap(disk).conformalEnergy;
  const double spectral = leastSquaresConformalMap(disk, withPins(ConformalPins::Spectral)).conformalEnergy;
  EXPECT_LT(spectral, two);
}

TEST(LeastSquaresConformalMap, TakesTheFarthestBoundaryVerticesAsPins) {
  const DiskMesh disk(roughDisk(9, 11));
  const LeastSquaresConformalMapResult result = leastSquaresConformalMap(disk);
  double farthest = 0;
  for (const int a : disk.boundary()) {
    for (const int b : disk.boundary())
      farthest = std::max(farthest, (disk.mesh().point(a) - disk.mesh().point(b)).norm());
  }
  EXPECT_EQ((disk.mesh().point(result.firstPin) - disk.mesh().point(result.secondPin)).norm(), farthest);
}

TEST(LeastSquaresConformalMap, CommutesWithSimilaritiesAndRenumbering) {
  const TriangleMesh mesh = bumpyDisk(8);
  const int a = DiskMesh(mesh).boundary()[2], b = DiskMesh(mesh).boundary()[25];
  std::vector<int> order(static_cast<std::size_t>(mesh.vertexCount()));
  std::iota(order.begin(), order.end(), 0);
  std::shuffle(order.begin(), order.end(), std::mt19937(1));
  Points3 points(mesh.vertexCount(), 3);
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  for (int v = 0; v < mesh.vertexCount(); ++v) {
    points.row(order[static_cast<std::size_t>(v)]) =
        5 * (turn * mesh.point(v)).transpose() + Eigen::RowVector3d(1, 2, 3);
  }
  Faces faces = mesh.faces();
  for (Eigen::Index k = 0; k < faces.size(); ++k) faces.data()[k] = order[static_cast<std::size_t>(faces.data()[k])];
  for (const ConformalPins pins : kBoth) {
    const Points2 before = leastSquaresConformalMap(DiskMesh(mesh), withPins(pins, a, b)).image;
    const Points2 after = leastSquaresConformalMap(DiskMesh(TriangleMesh(points, faces)),
        withPins(pins, order[static_cast<std::size_t>(a)], order[static_cast<std::size_t>(b)])).image;
    for (int v = 0; v < mesh.vertexCount(); ++v) {
      EXPECT_LT((after.row(order[static_cast<std::size_t>(v)]) - 5 * before.row(v)).norm(), 1e-6)
          << conformalPinsName(pins);
    }
  }
}

TEST(LeastSquaresConformalMap, GivesTheSameBitsOnOneThreadAndTwo) {
  const DiskMesh disk(bumpyDisk(12));
  for (const ConformalPins pins : kBoth) {
    const Points2 one = leastSquaresConformalMap(disk, withPins(pins), Execution({}, {}, 1)).image;
    EXPECT_TRUE(leastSquaresConformalMap(disk, withPins(pins), Execution({}, {}, 2)).image == one);
  }
}

TEST(LeastSquaresConformalMap, OfASingleTriangleIsSimilar) {
  Points3 points(3, 3);
  points << 0, 0, 0, 3, 0, 1, 0, 2, 2;
  Faces faces(1, 3);
  faces << 0, 1, 2;
  for (const ConformalPins pins : kBoth) {
    const TriangleMesh triangle(points, faces);
    const LeastSquaresConformalMapResult result = leastSquaresConformalMap(DiskMesh(triangle), withPins(pins));
    EXPECT_NEAR(measureDistortion(triangle, result.image).summary.angleDistortion, 2, 1e-6) << conformalPinsName(pins);
  }
}

TEST(LeastSquaresConformalMap, SaysWhenTheEigenvectorHasNotSettled) {
  LeastSquaresConformalMapOptions options = withPins(ConformalPins::Spectral);
  options.maxIterations = 1;
  const LeastSquaresConformalMapResult result = leastSquaresConformalMap(DiskMesh(bumpyDisk(8)), options);
  EXPECT_EQ(result.status, Status::NotConverged);
  EXPECT_EQ(result.history.size(), 1u);
  EXPECT_TRUE(result.image.allFinite());
}

TEST(LeastSquaresConformalMap, RefusesBadPinsAndOptions) {
  const DiskMesh disk(bumpyDisk(4));
  const auto refuses = [&disk](const LeastSquaresConformalMapOptions& options) {
    EXPECT_THROW((void)leastSquaresConformalMap(disk, options), InvalidArgument);
  };
  const int onBoundary = disk.boundary()[0];
  refuses(withPins(ConformalPins::TwoVertices, onBoundary, -1));
  refuses(withPins(ConformalPins::TwoVertices, onBoundary, onBoundary));
  refuses(withPins(ConformalPins::TwoVertices, onBoundary, 0));  // the centre of the disk
  refuses(withPins(ConformalPins::TwoVertices, onBoundary, 100000));
  LeastSquaresConformalMapOptions options;
  options.tolerance = 0;
  refuses(options);
  Points3 points = disk.mesh().points();
  points.row(disk.boundary()[3]) = points.row(onBoundary);
  EXPECT_THROW((void)leastSquaresConformalMap(DiskMesh(TriangleMesh(points, disk.mesh().faces())),
                                              withPins(ConformalPins::TwoVertices, onBoundary, disk.boundary()[3])),
               GeometryError);
}

TEST(LeastSquaresConformalMap, StopsOnRequest) {
  const Execution stopping({}, [] { return true; });
  EXPECT_THROW((void)leastSquaresConformalMap(DiskMesh(bumpyDisk(4)), {}, stopping), CancelledError);
}

TEST(LeastSquaresConformalMap, KeepsTheAnglesOfTheFaceAndTheBrainWithoutFolds) {
  for (const char* name : {"human_face", "human_brain"}) {
    const std::string path = sharedData(std::string("meshes/open_disk/") + name + ".off");
    AUTHALIC_NEEDS(path);
    const DiskMesh disk(readOff(path));
    for (const ConformalPins pins : kBoth) {
      const LeastSquaresConformalMapResult result = leastSquaresConformalMap(disk, withPins(pins));
      EXPECT_EQ(result.status, Status::Converged);
      EXPECT_EQ(result.flippedFaces, 0) << name;
      EXPECT_LE(measureDistortion(disk.mesh(), result.image).summary.meanAngleError, 1.5) << name;
    }
  }
}
