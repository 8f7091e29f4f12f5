/// @file
/// Removes folded faces from a spherical image by re-embedding small patches around them.
#pragma once

#include "Core/base/Arrays.h"
#include "Core/mesh/SphereMesh.h"

namespace authalic {

struct SphereUnfolding {
  Points3 image;          ///< n×3 on the unit sphere
  int rounds = 0;
  int movedVertices = 0;  ///< whose place is not that of the input
  int flippedFaces = 0;   ///< folds that are left
};

/// Unfold the faces of a spherical image whose signed volume is not positive.
///
/// The vertices within 1, 2, 3, 5, … 26 edges of a fold form patches. A patch is seen in the gnomonic projection
/// from its own middle, in which great circles are lines, so that a face is folded in the plane exactly when it is
/// on the sphere; its vertices go where each is the mean of its neighbours with the mean-value weights of the
/// **surface** @cite floater2003, the others held. Positive weights do not fold within a convex outline; outlines
/// here are what they are, so a patch that stays folded is tried with equal weights and then wider. A patch is kept
/// only if it has fewer folds than before. The mean-value weights keep angles nearly as well as the cotangent
/// weights that folded. Folds that patches leave, those of rings that go around the sphere among them, are untangled
/// vertex by vertex, see untangleOnSphere(), if they are at most a tenth of the faces.
///
/// Does **not** guarantee success → `flippedFaces`; a patch or star wider than a hemisphere is left alone.
/// Complexity: one small sparse solve per patch and round.
/// @throws GeometryError when a point is off the sphere or sizes differ
[[nodiscard]] SphereUnfolding unfoldOnSphere(const SphereMesh& sphere, Points3 image);

}  // namespace authalic
