#include "TransportReport.h"

#include <algorithm>
#include <utility>

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include "Conversion.h"
#include "FieldArrays.h"

namespace authalic {
namespace {

Points3 lifted(const Points2& points) {
  Points3 result = Points3::Zero(points.rows(), 3);
  result.leftCols(2) = points;
  return result;
}

// What the transports to clusters of the sites and to the sites took, the coarsest first.
Json levelsOf(const TransportSolution& result) {
  Json levels = Json::array();
  for (const TransportLevel& level : result.levels) {
    Json entry = Json::object();
    entry.set("sites", level.sites).set("iterations", level.iterations).set("voronoi_part", level.voronoi);
    levels.add(std::move(entry));
  }
  return levels;
}

}  // namespace

const char* nameOf(TransportStart start) {
  switch (start) {
    case TransportStart::Voronoi: return "voronoi";
    case TransportStart::CoarseToFine: return "coarse-to-fine";
    case TransportStart::Automatic: break;
  }
  return "automatic";
}

MapReport describeTransport(const TransportSolution& result, const TransportCosts& costs, vtkPolyData* map) {
  MapReport report;
  report.method = "transport";
  report.status = result.status;
  report.iterations = result.iterations;
  double smallest = 1;
  for (const TransportIteration& step : result.history) {
    report.residuals.push_back(step.residual);
    smallest = std::min(smallest, step.smallestCell);
  }
  report.residuals.push_back(result.residual);
  report.more.set("transport_residual", result.residual);
  if (costs.transport) report.more.set("transport_cost", *costs.transport);
  report.more.set("displacement_cost", costs.displacement);
  report.more.set("empty_cells", costs.emptyCells);
  report.more.set("smallest_cell", smallest);
  if (!result.levels.empty()) report.more.set("levels", levelsOf(result));
  addField(map, "TransportResidual", result.residual);
  if (costs.transport) addField(map, "TransportCost", *costs.transport);
  addField(map, "DisplacementCost", costs.displacement);
  addField(map, "EmptyCells", costs.emptyCells);
  return report;
}

void describeFinish(const AuthalicSolution& finished, const FinishCosts& costs, MapReport& report, vtkPolyData* map) {
  if (report.status == Status::Converged) report.status = finished.status;
  report.seconds.emplace_back("finish", finished.startSeconds + finished.faceSeconds + finished.vertexSeconds);
  report.more.set("finished_cost", costs.displacement);
  report.more.set("flipped_before_finish", costs.flippedBefore);
  report.more.set("finish_iterations", finished.iterations);
  addField(map, "FinishedCost", costs.displacement);
  addField(map, "FlippedBeforeFinish", costs.flippedBefore);
}

void setCells(vtkPolyData* output, const Points3& corners, const std::vector<int>& starts,
              const Eigen::VectorXd& areas) {
  setPoints(output, corners);
  vtkNew<vtkCellArray> polygons;
  std::vector<int> sites;
  std::vector<double> drawn;
  for (std::size_t i = 0; i + 1 < starts.size(); ++i) {
    if (starts[i + 1] - starts[i] < 3) continue;
    polygons->InsertNextCell(starts[i + 1] - starts[i]);
    for (int k = starts[i]; k < starts[i + 1]; ++k) polygons->InsertCellPoint(k);
    sites.push_back(static_cast<int>(i));
    drawn.push_back(areas[static_cast<Eigen::Index>(i)]);
  }
  output->SetPolys(polygons);
  addIds(output->GetCellData(), "SiteIds", sites);
  addArray(output->GetCellData(), "Area", drawn);
}

void addPlanarArrays(const PlanarTransport& transport, vtkPolyData* map) {
  const Eigen::Index n = map->GetNumberOfPoints();
  addArray(map->GetPointData(), "Site", lifted(transport.sites.topRows(n)));
  addArray(map->GetPointData(), "CellArea", Eigen::VectorXd(transport.cellAreas.head(n)));
  addArray(map->GetPointData(), "Potential", Eigen::VectorXd(transport.potential.head(n)));
  if (transport.cellMasses) addArray(map->GetPointData(), "CellMass", Eigen::VectorXd(transport.cellMasses->head(n)));
}

void setPlanarCells(const PlanarTransport& transport, vtkPolyData* output) {
  const CellPolygons& cells = transport.cells;
  setCells(output, lifted(cells.corners), cells.starts, transport.cellAreas);
  const Eigen::VectorXd heights = transport.heights.cast<double>();
  Eigen::VectorXd potential(cells.corners.rows());
  for (Eigen::Index i = 0; i < heights.size(); ++i) {
    const int begin = cells.starts[static_cast<std::size_t>(i)], end = cells.starts[static_cast<std::size_t>(i) + 1];
    for (int k = begin; k < end; ++k) potential[k] = cells.corners.row(k).dot(transport.sites.row(i)) + heights[i];
  }
  addArray(output->GetPointData(), "Potential", potential);
  if (!transport.cellMasses) return;
  const std::vector<int> drawn = toIntegers(output->GetCellData()->GetArray("SiteIds"));
  addArray(output->GetCellData(), "Mass", Eigen::VectorXd((*transport.cellMasses)(drawn)));
}

}  // namespace authalic
