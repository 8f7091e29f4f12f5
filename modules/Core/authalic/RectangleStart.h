/// @file
/// The start of area-preserving maps of annuli to the periodic rectangle, and their end. Private to authalic/.
#pragma once

#include <vector>

#include "Core/authalic/PeriodicRectangle.h"
#include "Core/authalic/TargetMeasure.h"
#include "Core/base/Execution.h"
#include "Core/mesh/AnnulusMesh.h"
#include "Core/numerics/SparseSolver.h"

namespace authalic {

struct RectangleStart {
  Points2 image;              ///< n×2, one image of every vertex, no face folded; empty when cancelled
  Points2 shifts;             ///< 3m×2, see periodicFaceAreas()
  std::vector<char> freedom;  ///< n: 1 on the sides (along x), 2 elsewhere, see PeriodicAreas
  int held = 0;               ///< a vertex of the outer loop, to fix the translation
  double height = 0;
  PeriodicRectangleImage opened;  ///< all but its image and its height

  /// `freedom` with the held vertex staying.
  [[nodiscard]] std::vector<char> heldFreedom() const;
};

/// The conformal map (annulusMap) with every row at the height below which its share of the target lies; where that is
/// folded or far from the target, barycentric maps with positive weights and the same boundary, reweighted.
/// @param outerLoop  −1 = the longer one
/// @throws GeometryError when faces stay folded; SolverError
[[nodiscard]] RectangleStart rectangleStart(const AnnulusMesh& annulus, const TargetMeasure& target, int outerLoop,
                                            SolverBackend backend, const Execution& execution);

/// The opened image. No area ratio changes by a shear along x and a change of height: those with the least Dirichlet
/// energy at the area of the surface are taken, and the held vertex is put at x = 0.
[[nodiscard]] PeriodicRectangleImage openRectangle(const AnnulusMesh& annulus, const RectangleStart& start,
                                                   Points2 image);

}  // namespace authalic
