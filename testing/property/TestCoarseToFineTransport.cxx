/// Transport from coarse to fine: its parts against closed forms and diagrams, and the same result in fewer steps.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>
#include <vector>

#include "Core/transport/CellMending.h"
#include "Core/transport/CoarseToFineStart.h"
#include "Core/transport/HeightInterpolation.h"
#include "Core/transport/SiteClusters.h"
#include "support/PlanarSites.h"
#include "support/TestMeshes.h"

using namespace authalic;
using authalic::testing::gridMesh;
using authalic::testing::randomPoints;
using authalic::testing::ringPoints;

namespace {

class CoarseToFineTransport : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!PowerDiagram::available()) GTEST_SKIP() << "CGAL was not built in";
  }
};

Eigen::VectorXd equalMasses(Eigen::Index count, double area) {
  return Eigen::VectorXd::Constant(count, area / static_cast<double>(count));
}

// Uneven by a factor of 16 from place to place, and by one of 4 from site to site.
Eigen::VectorXd unevenMasses(const Points2& sites, double area, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> noise(0.5, 2);
  Eigen::VectorXd masses(sites.rows());
  for (Eigen::Index i = 0; i < sites.rows(); ++i) masses[i] = noise(random) * (sites(i, 0) > 0.2 ? 16 : 1);
  return masses * (area / masses.sum());
}

// Many sites about the middle, as in a conformal map.
Points2 crowdedSites(int rings) {
  Points2 sites = ringPoints(rings);
  for (Eigen::Index i = 1; i < sites.rows(); ++i) sites.row(i) *= 0.1 + 0.9 * sites.row(i).squaredNorm();
  return sites;
}

SemiDiscreteTransportOptions startingAt(TransportStart start, double tolerance = 1e-9) {
  SemiDiscreteTransportOptions options;
  options.start = start;
  options.tolerance = tolerance;
  return options;
}

double largestDifference(const Heights& a, const Heights& b) {
  const Heights difference = (a.array() - a.mean()) - (b.array() - b.mean());
  return static_cast<double>(difference.cwiseAbs().maxCoeff() / (b.array() - b.mean()).abs().maxCoeff());
}

// From both starts: the second, which must be from coarse to fine, does not take more steps.
void expectTheSame(PowerDiagram& diagram, const Eigen::VectorXd& masses) {
  const TransportSolution voronoi =
      semiDiscreteTransport(diagram, masses, startingAt(TransportStart::Voronoi, 1e-10));
  const TransportSolution coarse =
      semiDiscreteTransport(diagram, masses, startingAt(TransportStart::CoarseToFine, 1e-10));
  EXPECT_EQ(voronoi.status, Status::Converged);
  EXPECT_EQ(coarse.status, Status::Converged);
  EXPECT_LE(coarse.iterations, voronoi.iterations);
  EXPECT_LT(largestDifference(coarse.heights, voronoi.heights), 1e-9);
  ASSERT_EQ(voronoi.levels.size(), 1U);
  ASSERT_EQ(coarse.levels.size(), 2U);
  EXPECT_EQ(coarse.levels.back().sites, static_cast<int>(masses.size()));
  EXPECT_EQ(coarse.levels.back().iterations, coarse.iterations);
  EXPECT_LT(coarse.levels.back().voronoi, 1);
}

}  // namespace

TEST_F(CoarseToFineTransport, ClustersNeighboursAndKeepsMassesAndCentres) {
  const Points2 sites = randomPoints(5000, 1, -1, 1);
  const Eigen::VectorXd masses = unevenMasses(sites, 4, 2);
  const SiteClusters clusters = clusterSites(sites, masses, 6);
  std::vector<int> sizes(static_cast<std::size_t>(clusters.masses.size()), 0);
  for (const int cluster : clusters.clusterOf) ++sizes[static_cast<std::size_t>(cluster)];
  EXPECT_LE(*std::max_element(sizes.begin(), sizes.end()), 5);  // 5000 / 2^10
  EXPECT_GE(*std::min_element(sizes.begin(), sizes.end()), 1);
  EXPECT_NEAR(clusters.masses.sum(), 4, 1e-12);
  EXPECT_LT((clusters.places.transpose() * clusters.masses - sites.transpose() * masses).norm(), 1e-12);
}

TEST_F(CoarseToFineTransport, LeavesASiteOfMostOfTheMassAlone) {
  const Points2 sites = randomPoints(200, 3, -1, 1);
  Eigen::VectorXd masses = equalMasses(200, 1);
  masses[17] = 1;
  const SiteClusters clusters = clusterSites(sites, masses, 6);
  EXPECT_EQ(std::count(clusters.clusterOf.begin(), clusters.clusterOf.end(), clusters.clusterOf[17]), 1);
  EXPECT_EQ(clusters.masses[clusters.clusterOf[17]], 1);
}

TEST_F(CoarseToFineTransport, InterpolatesTheHeightsOfALatticeThatWasMovedAndScaledExactly) {
  const int n = 10;
  const double scale = 0.4;
  const Eigen::RowVector2d shift(0.3, -0.2);
  Points2 lattice(n * n, 2);
  for (int k = 0; k < n * n; ++k) lattice.row(k) << (k % n + 0.5) / n, (k / n + 0.5) / n;
  const Points2 sites = (scale * lattice).rowwise() + shift;
  PowerDiagram diagram(sites, PlanarDomain::square());
  const TransportSolution solution = semiDiscreteTransport(diagram, equalMasses(n * n, 1));
  const Points2 inside = randomPoints(500, 4, 0, 1);
  std::vector<int> clusterOf;
  for (Eigen::Index i = 0; i < inside.rows(); ++i) {
    clusterOf.push_back(static_cast<int>(inside(i, 1) * n) * n + static_cast<int>(inside(i, 0) * n));
  }
  const HeightInterpolation interpolation(diagram, solution.heights);
  ASSERT_TRUE(interpolation.usable());
  const Heights heights = interpolation.heightsAt((scale * inside).rowwise() + shift, clusterOf, {});
  const Eigen::VectorXd value = 0.5 * scale * inside.rowwise().squaredNorm();  // v, up to a constant: ∇v = inside
  const Heights difference = heights + value.cast<long double>();
  EXPECT_LT(static_cast<double>(difference.maxCoeff() - difference.minCoeff()), 1e-12);
}

TEST_F(CoarseToFineTransport, MendsHiddenAndOversizedCells) {
  const Points2 sites = randomPoints(3000, 5, -0.7, 0.7);
  const PlanarDomain domain = PlanarDomain::disk();
  PowerDiagram diagram(sites, domain);
  Heights heights = startHeights(sites, domain);
  const Eigen::VectorXd masses = diagram.compute(heights).masses;
  for (Eigen::Index i = 0; i < 3000; i += 100) heights[i] -= 0.01;  // hidden
  for (Eigen::Index i = 50; i < 3000; i += 300) heights[i] += 0.001;  // hide others
  EXPECT_GT(diagram.compute(heights).emptyCells, 40);
  const std::vector<int> clusterOf = clusterSites(sites, masses, 6).clusterOf;
  const int clusters = 1 + *std::max_element(clusterOf.begin(), clusterOf.end());
  EXPECT_GE(mendCells(diagram, masses, clusterOf, clusters, heights), 40);  // the hidden ones and those that hide
  const Eigen::ArrayXd parts = diagram.compute(heights).masses.array() / masses.array();
  EXPECT_GE(parts.minCoeff(), 0.09);
  EXPECT_LE(parts.maxCoeff(), 5.1);
  EXPECT_EQ(mendCells(diagram, masses, clusterOf, clusters, heights), 0);
}

TEST_F(CoarseToFineTransport, RaisesAHiddenSiteToHalfOfItsMass) {
  const Points2 sites = randomPoints(2000, 6, 0.01, 0.99);
  const PlanarDomain domain = PlanarDomain::square();
  PowerDiagram diagram(sites, domain);
  const Heights voronoi = startHeights(sites, domain);
  const Eigen::VectorXd masses = diagram.compute(voronoi).masses;
  const std::vector<int> all(2000, 0);
  for (const Eigen::Index i : {3, 77, 1024}) {
    Heights heights = voronoi;
    heights[i] -= 0.01;
    diagram.compute(heights);
    EXPECT_EQ(diagram.cells().masses[i], 0);
    EXPECT_EQ(mendCells(diagram, masses, all, 1, heights), 1);
    diagram.compute(heights);
    EXPECT_GT(diagram.cells().masses[i], 0.5 / 1.21 * masses[i]);
    EXPECT_LT(diagram.cells().masses[i], 0.5 * 1.21 * masses[i]);
  }
}

TEST_F(CoarseToFineTransport, StartsWithoutEmptyCellsFromCrowdedSitesTheBoundaryAndUnevenMasses) {
  Points2 sites = crowdedSites(50);
  sites.bottomRows(300).rowwise().normalize();  // on the circle
  PowerDiagram diagram(sites, PlanarDomain::disk());
  for (const Eigen::VectorXd& masses : {equalMasses(sites.rows(), M_PI), unevenMasses(sites, M_PI, 7)}) {
    const CoarseToFineStart start = coarseToFineStart(diagram, masses, {}, {});
    ASSERT_EQ(start.heights.size(), sites.rows());
    ASSERT_EQ(start.levels.size(), 1U);
    EXPECT_LT(start.voronoi, 1);
    EXPECT_GT(diagram.compute(start.heights).masses.minCoeff(), 0);
    const double error = (diagram.cells().masses - masses).norm();
    EXPECT_LT(error, 0.5 * (diagram.compute(startHeights(sites, diagram.domain())).masses - masses).norm());
  }
}

TEST_F(CoarseToFineTransport, FallsBackOnVoronoisCellsWhereSitesClumpTooMuchToInterpolate) {
  for (unsigned seed = 0; seed < 3; ++seed) {
    Points2 sites = randomPoints(3000, seed, -0.7, 0.7);
    sites.topRows(1200) = (1e-2 * sites.topRows(1200)).rowwise() + Eigen::RowVector2d(0.4, 0.1);
    PowerDiagram diagram(sites, PlanarDomain::disk());
    const Eigen::VectorXd masses = equalMasses(3000, M_PI);
    EXPECT_EQ(coarseToFineStart(diagram, masses, {}, {}).heights.size(), 0);
    const TransportSolution solution =
        semiDiscreteTransport(diagram, masses, startingAt(TransportStart::CoarseToFine));
    EXPECT_EQ(solution.status, Status::Converged) << solution.residual;
    EXPECT_EQ(solution.levels.size(), 1U);
    for (const TransportIteration& step : solution.history) EXPECT_GT(step.smallestCell, 0);
  }
}

TEST_F(CoarseToFineTransport, FindsTheHeightsThatVoronoisCellsLeadToWithoutMoreSteps) {
  const Points2 crowded = crowdedSites(40);
  PowerDiagram disk(crowded, PlanarDomain::disk());
  expectTheSame(disk, equalMasses(crowded.rows(), M_PI));
  expectTheSame(disk, unevenMasses(crowded, M_PI, 8));
  Eigen::VectorXd holed = equalMasses(crowded.rows(), 0.98 * M_PI);
  holed[40] += 0.02 * M_PI;  // as of a hole
  expectTheSame(disk, holed);
  const Points2 random = randomPoints(4000, 9, 0, 1);
  const Points2 bent = random.cwiseProduct(random);  // crowded at one corner
  PowerDiagram square(bent, PlanarDomain::square());
  expectTheSame(square, equalMasses(4000, 1));
  const Points2 outside = (3 * crowded).rowwise() + Eigen::RowVector2d(5, 1);
  PowerDiagram moved(outside, PlanarDomain::disk());
  expectTheSame(moved, equalMasses(crowded.rows(), M_PI));
}

TEST_F(CoarseToFineTransport, FindsThemFromASourceDensity) {
  const TriangleMesh grid = gridMesh(12, 12, 1, 1);
  Eigen::VectorXd values(grid.vertexCount());
  for (int v = 0; v < grid.vertexCount(); ++v) values[v] = 1 + 4 * grid.point(v).x() + grid.point(v).y();
  const auto source =
      std::make_shared<const PiecewiseLinearDensity>(PlanarDomain::square(), DiskMesh(grid), values);
  const Points2 sites = randomPoints(3000, 10, 0, 1);
  PowerDiagram diagram(sites.cwiseProduct(sites), source);
  EXPECT_NEAR(diagram.densityAt({0.5, 0.25}), 3.25, 1e-12);
  expectTheSame(diagram, equalMasses(3000, diagram.total()));
}

TEST_F(CoarseToFineTransport, TakesFewerStepsWhereManySitesCrowd) {
  const Points2 sites = crowdedSites(100);  // 30 301
  PowerDiagram diagram(sites, PlanarDomain::disk());
  const Eigen::VectorXd masses = unevenMasses(sites, M_PI, 11);
  const TransportSolution voronoi = semiDiscreteTransport(diagram, masses, startingAt(TransportStart::Voronoi));
  const TransportSolution automatic = semiDiscreteTransport(diagram, masses);
  EXPECT_EQ(automatic.status, Status::Converged);
  EXPECT_EQ(automatic.levels.size(), 2U);
  EXPECT_LE(automatic.iterations + 2, voronoi.iterations);
}

TEST_F(CoarseToFineTransport, LeavesFewSitesToVoronoisCells) {
  const Points2 sites = crowdedSites(20);
  const Eigen::VectorXd masses = equalMasses(sites.rows(), M_PI);
  PowerDiagram one(sites, PlanarDomain::disk()), other(sites, PlanarDomain::disk());
  const TransportSolution automatic = semiDiscreteTransport(one, masses);
  EXPECT_EQ(automatic.heights,
            semiDiscreteTransport(other, masses, startingAt(TransportStart::Voronoi)).heights);
  ASSERT_EQ(automatic.levels.size(), 1U);
  EXPECT_EQ(automatic.levels[0].voronoi, 1);
}

TEST_F(CoarseToFineTransport, GivesSitesOnALineAndFewSitesTheirMasses) {
  Points2 line(200, 2);
  for (int i = 0; i < 200; ++i) line.row(i) << -0.9 + 1.8 * i * i / 40000.0, 0.1;
  PowerDiagram diagram(line, PlanarDomain::disk());
  const auto options = startingAt(TransportStart::CoarseToFine);
  EXPECT_EQ(semiDiscreteTransport(diagram, equalMasses(200, M_PI), options).status, Status::Converged);
  const Points2 few = randomPoints(10, 12, -0.5, 0.5);
  PowerDiagram small(few, PlanarDomain::disk());
  const TransportSolution solution = semiDiscreteTransport(small, equalMasses(10, M_PI), options);
  EXPECT_EQ(solution.status, Status::Converged);
  EXPECT_EQ(solution.levels.size(), 1U);
}

TEST_F(CoarseToFineTransport, GivesTheSameBitsAtAnyNumberOfThreads) {
  const Points2 sites = crowdedSites(50);
  const Eigen::VectorXd masses = unevenMasses(sites, M_PI, 13);
  const auto heightsOn = [&](int threads) {
    PowerDiagram diagram(sites, PlanarDomain::disk());
    return semiDiscreteTransport(diagram, masses, startingAt(TransportStart::CoarseToFine), {},
                                 Execution({}, {}, threads)).heights;
  };
  EXPECT_EQ(heightsOn(1), heightsOn(4));
}

TEST_F(CoarseToFineTransport, ReportsProgressAndStopsInTheCoarseTransport) {
  const Points2 sites = crowdedSites(50);
  const Eigen::VectorXd masses = equalMasses(sites.rows(), M_PI);
  PowerDiagram diagram(sites, PlanarDomain::disk());
  const auto options = startingAt(TransportStart::CoarseToFine);
  std::vector<double> seen;
  const Execution watched([&](double fraction, const std::string&) { seen.push_back(fraction); });
  const TransportSolution whole = semiDiscreteTransport(diagram, masses, options, {}, watched);
  EXPECT_GT(static_cast<int>(seen.size()), whole.iterations);
  EXPECT_TRUE(std::is_sorted(seen.begin(), seen.end()));
  int asked = 0;
  const Execution stopped({}, [&] { return ++asked > 2; });
  const TransportSolution cancelled = semiDiscreteTransport(diagram, masses, options, {}, stopped);
  EXPECT_EQ(cancelled.status, Status::Cancelled);
  EXPECT_EQ(cancelled.iterations, 0);
  EXPECT_EQ(cancelled.heights.size(), sites.rows());
}
