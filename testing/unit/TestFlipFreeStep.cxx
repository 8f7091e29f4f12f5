#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "Core/geometry/Areas.h"
#include "Core/numerics/FlipFreeStep.h"
#include "support/TestMeshes.h"

using namespace authalic;
using namespace authalic::testing;

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

double areaAt(const Points2& p, const Points2& v, double step) {
  Faces face(1, 3);
  face << 0, 1, 2;
  return signedFaceAreas(p + step * v, face)[0];
}

// First sign change on a fine grid, refined by bisection.
double firstFlipByBisection(const Points2& p, const Points2& v, double until, int samples) {
  for (int k = 1; k <= samples; ++k) {
    double low = until * (k - 1) / samples, high = until * k / samples;
    if (areaAt(p, v, high) > 0) continue;
    for (int i = 0; i < 200; ++i) {
      const double middle = 0.5 * (low + high);
      (areaAt(p, v, middle) > 0 ? low : high) = middle;
    }
    return 0.5 * (low + high);
  }
  return kInfinity;
}

}  // namespace

TEST(FlipFreeStep, SolvesQuadraticsWithTwoOneAndNoPositiveRoots) {
  EXPECT_DOUBLE_EQ(smallestPositiveRoot(1, -3, 2), 1);
  EXPECT_DOUBLE_EQ(smallestPositiveRoot(0, -2, 1), 0.5);
  EXPECT_DOUBLE_EQ(smallestPositiveRoot(-1, 0, 4), 2);
  EXPECT_EQ(smallestPositiveRoot(1, 3, 2), kInfinity);
  EXPECT_EQ(smallestPositiveRoot(1, 0, 1), kInfinity);
  EXPECT_EQ(smallestPositiveRoot(0, 0, 1), kInfinity);
  EXPECT_EQ(smallestPositiveRoot(1, 1, 0), 0);
}

TEST(FlipFreeStep, KeepsDigitsWhereTheTextbookFormulaCancels) {
  // roots 1e-9 and 1e9: the small one is lost in b − √D
  const double root = smallestPositiveRoot(1, -(1e9 + 1e-9), 1);
  EXPECT_NEAR(root, 1e-9, 1e-23);
}

TEST(FlipFreeStep, AgreesWithBisectionOnRandomTriangles) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(-1, 1);
  int finite = 0;
  for (int trial = 0; trial < 300; ++trial) {
    Points2 p(3, 2), v(3, 2);
    for (int i = 0; i < 6; ++i) p.data()[i] = uniform(random), v.data()[i] = uniform(random);
    if (areaAt(p, v, 0) < 0.05) continue;
    const double fast = firstFlip(p, v, 0, 1, 2), slow = firstFlipByBisection(p, v, 4, 20000);
    if (slow < 4) {
      EXPECT_NEAR(fast, slow, 1e-9 * (1 + slow));
      ++finite;
    } else {
      EXPECT_GT(fast, 3.99);
    }
  }
  EXPECT_GT(finite, 30);
}

TEST(FlipFreeStep, TakesTheMinimumOverFacesAtAnyThreadCount) {
  const TriangleMesh mesh = diskMesh(20);
  const Points2 points = mesh.points().leftCols(2);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(-1, 1);
  Points2 velocity(points.rows(), 2);
  for (Eigen::Index i = 0; i < velocity.size(); ++i) velocity.data()[i] = uniform(random);
  const double step = flipFreeStep(points, velocity, mesh.faces());
  EXPECT_EQ(countFlippedFaces(points + 0.999 * step * velocity, mesh.faces()), 0);
  EXPECT_GT(countFlippedFaces(points + 1.001 * step * velocity, mesh.faces()), 0);
  EXPECT_EQ(step, flipFreeStep(points, velocity, mesh.faces(), Execution({}, {}, 1)));
}

TEST(FlipFreeStep, IsInfiniteForARigidMotion) {
  const TriangleMesh mesh = diskMesh(3);
  const Points2 points = mesh.points().leftCols(2);
  EXPECT_EQ(flipFreeStep(points, Points2::Ones(points.rows(), 2), mesh.faces()), kInfinity);
}
