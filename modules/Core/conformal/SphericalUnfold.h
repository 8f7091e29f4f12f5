/// @file
/// Removes folded faces from a spherical image by re-embedding small patches around them.
#pragma once

#include "Core/base/Arrays.h"
#include "Core/base/Execution.h"

namespace authalic {

struct SphericalUnfoldResult {
  Points3 image;          ///< n×3 unit vectors
  int rounds = 0;
  int movedVertices = 0;  ///< vertices whose place changed
  int flippedFaces = 0;   ///< folds that are left
};

/// Unfold the faces of a spherical image whose signed volume is not positive.
///
/// The vertices within 1, 2, 4, … 32 edges of a fold are put where each is the weighted mean of its neighbours, the rest
/// held, in the gnomonic chart of each patch: great circles are lines there, so that a face is folded on the sphere
/// exactly when it is in the chart. The weights are the mean-value weights of the image itself with unsigned angles
/// @cite floater2003: positive, and such that a vertex without a fold around it is already at its mean. The image
/// changes near folds only.
///
/// Does not promise to remove every fold: patches that do not fit into a hemisphere are left → `flippedFaces`.
/// @param faces  closed, oriented, manifold
/// @param image  n×3 on the unit sphere, most faces positive seen from outside
/// Complexity: one sparse solve per round on the patches.
[[nodiscard]] SphericalUnfoldResult unfoldOnSphere(const Faces& faces, Points3 image, const Execution& execution = {});

}  // namespace authalic
