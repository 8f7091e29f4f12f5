/// @file
/// How much a periodic image stretches its surface, for the choice of periods. Private to authalic/.
#pragma once

#include "Core/mesh/TriangleMesh.h"

namespace authalic {

/// M = Σ A_t J_t J_tᵀ of the map from the surface to the plane: its trace is twice the Dirichlet energy, and a linear
/// map L after the image makes L M Lᵀ of it. Degenerate faces of the surface are left out. O(m)
/// @param shifts  3m×2, see periodicFaceAreas()
[[nodiscard]] Eigen::Matrix2d periodicStretch(const TriangleMesh& surface, const Points2& points,
                                              const Points2& shifts);

}  // namespace authalic
