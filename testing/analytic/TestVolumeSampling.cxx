#include <gtest/gtest.h>

#include <cmath>

#include "Core/sampling/VolumeSampling.h"
#include "support/TestMeshes.h"

using namespace authalic;
using namespace authalic::testing;

/// f(x) = |x|² inside a ball of radius 1: the mean over the depths 0 … 0.5 in 11 steps is the mean of (1 −
/// d)².
TEST(VolumeSampling, ConvergesToTheRadialMeanBelowASphere) {
  double exact = 0;
  for (int k = 0; k <= 10; ++k) exact += (1 - 0.05 * k) * (1 - 0.05 * k) / 11;
  VolumeSamplingOptions options;
  options.mode = SamplingMode::AlongNormal;
  options.depthTo = 0.5;
  options.depthStep = 0.05;
  double coarse = 0;
  for (const int refinement : {1, 2, 4}) {
    const int n = 24 * refinement + 1;
    Eigen::Matrix4d affine = Eigen::Matrix4d::Identity() * (2.4 / (n - 1));
    affine.col(3) << -1.2, -1.2, -1.2, 1.0;
    VolumeOf<double> volume({n, n, n}, affine);
    for (int k = 0; k < n; ++k)
      for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) volume.at(i, j, k) = volume.world(i, j, k).squaredNorm();
    const VolumeSamples samples = sampleVolume(sphereMesh(2 + (refinement + 1) / 2), volume, options);
    double error = 0;
    for (const double value : samples.values)
      error += std::abs(value - exact) / static_cast<double>(samples.values.size());
    if (coarse > 0) {
      EXPECT_GT(coarse / error, 3.3) << refinement;
    }
    coarse = error;
  }
}
