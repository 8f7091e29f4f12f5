/// @file
/// What the maps by optimal transport report. Private to FiltersParameterization/.
#pragma once

#include <optional>

#include "Core/authalic/AuthalicMap.h"
#include "Core/transport/SemiDiscreteTransport.h"
#include "Reports/MapReport.h"

class vtkPolyData;

namespace authalic {

/// What the cells cost.
struct TransportCosts {
  std::optional<double> transport;  ///< Σ ∫ over cells, where it is finite
  double displacement = 0;  ///< Σ ν_i |x_i − y_i|² of the centroids
  int emptyCells = 0;
};

/// As in options and reports: automatic, voronoi, coarse-to-fine.
[[nodiscard]] const char* nameOf(TransportStart start);

/// Method, status, iterations, residuals, levels in the plane, and what the cells cost: as members of the report, the
/// costs also as field data of the map (TransportResidual, TransportCost, DisplacementCost, EmptyCells).
[[nodiscard]] MapReport describeTransport(const TransportSolution& result, const TransportCosts& costs,
                                          vtkPolyData* map);

/// What the exact solve made of the map: its displacement cost, and the folds that there were.
struct FinishCosts {
  double displacement = 0;
  int flippedBefore = 0;
};

/// Adds them (FinishedCost, FlippedBeforeFinish), and the status of the finish when the transport converged.
void describeFinish(const AuthalicSolution& finished, const FinishCosts& costs, MapReport& report, vtkPolyData* map);

/// Cells as polygons, in the order of the sites, with SiteIds and Area.
void setCells(vtkPolyData* output, const Points3& corners, const std::vector<int>& starts,
              const Eigen::VectorXd& areas);

/// Sites, heights and cells of a transport in the plane, whichever surface it maps.
struct PlanarTransport {
  const Points2& sites;
  const Heights& heights;
  const Eigen::VectorXd& cellAreas;
  const Eigen::VectorXd& potential;
  const CellPolygons& cells;
  const Eigen::VectorXd* cellMasses = nullptr;  ///< of a source density; none: uniform
};

/// Point arrays Site, CellArea, Potential, and CellMass where there is a source density, of the map, whose vertices are
/// the first sites.
void addPlanarArrays(const PlanarTransport& transport, vtkPolyData* map);

/// setCells() with the potential at the corners, and Mass of a source density.
void setPlanarCells(const PlanarTransport& transport, vtkPolyData* output);

}  // namespace authalic
