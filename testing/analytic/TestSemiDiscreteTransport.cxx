#include <gtest/gtest.h>

#include <cmath>

#include "Core/base/Error.h"
#include "Core/transport/SemiDiscreteTransport.h"
#include "support/PlanarSites.h"

using namespace authalic;
using authalic::testing::randomPoints;
using authalic::testing::ringPoints;

namespace {

class SemiDiscreteTransport : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!PowerDiagram::available()) GTEST_SKIP() << "CGAL was not built in";
  }
};

// The radial map r ↦ r (1 + r²) / 2 of the disk and its inverse.
double outwards(double r) { return r * (1 + r * r) / 2; }
double inwards(double radius) {
  double r = radius;
  for (int k = 0; k < 60; ++k) r -= (outwards(r) - radius) / (0.5 + 1.5 * r * r);
  return r;
}

// What `outwards` makes of the uniform measure: the share of each of those points, exact for every ring.
Eigen::VectorXd ringMasses(int rings) {
  const auto within = [&](double k) { return M_PI * std::pow(inwards(std::min(1.0, (k + 0.5) / (rings + 0.5))), 2); };
  Eigen::VectorXd masses(1 + 3 * rings * (rings + 1));
  masses[0] = within(0);
  for (int r = 1, row = 1; r <= rings; ++r) {
    for (int k = 0; k < 6 * r; ++k, ++row) masses[row] = (within(r) - within(r - 1)) / (6 * r);
  }
  return masses;
}

// Root mean square distance between the centroids and the places that the closed form has for them.
double radialError(int rings) {
  const Points2 sites = ringPoints(rings);
  PowerDiagram diagram(sites, PlanarDomain::disk());
  const TransportSolution solution = semiDiscreteTransport(diagram, ringMasses(rings));
  EXPECT_EQ(solution.status, Status::Converged);
  double sum = 0;
  for (Eigen::Index i = 1; i < sites.rows(); ++i) {
    const double radius = sites.row(i).norm();
    sum += (diagram.cells().centroids.row(i) - inwards(radius) / radius * sites.row(i)).squaredNorm();
  }
  return std::sqrt(sum / static_cast<double>(sites.rows()));
}

Eigen::VectorXd equalMasses(Eigen::Index count, double area) {
  return Eigen::VectorXd::Constant(count, area / static_cast<double>(count));
}

}  // namespace

TEST_F(SemiDiscreteTransport, OfUniformToUniformIsTheIdentity) {
  const int n = 12;
  Points2 sites(n * n, 2);
  for (int k = 0; k < n * n; ++k) sites.row(k) << (k % n + 0.5) / n, (k / n + 0.5) / n;
  PowerDiagram diagram(sites, PlanarDomain::square());
  const TransportSolution solution = semiDiscreteTransport(diagram, equalMasses(n * n, 1));
  EXPECT_EQ(solution.status, Status::Converged);
  EXPECT_EQ(solution.iterations, 0);
  EXPECT_LT((diagram.cells().centroids - sites).cwiseAbs().maxCoeff(), 1e-13);
}

TEST_F(SemiDiscreteTransport, MovesTheBisectorOfTwoSitesToTheirMasses) {
  Points2 sites(2, 2);
  sites << -0.3, 0.1, 0.3, 0.1;
  for (const double c : {-0.95, -0.4, 0.0, 0.8}) {
    const double beyond = std::acos(c) - c * std::sqrt(1 - c * c);
    PowerDiagram diagram(sites, PlanarDomain::disk());
    const TransportSolution solution = semiDiscreteTransport(diagram, Eigen::Vector2d(M_PI - beyond, beyond));
    EXPECT_EQ(solution.status, Status::Converged);
    EXPECT_NEAR((solution.heights[0] - solution.heights[1]) / 0.6, c, 1e-7);
  }
}

TEST_F(SemiDiscreteTransport, GivesEverythingToASingleSite) {
  PowerDiagram diagram(Points2::Zero(1, 2), PlanarDomain::disk());
  const TransportSolution solution = semiDiscreteTransport(diagram, Eigen::VectorXd::Constant(1, M_PI));
  EXPECT_EQ(solution.status, Status::Converged);
  EXPECT_EQ(solution.iterations, 0);
  EXPECT_NEAR(diagram.cells().costs.sum(), M_PI / 2, 1e-15);
}

TEST_F(SemiDiscreteTransport, TakesAMovedAndScaledPointSetBackToItsVoronoiCells) {
  const Points2 sites = randomPoints(400, 1, 0.02, 0.98);
  PowerDiagram voronoi(sites, PlanarDomain::square());
  const PowerCells cells = voronoi.compute(startHeights(sites, PlanarDomain::square()));
  for (const double scale : {0.25, 3.0}) {
    const Points2 moved = (scale * sites).rowwise() + Eigen::RowVector2d(0.3, -0.2);
    PowerDiagram diagram(moved, PlanarDomain::square());
    const TransportSolution solution = semiDiscreteTransport(diagram, cells.areas);
    EXPECT_EQ(solution.status, Status::Converged);
    EXPECT_LT((diagram.cells().areas - cells.areas).cwiseAbs().maxCoeff(), 1e-9 / 400);
    EXPECT_LT((diagram.cells().centroids - cells.centroids).cwiseAbs().maxCoeff(), 1e-8);
  }
}

TEST_F(SemiDiscreteTransport, ApproachesTheRadialMapOfARadialDensity) {
  const double coarse = radialError(8), middle = radialError(16), fine = radialError(32);
  EXPECT_GT(coarse / middle, 3.0) << coarse << ' ' << middle;
  EXPECT_GT(middle / fine, 3.0) << middle << ' ' << fine;
  EXPECT_LT(fine, 1e-3);
}

TEST_F(SemiDiscreteTransport, HasNoGapBetweenPrimalAndDualCost) {
  for (const PlanarDomain& domain : {PlanarDomain::disk(), PlanarDomain::square()}) {
    const Points2 sites = randomPoints(300, 2, 0, 0.7);
    Eigen::VectorXd masses = randomPoints(300, 3, 0.2, 2).col(0);
    masses *= domain.area() / masses.sum();
    PowerDiagram diagram(sites, domain);
    const TransportSolution solution = semiDiscreteTransport(diagram, masses);
    ASSERT_EQ(solution.status, Status::Converged);
    const PowerCells& cells = diagram.cells();
    const double potential = cells.areas.dot(cells.centroids.cwiseProduct(sites).rowwise().sum() +
                                             solution.heights.cast<double>());
    const double polar = domain.isDisk() ? M_PI / 2 : 2.0 / 3;  // ∫ |x|²
    const double dual = polar + masses.dot(sites.rowwise().squaredNorm()) -
                        2 * (potential - masses.dot(solution.heights.cast<double>()));
    EXPECT_NEAR(cells.costs.sum(), dual, 1e-9);
  }
}

TEST_F(SemiDiscreteTransport, NeverEmptiesACellAndReachesTheMassesFromClusteredSites) {
  for (unsigned seed = 0; seed < 5; ++seed) {
    Points2 sites = randomPoints(600, seed, -1, 1);
    sites.topRows(300) *= 1e-3;  // half of them in a spot
    sites.bottomRows(300).rowwise().normalize();  // half of them on the circle
    const Eigen::VectorXd masses = equalMasses(600, M_PI);
    PowerDiagram diagram(sites, PlanarDomain::disk());
    const TransportSolution solution = semiDiscreteTransport(diagram, masses);
    EXPECT_EQ(solution.status, Status::Converged) << solution.residual;
    EXPECT_LE((diagram.cells().areas - masses).cwiseAbs().maxCoeff(), 1e-9 * masses[0]);
    double before = solution.history.front().residual;
    for (const TransportIteration& step : solution.history) {
      EXPECT_GT(step.smallestCell, 0);
      EXPECT_LE(step.residual, before);
      before = step.residual;
    }
    EXPECT_LE(solution.iterations, 25);
  }
}

TEST_F(SemiDiscreteTransport, TurnsWithItsSites) {
  const Points2 sites = randomPoints(200, 4, -0.7, 0.7);
  Eigen::Matrix2d turn;
  turn << 0.6, -0.8, 0.8, 0.6;
  PowerDiagram straight(sites, PlanarDomain::disk()), turned(sites * turn.transpose(), PlanarDomain::disk());
  const Eigen::VectorXd masses = equalMasses(200, M_PI);
  const TransportSolution a = semiDiscreteTransport(straight, masses), b = semiDiscreteTransport(turned, masses);
  EXPECT_LT((a.heights - b.heights).cwiseAbs().maxCoeff(), 1e-9);
  EXPECT_NEAR(straight.cells().costs.sum(), turned.cells().costs.sum(), 1e-10);
}

TEST_F(SemiDiscreteTransport, ComesBackWithItsBestWhenItMayNotGoOn) {
  const Points2 sites = randomPoints(200, 5, -0.3, 0.3);
  const Eigen::VectorXd masses = equalMasses(200, M_PI);
  PowerDiagram diagram(sites, PlanarDomain::disk());
  SemiDiscreteTransportOptions options;
  options.maxIterations = 1;
  const TransportSolution stopped = semiDiscreteTransport(diagram, masses, options);
  EXPECT_EQ(stopped.status, Status::NotConverged);
  EXPECT_EQ(stopped.iterations, 1);
  EXPECT_GT(stopped.residual, options.tolerance);
  const Execution cancelled({}, [] { return true; });
  EXPECT_EQ(semiDiscreteTransport(diagram, masses, {}, {}, cancelled).status, Status::Cancelled);
}

TEST_F(SemiDiscreteTransport, RefusesMassesAndStartsThatCannotBe) {
  const Points2 sites = randomPoints(10, 6, -0.7, 0.7);
  PowerDiagram diagram(sites, PlanarDomain::disk());
  Eigen::VectorXd masses = equalMasses(10, M_PI);
  masses[3] = 0;
  EXPECT_THROW(semiDiscreteTransport(diagram, masses), GeometryError);
  masses[3] = -1;
  EXPECT_THROW(semiDiscreteTransport(diagram, masses), GeometryError);
  EXPECT_THROW(semiDiscreteTransport(diagram, equalMasses(10, 3.0)), GeometryError);
  EXPECT_THROW(semiDiscreteTransport(diagram, equalMasses(9, M_PI)), GeometryError);
  Heights start = Heights::Zero(10);
  start[0] = 100;
  EXPECT_THROW(semiDiscreteTransport(diagram, equalMasses(10, M_PI), {}, start), GeometryError);
  SemiDiscreteTransportOptions options;
  options.tolerance = 0;
  EXPECT_THROW(semiDiscreteTransport(diagram, equalMasses(10, M_PI), options), InvalidArgument);
  options = {};
  options.maxIterations = -1;
  EXPECT_THROW(semiDiscreteTransport(diagram, equalMasses(10, M_PI), options), InvalidArgument);
}
