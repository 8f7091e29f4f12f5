#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "Core/base/Error.h"
#include "Core/geometry/Areas.h"
#include "Core/transport/PowerDiagram.h"

using namespace authalic;

namespace {

class PowerDiagrams : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!PowerDiagram::available()) GTEST_SKIP() << "CGAL was not built in";
  }
};

PlanarDomain pentagon() {
  Points2 corners(5, 2);
  corners << 0, 0, 3, 0, 4, 2, 1, 4, -1, 2;
  return PlanarDomain::polygon(corners);
}

Points2 randomPoints(int count, unsigned seed, double low = -1, double high = 1) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(low, high);
  Points2 points(count, 2);
  for (Eigen::Index i = 0; i < points.size(); ++i) points.data()[i] = uniform(random);
  return points;
}

Eigen::VectorXd voronoi(const Points2& sites) { return -0.5 * sites.rowwise().squaredNorm(); }

// Voronoi's heights and noise, so that a few cells are empty.
Eigen::VectorXd noisyHeights(const Points2& sites, unsigned seed, double noise) {
  return voronoi(sites) + noise * randomPoints(static_cast<int>(sites.rows()), seed).col(0);
}

// A corner every so often on the circle.
Points2 manyCorners(int count) {
  Points2 corners(count, 2);
  for (int k = 0; k < count; ++k) corners.row(k) << std::cos(2 * M_PI * k / count), std::sin(2 * M_PI * k / count);
  return corners;
}

// The cell as what is left of the domain when every other site has cut its half-plane off: no triangulation.
Points2 cellByHalfPlanes(Points2 polygon, const Points2& sites, const Eigen::VectorXd& heights, Eigen::Index i) {
  for (Eigen::Index j = 0; j < sites.rows(); ++j) {
    if (j == i) continue;
    const auto excess = [&](const Eigen::RowVector2d& x) {
      return x.dot(sites.row(i) - sites.row(j)) + heights[i] - heights[j];
    };
    std::vector<Eigen::RowVector2d> kept;
    for (Eigen::Index k = 0; k < polygon.rows(); ++k) {
      const Eigen::RowVector2d a = polygon.row(k), b = polygon.row((k + 1) % polygon.rows());
      const double ea = excess(a), eb = excess(b);
      if (ea >= 0) kept.push_back(a);
      if ((ea > 0 && eb < 0) || (ea < 0 && eb > 0)) kept.push_back(a + ea / (ea - eb) * (b - a));
    }
    polygon.resize(static_cast<Eigen::Index>(kept.size()), 2);
    for (std::size_t k = 0; k < kept.size(); ++k) polygon.row(static_cast<Eigen::Index>(k)) = kept[k];
    if (kept.empty()) break;
  }
  return polygon;
}

double worstAreaError(const Points2& sites, const Eigen::VectorXd& heights, const PlanarDomain& domain,
                      const Points2& outline) {
  PowerDiagram diagram(sites, domain);
  diagram.compute(heights);
  double worst = 0;
  for (Eigen::Index i = 0; i < sites.rows(); ++i) {
    const Points2 cell = cellByHalfPlanes(outline, sites, heights, i);
    worst = std::max(worst, std::abs(diagram.cells().areas[i] - (cell.rows() > 2 ? polygonArea(cell) : 0)));
  }
  return worst;
}

}  // namespace

TEST_F(PowerDiagrams, GiveTheWholeDomainToASingleSite) {
  Points2 site(1, 2);
  site << 0.25, -0.5;
  PowerDiagram disk(site, PlanarDomain::disk());
  const PowerCells& cells = disk.compute(Eigen::VectorXd::Constant(1, 3.0));
  EXPECT_NEAR(cells.areas[0], M_PI, 1e-15);
  EXPECT_LT(cells.centroids.row(0).norm(), 1e-15);
  EXPECT_NEAR(cells.costs[0], M_PI / 2 + 0.3125 * M_PI, 1e-15);
  EXPECT_TRUE(cells.edges.empty());
  PowerDiagram square(site, PlanarDomain::square());
  square.compute(Eigen::VectorXd::Zero(1));
  EXPECT_NEAR(square.cells().areas[0], 1, 1e-15);
  EXPECT_NEAR((square.cells().centroids.row(0) - Eigen::RowVector2d(0.5, 0.5)).norm(), 0, 1e-15);
  EXPECT_NEAR(square.cells().costs[0], 1.0 / 6 + 0.0625 + 1, 1e-15);
}

TEST_F(PowerDiagrams, CutTheDiskAlongTheBisectorOfTwoSites) {
  Points2 sites(2, 2);
  sites << 0.1, 0.2, 0.5, 0.5;  // at distance ½
  PowerDiagram diagram(sites, PlanarDomain::disk());
  const Eigen::RowVector2d normal(0.8, 0.6);
  for (const double c : {-0.99999, -0.7, 0.0, 0.3, 0.999}) {  // ⟨x, normal⟩ = c
    const PowerCells& cells = diagram.compute(Eigen::Vector2d(0.5 * c, 0));
    const double beyond = std::acos(c) - c * std::sqrt(1 - c * c), sine = std::sqrt(1 - c * c);
    EXPECT_NEAR(cells.areas[1], beyond, 1e-14) << c;
    EXPECT_NEAR(cells.areas[0], M_PI - beyond, 1e-14) << c;
    EXPECT_LT((cells.areas[1] * cells.centroids.row(1) - 2.0 / 3 * sine * sine * sine * normal).norm(), 1e-14) << c;
    const double polar = M_PI / 2 + M_PI * sites.row(0).squaredNorm();  // cost when site 0 had all
    const double moved = cells.areas[1] * (sites.row(1).squaredNorm() - sites.row(0).squaredNorm()) -
                         2 * cells.areas[1] * cells.centroids.row(1).dot(sites.row(1) - sites.row(0));
    EXPECT_NEAR(cells.costs.sum(), polar + moved, 1e-14) << c;
    ASSERT_EQ(cells.edges.size(), 1u);
    EXPECT_NEAR(cells.edges[0].length, 2 * sine, 1e-12) << c;
  }
}

TEST_F(PowerDiagrams, GiveNothingToASiteBeyondReach) {
  Points2 sites(2, 2);
  sites << 0, 0, 0.5, 0;
  PowerDiagram diagram(sites, PlanarDomain::disk());
  const PowerCells& cells = diagram.compute(Eigen::Vector2d(1, 0));
  EXPECT_EQ(cells.areas[1], 0);
  EXPECT_EQ(cells.emptyCells, 1);
  EXPECT_NEAR(cells.areas[0], M_PI, 1e-15);
  EXPECT_EQ(diagram.polygons().starts[1], diagram.polygons().starts[2]);
}

TEST_F(PowerDiagrams, CutStripesWhenAllSitesLieOnOneLine) {
  Points2 sites(4, 2);
  sites << 0.2, 0.4, 0.8, 0.4, 0.4, 0.4, 0.6, 0.4;  // not in order
  PowerDiagram diagram(sites, PlanarDomain::square());
  diagram.compute(voronoi(sites));
  EXPECT_LT((diagram.cells().areas - Eigen::Vector4d(0.3, 0.3, 0.2, 0.2)).norm(), 1e-15);
  Eigen::VectorXd heights = voronoi(sites);
  heights[2] -= 1;  // hidden
  diagram.compute(heights);
  EXPECT_LT((diagram.cells().areas - Eigen::Vector4d(0.4, 0.3, 0, 0.3)).norm(), 1e-15);
  EXPECT_EQ(diagram.cells().emptyCells, 1);
}

TEST_F(PowerDiagrams, OfALatticeAreItsSquares) {
  const int n = 8;
  Points2 sites(n * n, 2);
  for (int k = 0; k < n * n; ++k) sites.row(k) << (k % n + 0.5) / n, (k / n + 0.5) / n;
  PowerDiagram diagram(sites, PlanarDomain::square());
  const PowerCells& cells = diagram.compute(voronoi(sites));
  EXPECT_LT((cells.areas.array() - 1.0 / (n * n)).abs().maxCoeff(), 1e-15);
  EXPECT_LT((cells.centroids - sites).cwiseAbs().maxCoeff(), 1e-14);
  EXPECT_NEAR(cells.costs.sum(), 1.0 / (6 * n * n), 1e-15);
}

TEST_F(PowerDiagrams, AgreeWithCuttingHalfPlanesOneByOne) {
  for (unsigned seed = 0; seed < 8; ++seed) {
    const Points2 inSquare = randomPoints(60, seed, 0, 1), anywhere = randomPoints(60, seed, -2, 5);
    const PlanarDomain square = PlanarDomain::square();
    EXPECT_LT(worstAreaError(inSquare, noisyHeights(inSquare, seed + 50, 0.01), square, square.corners()), 1e-14);
    EXPECT_LT(worstAreaError(anywhere, noisyHeights(anywhere, seed, 0.5), pentagon(), pentagon().corners()), 1e-12);
    const Points2 aroundDisk = randomPoints(60, seed, -1.5, 1.5);
    EXPECT_LT(worstAreaError(aroundDisk, noisyHeights(aroundDisk, seed, 0.05), {}, manyCorners(4096)), 3e-6);
  }
}

TEST_F(PowerDiagrams, ShareTheDomainWithoutGapOrOverlap) {
  for (unsigned seed = 0; seed < 8; ++seed) {
    for (const PlanarDomain& domain : {PlanarDomain::disk(), PlanarDomain::square(), pentagon()}) {
      const Points2 sites = randomPoints(500, seed, -1, 2);
      PowerDiagram diagram(sites, domain);
      const PowerCells& cells = diagram.compute(noisyHeights(sites, seed, 0.02));
      EXPECT_NEAR(cells.areas.sum(), domain.area(), 1e-13 * domain.area());
      EXPECT_GT(cells.emptyCells, 0);
      const CellPolygons outlines = diagram.polygons(0.01);
      double drawn = 0;
      for (std::size_t i = 0; i + 1 < outlines.starts.size(); ++i) {
        const Points2 cell =
            outlines.corners.middleRows(outlines.starts[i], outlines.starts[i + 1] - outlines.starts[i]);
        if (cell.rows() > 2) drawn += polygonArea(cell);
      }
      EXPECT_NEAR(drawn, domain.area(), domain.isDisk() ? 1e-4 : 1e-13 * domain.area());
    }
  }
}

TEST_F(PowerDiagrams, CopeWithSitesOnTheBoundaryAndInItsCorners) {
  const Points2 circle = manyCorners(300);
  PowerDiagram disk(circle, PlanarDomain::disk());
  EXPECT_LT((disk.compute(voronoi(circle)).areas.array() - M_PI / 300).abs().maxCoeff(), 1e-13);
  Points2 grid(121, 2);
  for (int k = 0; k < 121; ++k) grid.row(k) << k % 11 / 10.0, k / 11 / 10.0;
  PowerDiagram square(grid, PlanarDomain::square());
  const Eigen::VectorXd& areas = square.compute(voronoi(grid)).areas;
  EXPECT_NEAR(areas[0], 0.0025, 1e-15);
  EXPECT_NEAR(areas[5], 0.005, 1e-15);
  EXPECT_NEAR(areas[60], 0.01, 1e-15);
}

TEST_F(PowerDiagrams, HaveAreasWhoseDerivativesAreTheirEdges) {
  const Points2 sites = 0.7 * randomPoints(40, 3);
  const Eigen::VectorXd heights = noisyHeights(sites, 4, 0.003);
  PowerDiagram diagram(sites, PlanarDomain::disk());
  const std::vector<PowerEdge> edges = diagram.compute(heights).edges;
  for (const int j : {0, 7, 21}) {
    Eigen::VectorXd expected = Eigen::VectorXd::Zero(40);
    for (const PowerEdge& edge : edges) {
      if (edge.first != j && edge.second != j) continue;
      const double rate = edge.length / (sites.row(edge.first) - sites.row(edge.second)).norm();
      expected[edge.first == j ? edge.second : edge.first] -= rate;
      expected[j] += rate;
    }
    const Eigen::VectorXd change = 1e-6 * Eigen::VectorXd::Unit(40, j);
    const Eigen::VectorXd above = diagram.compute(heights + change).areas;
    const Eigen::VectorXd below = diagram.compute(heights - change).areas;
    EXPECT_LT(((above - below) / 2e-6 - expected).cwiseAbs().maxCoeff(), 1e-6 * expected[j]);
  }
}

TEST_F(PowerDiagrams, HaveTheAreasAsDerivativesOfTheIntegratedPotential) {
  const Points2 sites = 0.7 * randomPoints(40, 5);
  const Eigen::VectorXd heights = noisyHeights(sites, 6, 0.003);
  PowerDiagram diagram(sites, PlanarDomain::disk());
  const auto integral = [&](const Eigen::VectorXd& h) {  // ∫ max_i ⟨x, y_i⟩ + h_i
    const PowerCells& cells = diagram.compute(h);
    return cells.areas.dot(cells.centroids.cwiseProduct(sites).rowwise().sum() + h);
  };
  for (const int j : {2, 11, 30}) {
    const Eigen::VectorXd change = 1e-6 * Eigen::VectorXd::Unit(40, j);
    const double slope = (integral(heights + change) - integral(heights - change)) / 2e-6;
    EXPECT_NEAR(slope, diagram.compute(heights).areas[j], 1e-8);
  }
}

TEST_F(PowerDiagrams, FollowChangingHeightsAsIfMadeAnew) {
  for (const bool disk : {true, false}) {
    Points2 sites = randomPoints(2000, 21, disk ? -0.7 : 0, disk ? 0.7 : 1);
    if (!disk) {  // sites on straight sides, where the hull of the sites is flat
      for (int k = 0; k < 40; ++k) sites.row(k) << k / 40.0, 0;
      for (int k = 0; k < 40; ++k) sites.row(40 + k) << 1, k / 40.0;
    }
    const PlanarDomain domain = disk ? PlanarDomain::disk() : PlanarDomain::square();
    PowerDiagram followed(sites, domain);
    followed.compute(voronoi(sites));
    for (unsigned step = 1; step < 20; ++step) {  // small changes, a few that hide sites, and back
      const Eigen::VectorXd heights = noisyHeights(sites, step, step % 5 == 0 ? 1e-2 : 2e-5 * step);
      PowerDiagram fresh(sites, domain);
      const PowerCells& expected = fresh.compute(heights);
      const PowerCells& cells = followed.compute(heights);
      EXPECT_LT((cells.areas - expected.areas).cwiseAbs().maxCoeff(), 1e-14) << step;
      EXPECT_EQ(cells.emptyCells, expected.emptyCells) << step;
      EXPECT_NEAR(cells.areas.sum(), domain.area(), 1e-12);
    }
  }
}

TEST_F(PowerDiagrams, AreTheSameBitsAtAnyNumberOfThreads) {
  const Points2 sites = randomPoints(5000, 9);
  PowerDiagram diagram(sites, PlanarDomain::disk());
  const PowerCells one = diagram.compute(noisyHeights(sites, 1, 1e-4), Execution({}, {}, 1));
  const PowerCells& three = diagram.compute(noisyHeights(sites, 1, 1e-4), Execution({}, {}, 3));
  EXPECT_EQ(one.areas, three.areas);
  EXPECT_EQ(one.costs, three.costs);
  ASSERT_EQ(one.edges.size(), three.edges.size());
  EXPECT_EQ(one.edges.back().length, three.edges.back().length);
}

TEST_F(PowerDiagrams, RefuseWhatTheyCannotDivide) {
  Points2 sites(3, 2);
  sites << 0, 0, 0.5, 0, 0, 0;
  try {
    PowerDiagram diagram(sites, PlanarDomain::disk());
    FAIL() << "coincident sites were taken";
  } catch (const GeometryError& error) {
    EXPECT_NE(std::string(error.what()).find("sites 0 and 2"), std::string::npos) << error.what();
  }
  EXPECT_THROW(PowerDiagram(Points2(0, 2), PlanarDomain::disk()), GeometryError);
  EXPECT_THROW(PowerDiagram(Points2::Constant(1, 2, NAN), PlanarDomain::disk()), GeometryError);
  Points2 arrow(4, 2);
  arrow << 0, 0, 2, 1, 0, 2, 1, 1;
  EXPECT_THROW(PowerDiagram(sites.topRows(2), PlanarDomain::polygon(arrow)), InvalidArgument);
  PowerDiagram diagram(sites.topRows(2), PlanarDomain::disk());
  EXPECT_THROW(diagram.compute(Eigen::VectorXd::Zero(3)), GeometryError);
  EXPECT_THROW(diagram.compute(Eigen::VectorXd::Constant(2, INFINITY)), GeometryError);
}
