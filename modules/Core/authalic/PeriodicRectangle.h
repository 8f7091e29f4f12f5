/// @file
/// The periodic rectangle as the domain of area-preserving maps of annuli: what their results share.
#pragma once

#include <vector>

#include "Core/base/Arrays.h"

namespace authalic {

/// An annulus on the flat cylinder of circumference 1, cut open.
struct PeriodicRectangleImage {
  Points2 image;  ///< n'×2: y = 0 on the outer loop, `height` on the other one, but for pockets; sides differ
                  ///< by (1, 0)
  Faces faces;     ///< m×3, faces of the input in order, opened along the cut
  std::vector<int> originalPointIds;  ///< n': vertex of the input; the first n are the input's, then the copies
  std::vector<int> cut;               ///< vertices of the cut, from the outer loop to the other one
  double height = 0;                  ///< height / circumference of the cylinder
  int outerLoop = 0;                  ///< of AnnulusMesh::loops(), the one at y = 0
  int pockets = 0;                    ///< pockets of the surface that lie outside of the rectangle, see FoldedPockets
};

}  // namespace authalic
