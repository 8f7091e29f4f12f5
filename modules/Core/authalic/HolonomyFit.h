/// @file
/// The flat cone surface that suits areas best. Private to authalic/.
#pragma once

#include "Core/authalic/SeamedBarycentricSystem.h"
#include "Core/authalic/TargetMeasure.h"
#include "Core/base/Execution.h"

namespace authalic {

/// Moves cones and translations so that the areas of an image come nearer to their targets, as relaxing the lattice
/// does for a torus.
///
/// The parameters q of the holonomy (see ConeHolonomy) move the image by B q, the barycentric map with the given
/// weights of the change of motions and cones; B is linear. Damped Gauss–Newton steps lower Σ m_t (r_t + 1/r_t) over q
/// as long as no face folds and a step takes a hundredth off. Afterwards `flat` has the new motions and `image` belongs
/// to them, with the cones in their new places. An image with a folded face is left as it is.
/// One sparse factorisation and a solve per parameter; O(m q²) per step, q = 2 (number of cones + 2g − 1).
/// @param areas   of `flat`
/// @param image   n×2, in the charts
void fitHolonomy(const SurfaceTopology& topology, const SeamedAreas& areas, const TargetMeasure& target,
                 const HalfEdgeWeights& weights, SolverBackend backend, FlatConeSurface& flat, Points2& image,
                 const Execution& execution);

}  // namespace authalic
