/// Transport from a piecewise linear density: closed forms, agreement with the uniform source, refusals.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "Core/base/Error.h"
#include "Core/transport/SemiDiscreteTransport.h"
#include "support/PlanarSites.h"
#include "support/TestMeshes.h"

using namespace authalic;
using authalic::testing::diskMesh;
using authalic::testing::gridMesh;
using authalic::testing::randomPoints;
using authalic::testing::ringPoints;

namespace {

class PiecewiseLinearDensities : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!PowerDiagram::available()) GTEST_SKIP() << "CGAL was not built in";
  }
};

using Field = std::function<double(double x, double y)>;
using Source = std::shared_ptr<const PiecewiseLinearDensity>;

Source sourceOf(const PlanarDomain& domain, const TriangleMesh& mesh, const Field& density) {
  Eigen::VectorXd values(mesh.vertexCount());
  for (int v = 0; v < mesh.vertexCount(); ++v) values[v] = density(mesh.point(v).x(), mesh.point(v).y());
  return std::make_shared<const PiecewiseLinearDensity>(domain, DiskMesh(mesh), values);
}

// Waves of an amplitude of 0.7 about 1.
double waves(double x, double y) { return 1 + 0.7 * std::sin(7 * x + 1) * std::cos(9 * y); }

// A grid over [−1.25, 1.25]², its inner vertices shaken.
TriangleMesh shakenGrid(int size, unsigned seed) {
  const TriangleMesh grid = gridMesh(size, size, 2.5, 2.5);
  Points3 points = grid.points().rowwise() - Eigen::RowVector3d(1.25, 1.25, 0);
  const Points2 noise = randomPoints(static_cast<int>(points.rows()), seed, -0.2 * 2.5 / size, 0.2 * 2.5 / size);
  for (Eigen::Index v = 0; v < points.rows(); ++v) {
    if (points.row(v).cwiseAbs().maxCoeff() < 1.2) points.row(v).head<2>() += noise.row(v);
  }
  return TriangleMesh(points, grid.faces());
}

PlanarDomain pentagon() {
  Points2 corners(5, 2);
  corners << -0.7, -0.8, 0.6, -0.9, 1.1, 0.1, 0.2, 1.1, -1, 0.4;
  return PlanarDomain::polygon(corners);
}

Heights noisyHeights(const Points2& sites, const PlanarDomain& domain, double noise) {
  const Eigen::Index n = sites.rows();
  return startHeights(sites, domain) +
         noise * randomPoints(static_cast<int>(n), 77, -1, 1).col(0).cast<long double>();
}

std::string words(const std::function<void()>& refused) {
  try {
    refused();
  } catch (const Error& error) {
    return error.what();
  }
  return "nothing was refused";
}

std::string wordsOf(const PlanarDomain& domain, const TriangleMesh& mesh, const Field& density) {
  return words([&] { (void)sourceOf(domain, mesh, density); });
}

::testing::AssertionResult holds(const std::string& text, const std::vector<std::string>& parts) {
  for (const std::string& part : parts) {
    if (text.find(part) == std::string::npos) return ::testing::AssertionFailure() << '"' << part << "\" in: " << text;
  }
  return ::testing::AssertionSuccess();
}

// Quantile of the density a + b x on [0, 1].
double quantile(double a, double b, double part) {
  const double wanted = part * (a + b / 2);
  return (-a + std::sqrt(a * a + 2 * b * wanted)) / b;
}

// ∫ (a + b x) xᵖ from s to t.
double power(double a, double b, int p, double s, double t) {
  const auto one = [&](int q) { return (std::pow(t, q) - std::pow(s, q)) / q; };
  return a * one(p + 1) + b * one(p + 2);
}

double radialError(int rings) {
  const Source source =
      sourceOf(PlanarDomain::disk(), diskMesh(rings), [](double x, double y) { return 1 + x * x + y * y; });
  const Points2 sites = ringPoints(rings);
  Eigen::VectorXd masses = Eigen::VectorXd::Ones(sites.rows());
  const double whole = (rings + 0.5) * (rings + 0.5);
  masses[0] = 0.25 / whole;
  for (int r = 1, row = 1; r <= rings; ++r) {
    for (int k = 0; k < 6 * r; ++k, ++row) masses[row] = 2.0 * r / whole / (6 * r);
  }
  PowerDiagram diagram(sites, source);
  EXPECT_EQ(semiDiscreteTransport(diagram, source->total() * masses).status, Status::Converged);
  double sum = 0;
  for (Eigen::Index i = 1; i < sites.rows(); ++i) {
    const double image = sites.row(i).norm(), radius = std::sqrt(std::sqrt(1 + 3 * image * image) - 1);
    sum += (diagram.cells().centroids.row(i) - radius / image * sites.row(i)).squaredNorm();
  }
  return std::sqrt(sum / static_cast<double>(sites.rows()));
}

}  // namespace

TEST_F(PiecewiseLinearDensities, HaveTheMomentsOfALinearFunctionOnTheDisk) {
  for (const TriangleMesh& mesh : {diskMesh(1), diskMesh(5), shakenGrid(9, 1)}) {
    const Source source = sourceOf(PlanarDomain::disk(), mesh, [](double x, double y) { return 3 + x - 0.5 * y; });
    EXPECT_NEAR(source->total(), 3 * M_PI, 1e-13);
    PowerDiagram diagram(Points2::Zero(1, 2), source);
    const PowerCells& cells = diagram.compute(Heights::Zero(1));
    EXPECT_NEAR(cells.areas[0], M_PI, 1e-14);
    EXPECT_NEAR(cells.masses[0], 3 * M_PI, 1e-13);
    EXPECT_NEAR(cells.centroids(0, 0), 1.0 / 12, 1e-14);
    EXPECT_NEAR(cells.centroids(0, 1), -0.5 / 12, 1e-14);
    EXPECT_NEAR(cells.costs[0], 3 * M_PI / 2, 1e-13);
  }
}

TEST_F(PiecewiseLinearDensities, MoveTheBisectorOfTwoSitesToTheirMasses) {
  const double a = 2, b = 1.5;
  const Source source = sourceOf(PlanarDomain::disk(), diskMesh(7), [&](double x, double) { return a + b * x; });
  Points2 sites(2, 2);
  sites << -0.3, 0.1, 0.3, 0.1;
  for (const double c : {-0.95, -0.4, 0.0, 0.8}) {
    const double beyond = a * (std::acos(c) - c * std::sqrt(1 - c * c)) + b * 2 / 3 * std::pow(1 - c * c, 1.5);
    PowerDiagram diagram(sites, source);
    const TransportSolution solution = semiDiscreteTransport(diagram, Eigen::Vector2d(2 * M_PI - beyond, beyond));
    EXPECT_EQ(solution.status, Status::Converged);
    EXPECT_NEAR((solution.heights[0] - solution.heights[1]) / 0.6, c, 1e-7);
    ASSERT_EQ(diagram.cells().edges.size(), 1U);
    EXPECT_NEAR(diagram.cells().edges[0].mass, 2 * std::sqrt(1 - c * c) * (a + b * c), 1e-6);
  }
}

TEST_F(PiecewiseLinearDensities, GiveTheProductOfOneDimensionalMapsOnASquare) {
  const double a = 0.3, b = 2;
  const int n = 8;
  Points2 sites(n * n, 2);
  for (int k = 0; k < n * n; ++k) sites.row(k) << (k % n + 0.5) / n, (k / n + 0.5) / n;
  for (const int cut : {1, 3, 16}) {
    const Source source =
        sourceOf(PlanarDomain::square(), gridMesh(cut, cut), [&](double x, double) { return a + b * x; });
    PowerDiagram diagram(sites, source);
    const Eigen::VectorXd masses = Eigen::VectorXd::Constant(n * n, (a + b / 2) / (n * n));
    SemiDiscreteTransportOptions options;
    options.tolerance = 1e-12;
    EXPECT_EQ(semiDiscreteTransport(diagram, masses, options).status, Status::Converged);
    double cost = 0;
    for (int k = 0; k < n * n; ++k) {
      const double s = quantile(a, b, k % n / double(n)), t = quantile(a, b, (k % n + 1) / double(n)), y = sites(k, 0);
      EXPECT_NEAR(diagram.cells().centroids(k, 0), power(a, b, 1, s, t) / power(a, b, 0, s, t), 1e-11);
      EXPECT_NEAR(diagram.cells().centroids(k, 1), sites(k, 1), 1e-11);
      cost += (power(a, b, 2, s, t) - 2 * y * power(a, b, 1, s, t) + y * y * power(a, b, 0, s, t)) / n;
      cost += masses[k] / (12.0 * n * n);
    }
    EXPECT_NEAR(diagram.cells().costs.sum(), cost, 1e-12);
  }
}

TEST_F(PiecewiseLinearDensities, ApproachTheRadialMapOfARadialDensity) {
  const double coarse = radialError(8), middle = radialError(16), fine = radialError(32);
  EXPECT_GT(coarse / middle, 3.0) << coarse << ' ' << middle;
  EXPECT_GT(middle / fine, 3.0) << middle << ' ' << fine;
  EXPECT_LT(fine, 1e-3);
}

TEST_F(PiecewiseLinearDensities, OfOneAreTheUniformMeasure) {
  for (const PlanarDomain& domain : {PlanarDomain::disk(), pentagon()}) {
    const Points2 sites = randomPoints(500, 3, -0.6, 0.6);
    const Heights heights = noisyHeights(sites, domain, 1e-3);
    const Source source = sourceOf(domain, shakenGrid(30, 2), [](double, double) { return 1; });
    PowerDiagram uniform(sites, domain), constant(sites, source);
    const PowerCells &a = uniform.compute(heights), &b = constant.compute(heights);
    EXPECT_EQ(a.areas, a.masses);
    EXPECT_EQ(a.areas, b.areas);
    EXPECT_EQ(a.emptyCells, b.emptyCells);
    EXPECT_LT((a.masses - b.masses).cwiseAbs().maxCoeff(), 1e-15);
    EXPECT_LT((a.costs - b.costs).cwiseAbs().maxCoeff(), 1e-15);
    for (Eigen::Index i = 0; i < 500; ++i) {
      EXPECT_LT((a.centroids.row(i) - b.centroids.row(i)).norm() * a.areas[i], 1e-15);
    }
    ASSERT_EQ(a.edges.size(), b.edges.size());
    for (std::size_t k = 0; k < a.edges.size(); ++k) {
      EXPECT_EQ(a.edges[k].length, a.edges[k].mass);
      EXPECT_NEAR(a.edges[k].mass, b.edges[k].mass, 1e-14);
    }
  }
}

TEST_F(PiecewiseLinearDensities, DoNotDependOnHowALinearFunctionIsCutIntoTriangles) {
  const Field linear = [](double x, double y) { return 2 + 0.8 * x - 0.6 * y; };
  for (const PlanarDomain& domain : {PlanarDomain::disk(), pentagon()}) {
    const Points2 sites = randomPoints(300, 4, -0.6, 0.6);
    const Heights heights = noisyHeights(sites, domain, 1e-3);
    PowerDiagram whole(sites, sourceOf(domain, shakenGrid(1, 0), linear));
    PowerDiagram cut(sites, sourceOf(domain, shakenGrid(40, 5), linear));
    const PowerCells &a = whole.compute(heights), &b = cut.compute(heights);
    EXPECT_LT((a.masses - b.masses).cwiseAbs().maxCoeff(), 1e-14);
    EXPECT_LT((a.costs - b.costs).cwiseAbs().maxCoeff(), 1e-14);
    ASSERT_EQ(a.edges.size(), b.edges.size());
    for (std::size_t k = 0; k < a.edges.size(); ++k) EXPECT_NEAR(a.edges[k].mass, b.edges[k].mass, 1e-13);
  }
}

TEST_F(PiecewiseLinearDensities, AreSharedWithoutGapOrOverlap) {
  for (unsigned seed = 0; seed < 4; ++seed) {
    for (const PlanarDomain& domain : {PlanarDomain::disk(), pentagon()}) {
      for (const int count : {3, 70, 4000}) {
        const Source source = sourceOf(domain, shakenGrid(50, seed), waves);
        const Points2 sites = randomPoints(count, seed, -0.6, 0.6);
        PowerDiagram diagram(sites, source);
        const PowerCells& cells = diagram.compute(noisyHeights(sites, domain, 1e-3));
        EXPECT_NEAR(cells.masses.sum() / source->total(), 1, 1e-13);
        EXPECT_NEAR(cells.areas.sum() / domain.area(), 1, 1e-13);
      }
    }
  }
}

TEST_F(PiecewiseLinearDensities, AreSharedOnMeshesWhoseBoundaryIsRounded) {
  for (const double scale : {1 - 9e-7, 1 - 1e-15, 1 + 1e-15, 1 + 9e-7, 1.1}) {
    const TriangleMesh mesh = diskMesh(20);
    const TriangleMesh scaled(scale * mesh.points(), mesh.faces());
    const Source source = sourceOf(PlanarDomain::disk(), scaled, [](double x, double) { return 2 + x; });
    EXPECT_NEAR(source->total(), 2 * M_PI, 1e-12) << scale;
    PowerDiagram diagram(randomPoints(300, 5, -0.6, 0.6), source);
    const PowerCells& cells = diagram.compute(noisyHeights(diagram.sites(), PlanarDomain::disk(), 1e-3));
    EXPECT_NEAR(cells.masses.sum() / source->total(), 1, 1e-13) << scale;
  }
}

TEST_F(PiecewiseLinearDensities, GiveMassesWhoseDerivativesAreThoseOfTheEdges) {
  const Source source = sourceOf(PlanarDomain::disk(), diskMesh(12), waves);
  const Points2 sites = randomPoints(60, 6, -0.7, 0.7);
  const Heights heights = noisyHeights(sites, PlanarDomain::disk(), 1e-3);
  PowerDiagram diagram(sites, source);
  const std::vector<PowerEdge> edges = diagram.compute(heights).edges;
  for (const int j : {0, 9, 33, 59}) {
    Eigen::VectorXd expected = Eigen::VectorXd::Zero(60);
    for (const PowerEdge& edge : edges) {
      if (edge.first != j && edge.second != j) continue;
      const double rate = edge.mass / (sites.row(edge.first) - sites.row(edge.second)).norm();
      expected[edge.first == j ? edge.second : edge.first] -= rate;
      expected[j] += rate;
    }
    Heights above = heights, below = heights;
    above[j] += 1e-6L, below[j] -= 1e-6L;
    const Eigen::VectorXd high = diagram.compute(above).masses, low = diagram.compute(below).masses;
    EXPECT_LT(((high - low) / 2e-6 - expected).cwiseAbs().maxCoeff(), 1e-6 * expected[j]) << j;
  }
}

TEST_F(PiecewiseLinearDensities, HaveNoGapBetweenPrimalAndDualCost) {
  for (const PlanarDomain& domain : {PlanarDomain::disk(), pentagon()}) {
    const Source source = sourceOf(domain, shakenGrid(25, 7), waves);
    const Points2 sites = randomPoints(400, 8, -0.5, 0.4);
    Eigen::VectorXd masses = randomPoints(400, 9, 0.2, 2).col(0);
    masses *= source->total() / masses.sum();
    PowerDiagram diagram(sites, source);
    const TransportSolution solution = semiDiscreteTransport(diagram, masses);
    ASSERT_EQ(solution.status, Status::Converged);
    const PowerCells& cells = diagram.cells();
    EXPECT_LT((cells.masses - masses).cwiseAbs().maxCoeff(), 1e-9 * source->total() / 400);
    EXPECT_EQ(cells.emptyCells, 0);
    PowerDiagram one(Points2::Zero(1, 2), source);
    double dual = one.compute(Heights::Zero(1)).costs[0];  // ∫ |x|² ρ − 2 ∫ u ρ + Σ ν (|y|² + 2 h)
    for (Eigen::Index i = 0; i < 400; ++i) {
      const double h = static_cast<double>(solution.heights[i]);
      dual -= 2 * cells.masses[i] * (cells.centroids.row(i).dot(sites.row(i)) + h);
      dual += masses[i] * (sites.row(i).squaredNorm() + 2 * h);
    }
    EXPECT_NEAR(cells.costs.sum(), dual, 1e-8);
  }
}

TEST_F(PiecewiseLinearDensities, OfAnotherScaleGiveTheSameCells) {
  const Points2 sites = randomPoints(200, 10, -0.5, 0.4);
  Points2 centroids[2];
  for (const int k : {0, 1}) {
    const double scale = k == 0 ? 1 : 1e-3;
    const Field density = [&](double x, double y) { return scale * waves(x, y); };
    const Source source = sourceOf(PlanarDomain::disk(), diskMesh(9), density);
    PowerDiagram diagram(sites, source);
    const TransportSolution solution =
        semiDiscreteTransport(diagram, Eigen::VectorXd::Constant(200, source->total() / 200));
    EXPECT_EQ(solution.status, Status::Converged);
    centroids[k] = diagram.cells().centroids;
  }
  EXPECT_LT((centroids[0] - centroids[1]).cwiseAbs().maxCoeff(), 1e-8);
}

TEST_F(PiecewiseLinearDensities, DoNotDependOnTheSideFromWhichTheirMeshIsSeen) {
  const TriangleMesh mesh = shakenGrid(8, 11);
  Faces turned = mesh.faces();
  turned.col(0).swap(turned.col(1));
  const Source a = sourceOf(PlanarDomain::disk(), mesh, waves);
  const Source b = sourceOf(PlanarDomain::disk(), TriangleMesh(mesh.points(), turned), waves);
  EXPECT_NEAR(a->total(), b->total(), 1e-14);
}

TEST_F(PiecewiseLinearDensities, FindThePieceOfAPoint) {
  for (const TriangleMesh& mesh : {shakenGrid(40, 12), diskMesh(30), diskMesh(1)}) {
    const Source source = sourceOf(PlanarDomain::disk(), mesh, waves);
    const Points2 points = randomPoints(4000, 13, -1, 1);
    for (Eigen::Index k = 0; k < points.rows(); ++k) {
      const Eigen::Vector2d point = points.row(k);
      if (point.norm() >= 1) continue;
      const int piece = source->pieceAt(point);
      for (const HalfPlane& side : source->pieces()[static_cast<std::size_t>(piece)].sides) {
        EXPECT_GE(side.depth(point), -1e-15);
      }
    }
  }
}

TEST_F(PiecewiseLinearDensities, GiveTheSameBitsAtAnyThreadCount) {
  const Source source = sourceOf(PlanarDomain::disk(), shakenGrid(40, 14), waves);
  const Points2 sites = randomPoints(5000, 15, -0.6, 0.6);
  const Eigen::VectorXd masses = Eigen::VectorXd::Constant(5000, source->total() / 5000);
  Points2 centroids[2];
  Heights heights[2];
  for (const int k : {0, 1}) {
    PowerDiagram diagram(sites, source);
    heights[k] = semiDiscreteTransport(diagram, masses, {}, {}, Execution({}, {}, k + 1)).heights;
    centroids[k] = diagram.cells().centroids;
  }
  EXPECT_EQ(heights[0], heights[1]);
  EXPECT_EQ(centroids[0], centroids[1]);
}

TEST_F(PiecewiseLinearDensities, AreRefusedWhenTheyAreNotPositiveOrNotOfTheMesh) {
  const PlanarDomain disk = PlanarDomain::disk();
  const TriangleMesh mesh = diskMesh(3);
  const auto one = [](double, double) { return 1.0; };
  for (const double bad : {0.0, -1.0, std::nan(""), HUGE_VAL}) {
    Eigen::VectorXd values = Eigen::VectorXd::Ones(mesh.vertexCount());
    values[5] = bad;
    EXPECT_THROW(PiecewiseLinearDensity(disk, DiskMesh(mesh), values), InvalidArgument);
    EXPECT_TRUE(holds(words([&] { PiecewiseLinearDensity(disk, DiskMesh(mesh), values); }), {"vertex 5", "positive"}));
  }
  EXPECT_THROW(PiecewiseLinearDensity(disk, DiskMesh(mesh), Eigen::VectorXd::Ones(4)), GeometryError);
  Points2 bent(4, 2);
  bent << 0, 0, 1, 0, 0.2, 0.2, 0, 1;
  EXPECT_THROW((void)sourceOf(PlanarDomain::polygon(bent), mesh, one), InvalidArgument);
  EXPECT_TRUE(holds(wordsOf(disk, diskMesh(1), [](double x, double y) { return std::hypot(x, y) < 0.5 ? 30 : 0.1; }),
                    {"stays positive", "continued beyond the mesh"}));
}

TEST_F(PiecewiseLinearDensities, AreRefusedOnMeshesThatDoNotCoverTheDomainOnce) {
  const PlanarDomain disk = PlanarDomain::disk(), square = PlanarDomain::square();
  const auto one = [](double, double) { return 1.0; };
  const auto moved = [](const TriangleMesh& mesh, double scale, double x) {
    return TriangleMesh((scale * mesh.points()).rowwise() + Eigen::RowVector3d(x, 0, 0), mesh.faces());
  };
  EXPECT_TRUE(holds(wordsOf(disk, moved(diskMesh(4), 0.9, 0), one), {"covers the unit disk", "(0.9, 0)"}));
  EXPECT_TRUE(holds(wordsOf(disk, moved(diskMesh(4), 1, 0.1), one), {"covers the unit disk"}));
  EXPECT_TRUE(holds(wordsOf(disk, moved(diskMesh(4), 1, 5), one), {"covers the unit disk", "area of 0"}));
  EXPECT_TRUE(holds(wordsOf(disk, moved(gridMesh(1, 1, 1.8, 1.8), 1, -0.9), one), {"covers the unit disk"}));
  EXPECT_TRUE(holds(wordsOf(square, moved(diskMesh(6), 0.6, 0.5), one), {"covers the polygon of 4 corners"}));
  EXPECT_TRUE(holds(wordsOf(square, gridMesh(4, 4, 1, 0.9), one), {"covers the polygon of 4 corners"}));
  Points3 corners(3, 3);
  corners << -0.4, -0.2, 0, 2, -0.2, 0, -0.4, 1.2, 0;  // cuts off the corner (1, 1)
  Faces face(1, 3);
  face << 0, 1, 2;
  EXPECT_TRUE(holds(wordsOf(square, TriangleMesh(corners, face), one), {"covers the polygon of 4 corners"}));
}

TEST_F(PiecewiseLinearDensities, AreRefusedOnMeshesThatAreFoldedOrNotPlanar) {
  const auto one = [](double, double) { return 1.0; };
  const TriangleMesh mesh = diskMesh(4);
  Points3 points = mesh.points();
  points.row(0) << 0.6, 0.1, 0;
  const std::string folded = wordsOf(PlanarDomain::disk(), TriangleMesh(points, mesh.faces()), one);
  EXPECT_TRUE(holds(folded, {"without folds", "triangle"}));
  points = mesh.points();
  points(3, 2) = 0.1;
  const std::string bent = wordsOf(PlanarDomain::disk(), TriangleMesh(points, mesh.faces()), one);
  EXPECT_TRUE(holds(bent, {"z = constant", "0.1"}));
}
