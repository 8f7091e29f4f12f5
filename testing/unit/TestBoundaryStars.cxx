#include <gtest/gtest.h>

#include "Core/authalic/BoundaryStars.h"
#include "Core/authalic/PlanarAreas.h"
#include "Core/geometry/Areas.h"
#include "Core/initial/BoundaryPlacement.h"
#include "support/TestMeshes.h"

using namespace authalic;
using namespace authalic::testing;

namespace {

// A flat disk on its own circle, all targets alike.
struct SlidingDisk {
  DiskMesh disk{bumpyDisk(6, 0)};
  PlanarDomain domain;
  Points2 image = disk.mesh().points().leftCols(2);
  BoundaryPlacement placement = placeBoundary(disk, domain);
  SlidingBoundary sliding{placement, domain, image};
  PlanarAreas areas{disk.mesh().faces(), sliding, disk.mesh().vertexCount()};
  Eigen::VectorXd targets =
      Eigen::VectorXd::Constant(disk.mesh().faceCount(), 1.0 / disk.mesh().faceCount());
  Eigen::VectorXd importance = Eigen::VectorXd::LinSpaced(disk.mesh().faceCount(), 0.5, 2);
  BoundaryStars stars{areas, targets, importance};
};

}  // namespace

TEST(BoundaryStars, VanishAtTheirTargets) {
  const SlidingDisk disk;
  EXPECT_NEAR(disk.stars.value(3 * disk.targets), 0, 1e-25);
  EXPECT_GT(disk.stars.value(Eigen::VectorXd::LinSpaced(disk.targets.size(), 1, 2)), 1e-5);
}

// Area goes from an inner face, which no star has, to each other one: the whole stays as it is.
TEST(BoundaryStars, PullDownTheirValue) {
  SlidingDisk disk;
  const Eigen::VectorXd a = faceAreas(disk.disk.mesh());
  disk.stars.linearise(a);
  Eigen::VectorXd pulls = Eigen::VectorXd::Zero(a.size());
  disk.stars.addPulls(pulls);
  ASSERT_EQ(pulls[0], 0);
  const double h = 1e-6 * a.mean();
  int pulled = 0;
  for (Eigen::Index f = 1; f < a.size(); ++f) {
    Eigen::VectorXd more = a, less = a;
    more[f] += h;
    more[0] -= h;
    less[f] -= h;
    less[0] += h;
    const double slope = 0.5 * a.sum() * (disk.stars.value(more) - disk.stars.value(less)) / (2 * h);
    EXPECT_NEAR(-slope, pulls[f], 1e-6 * pulls.cwiseAbs().maxCoeff());
    pulled += pulls[f] != 0;
  }
  EXPECT_GT(pulled, static_cast<int>(disk.disk.boundary().size()));
}
