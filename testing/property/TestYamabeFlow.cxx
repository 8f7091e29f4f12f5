#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include "Core/base/Error.h"
#include "Core/conformal/YamabeFlow.h"
#include "Core/geometry/Areas.h"
#include "Core/geometry/Development.h"
#include "support/TestMeshes.h"

using namespace authalic;
using namespace authalic::testing;

namespace {

constexpr double kFullTurn = 2 * M_PI;

IntrinsicTriangulation intrinsic(const TriangleMesh& mesh) {
  return IntrinsicTriangulation(mesh, SurfaceTopology(mesh.faces(), mesh.vertexCount()));
}

// Edge lengths drawn so that every face keeps its triangle inequality; nothing else is nice about them.
IntrinsicTriangulation withRandomLengths(const TriangleMesh& mesh, unsigned seed) {
  std::mt19937 random(seed);
  const SurfaceTopology topology(mesh.faces(), mesh.vertexCount());
  FaceLengths lengths(mesh.faceCount(), 3);
  for (int h = 0; h < 3 * mesh.faceCount(); ++h) {
    const int g = topology.opposite(h);
    lengths(h / 3, h % 3) = g >= 0 && g < h ? lengths(g / 3, g % 3) : std::uniform_real_distribution<double>(0.5001, 1)(random);
  }
  return IntrinsicTriangulation(topology, lengths);
}

// Positive angles with the sum that Gauss–Bonnet asks for, of very different sizes.
Eigen::VectorXd randomTarget(const IntrinsicTriangulation& t, int euler, unsigned seed) {
  std::mt19937 random(seed);
  const int n = t.vertexCount();
  Eigen::VectorXd angle(n);
  double flat = 0;
  for (int i = 0; i < n; ++i) {
    angle[i] = std::exp(std::uniform_real_distribution<double>(-2.5, 0)(random));
    flat += t.onBoundary()[static_cast<std::size_t>(i)] ? M_PI : kFullTurn;
  }
  angle *= (flat - kFullTurn * euler) / angle.sum();
  Eigen::VectorXd target(n);
  for (int i = 0; i < n; ++i) target[i] = (t.onBoundary()[static_cast<std::size_t>(i)] ? M_PI : kFullTurn) - angle[i];
  return target;
}

void expectSolved(const YamabeFlowResult& flow, const Eigen::VectorXd& target) {
  ASSERT_EQ(flow.status, Status::Converged) << "residual " << flow.residual << " after " << flow.iterations;
  EXPECT_LE(flow.residual, 1e-10);
  // Judged anew, on the triangulation that is handed back.
  const Eigen::VectorXd curvature = vertexCurvature(flow.triangulation, flow.logScale);
  EXPECT_LE((curvature.head(target.size()) - target).cwiseAbs().maxCoeff(), 1.01e-10);
  for (int h = 0; h < flow.triangulation.halfEdgeCount(); ++h) EXPECT_TRUE(flow.triangulation.isDelaunay(h, flow.logScale));
}

TriangleMesh torusMesh(int columns, int rows) {
  Points3 points(columns * rows, 3);
  Faces faces(2 * columns * rows, 3);
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      const double a = kFullTurn * i / columns, b = kFullTurn * j / rows, r = 2 + 0.7 * std::cos(b);
      points.row(j * columns + i) << r * std::cos(a), r * std::sin(a), 0.7 * std::sin(b);
      const int p = j * columns + i, q = j * columns + (i + 1) % columns, s = (j + 1) % rows * columns + i,
                t = (j + 1) % rows * columns + (i + 1) % columns;
      faces.row(2 * p) << p, q, t;
      faces.row(2 * p + 1) << p, t, s;
    }
  }
  return TriangleMesh(points, faces);
}

}  // namespace

TEST(YamabeFlow, SolvesRandomTargetsOnClosedSurfacesWithRandomLengths) {
  for (unsigned seed = 1; seed <= 12; ++seed) {
    const bool torus = seed % 2 == 0;
    const IntrinsicTriangulation t = withRandomLengths(torus ? torusMesh(9, 7) : sphereMesh(2), seed);
    const Eigen::VectorXd target = randomTarget(t, torus ? 0 : 2, 100 + seed);
    expectSolved(yamabeFlow(t, target), target);
  }
}

TEST(YamabeFlow, SolvesRandomTargetsOnDisksWithRandomLengths) {
  for (unsigned seed = 1; seed <= 12; ++seed) {
    const IntrinsicTriangulation t = withRandomLengths(diskMesh(4), seed);
    const Eigen::VectorXd target = randomTarget(t, 1, 100 + seed);
    expectSolved(yamabeFlow(t, target), target);
  }
}

TEST(YamabeFlow, SolvesOneRingConesOfEveryAngle) {
  for (const double angle : {0.01, 0.5, 3.0, 9.0, 30.0}) {
    const IntrinsicTriangulation t = intrinsic(diskMesh(1));
    // Six equal boundary angles θ with Σ K = 2π: (2π − Θ) + 6 (π − θ) = 2π.
    const double theta = M_PI - angle / 6;
    if (theta <= 0) continue;
    Eigen::VectorXd target = Eigen::VectorXd::Constant(7, M_PI - theta);
    target[0] = kFullTurn - angle;
    const YamabeFlowResult flow = yamabeFlow(t, target);
    expectSolved(flow, target);
  }
}

TEST(YamabeFlow, SolvesUnequalOneRingCones) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const IntrinsicTriangulation t = withRandomLengths(diskMesh(1), seed);
    const Eigen::VectorXd target = randomTarget(t, 1, seed);
    expectSolved(yamabeFlow(t, target), target);
  }
}

TEST(YamabeFlow, FlattensMeshesFullOfSlivers) {
  for (const double width : {1e-2, 1e-3, 1e-4, 1e-5}) {
    const TriangleMesh nice = bumpyDisk(10);
    Points3 points = nice.points();
    // Every fifth face gets flat: its first corner moves onto its longest side's middle or its neighbour.
    for (int f = 0; f < nice.faceCount(); f += 5) {
      const int a = nice.faces()(f, 0), b = nice.faces()(f, 1), c = nice.faces()(f, 2);
      const Eigen::RowVector3d to = f % 2 ? Eigen::RowVector3d(0.5 * (points.row(b) + points.row(c))) : Eigen::RowVector3d(points.row(b));
      points.row(a) = to + width * (points.row(a) - to);
    }
    const IntrinsicTriangulation t = intrinsic(TriangleMesh(points, nice.faces()));
    double smallest = M_PI;
    for (int f = 0; f < t.faceCount(); ++f) {
      for (const double angle : t.shape(f, Eigen::VectorXd::Zero(t.vertexCount())).angle) smallest = std::min(smallest, angle);
    }
    EXPECT_LT(smallest, width);
    Eigen::VectorXd target = Eigen::VectorXd::Zero(t.vertexCount());
    target.tail(60).setConstant(kFullTurn / 60);
    expectSolved(yamabeFlow(t, target), target);
  }
}

TEST(YamabeFlow, StallsSmallWhereNeedlesMagnifyRounding) {
  TriangleMesh nice = bumpyDisk(10);
  Points3 points = nice.points();
  for (int v = 5; v < 250; v += 20) points.row(v) = points.row(v + 1) + 1e-11 * (points.row(v) - points.row(v + 1));
  const IntrinsicTriangulation t = intrinsic(TriangleMesh(points, nice.faces()));
  Eigen::VectorXd target = Eigen::VectorXd::Zero(t.vertexCount());
  target.tail(60).setConstant(kFullTurn / 60);
  const YamabeFlowResult flow = yamabeFlow(t, target);
  EXPECT_EQ(flow.status, Status::Stalled);
  EXPECT_LT(flow.residual, 1e-3);
  EXPECT_LT(flow.iterations, 80);
}

TEST(YamabeFlow, BendsARibbonIntoADisk) {
  const TriangleMesh nice = bumpyDisk(10);
  Points3 points = nice.points();
  points.rightCols(2) *= 1e-2;  // a hundred times as long as wide: lengths change by e^45 against each other
  const IntrinsicTriangulation t = intrinsic(TriangleMesh(points, nice.faces()));
  Eigen::VectorXd target = Eigen::VectorXd::Zero(t.vertexCount());
  target.tail(60).setConstant(kFullTurn / 60);
  const YamabeFlowResult flow = yamabeFlow(t, target);
  expectSolved(flow, target);
  EXPECT_GT(flow.logScale.maxCoeff() - flow.logScale.minCoeff(), 40);
}

TEST(YamabeFlow, LeavesASurfaceWithItsOwnCurvatureAlone) {
  const TriangleMesh mesh = bumpyDisk(8);
  const IntrinsicTriangulation t = intrinsic(mesh);
  const YamabeFlowResult flow = yamabeFlow(t, vertexCurvature(t, Eigen::VectorXd::Zero(t.vertexCount())));
  EXPECT_EQ(flow.status, Status::Converged);
  EXPECT_EQ(flow.iterations, 0);
  EXPECT_EQ(flow.logScale, Eigen::VectorXd(Eigen::VectorXd::Zero(t.vertexCount())));
}

TEST(YamabeFlow, ComesBackFromADeformationInItsOwnClass) {
  // Scale a sphere's lengths by e^{(v_i + v_j)/2}: asking for the old curvature gives u = −v up to a constant.
  IntrinsicTriangulation t = intrinsic(sphereMesh(3));
  const int n = t.vertexCount();
  const Eigen::VectorXd zero = Eigen::VectorXd::Zero(n), curvature = vertexCurvature(t, zero);
  Eigen::VectorXd v(n);
  std::mt19937 random(5);
  for (int i = 0; i < n; ++i) v[i] = std::uniform_real_distribution<double>(-0.2, 0.2)(random);
  EXPECT_GT(t.makeDelaunay(v), 10);
  const Faces faces = t.faces();
  FaceLengths lengths(t.faceCount(), 3);
  const SurfaceTopology topology(faces, n);
  ASSERT_TRUE(topology.manifold());
  for (int f = 0; f < t.faceCount(); ++f) {
    int h = t.first(f);
    for (int k = 0; k < 3; ++k, h = t.next(h)) lengths(f, k) = std::exp(t.logLength(h, v));
  }
  const YamabeFlowResult flow = yamabeFlow(IntrinsicTriangulation(topology, lengths), curvature);
  ASSERT_EQ(flow.status, Status::Converged);
  EXPECT_LT((flow.logScale + v - Eigen::VectorXd::Constant(n, v.mean())).cwiseAbs().maxCoeff(), 1e-7);
}

TEST(YamabeFlow, DoesNotDependOnScaleOrOnTheNumberingOfVertices) {
  const TriangleMesh mesh = bumpyDisk(8);
  const int n = mesh.vertexCount();
  Eigen::VectorXd target = Eigen::VectorXd::Zero(n);
  target.tail(48).setConstant(kFullTurn / 48);
  const Eigen::VectorXd u = yamabeFlow(intrinsic(mesh), target).logScale;
  const Eigen::VectorXd scaled = yamabeFlow(intrinsic(TriangleMesh(Points3(137.5 * mesh.points()), mesh.faces())), target).logScale;
  EXPECT_LT((scaled - u).cwiseAbs().maxCoeff(), 1e-9);
  std::vector<int> order(static_cast<std::size_t>(n));
  std::iota(order.begin(), order.end(), 0);
  std::shuffle(order.begin(), order.end(), std::mt19937(3));
  Points3 points(n, 3);
  Faces faces = mesh.faces();
  Eigen::VectorXd shuffled(n);
  for (int i = 0; i < n; ++i) {
    points.row(order[static_cast<std::size_t>(i)]) = mesh.points().row(i);
    shuffled[order[static_cast<std::size_t>(i)]] = target[i];
  }
  for (Eigen::Index k = 0; k < faces.size(); ++k) faces.data()[k] = order[static_cast<std::size_t>(faces.data()[k])];
  const Eigen::VectorXd other = yamabeFlow(intrinsic(TriangleMesh(points, faces)), shuffled).logScale;
  for (int i = 0; i < n; ++i) EXPECT_NEAR(other[order[static_cast<std::size_t>(i)]], u[i], 1e-9);
}

TEST(YamabeFlow, KeepsGaussBonnetToRounding) {
  for (const auto& [mesh, euler] : {std::pair{bumpyDisk(12), 1}, std::pair{sphereMesh(4), 2}, std::pair{torusMesh(20, 16), 0}}) {
    const IntrinsicTriangulation t = intrinsic(mesh);
    const YamabeFlowResult flow = yamabeFlow(t, randomTarget(t, euler, 9));
    EXPECT_NEAR(flow.curvature.sum(), kFullTurn * euler, 1e-12);
  }
}

TEST(YamabeFlow, GivesTheSameBitsOnOneThreadAndTwo) {
  const IntrinsicTriangulation t = intrinsic(bumpyDisk(30));
  Eigen::VectorXd target = Eigen::VectorXd::Zero(t.vertexCount());
  target.tail(180).setConstant(kFullTurn / 180);
  const YamabeFlowResult one = yamabeFlow(t, target, {}, {}, Execution({}, {}, 1)),
                         two = yamabeFlow(t, target, {}, {}, Execution({}, {}, 2));
  EXPECT_EQ(one.logScale, two.logScale);
}

TEST(YamabeFlow, ConvergesQuadraticallyInTheEnd) {
  const IntrinsicTriangulation t = intrinsic(bumpyDisk(20));
  Eigen::VectorXd target = Eigen::VectorXd::Zero(t.vertexCount());
  target.tail(120).setConstant(kFullTurn / 120);
  const YamabeFlowResult flow = yamabeFlow(t, target);
  ASSERT_EQ(flow.status, Status::Converged);
  EXPECT_LE(flow.iterations, 8);
  ASSERT_GE(flow.history.size(), 3u);
  const double last = flow.residual, before = flow.history.back().residual;
  EXPECT_LT(last, 100 * before * before + 1e-11);
}

TEST(YamabeFlow, RefusesCurvaturesThatNoMetricHas) {
  const IntrinsicTriangulation t = intrinsic(bumpyDisk(3));
  const int n = t.vertexCount();
  Eigen::VectorXd target = Eigen::VectorXd::Zero(n);
  target.tail(18).setConstant(kFullTurn / 18);
  const auto words = [&t](const Eigen::VectorXd& k) -> std::string {
    try {
      static_cast<void>(yamabeFlow(t, k));
    } catch (const InvalidArgument& error) {
      return error.what();
    }
    return {};
  };
  Eigen::VectorXd wrong = target;
  wrong[3] += 0.1;
  EXPECT_NE(words(wrong).find("Gauss-Bonnet"), std::string::npos);
  wrong = target;
  wrong[3] += kFullTurn;
  wrong[4] -= kFullTurn;
  EXPECT_NE(words(wrong).find("below 2π inside"), std::string::npos);
  wrong = target;
  wrong[n - 1] += 3;
  wrong[4] -= 3;
  EXPECT_NE(words(wrong).find("below π on the boundary"), std::string::npos);
  EXPECT_THROW(static_cast<void>(yamabeFlow(t, Eigen::VectorXd::Zero(3))), GeometryError);
  YamabeFlowOptions options;
  options.tolerance = 0;
  EXPECT_THROW(static_cast<void>(yamabeFlow(t, target, {}, options)), InvalidArgument);
  options = {};
  options.maxIterations = -1;
  EXPECT_THROW(static_cast<void>(yamabeFlow(t, target, {}, options)), InvalidArgument);
}

TEST(YamabeFlow, SaysWhenItRanOutOfIterationsOrWasCancelled) {
  const IntrinsicTriangulation t = intrinsic(bumpyDisk(10));
  Eigen::VectorXd target = Eigen::VectorXd::Zero(t.vertexCount());
  target.tail(60).setConstant(kFullTurn / 60);
  YamabeFlowOptions options;
  options.maxIterations = 1;
  const YamabeFlowResult stopped = yamabeFlow(t, target, {}, options);
  EXPECT_EQ(stopped.status, Status::NotConverged);
  EXPECT_GT(stopped.residual, 1e-10);
  EXPECT_EQ(yamabeFlow(t, target, {}, {}, Execution({}, [] { return true; })).status, Status::Cancelled);
}

TEST(RicciFlow, OfCirclePackingsFlattensADiskAndAgreesWithYamabeFlowMoreAndMoreAsMeshesGetFiner) {
  const auto difference = [](int rings) {
    const TriangleMesh mesh = bumpyDisk(rings, 0.3);
    Eigen::VectorXd target = Eigen::VectorXd::Zero(mesh.vertexCount());
    target.tail(6 * rings).setConstant(kFullTurn / (6 * rings));
    YamabeFlowOptions options;
    options.metric = ConformalMetric::CirclePacking;
    const YamabeFlowResult packing = yamabeFlow(intrinsic(mesh), target, {}, options), yamabe = yamabeFlow(intrinsic(mesh), target);
    EXPECT_EQ(packing.status, Status::Converged);
    EXPECT_LE((vertexCurvature(packing.triangulation, packing.logScale) - target).cwiseAbs().maxCoeff(), 1.01e-10);
    // Both layouts, scaled to the same size, turned by their first boundary vertex.
    const auto layout = [&](const YamabeFlowResult& flow) {
      const Development development = develop(flow.triangulation, flow.logScale);
      EXPECT_LT(development.holonomy, 1e-8);
      Points2 p = development.points.rowwise() - development.points.row(0);
      const Eigen::RowVector2d first = p.row(mesh.vertexCount() - 1) / p.row(mesh.vertexCount() - 1).squaredNorm();
      for (Eigen::Index i = 0; i < p.rows(); ++i) {
        p.row(i) = Eigen::RowVector2d(p.row(i).dot(first), p(i, 1) * first[0] - p(i, 0) * first[1]);
      }
      return p;
    };
    return (layout(packing) - layout(yamabe)).norm() / std::sqrt(static_cast<double>(mesh.vertexCount()));
  };
  const double coarse = difference(8), fine = difference(16);
  EXPECT_LT(fine, 1e-2);
  EXPECT_GT(coarse / fine, 2);
}

TEST(RicciFlow, ConvergesForBothChoicesOfRadiiOnGoodTriangles) {
  for (const PackingRadii radii : {PackingRadii::Tangent, PackingRadii::Circumradius}) {
    const IntrinsicTriangulation t = intrinsic(bumpyDisk(12, 0.2));
    Eigen::VectorXd target = Eigen::VectorXd::Zero(t.vertexCount());
    target.tail(72).setConstant(kFullTurn / 72);
    YamabeFlowOptions options;
    options.metric = ConformalMetric::CirclePacking;
    options.radii = radii;
    const YamabeFlowResult flow = yamabeFlow(t, target, {}, options);
    EXPECT_EQ(flow.status, Status::Converged);
    EXPECT_EQ(flow.degenerateFaces, 0);
  }
}

TEST(RicciFlow, SaysHowManyFacesDegenerateWhereItStalls) {
  // Random lengths and curvatures: overlapping circles run out of triangles; vertex scaling solves every one (see
  // above).
  int stalled = 0, degenerate = 0;
  for (unsigned seed = 1; seed <= 12; ++seed) {
    const IntrinsicTriangulation t = withRandomLengths(diskMesh(4), seed);
    YamabeFlowOptions options;
    options.metric = ConformalMetric::CirclePacking;
    options.radii = PackingRadii::Circumradius;
    const YamabeFlowResult flow = yamabeFlow(t, randomTarget(t, 1, 100 + seed), {}, options);
    if (flow.status == Status::Converged) {
      EXPECT_LE(flow.residual, 1e-10);
      continue;
    }
    ++stalled;
    EXPECT_EQ(flow.status, Status::Stalled);
    EXPECT_GT(flow.residual, 1e-10);
    EXPECT_TRUE(flow.logScale.allFinite());
    degenerate += flow.degenerateFaces;
  }
  EXPECT_GT(stalled, 0);
  EXPECT_GT(degenerate, 0);
}

TEST(BoundaryCircle, InscribesPolygonsWithTheCentreInsideAndOutside) {
  Eigen::VectorXd sides(4);
  const double radius = 2.5;
  for (const double longest : {1.4, 2.9}) {  // half arcs; the rest shares what is left
    Eigen::VectorXd arcs(4);
    arcs << longest, (M_PI - longest) * 0.2, (M_PI - longest) * 0.3, (M_PI - longest) * 0.5;
    for (int k = 0; k < 4; ++k) sides[k] = 2 * radius * std::sin(arcs[k]);
    const InscribedPolygon polygon = inscribe(sides);
    EXPECT_NEAR(polygon.radius, radius, 1e-12);
    EXPECT_LT((polygon.halfArcs - arcs).cwiseAbs().maxCoeff(), 1e-12);
  }
  sides << 10, 1, 2, 3;  // no such polygon
  EXPECT_NEAR(inscribe(sides).halfArcs.sum(), M_PI, 1e-14);
}

TEST(BoundaryCircle, DifferentiatesItsCurvature) {
  const IntrinsicTriangulation t = intrinsic(bumpyDisk(4));
  const SurfaceTopology topology(bumpyDisk(4).faces(), t.vertexCount());
  BoundaryCircle circle(t, topology.boundaryLoops().front(), true);
  const int n = t.vertexCount();
  Eigen::VectorXd v(n);
  std::mt19937 random(2);
  for (int i = 0; i < n; ++i) v[i] = std::uniform_real_distribution<double>(-1, 1)(random);
  const double h = 1e-5;
  Eigen::VectorXd plus = Eigen::VectorXd::Zero(n), minus = plus, derivative = plus;
  circle.update(t, h * v);
  circle.setCurvature(plus);
  circle.update(t, -h * v);
  circle.setCurvature(minus);
  circle.update(t, 0 * v);
  circle.addDerivative(v, 1, derivative);
  EXPECT_LT((derivative - (plus - minus) / (2 * h)).cwiseAbs().maxCoeff(), 1e-8);
  EXPECT_GT(derivative.norm(), 1e-2);
}
