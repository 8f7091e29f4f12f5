/// @file
/// One face cut by the lines of a grid, in barycentric coordinates. Private to sampling/.
#pragma once

#include <array>
#include <vector>

#include "Core/mesh/TriangleMesh.h"
#include "Core/sampling/ElementGrid.h"

namespace authalic {

/// The part of a face whose image lies in one cell.
struct FacePart {
  int cell = -1;                          ///< column + columns · row
  double fraction = 0.0;                  ///< of the face, in (0, 1]
  std::array<double, 3> corner{0, 0, 0};  ///< barycentric centroid
};

/// Cuts face `face` into the preimages of the cells, by column, then row; `parts` is replaced (its memory is
/// reused). The outermost cells reach to infinity, so nothing is lost where an image leaves the frame by
/// rounding. Fractions sum to 1 up to rounding, also for collapsed images. Parts below 1e-15 of the face are
/// dropped.
void cutFace(const Faces& faces, const Points2& image, int face, const GridLines& lines,
             std::vector<FacePart>& parts);

}  // namespace authalic
