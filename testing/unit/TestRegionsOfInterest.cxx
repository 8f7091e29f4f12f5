#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <string>

#include "Core/authalic/RegionsOfInterest.h"
#include "Core/authalic/TargetMeasure.h"
#include "Core/base/Error.h"
#include "Core/geometry/Areas.h"
#include "support/TestMeshes.h"

using namespace authalic;
using namespace authalic::testing;

namespace {

using Inside = std::function<bool(const Eigen::Vector3d&)>;

RegionOfInterest region(const TriangleMesh& mesh, const Inside& inside, double factor, double blend = 0) {
  RegionOfInterest result{"R", {}, factor, blend};
  for (int v = 0; v < mesh.vertexCount(); ++v) result.inside.push_back(inside(mesh.point(v)));
  return result;
}

bool left(const Eigen::Vector3d& p) { return p[0] < -0.2; }
bool right(const Eigen::Vector3d& p) { return p[0] > 0.35; }
bool upper(const Eigen::Vector3d& p) { return p[1] > 0.1; }

/// Σ over the vertices of a region of the target's stars.
double share(const TriangleMesh& mesh, const Eigen::VectorXd& density, const RegionOfInterest& region) {
  const Eigen::VectorXd stars = TargetMeasure::fromFaceDensity(mesh, density).vertices();
  double sum = 0;
  for (int v = 0; v < stars.size(); ++v) sum += region.inside[static_cast<std::size_t>(v)] ? stars[v] : 0;
  return sum;
}

double area(const TriangleMesh& mesh, const RegionOfInterest& region) {
  return share(mesh, Eigen::VectorXd::Ones(mesh.faceCount()), region);
}

std::string refusal(const std::function<void()>& action) {
  try {
    action();
  } catch (const InvalidArgument& error) {
    return error.what();
  }
  return "nothing was refused";
}

}  // namespace

TEST(RegionsOfInterest, MultipliesTheOddsOfARegionByItsFactorSharpOrBlended) {
  const TriangleMesh mesh = bumpyDisk(12);
  for (const double factor : {0.25, 0.5, 1.0, 2.0, 4.0, 16.0}) {
    for (const double blend : {0.0, 0.3}) {
      const RegionOfInterest one = region(mesh, left, factor, blend);
      const RegionsOfInterestDensity density = densityOfRegions(mesh, {}, {one});
      const double s = area(mesh, one), wanted = factor * s / (factor * s + 1 - s);
      EXPECT_NEAR(density.sourceShares[0], s, 1e-14);
      EXPECT_NEAR(density.targetShares[0], wanted, 1e-14);
      EXPECT_NEAR(share(mesh, density.faces, one), wanted, 1e-12) << factor << " " << blend;
      EXPECT_GT(density.faces.minCoeff(), 0);
    }
  }
}

TEST(RegionsOfInterest, GivesEverySeparateRegionItsShareAtOnce) {
  const TriangleMesh mesh = bumpyDisk(12);
  const std::vector<RegionOfInterest> both = {region(mesh, left, 4, 0.2), region(mesh, right, 0.5)};
  const RegionsOfInterestDensity density = densityOfRegions(mesh, {}, both);
  const double a = area(mesh, both[0]), b = area(mesh, both[1]), whole = 4 * a + 0.5 * b + 1 - a - b;
  EXPECT_NEAR(share(mesh, density.faces, both[0]), 4 * a / whole, 1e-12);
  EXPECT_NEAR(share(mesh, density.faces, both[1]), 0.5 * b / whole, 1e-12);
}

TEST(RegionsOfInterest, MultipliesFactorsWhereRegionsOverlapInAnyOrder) {
  const TriangleMesh mesh = bumpyDisk(12);
  const RegionOfInterest a = region(mesh, left, 4), b = region(mesh, upper, 2),
                         ab = region(mesh, [](const auto& p) { return left(p) && upper(p); }, 1);
  const double sa = area(mesh, a), sb = area(mesh, b), sab = area(mesh, ab);
  const double inA = 4 * (sa - sab) + 8 * sab, whole = inA + 2 * (sb - sab) + 1 - sa - sb + sab;
  const RegionsOfInterestDensity one = densityOfRegions(mesh, {}, {a, b}), other = densityOfRegions(mesh, {}, {b, a});
  EXPECT_NEAR(share(mesh, one.faces, a), inA / whole, 1e-12);
  EXPECT_NEAR(share(mesh, one.faces, b), (2 * (sb - sab) + 8 * sab) / whole, 1e-12);
  EXPECT_LT((one.faces - other.faces).cwiseAbs().maxCoeff(), 1e-9);
}

TEST(RegionsOfInterest, MultipliesADensityThatIsThereAlready) {
  const TriangleMesh mesh = bumpyDisk(10);
  const Eigen::VectorXd base = Eigen::VectorXd::LinSpaced(mesh.faceCount(), 1, 3);
  const RegionOfInterest one = region(mesh, left, 4);
  const double s = share(mesh, base, one);
  EXPECT_NEAR(share(mesh, densityOfRegions(mesh, base, {one}).faces, one), 4 * s / (4 * s + 1 - s), 1e-12);
}

TEST(RegionsOfInterest, IsNearlyTheFactorOnAndOneOffASharpRegion) {
  const TriangleMesh mesh = bumpyDisk(20);
  const RegionsOfInterestDensity density = densityOfRegions(mesh, {}, {region(mesh, left, 4)});
  EXPECT_EQ(density.faces.minCoeff(), 1);
  EXPECT_NEAR(density.faces.maxCoeff(), density.factors[0], 1e-12);
  EXPECT_GT(density.factors[0], 4);
  EXPECT_LT(density.factors[0], 4.5);
}

TEST(RegionsOfInterest, BlendsOverTheWidthAskedForAndNoFurther) {
  const TriangleMesh mesh = gridMesh(40, 40, 2, 2);
  const RegionOfInterest one = region(mesh, [](const auto& p) { return p[0] < 1.01; }, 4, 0.4);
  const RegionsOfInterestDensity density = densityOfRegions(mesh, {}, {one});
  double before = 1e9;
  for (int column = 0; column < 40; ++column) {
    const double x = (column + 0.5) / 20, rho = density.faces[2 * (20 * 40 + column)];
    if (x < 0.74) {
      EXPECT_NEAR(rho, density.factors[0], 1e-9) << x;
    } else if (x > 1.31) {
      EXPECT_NEAR(rho, 1, 1e-12) << x;
    }
    EXPECT_LE(rho, before + 1e-9) << x;
    before = rho;
  }
}

TEST(RegionsOfInterest, TakesFacesWithoutAreaAsTheTargetMeasureDoes) {
  TriangleMesh mesh = bumpyDisk(8);
  Points3 points = mesh.points();
  points.row(0) = points.row(1);
  mesh = TriangleMesh(points, mesh.faces());
  const RegionOfInterest one = region(mesh, [](const auto& p) { return p.head(2).norm() < 0.4; }, 4);
  const RegionsOfInterestDensity density = densityOfRegions(mesh, {}, {one});
  EXPECT_GT(TargetMeasure::fromFaceDensity(mesh, density.faces).clampedFaces(), 0);
  EXPECT_NEAR(share(mesh, density.faces, one), density.targetShares[0], 1e-12);
}

TEST(RegionsOfInterest, RefusesInWords) {
  const TriangleMesh mesh = bumpyDisk(8);
  const auto said = [&](const RegionOfInterest& bad) {
    return refusal([&] { (void)densityOfRegions(mesh, {}, {bad}); });
  };
  for (const double bad : {0.0, -2.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
    EXPECT_NE(said(region(mesh, left, bad)).find("positive, finite factor"), std::string::npos) << bad;
  }
  EXPECT_NE(said(region(mesh, left, 2, -1)).find("blend of 0 mm or more"), std::string::npos);
  EXPECT_NE(said(region(mesh, [](const auto&) { return false; }, 2)).find("it is empty"), std::string::npos);
  EXPECT_NE(said(region(mesh, [](const auto&) { return true; }, 2)).find("it is everything"), std::string::npos);
  const auto spot = [](const auto& p) { return p.head(2).norm() < 0.15; };
  EXPECT_NE(said(region(mesh, spot, 1e6, 1.5)).find("cannot have"), std::string::npos);
  EXPECT_THROW((void)densityOfRegions(mesh, {}, {RegionOfInterest{"R", {1, 0}, 2, 0}}), GeometryError);
}

TEST(RegionsOfInterest, BrushReachesOnlyTheSheetThatItTouches) {
  const TriangleMesh one = gridMesh(10, 10, 10, 10);
  Points3 points(2 * one.vertexCount(), 3);
  points << one.points(), one.points().rowwise() + Eigen::RowVector3d(0, 0, 1);
  Faces faces(2 * one.faceCount(), 3);
  faces << one.faces(), (one.faces().array() + one.vertexCount()).matrix();
  const TriangleMesh sheets(points, faces);
  for (const auto& inside :
       {ballOnSurface(sheets, {5, 5, 0.1}, 3.01), geodesicBallOnSurface(sheets, {5, 5, 0.1}, 3.01)}) {
    EXPECT_EQ(std::count(inside.begin() + one.vertexCount(), inside.end(), 1), 0);
    EXPECT_GT(std::count(inside.begin(), inside.end(), 1), 20);
    EXPECT_TRUE(inside[5 * 11 + 8]);
    EXPECT_FALSE(inside[5 * 11 + 9]);
  }
  EXPECT_NE(refusal([&] {
              (void)ballOnSurface(sheets, {5, 5, 40}, 3);
            }).find("39 mm away"),
            std::string::npos);
  EXPECT_NE(refusal([&] { (void)ballOnSurface(sheets, {5, 5, 0}, -3); }).find("radius above 0"), std::string::npos);
}

TEST(CurvatureDensity, IsTheMixOfAreaAndCurvature) {
  const TriangleMesh mesh = bumpyDisk(8);
  const Eigen::VectorXd curvature = mesh.points().col(0),
                        stars = vertexStars(faceAreas(mesh), mesh.faces(), mesh.vertexCount());
  const Eigen::VectorXd half = curvatureDensity(mesh, curvature, 0.5);
  const Eigen::VectorXd bent = stars.cwiseProduct(curvature.cwiseAbs());
  const Eigen::VectorXd wanted = 0.5 * stars / stars.sum() + 0.5 * bent / bent.sum();
  EXPECT_LT((half.cwiseProduct(stars) / stars.sum() - wanted).cwiseAbs().maxCoeff(), 1e-15);
  EXPECT_LT((curvatureDensity(mesh, curvature, 0).array() - 1).abs().maxCoeff(), 1e-15);
  EXPECT_THROW((void)curvatureDensity(mesh, curvature, 1), InvalidArgument);
  EXPECT_THROW((void)curvatureDensity(mesh, 0 * curvature, 0.5), InvalidArgument);
  EXPECT_THROW((void)curvatureDensity(mesh, curvature.head(3), 0.5), GeometryError);
}
