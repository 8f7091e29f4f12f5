/// @file
/// Holes of an image made round, the rest following. Private to authalic/.
#pragma once

#include <vector>

#include "Core/authalic/CircleDomainAreas.h"
#include "Core/base/Execution.h"
#include "Core/mesh/PolyAnnulusMesh.h"
#include "Core/numerics/SparseSolver.h"

namespace authalic {

struct RoundedHoles {
  Points2 image;
  int folded = 0;   ///< faces; 0 unless circles had no room
  int pockets = 0;  ///< see FoldedPockets
  std::vector<LoopOnCircle> loops;  ///< the outer one first; without vertices of pockets
};

/// Brings the polygons of holes to circles of the area that they are to have.
///
/// Each circle lies about the centroid of its polygon; circles that overlap, or leave the disk, are pushed apart first.
/// Its vertices keep their angles about the centre, or, where they run back, their arc lengths. They move in straight
/// lines, as far at a time as no face folds; the displacement inside is the barycentric one with weights against the
/// areas of the faces, so that small faces move as a whole. Pockets are bulged into holes. What stays folded is
/// unfolded by patches.
/// @param image   n×2, no face folded, outer loop on the unit circle
/// @param shares  of the holes: area by that of the disk, in the order of the loops
/// @param outer   number of the outer loop
/// Complexity: one sparse factorisation per step, at most 40.
[[nodiscard]] RoundedHoles roundHoles(const PolyAnnulusMesh& surface, const Points2& image,
                                      const std::vector<double>& shares, int outer, SolverBackend backend,
                                      const Execution& execution);

}  // namespace authalic
