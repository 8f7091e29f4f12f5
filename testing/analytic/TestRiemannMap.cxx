#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include "Core/base/Error.h"
#include "Core/conformal/RiemannMap.h"
#include "Core/distortion/Distortion.h"
#include "Core/geometry/Areas.h"
#include "Core/numerics/Mobius.h"
#include "support/OffFile.h"
#include "support/SharedData.h"
#include "support/TestMeshes.h"

using namespace authalic;
using namespace authalic::testing;

namespace {

RiemannMapOptions road(RiemannRoad which) {
  RiemannMapOptions options;
  options.road = which;
  return options;
}

double rms(const Points2& a, const Points2& b) {
  return std::sqrt((a - b).squaredNorm() / static_cast<double>(a.rows()));
}

// The conformal map of the spherical cap onto the unit disk: stereographic projection, scaled.
Points2 stereographic(const TriangleMesh& cap, double opening) {
  Points2 image(cap.vertexCount(), 2);
  for (int i = 0; i < cap.vertexCount(); ++i) {
    image.row(i) = cap.points().row(i).head(2) / (1 + cap.points()(i, 2)) / std::tan(opening / 2);
  }
  return image;
}

// A disk mesh without symmetry, moved within the disk by a known Möbius transformation.
TriangleMesh movedDisk(int rings, const Mobius& map) {
  const TriangleMesh flat = diskMesh(rings);
  Points3 points = Points3::Zero(flat.vertexCount(), 3);
  points.leftCols(2) = map(Points2(flat.points().leftCols(2)));
  return TriangleMesh(points, flat.faces());
}

int nearest(const TriangleMesh& mesh, const Eigen::RowVector2d& place) {
  Eigen::Index vertex = 0;
  (mesh.points().leftCols(2).rowwise() - place).rowwise().squaredNorm().minCoeff(&vertex);
  return static_cast<int>(vertex);
}

// Largest |ln(image length / length) − (u_i + u_j)/2| over the edges.
double worstScale(const DiskMesh& disk, const RiemannMapResult& map) {
  double worst = 0;
  for (int h = 0; h < 3 * disk.mesh().faceCount(); ++h) {
    const int i = disk.topology().tail(h), j = disk.topology().head(h);
    const double ratio = (map.image.row(i) - map.image.row(j)).norm() /
                         (disk.mesh().point(i) - disk.mesh().point(j)).norm();
    worst = std::max(worst, std::abs(std::log(ratio) - 0.5 * (map.logScale[i] + map.logScale[j])));
  }
  return worst;
}

}  // namespace

TEST(RiemannMap, OfAFlatDiskIsTheIdentity) {
  const DiskMesh disk(diskMesh(12));
  const RiemannMapResult result = riemannMap(disk);
  EXPECT_EQ(result.status, Status::Converged);
  EXPECT_LT((result.image - disk.mesh().points().leftCols(2)).cwiseAbs().maxCoeff(), 1e-9);
  EXPECT_EQ(result.flippedFaces, 0);
}

TEST(RiemannMap, OfAFlatDiskMovedByAMobiusTransformationTakesItBackExactly) {
  // Möbius transformations are discretely conformal: no discretisation error on this road, whatever the mesh.
  const Mobius map = Mobius::diskToOrigin({0.4, -0.3});
  const DiskMesh disk(movedDisk(10, map));
  RiemannMapOptions options;
  options.normalisation.centre = DiskCentre::Vertex;
  options.normalisation.centreId = 0;
  const RiemannMapResult result = riemannMap(disk, options);
  ASSERT_EQ(result.status, Status::Converged);
  Points2 expected = disk.mesh().points().leftCols(2);
  expected = Mobius::diskToOrigin({expected(0, 0), expected(0, 1)})(expected);
  const int start = disk.boundary().front();
  expected = Mobius::rotation(-std::atan2(expected(start, 1), expected(start, 0)))(expected);
  EXPECT_LT((result.image - expected).cwiseAbs().maxCoeff(), 1e-8);
}

TEST(RiemannMap, OfASphericalCapIsStereographicProjectionExactly) {
  // Stereographic projection is a Möbius transformation of space: chords of the sphere scale by vertex
  // factors.
  const double opening = 1.9;
  const DiskMesh disk(capMesh(16, opening));
  const RiemannMapResult result = riemannMap(disk);
  EXPECT_EQ(result.status, Status::Converged);
  EXPECT_LT(result.holonomy, 1e-9);
  EXPECT_EQ(result.flippedFaces, 0);
  EXPECT_LT((result.image - stereographic(disk.mesh(), opening)).cwiseAbs().maxCoeff(), 1e-9);
}

TEST(RiemannMap, OfAParaboloidConvergesAtSecondOrderOnBothRoads) {
  // A surface of revolution with arc length s: ln r = ∫ ds/ρ, here with ds = √(1 + a²ρ²) dρ.
  const double steepness = 3;
  const auto logRadius = [steepness](double rho) {
    const double s = std::sqrt(1 + steepness * steepness * rho * rho);
    return s - std::atanh(1 / s);
  };
  for (const RiemannRoad which : {RiemannRoad::Boundary, RiemannRoad::Puncture}) {
    const auto error = [&](int rings) {
      const TriangleMesh flat = diskMesh(rings);
      Points3 points = flat.points();
      Points2 expected = points.leftCols(2);
      for (Eigen::Index i = 1; i < points.rows(); ++i) {
        const double rho = expected.row(i).norm();
        points(i, 2) = 0.5 * steepness * rho * rho;
        expected.row(i) *= std::exp(logRadius(rho) - logRadius(1)) / rho;
      }
      const DiskMesh disk(TriangleMesh(points, flat.faces()));
      const RiemannMapResult result = riemannMap(disk, road(which));
      EXPECT_EQ(result.status, Status::Converged);
      EXPECT_LT(result.holonomy, 1e-9);
      EXPECT_EQ(result.flippedFaces, 0);
      return rms(result.image, expected);
    };
    const double coarse = error(16), fine = error(32);
    EXPECT_LT(fine, 2e-3) << riemannRoadName(which);
    EXPECT_GT(coarse / fine, 3.3) << riemannRoadName(which);
  }
}

TEST(RiemannMap, HasScaleFactorsThatItsEdgesFollow) {
  RiemannMapOptions boundary, puncture = road(RiemannRoad::Puncture);
  double coarse = 0, fine = 0;
  for (const int rings : {8, 16}) {
    const DiskMesh disk(capMesh(rings, 1.2));  // Delaunay from the start to the end
    boundary.normalisation.centre = DiskCentre::Vertex;  // off the centre: a Möbius transformation to follow
    boundary.normalisation.centreId = nearest(disk.mesh(), {0.4, 0.2});
    const RiemannMapResult exact = riemannMap(disk, boundary);
    ASSERT_EQ(exact.edgeFlips, 0);
    EXPECT_LT(worstScale(disk, exact), 1e-8);
    puncture.normalisation = boundary.normalisation;
    (rings == 8 ? coarse : fine) = (riemannMap(disk, puncture).logScale - exact.logScale).cwiseAbs().mean();
  }
  EXPECT_LT(fine, 0.3 * coarse);
}

TEST(RiemannMap, RoadsAgreeMoreAndMoreAsMeshesGetFiner) {
  const auto difference = [](int rings) {
    const DiskMesh disk(bumpyDisk(rings, 0.3));
    return rms(riemannMap(disk, road(RiemannRoad::Boundary)).image,
               riemannMap(disk, road(RiemannRoad::Puncture)).image);
  };
  const double coarse = difference(12), fine = difference(24);
  EXPECT_LT(fine, 5e-3);
  EXPECT_GT(coarse / fine, 1.8);
}

TEST(RiemannMap, PutsTheBoundaryOnTheCircleAndTheChosenPartsInTheirPlaces) {
  const DiskMesh disk(bumpyDisk(14));
  RiemannMapOptions options;
  options.normalisation.startVertex = disk.boundary()[17];
  const RiemannMapResult result = riemannMap(disk, options);
  EXPECT_LT(result.roundness, 1e-8);
  for (const int v : disk.boundary()) EXPECT_NEAR(result.image.row(v).norm(), 1, 1e-15);
  EXPECT_NEAR(result.image(disk.boundary()[17], 0), 1, 1e-15);
  EXPECT_NEAR(result.image(disk.boundary()[17], 1), 0, 1e-15);
  const Eigen::VectorXd areas =
      vertexStars(faceAreas(disk.mesh()), disk.mesh().faces(), disk.mesh().vertexCount());
  EXPECT_LT((areas.transpose() * result.image).norm() / areas.sum(), 1e-12);
  Points2 boundary(static_cast<Eigen::Index>(disk.boundary().size()), 2);
  for (std::size_t k = 0; k < disk.boundary().size(); ++k) {
    boundary.row(static_cast<Eigen::Index>(k)) = result.image.row(disk.boundary()[k]);
  }
  EXPECT_GT(polygonArea(boundary), 3);  // counter-clockwise, once around
  options.normalisation.centre = DiskCentre::Face;
  options.normalisation.centreId = 100;
  const Points2 other = riemannMap(disk, options).image;
  Eigen::RowVector2d centroid(0, 0);
  for (int k = 0; k < 3; ++k) centroid += other.row(disk.mesh().faces()(100, k)) / 3;
  EXPECT_LT(centroid.norm(),
            1e-2);  // the transformation takes the old centroid to 0; of the moved face nearly
}

TEST(RiemannMap, DoesNotDependOnScaleOrOnTheNumberingOfVertices) {
  const TriangleMesh mesh = bumpyDisk(10);
  const int n = mesh.vertexCount();
  std::vector<int> order(static_cast<std::size_t>(n));
  std::iota(order.begin(), order.end(), 0);
  std::shuffle(order.begin(), order.end(), std::mt19937(7));
  Points3 points(n, 3);
  Faces faces = mesh.faces();
  for (int i = 0; i < n; ++i) points.row(order[static_cast<std::size_t>(i)]) = 0.01 * mesh.points().row(i);
  for (Eigen::Index k = 0; k < faces.size(); ++k)
    faces.data()[k] = order[static_cast<std::size_t>(faces.data()[k])];
  const DiskMesh disk(mesh), other(TriangleMesh(points, faces));
  for (const RiemannRoad which : {RiemannRoad::Boundary, RiemannRoad::Puncture}) {
    RiemannMapOptions options = road(which);
    options.puncture = 40;
    options.normalisation.startVertex = disk.boundary().front();
    const Points2 image = riemannMap(disk, options).image;
    options.normalisation.startVertex = order[static_cast<std::size_t>(disk.boundary().front())];
    const Points2 shuffled = riemannMap(other, options).image;
    for (int i = 0; i < n; ++i)
      EXPECT_LT((shuffled.row(order[static_cast<std::size_t>(i)]) - image.row(i)).norm(), 1e-8);
  }
}

TEST(RiemannMap, RefusesPuncturesAndCentresThatAreNone) {
  const DiskMesh disk(diskMesh(4)), single(diskMesh(1));
  RiemannMapOptions options = road(RiemannRoad::Puncture);
  options.puncture = disk.mesh().faceCount() - 1;  // at the boundary
  EXPECT_THROW(static_cast<void>(riemannMap(disk, options)), InvalidArgument);
  options.puncture = disk.mesh().faceCount();
  EXPECT_THROW(static_cast<void>(riemannMap(disk, options)), InvalidArgument);
  EXPECT_THROW(static_cast<void>(riemannMap(single, road(RiemannRoad::Puncture))), InvalidArgument);
  options = {};
  options.normalisation.centre = DiskCentre::Vertex;
  options.normalisation.centreId = disk.boundary()[2];
  EXPECT_THROW(static_cast<void>(riemannMap(disk, options)), InvalidArgument);
  options.normalisation.centre = DiskCentre::Face;
  options.normalisation.centreId = -1;
  EXPECT_THROW(static_cast<void>(riemannMap(disk, options)), InvalidArgument);
  options = {};
  options.normalisation.startVertex = 0;
  EXPECT_THROW(static_cast<void>(riemannMap(disk, options)), InvalidArgument);
}

TEST(RiemannMap, HandsBackAnEmptyImageWhenCancelled) {
  const DiskMesh disk(bumpyDisk(6));
  for (const RiemannRoad which : {RiemannRoad::Boundary, RiemannRoad::Puncture}) {
    const RiemannMapResult result = riemannMap(disk, road(which), Execution({}, [] { return true; }));
    EXPECT_EQ(result.status, Status::Cancelled);
    EXPECT_EQ(result.image.rows(), 0);
  }
}

TEST(RiemannMap, OfRealSurfacesIsConformalWithoutFolds) {
  for (const auto& [name, angle] : {std::pair{"human_face", 1.25}, std::pair{"camelhead", 1.45}}) {
    const std::string path = sharedData("meshes/open_disk/" + std::string(name) + ".off");
    AUTHALIC_NEEDS(path);
    const DiskMesh disk(readOff(path));
    for (const RiemannRoad which : {RiemannRoad::Boundary, RiemannRoad::Puncture}) {
      const RiemannMapResult result = riemannMap(disk, road(which));
      EXPECT_EQ(result.status, Status::Converged);
      EXPECT_EQ(result.flippedFaces, 0);
      EXPECT_LT(result.holonomy, 1e-9);
      EXPECT_LT(measureDistortion(disk.mesh(), result.image).summary.meanAngleError, angle);
    }
  }
}

TEST(RiemannMapSlow, OfABrainHasAnAngleErrorBelowOneAndAHalfDegreesOnBothRoads) {
  const std::string path = sharedData("meshes/open_disk/human_brain.off");
  AUTHALIC_NEEDS(path);
  const DiskMesh disk(readOff(path));
  std::vector<Points2> images;
  for (const RiemannRoad which : {RiemannRoad::Boundary, RiemannRoad::Puncture}) {
    const RiemannMapResult result = riemannMap(disk, road(which));
    EXPECT_EQ(result.status, Status::Converged);
    EXPECT_EQ(result.flippedBeforeUnfolding, 0);
    EXPECT_LT(result.holonomy, 1e-9);
    EXPECT_LT(measureDistortion(disk.mesh(), result.image).summary.meanAngleError, 1.44);
    images.push_back(result.image);
  }
  EXPECT_LT((images[0] - images[1]).rowwise().norm().maxCoeff(), 1e-3);
}
