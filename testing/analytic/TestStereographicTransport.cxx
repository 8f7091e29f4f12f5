#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <cmath>
#include <random>

#include "Core/base/Error.h"
#include "Core/geometry/SphericalAreas.h"
#include "Core/transport/StereographicTransport.h"

using namespace authalic;

namespace {

class StereographicTransport : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!PowerDiagram::available()) GTEST_SKIP() << "CGAL was not built in";
  }
};

const Eigen::Vector3d kPole(0.3, -0.5, 0.8);

Points3 randomOnSphere(int count, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  Points3 points(count, 3);
  for (Eigen::Index i = 0; i < points.size(); ++i) points.data()[i] = normal(random);
  points.rowwise().normalize();
  return points;
}

Eigen::VectorXd equalMasses(Eigen::Index count) {
  return Eigen::VectorXd::Constant(count, 4 * M_PI / static_cast<double>(count));
}

// n sites on the circle of radius r of the plane, after one at the origin; the pole is (0, 0, 1).
Points3 ringAndMiddle(int n, double r) {
  Points3 sites(n + 1, 3);
  sites.row(0) << 0, 0, -1;
  for (int k = 0; k < n; ++k) {
    const double angle = 2 * M_PI * k / n;
    sites.row(k + 1) << 2 * r * std::cos(angle), 2 * r * std::sin(angle), r * r - 1;
    sites.row(k + 1) /= 1 + r * r;
  }
  return sites;
}

// Voronoi's heights with a little noise where cells are small, so that none is empty.
Heights someHeights(const StereographicPowerDiagram& diagram, unsigned seed, double size) {
  const Eigen::VectorXd noise = randomOnSphere(static_cast<int>(diagram.sites().rows()), seed).col(0);
  return diagram.voronoiHeights() + (size * noise).cast<long double>();
}

// ∫ over the square of half side d of 4 / (1 + |x|²)² by Simpson's rule.
double squareBySimpson(double d) {
  const int n = 400;
  double sum = 0;
  for (int i = 0; i <= n; ++i) {
    for (int j = 0; j <= n; ++j) {
      const double x = d * (2.0 * i / n - 1), y = d * (2.0 * j / n - 1), q = 1 + x * x + y * y;
      const double wx = i == 0 || i == n ? 1 : i % 2 ? 4 : 2, wy = j == 0 || j == n ? 1 : j % 2 ? 4 : 2;
      sum += wx * wy * 4 / (q * q);
    }
  }
  return sum * std::pow(2 * d / n / 3, 2);
}

// Of the outlines of the cells, fans of great-circle triangles around the first corner.
double fanArea(const SphericalCellPolygons& cells, int i) {
  double area = 0;
  const auto corner = [&](int k) { return Eigen::Vector3d(cells.corners.row(k).transpose()); };
  const int begin = cells.starts[static_cast<std::size_t>(i)], end = cells.starts[static_cast<std::size_t>(i) + 1];
  for (int k = begin + 1; k + 1 < end; ++k) area += signedSolidAngle(corner(begin), corner(k), corner(k + 1));
  return area;
}

}  // namespace

TEST_F(StereographicTransport, GivesARingAndItsMiddleTheAreasOfTheClosedForm) {
  StereographicPowerDiagram diagram(ringAndMiddle(4, 1.2), Eigen::Vector3d::UnitZ());
  ASSERT_TRUE(diagram.compute(diagram.voronoiHeights()));
  const double middle = squareBySimpson(0.6);
  EXPECT_NEAR(diagram.cells().areas[0], middle, 1e-10);
  for (int k = 1; k <= 4; ++k) EXPECT_NEAR(diagram.cells().areas[k], (4 * M_PI - middle) / 4, 1e-10);
  EXPECT_LT((diagram.cells().centroids.row(0) + Eigen::RowVector3d::UnitZ()).norm(), 1e-15);
}

TEST_F(StereographicTransport, CutsThePlaneIntoEqualSectorsOfSitesOnACircle) {
  for (const int n : {3, 5, 8}) {
    StereographicPowerDiagram diagram(ringAndMiddle(n, 0.7).bottomRows(n), Eigen::Vector3d(0, 0, 3));
    ASSERT_TRUE(diagram.compute(diagram.voronoiHeights()));
    EXPECT_LT((diagram.cells().areas.array() - 4 * M_PI / n).abs().maxCoeff(), 1e-14);
    for (int k = 0; k < n; ++k) {  // a lune: its middle lies on the equator
      const Eigen::Vector3d expected(std::cos(2 * M_PI * k / n), std::sin(2 * M_PI * k / n), 0);
      EXPECT_LT((diagram.cells().centroids.row(k).transpose() - expected).norm(), 1e-14);
    }
  }
}

TEST_F(StereographicTransport, GivesTheCornersOfACubeFromTheMiddleOfAFaceTheirClosedForm) {
  Points3 cube(8, 3);
  for (int k = 0; k < 8; ++k) cube.row(k) << (k & 1 ? 1 : -1), (k & 2 ? 1 : -1), (k & 4 ? 1 : -1);
  StereographicPowerDiagram diagram(cube / std::sqrt(3.0), Eigen::Vector3d::UnitZ());
  const TransportSolution solution = stereographicTransport(diagram, equalMasses(8));
  ASSERT_EQ(solution.status, Status::Converged);
  // The four lower corners share a square at the distance d with half the sphere: 16 t atan t = 2π, t = d / √(1 + d²).
  double low = 0, high = 1;
  for (int step = 0; step < 100; ++step) {
    const double t = (low + high) / 2;
    (16 * t * std::atan(t) < 2 * M_PI ? low : high) = t;
  }
  const Points2& z = diagram.planarSites();
  for (int k = 0; k < 4; ++k) {
    const double gap = (z.row(k + 4) - z.row(k)).norm();
    const double distance = static_cast<double>(solution.heights[k] - solution.heights[k + 4]) / gap;
    EXPECT_NEAR(distance, low / std::sqrt(1 - low * low), 1e-9);
    const Eigen::RowVector2d below = diagram.cells().centroids.row(k).head(2),
                             above = diagram.cells().centroids.row(k + 4).head(2);
    EXPECT_NEAR(std::abs(below[0]), std::abs(below[1]), 1e-9);
    EXPECT_GT(below.dot(above) / below.norm() / above.norm(), 1 - 1e-12);  // on one meridian
  }
}

TEST_F(StereographicTransport, CutsHalfThePlaneOffAlongALine) {
  // Two sites, and a third whose height leaves it next to nothing: the line between the two is at the distance d.
  Points3 sites = ringAndMiddle(3, 0.5).topRows(3);
  sites.row(1) << 0.8, 0, -0.6;   // z = (1/2, 0)
  sites.row(2) << -0.8, 0, -0.6;  // z = (−1/2, 0)
  sites.row(0) << 0, 0.8, -0.6;   // z = (0, 1/2)
  StereographicPowerDiagram diagram(sites, Eigen::Vector3d::UnitZ());
  for (const double d : {0.0, 0.4, 3.0}) {
    Heights heights(3);
    heights << -1e9L, 0, d;
    ASSERT_TRUE(diagram.compute(heights));
    const double cap = 2 * M_PI * (1 - d / std::sqrt(1 + d * d));  // the circle through the pole at height d / k
    EXPECT_NEAR(diagram.cells().areas[1], cap, 1e-8);
    EXPECT_NEAR(diagram.cells().areas[2], 4 * M_PI - cap, 1e-8);
    const Eigen::RowVector3d axis = Eigen::RowVector3d(1, 0, d).normalized();
    EXPECT_LT((diagram.cells().centroids.row(1) - axis).norm(), 1e-8);
  }
}

TEST_F(StereographicTransport, SharesTheSphereWithoutGapOrOverlap) {
  for (unsigned seed = 0; seed < 6; ++seed) {
    StereographicPowerDiagram diagram(randomOnSphere(2000, seed), kPole);
    ASSERT_TRUE(diagram.compute(diagram.voronoiHeights()));
    EXPECT_NEAR(diagram.cells().areas.sum(), 4 * M_PI, 1e-12);
    EXPECT_GT(diagram.cells().areas.minCoeff(), 0);
  }
}

TEST_F(StereographicTransport, DrawsOutlinesWhoseAreasApproachThoseOfTheCells) {
  StereographicPowerDiagram diagram(randomOnSphere(2000, 1), kPole);
  ASSERT_TRUE(diagram.compute(diagram.voronoiHeights()));
  const auto error = [&](double arcStep) {
    const SphericalCellPolygons outlines = diagram.polygons(arcStep);
    double worst = 0;
    for (int i = 0; i < 2000; ++i) worst = std::max(worst, std::abs(fanArea(outlines, i) - diagram.cells().areas[i]));
    return worst;
  };
  const double coarse = error(0.004), fine = error(0.002);
  EXPECT_GT(coarse / fine, 3.5) << coarse << ' ' << fine;
  EXPECT_LT(fine, 1e-6);
}

TEST_F(StereographicTransport, GivesEveryPointToTheHighestPlaneAndEveryCellItsMiddle) {
  const Points3 points = randomOnSphere(400000, 4);
  StereographicPowerDiagram diagram(randomOnSphere(40, 3), Eigen::Vector3d::UnitZ());
  const Heights heights = someHeights(diagram, 5, 0.004);
  ASSERT_TRUE(diagram.compute(heights));
  const Points2& z = diagram.planarSites();
  const double share = 4 * M_PI / static_cast<double>(points.rows());
  Eigen::VectorXd counts = Eigen::VectorXd::Zero(40);
  Points3 moments = Points3::Zero(40, 3);
  // The frame of UnitZ may be turned about it: the sites tell how.
  Eigen::Matrix2d turn;
  turn = (diagram.sites().leftCols<2>().topRows<2>().array().colwise() /
          (1 - diagram.sites().col(2).head<2>().array())).matrix().inverse() * z.topRows<2>();
  for (Eigen::Index k = 0; k < points.rows(); ++k) {
    const Eigen::RowVector2d x = points.row(k).head<2>() / (1 - points(k, 2)) * turn;
    Eigen::Index owner = 0;
    (z * x.transpose() + heights.cast<double>()).maxCoeff(&owner);
    counts[owner] += share;
    moments.row(owner) += share * points.row(k);
  }
  for (int i = 0; i < 40; ++i) {  // five standard deviations of the count
    const double deviation = 5 * std::sqrt(share * (diagram.cells().areas[i] + 1e-4));
    EXPECT_NEAR(counts[i], diagram.cells().areas[i], deviation) << i;
    if (counts[i] < 0.05) continue;
    EXPECT_LT((moments.row(i).normalized() - diagram.cells().centroids.row(i)).norm(), deviation / counts[i]) << i;
  }
}

TEST_F(StereographicTransport, HasAreasWhoseDerivativesAreTheRatesOfTheEdges) {
  StereographicPowerDiagram diagram(randomOnSphere(50, 6), kPole);
  const Heights heights = someHeights(diagram, 7, 0.002);
  ASSERT_TRUE(diagram.compute(heights));
  const std::vector<StereographicPowerEdge> edges = diagram.cells().edges;
  for (int j = 0; j < 50; ++j) {
    Eigen::VectorXd expected = Eigen::VectorXd::Zero(50);
    for (const StereographicPowerEdge& edge : edges) {
      if (edge.first != j && edge.second != j) continue;
      expected[edge.first == j ? edge.second : edge.first] -= edge.rate;
      expected[j] += edge.rate;
    }
    const auto step = static_cast<long double>(1e-5 * diagram.cells().areas[j] / expected[j]);
    Heights above = heights, below = heights;
    above[j] += step, below[j] -= step;
    ASSERT_TRUE(diagram.compute(above));
    const Eigen::VectorXd high = diagram.cells().areas;
    ASSERT_TRUE(diagram.compute(below));
    const Eigen::VectorXd slope = (high - diagram.cells().areas) / static_cast<double>(2 * step);
    EXPECT_LT((slope - expected).cwiseAbs().maxCoeff(), 1e-5 * expected[j]) << j;
  }
}

TEST_F(StereographicTransport, ReachesEqualMassesWithoutEmptyingACell) {
  for (unsigned seed = 0; seed < 4; ++seed) {
    StereographicPowerDiagram diagram(randomOnSphere(1000, seed), kPole);
    const TransportSolution solution = stereographicTransport(diagram, equalMasses(1000));
    EXPECT_EQ(solution.status, Status::Converged) << solution.residual;
    EXPECT_LE((diagram.cells().areas.array() - 4 * M_PI / 1000).abs().maxCoeff(), 1e-9 * 4 * M_PI / 1000);
    for (const TransportIteration& step : solution.history) EXPECT_GT(step.smallestCell, 0);
  }
}

TEST_F(StereographicTransport, TakesMoreThanHalfOfTheMassInOneSpot) {  // which transport on the sphere cannot
  Eigen::VectorXd masses = Eigen::VectorXd::Constant(60, 0.3 * 4 * M_PI / 59);
  masses[0] = 0.7 * 4 * M_PI;
  StereographicPowerDiagram diagram(randomOnSphere(60, 10), kPole);
  EXPECT_EQ(stereographicTransport(diagram, masses).status, Status::Converged);
  EXPECT_NEAR(diagram.cells().areas[0], masses[0], 1e-9);
}

TEST_F(StereographicTransport, ConvergesFromAPoleBesideASite) {
  const Points3 sites = randomOnSphere(500, 11);
  for (const double distance : {1e-2, 1e-4, 2e-5}) {
    const Eigen::Vector3d site = sites.row(17).transpose();
    StereographicPowerDiagram diagram(sites, site + distance * site.unitOrthogonal());
    EXPECT_EQ(stereographicTransport(diagram, equalMasses(500)).status, Status::Converged) << distance;
    EXPECT_NEAR(diagram.cells().areas.sum(), 4 * M_PI, 1e-12);
  }
}

TEST_F(StereographicTransport, IsTheSameBitsAtAnyNumberOfThreads) {
  const Points3 sites = randomOnSphere(3000, 9);
  StereographicPowerDiagram one(sites, kPole), three(sites, kPole);
  ASSERT_TRUE(one.compute(one.voronoiHeights(), Execution({}, {}, 1)));
  ASSERT_TRUE(three.compute(three.voronoiHeights(), Execution({}, {}, 3)));
  EXPECT_EQ(one.cells().areas, three.cells().areas);
  EXPECT_EQ(one.cells().centroids, three.cells().centroids);
}

TEST_F(StereographicTransport, RefusesPolesAndSitesThatHaveNoProjection) {
  Points3 sites = randomOnSphere(40, 12);
  EXPECT_THROW(StereographicPowerDiagram(sites, Eigen::Vector3d::Zero()), InvalidArgument);
  EXPECT_THROW(StereographicPowerDiagram(sites, Eigen::Vector3d(0, NAN, 1)), InvalidArgument);
  EXPECT_THROW(StereographicPowerDiagram(sites, sites.row(5).transpose()), GeometryError);
  const Eigen::Vector3d site = sites.row(5).transpose();
  EXPECT_THROW(StereographicPowerDiagram(sites, site + 9e-6 * site.unitOrthogonal()), GeometryError);
  EXPECT_THROW(StereographicPowerDiagram(sites.topRows(2), kPole), GeometryError);
  EXPECT_THROW(StereographicPowerDiagram(2 * sites, kPole), GeometryError);
  StereographicPowerDiagram diagram(sites, kPole);
  EXPECT_THROW((void)diagram.compute(Heights::Zero(39)), GeometryError);
  EXPECT_THROW((void)diagram.compute(Heights::Constant(40, NAN)), GeometryError);
  EXPECT_THROW((void)stereographicTransport(diagram, 2 * equalMasses(40)), GeometryError);
  Heights hidden = diagram.voronoiHeights();
  Eigen::Index inner = 0;
  (void)diagram.planarSites().rowwise().norm().minCoeff(&inner);
  hidden[inner] -= 1e6L;
  EXPECT_FALSE(diagram.compute(hidden));
  sites.row(7) = sites.row(2);
  EXPECT_THROW(StereographicPowerDiagram(sites, kPole), GeometryError);
  Points3 circle(4, 3);
  circle << 1, 0, 0, 0, 0, -1, -1, 0, 0, 0.6, 0, -0.8;
  StereographicPowerDiagram line(circle, Eigen::Vector3d::UnitZ());
  EXPECT_THROW((void)line.compute(line.voronoiHeights()), GeometryError);
}
