/// @file
/// Two disk maps of the halves of a closed surface, welded into one map to the sphere.
#pragma once

#include "Core/base/Execution.h"
#include "Core/conformal/ConformalWelding.h"
#include "Core/topology/LevelSetCut.h"

namespace authalic {

struct WeldedHalves {
  Points3 image;             ///< n×3 on the unit sphere: the vertices of the surface that was cut
  ConformalWelding welding;  ///< disk 1 = above, disk 2 = below; Φ1(0) at (0, 0, 1), Φ2(0) at (0, 0, −1)
};

/// Follows the conformal maps f_1, f_2 of the two halves to the unit disk by the maps of the welding
/// f_1(seam point k) ~ f_2(seam point k), and lifts the plane to the sphere: conformal across the seam, as far as
/// f_1 and f_2 are conformal and the seam points resolve them. @cite nadeem2017 (algorithm 2)
///
/// @param above, below  images of the vertices of the two halves: the seam on the unit circle (only its directions are
///        used), the others inside; counter-clockwise
/// @throws InvalidArgument when sizes do not match, a vertex lies outside the disk, or the seam is out of order (see
///         WeldingSignature)
/// Complexity O((n + s) s) for a seam of s points.
[[nodiscard]] WeldedHalves weldHalves(const LevelSetCutResult& cut, const Points2& above, const Points2& below,
                                      const Execution& execution = {});

}  // namespace authalic
