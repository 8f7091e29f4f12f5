#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "Core/base/Error.h"
#include "Core/conformal/YamabeFlow.h"
#include "Core/geometry/Areas.h"
#include "Core/geometry/Development.h"
#include "Core/geometry/IntrinsicTriangulation.h"
#include "support/TestMeshes.h"

using namespace authalic;
using namespace authalic::testing;

namespace {

IntrinsicTriangulation intrinsic(const TriangleMesh& mesh) {
  return IntrinsicTriangulation(mesh, SurfaceTopology(mesh.faces(), mesh.vertexCount()));
}

Eigen::VectorXd noScale(const IntrinsicTriangulation& t) { return Eigen::VectorXd::Zero(t.vertexCount()); }

Eigen::VectorXd randomScale(int count, double size, unsigned seed) {
  std::mt19937 random(seed);
  Eigen::VectorXd u(count);
  for (int i = 0; i < count; ++i) u[i] = std::uniform_real_distribution<double>(-size, size)(random);
  return u;
}

// The two triangles of a planar quadrilateral a, b, c, d with diagonal ac.
TriangleMesh quadrilateral(const Eigen::Matrix<double, 4, 2>& corners) {
  Points3 points = Points3::Zero(4, 3);
  points.leftCols(2) = corners;
  Faces faces(2, 3);
  faces << 0, 1, 2, 0, 2, 3;
  return TriangleMesh(points, faces);
}

double areaOf(const IntrinsicTriangulation& t, const Eigen::VectorXd& u) {
  double area = 0;
  for (int f = 0; f < t.faceCount(); ++f) {
    const int h = t.first(f);
    const FaceShape s = t.shape(f, u);  // ½ a b sin γ, γ opposite to the first half-edge
    area += 0.5 * std::exp(t.logLength(t.next(h), u) + t.logLength(t.previous(h), u)) * std::sin(s.angle[0]);
  }
  return area;
}

int nonDelaunay(const IntrinsicTriangulation& t, const Eigen::VectorXd& u) {
  int count = 0;
  for (int h = 0; h < t.halfEdgeCount(); ++h) count += !t.isDelaunay(h, u);
  return count;
}

// Half-edges agree about faces, ends and lengths with each other.
void expectConsistent(const IntrinsicTriangulation& t) {
  for (int h = 0; h < t.halfEdgeCount(); ++h) {
    ASSERT_EQ(t.next(t.next(t.next(h))), h);
    ASSERT_EQ(t.face(t.next(h)), t.face(h));
    const int g = t.opposite(h);
    if (g < 0) continue;
    ASSERT_EQ(t.opposite(g), h);
    ASSERT_EQ(t.tail(g), t.head(h));
    ASSERT_EQ(t.logLength(g), t.logLength(h));
    ASSERT_EQ(t.winding(g), -t.winding(h));
  }
}

}  // namespace

TEST(IntrinsicTriangulation, GivesAnglesOfARightTriangleAtAnyScale) {
  Points3 points(3, 3);
  points << 0, 0, 0, 3, 0, 0, 0, 4, 0;
  Faces faces(1, 3);
  faces << 0, 1, 2;
  for (const double scale : {1.0, 1e-150, 1e150}) {
    const IntrinsicTriangulation t = intrinsic(TriangleMesh(Points3(scale * points), faces));
    const FaceShape shape = t.shape(0, Eigen::Vector3d::Zero());
    const double rounding = scale == 1 ? 1e-15 : 1e-13;  // a logarithm of 345 has an ulp of 6e-14
    EXPECT_NEAR(shape.angle[0], std::atan2(3, 4), rounding);  // opposite to the edge 01
    EXPECT_NEAR(shape.angle[1], M_PI / 2, rounding);
    EXPECT_NEAR(shape.angle[2], std::atan2(4, 3), rounding);
    EXPECT_NEAR(shape.cotangent[0], 4.0 / 3, 2 * rounding);
  }
}

TEST(IntrinsicTriangulation, KeepsSmallAnglesOfNeedlesToFullRelativePrecision) {
  const SurfaceTopology topology((Faces(1, 3) << 0, 1, 2).finished(), 3);
  FaceLengths sides(1, 3);
  const double width = 1e-9;
  sides << width, 1, 1;  // isosceles
  const FaceShape shape = IntrinsicTriangulation(topology, sides).shape(0, Eigen::Vector3d::Zero());
  EXPECT_NEAR(shape.angle[0] / (2 * std::asin(width / 2)), 1, 1e-14);
  EXPECT_NEAR(shape.angle[0] + shape.angle[1] + shape.angle[2], M_PI, 1e-15);
}

TEST(IntrinsicTriangulation, BothRulesAgreeOnACocircularQuadrilateralOnly) {
  Eigen::Matrix<double, 4, 2> corners;
  const auto at = [](double angle) { return Eigen::RowVector2d(std::cos(angle), std::sin(angle)); };
  corners << at(0.1), at(1.9), at(3.0), at(5.1);
  for (const double shift : {0.0, 0.4}) {
    Eigen::Matrix<double, 4, 2> moved = corners;
    moved.row(3) += shift * Eigen::RowVector2d(1, 1);
    IntrinsicTriangulation ptolemy = intrinsic(quadrilateral(moved)), euclidean = ptolemy;
    int diagonal = 0;
    while (ptolemy.opposite(diagonal) < 0) ++diagonal;
    ptolemy.flip(diagonal, noScale(ptolemy), FlipRule::Ptolemy);
    euclidean.flip(diagonal, noScale(ptolemy), FlipRule::Euclidean);
    const double distance = (moved.row(1) - moved.row(3)).norm();
    EXPECT_NEAR(std::exp(euclidean.logLength(diagonal)), distance, 1e-14);
    if (shift == 0) {
      EXPECT_NEAR(std::exp(ptolemy.logLength(diagonal)), distance, 1e-14);
    } else {
      EXPECT_GT(std::exp(ptolemy.logLength(diagonal)), distance + 1e-3);  // Ptolemy's inequality
    }
  }
}

TEST(IntrinsicTriangulation, AFlipTwiceIsNoFlip) {
  for (const FlipRule rule : {FlipRule::Ptolemy, FlipRule::Euclidean}) {
    // Euclidean flips are undone where the pair of triangles is convex, as all are here.
    IntrinsicTriangulation t = intrinsic(rule == FlipRule::Ptolemy ? bumpyDisk(4) : diskMesh(6));
    const IntrinsicTriangulation before = t;
    for (int h = 0; h < t.halfEdgeCount(); ++h) {
      const Eigen::VectorXd u = randomScale(t.vertexCount(), rule == FlipRule::Ptolemy ? 1 : 0.05, 3);
      if (!t.flippable(h)) continue;
      t.flip(h, u, rule);
      expectConsistent(t);
      t.flip(h, u, rule);
      EXPECT_EQ(t.tail(h), before.head(h));  // turned by half a turn
      EXPECT_EQ(t.head(h), before.tail(h));
      EXPECT_NEAR(t.logLength(h), before.logLength(h), 1e-11);
      t = before;
    }
  }
}

TEST(IntrinsicTriangulation, FlipsByPtolemyCommuteWithScaling) {
  IntrinsicTriangulation t = intrinsic(bumpyDisk(3));
  const Eigen::VectorXd u = randomScale(t.vertexCount(), 2, 5);
  int h = 0;
  while (!t.flippable(h)) ++h;
  const int g = t.opposite(h), jk = t.next(h), ki = t.previous(h), il = t.next(g), lj = t.previous(g);
  const double expected = (std::exp(t.logLength(ki, u) + t.logLength(lj, u)) + std::exp(t.logLength(il, u) + t.logLength(jk, u))) /
                          std::exp(t.logLength(h, u));
  t.flip(h, u);
  EXPECT_NEAR(std::exp(t.logLength(h, u)) / expected, 1, 1e-14);
}

TEST(IntrinsicTriangulation, EuclideanFlipsToDelaunayKeepAreaAndCurvature) {
  IntrinsicTriangulation t = intrinsic(roughDisk(12, 7));
  const Eigen::VectorXd u = noScale(t), curvature = vertexCurvature(t, u);
  const double area = areaOf(t, u);
  EXPECT_GT(nonDelaunay(t, u), 0);
  EXPECT_GT(t.makeDelaunay(u, FlipRule::Euclidean), 10);
  expectConsistent(t);
  EXPECT_EQ(nonDelaunay(t, u), 0);
  EXPECT_NEAR(areaOf(t, u), area, 1e-12 * area);
  EXPECT_LT((vertexCurvature(t, u) - curvature).cwiseAbs().maxCoeff(), 1e-11);
}

TEST(IntrinsicTriangulation, OfAClosedSurfaceIsMadeOfTrianglesAfterPtolemyFlipsWhateverTheScale) {
  for (const unsigned seed : {1u, 2u, 3u}) {
    IntrinsicTriangulation t = intrinsic(sphereMesh(3));
    const Eigen::VectorXd u = randomScale(t.vertexCount(), 12, seed);
    int broken = 0;
    for (int f = 0; f < t.faceCount(); ++f) broken += !t.shape(f, u).triangle;
    EXPECT_GT(broken, 100);
    EXPECT_GT(t.makeDelaunay(u), 100);
    expectConsistent(t);
    EXPECT_EQ(nonDelaunay(t, u), 0);
    for (int f = 0; f < t.faceCount(); ++f) EXPECT_TRUE(t.shape(f, u).triangle);
    EXPECT_NEAR(vertexCurvature(t, u).sum(), 4 * M_PI, 1e-11);  // Gauss–Bonnet
    // Edges from a vertex to itself occur here; back at u = 0 the surface is what it was.
    t.makeDelaunay(noScale(t));
    EXPECT_LT((vertexCurvature(t, noScale(t)) - vertexCurvature(intrinsic(sphereMesh(3)), noScale(t))).cwiseAbs().maxCoeff(),
              1e-6);
  }
}

TEST(IntrinsicTriangulation, SplitsABoundaryEdgeWithoutChangingTheMetric) {
  Points3 points(4, 3);
  points << 0, 0, 0, 10, 0, 0, 4, 0.5, 0, 5, 8, 0;
  Faces faces(3, 3);
  faces << 0, 1, 2, 1, 3, 2, 3, 0, 2;
  IntrinsicTriangulation t = intrinsic(TriangleMesh(points, faces));
  const Eigen::VectorXd u = randomScale(4, 0.01, 4), before = vertexCurvature(t, u);
  const double area = areaOf(t, u);
  EXPECT_LT(t.oppositeCosine(0, u), -0.9);
  EXPECT_EQ(t.splitBoundaryEdge(0, u), 4);
  expectConsistent(t);
  Eigen::VectorXd wider(5);
  wider << u, 0.5 * (u[0] + u[1]);
  const Eigen::VectorXd after = vertexCurvature(t, wider);
  EXPECT_LT((after.head(4) - before).cwiseAbs().maxCoeff(), 1e-13);
  EXPECT_NEAR(after[4], 0, 1e-13);
  EXPECT_NEAR(areaOf(t, wider), area, 1e-13);
  EXPECT_EQ(t.head(0), 4);
  EXPECT_GT(t.oppositeCosine(0, wider), 0);
}

TEST(IntrinsicTriangulation, RefusesEdgesWithoutLengthAndLengthsThatDisagree) {
  Points3 points(4, 3);
  points << 0, 0, 0, 1, 0, 0, 1, 0, 0, 0, 1, 0;
  Faces faces(2, 3);
  faces << 0, 1, 2, 0, 2, 3;
  EXPECT_THROW(intrinsic(TriangleMesh(points, faces)), GeometryError);
  const SurfaceTopology topology(faces, 4);
  EXPECT_THROW(IntrinsicTriangulation(topology, FaceLengths::Ones(3, 3)), GeometryError);
  FaceLengths lengths = FaceLengths::Ones(2, 3);
  lengths(0, 2) = 1.5;
  EXPECT_THROW(IntrinsicTriangulation(topology, lengths), GeometryError);
  lengths(0, 2) = std::nan("");
  EXPECT_THROW(IntrinsicTriangulation(topology, lengths), GeometryError);
  IntrinsicTriangulation t(topology, FaceLengths::Ones(2, 3));
  EXPECT_THROW(t.attachWinding(std::vector<int>(6, 1)), InvalidArgument);
}

TEST(Development, UnfoldsAFlatMeshToItselfAfterFlips) {
  const TriangleMesh mesh = roughDisk(10, 3);
  Points3 flat = mesh.points();
  flat.col(2).setZero();
  Points2 plane = flat.leftCols(2);
  const int folded = countFlippedFaces(plane, mesh.faces());
  ASSERT_EQ(folded, 0);
  IntrinsicTriangulation t = intrinsic(TriangleMesh(flat, mesh.faces()));
  t.makeDelaunay(noScale(t), FlipRule::Euclidean);
  const Development development = develop(t, noScale(t));
  EXPECT_LT(development.holonomy, 1e-13);
  EXPECT_EQ(countFlippedFaces(development.points, mesh.faces()), 0);
  const auto distances = [](const Points2& p) {
    Eigen::VectorXd d(p.rows());
    for (Eigen::Index i = 0; i < p.rows(); ++i) d[i] = (p.row(i) - p.row((7 * i + 3) % p.rows())).norm();
    return d;
  };
  EXPECT_LT((distances(development.points) - distances(plane)).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(Development, ShowsTheHolonomyOfAConeThatIsNotFlat) {
  const IntrinsicTriangulation t = intrinsic(capMesh(4, 1.0));
  EXPECT_GT(develop(t, noScale(t)).holonomy, 1e-2);
}
