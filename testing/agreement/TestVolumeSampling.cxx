#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <variant>

#include "Core/base/Error.h"
#include "Core/sampling/VolumeSampling.h"
#include "Formats/Gifti.h"
#include "Formats/SurfaceFile.h"
#include "Formats/VolumeFile.h"
#include "support/SharedData.h"

using namespace authalic;
using namespace authalic::testing;

namespace {

TriangleMesh meshOf(const SurfaceFile& file) {
  Points3 points(static_cast<Eigen::Index>(file.vertexCount()), 3);
  Faces faces(static_cast<Eigen::Index>(file.faceCount()), 3);
  std::copy(file.points.begin(), file.points.end(), points.data());
  std::copy(file.faces.begin(), file.faces.end(), faces.data());
  return TriangleMesh(points, faces);
}

/// Linear between order statistics, as numpy.percentile; NaN left out.
double percentile(std::vector<double> values, double percent) {
  values.erase(std::remove_if(values.begin(), values.end(), [](double x) { return std::isnan(x); }),
               values.end());
  std::sort(values.begin(), values.end());
  const double position = percent / 100 * static_cast<double>(values.size() - 1);
  const auto low = static_cast<std::size_t>(position);
  const double high = values[std::min(low + 1, values.size() - 1)];
  return values[low] + (position - std::floor(position)) * (high - values[low]);
}

}  // namespace

/// Published for this subject; only the full tkRAS formula gives them.
TEST(VolumeSampling, ReproducesThePercentilesOfARealBrainAtItsPialSurface) {
  const std::string surfacePath = sharedData("cortex/subject1_fs/lh.pialsurface6");
  const std::string volumePath = sharedData("cortex/subject1_fs/brain.mgz");
  AUTHALIC_NEEDS(surfacePath);
  AUTHALIC_NEEDS(volumePath);
  SurfaceFile surface = readSurface(surfacePath);
  ASSERT_EQ(surface.space, CoordinateSpace::TkRAS);
  toScannerRas(surface);
  const VolumeSamples samples = sampleVolume(meshOf(surface), readVolume(volumePath).scalars());
  EXPECT_EQ(samples.verticesWithoutValue, 0);
  EXPECT_NEAR(percentile(samples.values, 1), 40.4, 0.05);
  EXPECT_NEAR(percentile(samples.values, 25), 49.4, 0.05);
  EXPECT_NEAR(percentile(samples.values, 50), 53.2, 0.05);
  EXPECT_NEAR(percentile(samples.values, 75), 56.8, 0.05);
  EXPECT_NEAR(percentile(samples.values, 99), 103, 0.5);
}

TEST(VolumeSampling, ReproducesTheQuartilesOfPetAtTheMidthickness) {
  const std::string surfacePath = sharedData("cortex/conte69_gifti/conte69_32k_lh.gii");
  const std::string volumePath = sharedData("volumes/spm12/PET.nii");
  AUTHALIC_NEEDS(surfacePath);
  AUTHALIC_NEEDS(volumePath);
  const SurfaceFile surface = readSurface(surfacePath);
  const VolumeSamples samples = sampleVolume(meshOf(surface), readVolume(volumePath).scalars());
  EXPECT_EQ(samples.verticesWithoutValue, 0);
  EXPECT_NEAR(percentile(samples.values, 25), 0.70857, 1e-5);
  EXPECT_NEAR(percentile(samples.values, 50), 0.75397, 1e-5);
  EXPECT_NEAR(percentile(samples.values, 75), 0.80038, 1e-5);
}

/// Between white and pial the same sample comes from the segment and from the surface half-way.
TEST(VolumeSampling, AgreesBetweenSurfacesAndOnTheSurfaceBetween) {
  const std::string whitePath = sharedData("cortex/fsaverage5_gifti/white_left.gii.gz");
  const std::string pialPath = sharedData("cortex/fsaverage5_gifti/pial_left.gii.gz");
  const std::string volumePath = sharedData("volumes/mni/mni_icbm152_t1_tal_nlin_sym_09a_converted.nii.gz");
  AUTHALIC_NEEDS(whitePath);
  AUTHALIC_NEEDS(pialPath);
  AUTHALIC_NEEDS(volumePath);
  const TriangleMesh white = meshOf(readSurface(whitePath)), pial = meshOf(readSurface(pialPath));
  const ScalarVolume volume = readVolume(volumePath).scalars();
  VolumeSamplingOptions options;
  options.fractionFrom = options.fractionTo = 0.5;
  const VolumeSamples between = sampleVolumeBetween(white, pial.points(), volume, options);
  const VolumeSamples middle =
      sampleVolume(TriangleMesh(0.5 * (white.points() + pial.points()), white.faces()), volume);
  ASSERT_EQ(between.values.size(), middle.values.size());
  for (std::size_t v = 0; v < middle.values.size(); ++v) {
    if (std::isnan(middle.values[v])) {
      EXPECT_TRUE(std::isnan(between.values[v]));
    } else {
      EXPECT_NEAR(between.values[v], middle.values[v], 1e-9);
    }
  }
}

TEST(VolumeSampling, IsNotAvailableWhereARealSurfaceLeavesTheField) {
  const std::string surfacePath = sharedData("cortex/conte69_gifti/conte69_32k_lh.gii");
  const std::string volumePath = sharedData("volumes/spm12/PET.nii");
  AUTHALIC_NEEDS(surfacePath);
  AUTHALIC_NEEDS(volumePath);
  const SurfaceFile surface = readSurface(surfacePath);
  Points3 shifted = meshOf(surface).points();
  shifted.col(0).array() -= 60.0;
  const VolumeSamples samples =
      sampleVolume(TriangleMesh(shifted, meshOf(surface).faces()), readVolume(volumePath).scalars());
  EXPECT_GT(samples.verticesWithoutValue, 5000);
  for (std::size_t v = 0; v < samples.values.size(); ++v) {
    EXPECT_EQ(std::isnan(samples.values[v]), samples.coverage[v] == 0.0);
    EXPECT_EQ(std::isnan(samples.values[v]), shifted(static_cast<Eigen::Index>(v), 0) < -90.0 - 1e-5)
        << "the outermost voxel centre";
  }
}
