#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "Core/authalic/AuthalicMap.h"
#include "support/TestMeshes.h"

using namespace authalic;
using namespace authalic::testing;

namespace {

// How far the exact map of a cap of 2 radians is from Lambert's equal-area projection, r(θ) = sin(θ/2) /
// sin(opening/2), when it starts there: root mean square over the vertices.
double lambertError(int rings) {
  const double opening = 2;
  const DiskMesh disk(capMesh(rings, opening));
  Points2 lambert = disk.mesh().points().leftCols(2);
  for (int v = 0; v < disk.mesh().vertexCount(); ++v) {
    const double theta = std::acos(std::clamp(disk.mesh().points()(v, 2), -1.0, 1.0));
    if (theta > 0) lambert.row(v) *= std::sin(theta / 2) / std::sin(opening / 2) / lambert.row(v).norm();
  }
  AuthalicMapOptions options;
  options.tolerance = 0.2;  // the faces of Lambert's projection are as near as the mesh is fine
  const AuthalicMapResult result = authalicMap(disk, TargetMeasure(disk.mesh()), options, lambert);
  EXPECT_EQ(result.status, Status::Converged);
  EXPECT_LT(result.vertexResidual, 1e-10);
  return std::sqrt((result.image - lambert).squaredNorm() / disk.mesh().vertexCount());
}

}  // namespace

TEST(AuthalicMap, IsLambertsProjectionOfASphericalCapToSecondOrder) {
  const double coarse = lambertError(12), middle = lambertError(24), fine = lambertError(48);
  EXPECT_GT(coarse / middle, 3) << coarse << ' ' << middle;
  EXPECT_GT(middle / fine, 3) << middle << ' ' << fine;
  EXPECT_LT(fine, 1e-3);
}
