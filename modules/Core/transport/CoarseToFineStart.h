/// @file
/// Heights to start from by a transport to fewer sites. Private to transport/.
#pragma once

#include <vector>

#include "Core/transport/SemiDiscreteTransport.h"

namespace authalic {

/// Heights without empty cells, and how they were found.
struct CoarseToFineStart {
  Heights heights;                     ///< n; empty when there is no such start: take Voronoi's
  std::vector<TransportLevel> levels;  ///< of the coarser transports, coarsest first
  double voronoi = 0;                  ///< t: part of Voronoi's heights in them
};

/// Solves for clusters of about six sites (SiteClusters), itself from coarse to fine while there are many,
/// interpolates their heights (HeightInterpolation), mends the few cells that are empty or far from their masses
/// (CellMending), and, while a cell is still empty or nearly so, goes on to (1 − t) h + t × Voronoi's heights for
/// growing t < 1. @cite merigot2011 starts a fine transport from a coarse one in the same way, with piecewise constant
/// weights.
/// @param diagram  its cells are those of the result afterwards
/// Guarantees: no empty cell.
[[nodiscard]] CoarseToFineStart coarseToFineStart(PowerDiagram& diagram, const Eigen::VectorXd& masses,
                                                  const SemiDiscreteTransportOptions& options,
                                                  const Execution& execution);

}  // namespace authalic
