/// @file
/// Removes folded faces from an image of any outline by moving one vertex at a time.
#pragma once

#include "Core/initial/Unfold.h"

namespace authalic {

/// Untangle the faces of `image` whose signed area is not positive.
///
/// In turn, every inner vertex of a folded face goes to the middle of the largest circle in the kernel of its star,
/// where no face around it is folded, or, when the kernel is empty, where the smallest signed area of those faces
/// is largest:
///
///     max_{x,t} t   with   h_f(x) ≥ t   for all faces f around the vertex   (heights over the opposite sides; areas),
///
/// linear programs in three unknowns, since both are affine in the place of one corner @cite freitag2000. The outline
/// need not be convex: in a corner that points inwards, where the means of unfold()
/// lie outside the domain, the answer is inside. Where 16 passes over these vertices do not suffice, their
/// neighbours move too, up to 8 rings; the rest stays. Boundary vertices never move.
/// Does **not** guarantee success → `flippedFaces`. Complexity O(k⁴) for a vertex of k ≤ 16 faces; vertices of more
/// stay.
/// @param least  m areas or empty: faces with no larger area are treated as folded ones; not counted in
/// `flippedFaces`
[[nodiscard]] UnfoldResult untangle(const SurfaceTopology& topology, Points2 image, const Eigen::VectorXd& least = {});

/// The same on the unit sphere: every star is seen in the gnomonic projection from its own middle, in which great
/// circles are lines; one wider than a hemisphere stays.
/// @param image  n×3 of length 1
/// @return it, with as many vertices moved as that takes; folds may stay
[[nodiscard]] Points3 untangleOnSphere(const SurfaceTopology& topology, Points3 image);

/// unfold() with UnfoldReach::Patches, and where that leaves folds untangle() instead: for domains that are not
/// convex.
[[nodiscard]] UnfoldResult unfoldOrUntangle(const SurfaceTopology& topology, const Points2& image);

}  // namespace authalic
