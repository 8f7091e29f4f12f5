/// @file
/// What the maps by optimal transport report. Private to FiltersParameterization/.
#pragma once

#include "Core/transport/SemiDiscreteTransport.h"
#include "Reports/MapReport.h"

class vtkPolyData;

namespace authalic {

/// Method, status, iterations, residuals, and what the cells cost: as members of the report and as field data of the
/// map (TransportResidual, TransportCost, DisplacementCost, EmptyCells).
struct TransportCosts {
  double transport = 0;     ///< Σ ∫ over cells
  double displacement = 0;  ///< Σ ν_i |x_i − y_i|² of the centroids
  int emptyCells = 0;
};
[[nodiscard]] MapReport describeTransport(const TransportSolution& result, const TransportCosts& costs,
                                          vtkPolyData* map);

/// Cells as polygons, in the order of the sites.
void setCells(vtkPolyData* output, const Points3& corners, const std::vector<int>& starts);

}  // namespace authalic
