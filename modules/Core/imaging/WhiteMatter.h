/// @file
/// White matter of each hemisphere of a T1 image: filled, separated from the hindbrain, split at the midline.
#pragma once

#include "Core/base/Execution.h"
#include "Core/imaging/BrainFrame.h"
#include "Core/imaging/IntensityClasses.h"
#include "Core/imaging/LabelConvention.h"
#include "Core/imaging/Volume.h"

namespace authalic {

/// Choices of segmentWhiteMatter. Lengths in mm.
struct WhiteMatterOptions {
  double threshold = 0;   ///< grey–white threshold in units of the image; 0 = from the histogram
  double biasScale = 20;  ///< width of the window of the local threshold; 0 = one threshold everywhere
  double midlineBand =
      6;  ///< half width of the band in which the midline is decided by connection, not by side
  LabelConvention labels = LabelConvention::aal();

  /// @throws InvalidArgument naming the first field out of range
  void validate() const;
};

/// Where a voxel belongs.
enum Tissue : std::uint8_t { kOutside = 0, kLeft = 1, kRight = 2, kHindbrain = 3 };

/// On the grid of the T1 cropped to the brain, with an empty margin of at least 3 voxels.
struct WhiteMatter {
  MaskVolume tissue;      ///< a Tissue per voxel: white or filled
  MaskVolume filled;      ///< 1 = taken as white although it is not (ventricle, subcortex, cavity)
  ScalarVolume contrast;  ///< (T1 − θ) / (white − grey): −½ grey, +½ white, 0 at their border
  IntensityClasses classes;
  BrainFrame frame;
  double brainVolume = 0;  ///< mm³ of the brain mask
};

/// Segments white matter.
///
/// 1. The brain is where T1 is above a fifth of its 98th percentile; with labels on a T1 with skull, only
/// within their closed
///    hull. 2. Classes and local threshold (IntensityClasses.h). 3. White = T1 > θ. 4. Filled: the label ids
///    to fill; without such labels, CerebralPrior; and every fluid space that is enclosed by white matter and
///    filled parts (lateral ventricles). 5. Hindbrain and cerebrum flood white ∪ filled from certain markers,
///    the thickest parts first, and meet at the thinnest neck. 6. So do left and right, from `midlineBand`
///    beside the mid-sagittal plane towards it: they meet in that plane where they are joined, and a gyrus
///    that bulges across it stays with its hemisphere. 7. The largest component of each.
///
/// @param labels  on any grid (looked up by the nearest voxel through both affines), or nullptr
/// @throws GeometryError when T1 has no brain in it, shows a skull and there are no labels, the labels miss
/// it, or a hemisphere is empty;
///         InvalidArgument for bad options or an empty volume; CancelledError
/// @cite dale1999 @cite meyer1994
[[nodiscard]] WhiteMatter segmentWhiteMatter(const ScalarVolume& t1, const LabelVolume* labels,
                                             const WhiteMatterOptions& options,
                                             const Execution& execution = {});

}  // namespace authalic
