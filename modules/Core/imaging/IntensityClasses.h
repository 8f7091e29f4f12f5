/// @file
/// Grey and white matter of a T1 image, read off its histogram.
#pragma once

#include "Core/base/Execution.h"
#include "Core/imaging/Volume.h"

namespace authalic {

/// Typical intensities, in the units of the image.
struct IntensityClasses {
  double grey = 0;       ///< most frequent intensity of grey matter
  double white = 0;      ///< most frequent intensity of white matter
  double threshold = 0;  ///< between grey and white: their mean
  double fluid = 0;      ///< below: cerebrospinal fluid or background, grey − 0.9 (white − grey)
};

/// The two highest peaks of the smoothed histogram of the voxels inside `mask`, white being the brighter one.
///
/// When the histogram shows no two peaks at least a tenth of its range apart, the centres of the two brighter
/// of three classes (1-D k-means) are used instead.
///
/// @param mask  1 = brain
/// @throws GeometryError when fewer than 1000 voxels are given or their intensities are all alike
[[nodiscard]] IntensityClasses estimateIntensityClasses(const ScalarVolume& t1, const MaskVolume& mask);

/// The threshold between grey and white as a smooth function of place, for images with a bias field.
///
/// θ(x) = ½ (μ_w(x) + μ_g(x)) where μ_w, μ_g are the means of the voxels classified white and grey by the
/// global classes, weighted by a Gaussian of `scale` mm around x, with the global means as a prior of the
/// weight of 2 % of such a window.
/// @return threshold per voxel of t1
[[nodiscard]] ScalarVolume localThreshold(const ScalarVolume& t1, const MaskVolume& mask,
                                          const IntensityClasses& classes, double scale,
                                          const Execution& execution = {});

}  // namespace authalic
