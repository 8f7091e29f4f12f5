#include <gtest/gtest.h>

#include <string>

#include "Core/authalic/AuthalicMap.h"
#include "Core/authalic/FlatConeAuthalicMap.h"
#include "Core/authalic/SphericalAuthalicMap.h"
#include "Core/distortion/Distortion.h"
#include "Core/distortion/SphericalDistortion.h"
#include "Formats/SurfaceFile.h"
#include "support/OffFile.h"
#include "support/SharedData.h"

using namespace authalic;
using namespace authalic::testing;

namespace {

DistortionSummary exactMap(const std::string& path, const AuthalicMapOptions& options) {
  const DiskMesh disk(readOff(path));
  const AuthalicMapResult result = authalicMap(disk, TargetMeasure(disk.mesh()), options);
  EXPECT_EQ(result.status, Status::Converged) << result.faceResidual << " " << result.vertexResidual;
  return measureDistortion(disk.mesh(), result.image).summary;
}

class AuthalicMapOnCortexSlow : public ::testing::TestWithParam<const char*> {};

}  // namespace

TEST(AuthalicMapToASquareSlow, IsExactAtVerticesAndNearlySoAtFaces) {
  const std::string path = sharedData("meshes/open_disk/chinese_lion.off");
  AUTHALIC_NEEDS(path);
  AuthalicMapOptions options;
  options.domain = PlanarDomain::square();
  const DistortionSummary summary = exactMap(path, options);
  EXPECT_EQ(summary.flippedFaces, 0);
  EXPECT_LT(summary.areaDistortion, 2 + 1e-4);
  EXPECT_LT(summary.vertexMaxAbsLog, 1e-9);
}

TEST(AuthalicMapWithASmallToleranceSlow, IsTenTimesNearerAtFaces) {
  const std::string path = sharedData("meshes/open_disk/chinese_lion.off");
  AUTHALIC_NEEDS(path);
  AuthalicMapOptions options;
  options.tolerance = 1e-3;
  const DistortionSummary summary = exactMap(path, options);
  EXPECT_EQ(summary.flippedFaces, 0);
  EXPECT_LT(summary.areaDistortion, 2 + 1e-5);
  EXPECT_LT(summary.faceMeanAbsLog, 2e-3);
  EXPECT_LT(summary.vertexMaxAbsLog, 1e-9);
}

TEST_P(AuthalicMapOnCortexSlow, IsExactOnTheSphere) {
  const std::string path = sharedData(GetParam());
  AUTHALIC_NEEDS(path);
  const SurfaceFile file = readSurface(path);
  const auto n = static_cast<Eigen::Index>(file.vertexCount()), m = static_cast<Eigen::Index>(file.faceCount());
  const TriangleMesh mesh(Eigen::Map<const Points3>(file.points.data(), n, 3),
                          Eigen::Map<const Faces>(file.faces.data(), m, 3));
  const SphericalAuthalicMapResult result = sphericalAuthalicMap(SphereMesh(mesh), TargetMeasure(mesh));
  const SphericalDistortion distortion = measureSphericalDistortion(mesh, result.image);
  EXPECT_EQ(result.status, Status::Converged);
  EXPECT_LT(result.vertexResidual, 1e-9);
  EXPECT_LT(result.faceResidual, 1e-2);
  EXPECT_EQ(distortion.flippedByVolume, 0);
  EXPECT_NEAR(distortion.coverage, 1, 1e-10);
}

INSTANTIATE_TEST_SUITE_P(Sphere, AuthalicMapOnCortexSlow,
                         ::testing::Values("meshes/closed_g0/david.off", "meshes/closed_g0/gargoyle.obj",
                                           "meshes/closed_g0/sphere_brain.off"),
                         [](const auto& parameter) { return std::to_string(parameter.index); });

namespace {

class AuthalicMapOfHandles : public ::testing::TestWithParam<const char*> {};

}  // namespace

TEST_P(AuthalicMapOfHandles, IsExactAtVerticesAndClosesItsSeams) {
  const std::string path = sharedData(GetParam());
  AUTHALIC_NEEDS(path);
  const SurfaceFile file = readSurface(path);
  const auto n = static_cast<Eigen::Index>(file.vertexCount()), m = static_cast<Eigen::Index>(file.faceCount());
  const HighGenusMesh surface(TriangleMesh(Eigen::Map<const Points3>(file.points.data(), n, 3),
                                           Eigen::Map<const Faces>(file.faces.data(), m, 3)));
  const FlatConeAuthalicMapResult result = flatConeAuthalicMap(surface, TargetMeasure(surface.mesh()));
  const CutGraph& cut = result.flat.cut;
  const TriangleMesh opened(surface.mesh().points()(cut.originalPointIds, Eigen::all), cut.faces);
  const DistortionSummary summary = measureDistortion(opened, cut.originalPointIds, result.image).summary;
  EXPECT_EQ(result.status, Status::Converged) << result.faceResidual << " " << result.vertexResidual;
  EXPECT_EQ(summary.flippedFaces, 0);
  EXPECT_LT(summary.areaDistortion, 2 + 1e-4);
  EXPECT_LT(summary.faceMeanAbsLog, 1e-2);
  EXPECT_LT(summary.vertexMaxAbsLog, 1e-9);
  EXPECT_LT(result.seamError, 1e-9);
  EXPECT_LT(result.angleError, 1e-9);
}

INSTANTIATE_TEST_SUITE_P(Real, AuthalicMapOfHandles,
                         ::testing::Values("meshes/genus/double-torus.obj", "meshes/genus/3holes.off",
                                           "meshes/genus/fertility.off"),
                         [](const auto& parameter) { return "Genus" + std::to_string(2 + parameter.index); });
