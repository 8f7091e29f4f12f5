#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <cmath>
#include <random>

#include "Core/base/Error.h"
#include "Core/transport/SphericalTransport.h"
#include "support/TestMeshes.h"

using namespace authalic;
using namespace authalic::testing;

namespace {

class SphericalTransport : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!PowerDiagram::available()) GTEST_SKIP() << "CGAL was not built in";
  }
};

Points3 randomOnSphere(int count, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  Points3 points(count, 3);
  for (Eigen::Index i = 0; i < points.size(); ++i) points.data()[i] = normal(random);
  points.rowwise().normalize();
  return points;
}

Heights noise(int count, unsigned seed, double size) {
  return size * randomOnSphere(count, seed).col(0).cast<long double>();
}

Eigen::VectorXd equalMasses(Eigen::Index count) {
  return Eigen::VectorXd::Constant(count, 4 * M_PI / static_cast<double>(count));
}

double spread(const Points3& image, const Points3& expected) {
  return std::sqrt((image - expected).squaredNorm() / static_cast<double>(image.rows()));
}

// Rings of equal width in polar angle with sites in their middles, the poles included.
struct Rings {
  Points3 sites;
  std::vector<int> ring, size;
  explicit Rings(int count) {
    std::vector<Eigen::Vector3d> places;
    for (int r = 0; r <= count; ++r) {
      const double polar = M_PI * r / count;
      size.push_back(
          r == 0 || r == count ? 1 : std::max(4, static_cast<int>(std::lround(2 * count * std::sin(polar)))));
      for (int k = 0; k < size.back(); ++k) {
        const double angle = 2 * M_PI * (k + 0.5 * (r % 2)) / size.back();
        places.emplace_back(std::sin(polar) * std::cos(angle), std::sin(polar) * std::sin(angle), std::cos(polar));
        ring.push_back(r);
      }
    }
    sites.resize(static_cast<Eigen::Index>(places.size()), 3);
    for (std::size_t i = 0; i < places.size(); ++i) sites.row(static_cast<Eigen::Index>(i)) = places[i].transpose();
  }
};

// A monotone map of heights z of a cap density: masses in proportion to `densityOfCap` within the cap z > ½. In
// closed form the share of the sphere above the image of height z is that of the mass above it.
double imageHeight(double z, double density) {
  const double cap = 0.5, whole = density * (1 - cap) + (1 + cap);
  const double above = z > cap ? density * (1 - z) : density * (1 - cap) + (cap - z);
  return 1 - 2 * above / whole;
}

double capError(int count, double density) {
  const Rings rings(count);
  Eigen::VectorXd masses(rings.sites.rows());
  for (Eigen::Index i = 0; i < masses.size(); ++i) {
    const int r = rings.ring[static_cast<std::size_t>(i)];
    const double top = std::cos(M_PI * std::max(0.0, r - 0.5) / count);
    const double bottom = std::cos(M_PI * std::min<double>(count, r + 0.5) / count);
    masses[i] = 2 * M_PI * (imageHeight(top, density) - imageHeight(bottom, density)) /
                rings.size[static_cast<std::size_t>(r)];
  }
  SphericalPowerDiagram diagram(rings.sites);
  const TransportSolution solution = sphericalTransport(diagram, masses);
  EXPECT_EQ(solution.status, Status::Converged);
  Points3 expected(masses.size(), 3);
  for (Eigen::Index i = 0; i < masses.size(); ++i) {
    const double z = imageHeight(rings.sites(i, 2), density), radius = rings.sites.row(i).head(2).norm();
    const double scale = radius > 1e-12 ? std::sqrt(std::max(0.0, 1 - z * z)) / radius : 0;
    expected.row(i) << scale * rings.sites(i, 0), scale * rings.sites(i, 1), z;
  }
  return spread(diagram.cells().centroids, expected);
}

}  // namespace

TEST_F(SphericalTransport, CutsTheSphereIntoEightEqualTrianglesOfACube) {
  Points3 cube(8, 3);
  for (int k = 0; k < 8; ++k) cube.row(k) << (k & 1 ? 1 : -1), (k & 2 ? 1 : -1), (k & 4 ? 1 : -1);
  cube /= std::sqrt(3.0);
  SphericalPowerDiagram diagram(cube);
  const SphericalPowerCells& cells = diagram.compute(Heights::Zero(8));
  EXPECT_TRUE(cells.surrounded);
  EXPECT_LT((cells.areas.array() - M_PI / 2).abs().maxCoeff(), 1e-14);
  EXPECT_LT((cells.centroids - cube).cwiseAbs().maxCoeff(), 1e-14);
}

TEST_F(SphericalTransport, SharesTheSphereWithoutGapOrOverlap) {
  for (unsigned seed = 0; seed < 6; ++seed) {
    const Points3 sites = randomOnSphere(700, seed);
    SphericalPowerDiagram diagram(sites);
    const SphericalPowerCells& cells = diagram.compute(noise(700, seed + 10, 2e-3));
    EXPECT_NEAR(cells.areas.sum(), 4 * M_PI, 1e-12);
    EXPECT_GT(cells.emptyCells, 0);
    EXPECT_GE(cells.areas.minCoeff(), -1e-15);
  }
}

TEST_F(SphericalTransport, GivesEveryPointToTheSiteOfGreatestProduct) {
  const Points3 sites = randomOnSphere(60, 3), points = randomOnSphere(200000, 4);
  const Heights heights = noise(60, 5, 0.05);
  SphericalPowerDiagram diagram(sites);
  const SphericalPowerCells& cells = diagram.compute(heights);
  const Eigen::VectorXd radius = heights.array().exp().cast<double>();
  Eigen::VectorXd counts = Eigen::VectorXd::Zero(60);
  for (Eigen::Index k = 0; k < points.rows(); ++k) {
    Eigen::Index owner = 0;
    (sites * points.row(k).transpose()).cwiseProduct(radius).maxCoeff(&owner);
    counts[owner] += 4 * M_PI / static_cast<double>(points.rows());
  }
  for (int i = 0; i < 60; ++i) {  // five standard deviations of the count
    EXPECT_NEAR(counts[i], cells.areas[i], 5 * std::sqrt(4 * M_PI * (cells.areas[i] + 1e-4) / 200000)) << i;
  }
}

TEST_F(SphericalTransport, HasAreasWhoseDerivativesAreTheRatesOfTheEdges) {
  const Points3 sites = randomOnSphere(50, 6);
  const Heights heights = noise(50, 7, 0.02);
  SphericalPowerDiagram diagram(sites);
  const std::vector<SphericalPowerEdge> edges = diagram.compute(heights).edges;
  for (const int j : {0, 9, 33}) {
    Eigen::VectorXd expected = Eigen::VectorXd::Zero(50);
    for (const SphericalPowerEdge& edge : edges) {
      if (edge.first != j && edge.second != j) continue;
      expected[edge.first == j ? edge.second : edge.first] -= edge.rate;
      expected[j] += edge.rate;
    }
    Heights above = heights, below = heights;
    above[j] += 1e-6L, below[j] -= 1e-6L;
    const Eigen::VectorXd high = diagram.compute(above).areas, low = diagram.compute(below).areas;
    EXPECT_LT(((high - low) / 2e-6 - expected).cwiseAbs().maxCoeff(), 1e-6 * expected[j]) << j;
  }
}

TEST_F(SphericalTransport, OfVoronoiCellsToThemselvesIsTheIdentity) {
  const Points3 sites = randomOnSphere(300, 8);
  SphericalPowerDiagram diagram(sites);
  const Eigen::VectorXd masses = diagram.compute(Heights::Zero(300)).areas;
  const TransportSolution solution = sphericalTransport(diagram, masses);
  EXPECT_EQ(solution.status, Status::Converged);
  EXPECT_EQ(solution.iterations, 0);
}

TEST_F(SphericalTransport, ReachesEqualMassesWithoutEmptyingACell) {
  for (unsigned seed = 0; seed < 4; ++seed) {
    const Points3 sites = randomOnSphere(1000, seed);
    SphericalPowerDiagram diagram(sites);
    const TransportSolution solution = sphericalTransport(diagram, equalMasses(1000));
    EXPECT_EQ(solution.status, Status::Converged) << solution.residual;
    EXPECT_LE(solution.iterations, 25);
    EXPECT_LE((diagram.cells().areas.array() - 4 * M_PI / 1000).abs().maxCoeff(), 1e-9 * 4 * M_PI / 1000);
    double before = solution.history.front().residual;
    for (const TransportIteration& step : solution.history) {
      EXPECT_GT(step.smallestCell, 0);
      EXPECT_LE(step.residual, before);
      before = step.residual;
    }
    EXPECT_GT(diagram.transportCost(), 0);
  }
}

TEST_F(SphericalTransport, ApproachesTheClosedFormOfADensityOnACap) {
  const double coarse = capError(16, 3), middle = capError(32, 3), fine = capError(64, 3);
  EXPECT_GT(coarse / middle, 1.8) << coarse << ' ' << middle;  // the density jumps: first order at the rim of the cap
  EXPECT_GT(middle / fine, 1.8) << middle << ' ' << fine;
  EXPECT_LT(fine, 0.01);
}

TEST_F(SphericalTransport, IsTheSameBitsAtAnyNumberOfThreads) {
  const Points3 sites = randomOnSphere(3000, 9);
  SphericalPowerDiagram diagram(sites);
  const SphericalPowerCells one = diagram.compute(noise(3000, 1, 1e-4), Execution({}, {}, 1));
  const SphericalPowerCells& three = diagram.compute(noise(3000, 1, 1e-4), Execution({}, {}, 3));
  EXPECT_EQ(one.areas, three.areas);
  EXPECT_EQ(one.centroids, three.centroids);
}

TEST_F(SphericalTransport, StallsWhenMoreThanHalfOfTheMassIsInOneSpot) {
  Points3 sites = randomOnSphere(60, 10);
  Eigen::VectorXd masses = Eigen::VectorXd::Constant(60, 0.3 * 4 * M_PI / 59);
  masses[0] = 0.7 * 4 * M_PI;
  SphericalPowerDiagram diagram(sites);
  const TransportSolution solution = sphericalTransport(diagram, masses);
  EXPECT_NE(solution.status, Status::Converged);
  EXPECT_GT(diagram.cells().areas.minCoeff(), 0);
}

TEST_F(SphericalTransport, RefusesSitesThatDoNotSurroundTheCentreAndOthers) {
  Points3 sites = randomOnSphere(40, 11);
  sites.col(2) = sites.col(2).cwiseAbs().array() + 0.1;
  sites.rowwise().normalize();
  SphericalPowerDiagram hemisphere(sites);
  EXPECT_THROW((void)sphericalTransport(hemisphere, equalMasses(40)), GeometryError);
  EXPECT_THROW(SphericalPowerDiagram(sites.topRows(3)), GeometryError);
  EXPECT_THROW(SphericalPowerDiagram(2 * sites), GeometryError);
  sites.row(7) = sites.row(2);
  EXPECT_THROW(SphericalPowerDiagram{sites}, GeometryError);
  SphericalPowerDiagram diagram(randomOnSphere(40, 12));
  EXPECT_THROW((void)diagram.compute(Heights::Zero(39)), GeometryError);
  EXPECT_THROW((void)sphericalTransport(diagram, 2 * equalMasses(40)), GeometryError);
}
