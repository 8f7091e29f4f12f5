#include <gtest/gtest.h>

#include "Core/conformal/SphericalConformalMap.h"
#include "Core/distortion/SphericalDistortion.h"
#include "Formats/SurfaceFile.h"
#include "support/SharedData.h"

using namespace authalic;
using namespace authalic::testing;

namespace {

TriangleMesh readMesh(const std::string& path) {
  const SurfaceFile file = readSurface(path);
  const auto n = static_cast<Eigen::Index>(file.vertexCount()), m = static_cast<Eigen::Index>(file.faceCount());
  return TriangleMesh(Eigen::Map<const Points3>(file.points.data(), n, 3),
                      Eigen::Map<const Faces>(file.faces.data(), m, 3));
}

/// Maps a surface; expects no folds, the mass centred, and at most this mean angle error (degrees).
void expectConformal(const std::string& name, double mostAngleError) {
  const std::string path = sharedData(name);
  AUTHALIC_NEEDS(path);
  const TriangleMesh mesh = readMesh(path);
  const SphericalMapResult result = sphericalConformalMap(SphereMesh(mesh));
  const SphericalDistortion distortion = measureSphericalDistortion(mesh, result.image);
  EXPECT_EQ(result.status, Status::Converged) << name;
  EXPECT_EQ(distortion.flippedByVolume, 0) << name;
  EXPECT_NEAR(distortion.coverage, 1, 1e-10) << name;
  EXPECT_LE(result.centreOfMass, 1e-10) << name;
  EXPECT_LE(distortion.summary.meanAngleError, mostAngleError) << name;
}

}  // namespace

TEST(SphericalConformalMap, OfTheBrainSphereKeepsAnglesToOneDegreeAndAQuarter) {
  expectConformal("meshes/closed_g0/sphere_brain.off", 1.25);
}

TEST(SphericalConformalMap, OfTemplateCorticesHasNoFolds) {
  expectConformal("cortex/fsaverage5_gifti/pial_left.gii.gz",
                  2.11);  // the peer's; curvature at the vertices allows 0.81
  expectConformal("cortex/fsaverage6_fs/lh.pial", 1.3);
  expectConformal("cortex/fsaverage6_fs/rh.pial", 1.3);
}

TEST(SphericalConformalMap, OfASubjectWithDegenerateFacesHasNoFolds) {
  expectConformal("cortex/subject1_fs/lh.pialsurface6", 2.9);  // curvature at the vertices allows 1.22
  expectConformal("cortex/subject1_fs/rh.pialsurface6", 2.9);
}
