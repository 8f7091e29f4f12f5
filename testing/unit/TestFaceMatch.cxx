#include <gtest/gtest.h>

#include "Core/authalic/FaceMatch.h"
#include "Core/authalic/SolidAngles.h"
#include "Core/geometry/Areas.h"
#include "support/TestMeshes.h"

using namespace authalic;
using namespace authalic::testing;

namespace {

// The unit sphere as the image of a rod, ten times as long as wide.
struct RodOnSphere {
  TriangleMesh sphere = sphereMesh(3), rod = stretched(sphere);
  SolidAngles areas{sphere.faces(), sphere.vertexCount()};
  Eigen::VectorXd targets = faceAreas(rod) / faceAreas(rod).sum();
  AnalysedSystems systems;
  FaceMatch match{areas, targets, cotangentWeights(rod), SolverBackend::Automatic, Shapes::First, systems};
  Coordinates image = sphere.points();

  static TriangleMesh stretched(const TriangleMesh& mesh) {
    Points3 points = mesh.points();
    points.col(2) *= 10;
    return TriangleMesh(points, mesh.faces());
  }
};

}  // namespace

// With areas alone in the objective, and with faces that are stiffer from the 20th step on, no step may raise F.
TEST(FaceMatch, FreedOfShapesLowersAreasInEveryStep) {
  RodOnSphere rod;
  for (int k = 0; k < 10; ++k) rod.match.advance(rod.image);
  rod.match.freeShapes();
  double before = rod.match.residual(rod.image);
  const double withShapes = before;
  for (int k = 0; k < 30; ++k) {
    rod.match.advance(rod.image);
    const double after = rod.match.residual(rod.image);
    EXPECT_LE(after, before) << k;
    before = after;
  }
  EXPECT_LT(before, 0.01 * withShapes);
}
