/// @file
/// Optimal transport of the area of the sphere to point masses in a stereographic plane.
#pragma once

#include "Core/transport/SemiDiscreteTransport.h"
#include "Core/transport/StereographicPowerDiagram.h"

namespace authalic {

/// Heights h such that the cell of site i has the solid angle ν_i: the cyclically monotone map x ↦ z_i on W_i of the
/// plane with the density 4 / (1 + |x|²)² @cite nadeem2017. It is the gradient of a convex function and that of least
/// Σ ∫ −⟨x, z_i⟩; its Σ ∫ |x − z_i|² is infinite, since ∫ |x|² over the plane diverges. Depends on the pole.
///
/// As semiDiscreteTransport, from Voronoi's cells, with ∂w_i/∂h_j = −∫_{e_ij} 4 / (1 + |x|²)² ds / |z_i − z_j|.
/// Whatever the masses, such heights exist.
///
/// @param diagram  its sites; holds the cells of the result afterwards
/// @param masses   ν, n, > 0, with the sum 4π (to 1e-6; scaled to it exactly)
/// @param start    n heights without empty cells, or empty for Voronoi's cells
/// Guarantees, complexity and exceptions: as semiDiscreteTransport
[[nodiscard]] TransportSolution stereographicTransport(StereographicPowerDiagram& diagram,
                                                       const Eigen::VectorXd& masses,
                                                       const SemiDiscreteTransportOptions& options = {},
                                                       const Heights& start = {}, const Execution& execution = {});

}  // namespace authalic
