#include <gtest/gtest.h>

#include <algorithm>

#include "Core/authalic/DiscreteLieFlow.h"
#include "Core/initial/BarycentricMap.h"
#include "Core/sampling/ElementGrid.h"
#include "Formats/SurfaceFile.h"
#include "support/SharedData.h"

using namespace authalic;
using namespace authalic::testing;

/// What area preservation buys: the same grid on the initial map and on the map of the discrete Lie flow.
TEST(ElementGridSlow, HasInteriorElementsOfEqualAreaOnTheLieFlowOfARealSurface) {
  const std::string path = sharedData("meshes/open_disk/chinese_lion.off");
  AUTHALIC_NEEDS(path);
  const SurfaceFile file = readSurface(path);
  Points3 points(static_cast<Eigen::Index>(file.vertexCount()), 3);
  Faces faces(static_cast<Eigen::Index>(file.faceCount()), 3);
  std::copy(file.points.begin(), file.points.end(), points.data());
  std::copy(file.faces.begin(), file.faces.end(), faces.data());
  const DiskMesh disk(TriangleMesh(points, faces));
  BarycentricMapOptions initialOptions;
  DiscreteLieFlowOptions flowOptions;
  initialOptions.domain = flowOptions.domain = PlanarDomain::square();
  const BarycentricMapResult initial = barycentricMap(disk, initialOptions);
  const DiscreteLieFlowResult flow =
      discreteLieFlow(disk, initial.image, TargetMeasure(disk.mesh()), flowOptions);
  const ElementGrid before = elementGrid(disk.mesh(), initial.image),
                    after = elementGrid(disk.mesh(), flow.image);
  EXPECT_GT(after.deviation.interiorElements, 300);
  EXPECT_LT(after.deviation.interiorMaximum, 0.02);
  EXPECT_LT(after.deviation.interiorMean, 0.002);
  EXPECT_GT(before.deviation.interiorMean, 100 * after.deviation.interiorMean);
  EXPECT_NEAR(after.surfaceArea, before.surfaceArea, 1e-9 * before.surfaceArea);
}
