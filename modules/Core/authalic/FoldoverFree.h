/// @file
/// Removes the folds of an image in the plane by minimisation, whatever is held. Private to authalic/.
#pragma once

#include "Core/authalic/AreaFunctional.h"
#include "Core/numerics/SparseSolver.h"

namespace authalic {

/// An image without folds from one with some, where barycentric maps cannot help: held vertices need not be in convex
/// position, and seams with rigid transitions and cones are allowed.
///
/// With J_t the map from face t of the surface, scaled to its target area, to its image, and D_t = det J_t, Newton's
/// method lowers
///
///     Σ_t m_t (|J_t|² + 1 + D_t²) / χ_ε(D_t),   χ_ε(D) = ½ (D + (ε² + D²)^½),
///
/// whose second derivative is made positive face by face. χ is positive on folded faces as well; ε falls with the
/// energy, but not below the depth of the deepest fold, so that the energy becomes a barrier once no face is folded:
/// then it is least where faces have their areas and shapes @cite garanzha2021.
/// @param areas      in the plane, every free vertex in both directions
/// @param targets    m areas > 0, in the unit of the image
/// @param points     n×3, of the surface
/// @param mostSteps  of Newton's method; fewer where the image is free of folds and the energy falls slowly
/// @return the number of folded faces that are left
/// Complexity: one symbolic and a numeric sparse factorisation per step.
[[nodiscard]] int foldoverFree(const AreaFunctional& areas, const Eigen::VectorXd& targets, const Points3& points,
                               int mostSteps, SolverBackend backend, Coordinates& image);

}  // namespace authalic
