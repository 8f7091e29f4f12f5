/// @file
/// Optimal transport of the area of the unit sphere to point masses.
#pragma once

#include "Core/transport/SemiDiscreteTransport.h"
#include "Core/transport/SphericalPowerDiagram.h"

namespace authalic {

/// Heights h such that the cell of site i has the solid angle ν_i: the map x ↦ y_i on W_i then has the least cost
/// Σ_i ∫_{W_i} −ln cos d(x, y_i) of all maps of that measure @cite oliker2007.
///
/// As semiDiscreteTransport, with ∂w_i/∂h_j = −∫_{e_ij} ⟨x, Y_i⟩ ds / |Y_i − Y_j|, Y_i = e^{h_i} y_i. Cells stay
/// within 90° of their sites; when more than half of the mass lies in one spot no such map exists, and the status
/// is Stalled.
///
/// @param diagram  its sites; holds the cells of the result afterwards
/// @param masses   ν, n, > 0, with the sum 4π (to 1e-6; scaled to it exactly)
/// @param start    n heights without empty cells, or empty for Voronoi's cells
/// Guarantees: no cell of any iterate is empty; when not converged, the best iterate with its residual.
/// Complexity: a power diagram and a sparse factorisation of size n per step, O(n^1.5).
/// @throws as semiDiscreteTransport; GeometryError also when the sites lie in one hemisphere
[[nodiscard]] TransportSolution sphericalTransport(SphericalPowerDiagram& diagram, const Eigen::VectorXd& masses,
                                                   const SemiDiscreteTransportOptions& options = {},
                                                   const Heights& start = {}, const Execution& execution = {});

}  // namespace authalic
