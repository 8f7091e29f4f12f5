#include "GridArrays.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include "Conversion.h"
#include "Core/base/Error.h"
#include "FieldArrays.h"

namespace authalic {
namespace {

constexpr const char* optionsName = "ElementGridOptions";

std::vector<int> fromOne(std::vector<int> ids) {
  for (int& id : ids) ++id;
  return ids;
}

Points3 lifted(const Points2& points) {
  Points3 result = Points3::Zero(points.rows(), 3);
  result.leftCols<2>() = points;
  return result;
}

template <class Value, class Get>
std::vector<Value> column(const ElementGrid& grid, Get get) {
  std::vector<Value> values;
  for (const Element& element : grid.elements) values.push_back(get(element));
  return values;
}

}  // namespace

void addGrid(vtkPolyData* map, const ElementGrid& grid, const ElementGridOptions& options) {
  addArray(map->GetPointData(), "ElementId", fromOne(grid.vertexElement));
  addArray(map->GetCellData(), "ElementId", fromOne(grid.faceElement));
  addField(map, optionsName,
           std::vector<double>{static_cast<double>(options.elements), options.elementArea,
                               static_cast<double>(options.frame), options.mergeBelow});
  addField(map, "Elements", static_cast<int>(grid.elements.size()));
  addField(map, "GridColumns", grid.lines.columns);
  addField(map, "GridRows", grid.lines.rows);
  addField(map, "InteriorElements", grid.deviation.interiorElements);
  addField(map, "InteriorMaximumDeviation", grid.deviation.interiorMaximum);
  addField(map, "InteriorMeanDeviation", grid.deviation.interiorMean);
  addField(map, "MaximumDeviation", grid.deviation.maximum);
  addField(map, "MeanDeviation", grid.deviation.mean);
}

void setOutline(vtkPolyData* lines, const ElementOutline& outline) {
  setPoints(lines, outline.points);
  addArray(lines->GetPointData(), "ImagePoints", lifted(outline.image));
  vtkNew<vtkCellArray> segments;
  vtkNew<vtkIntArray> sides;
  sides->SetName("ElementIds");
  sides->SetNumberOfComponents(2);
  vtkIdType point = 0;
  for (const std::array<int, 2>& pair : outline.elements) {
    segments->InsertNextCell({point, point + 1});
    sides->InsertNextTuple2(pair[0] + 1, pair[1] + 1);
    point += 2;
  }
  lines->SetLines(segments);
  lines->GetCellData()->AddArray(sides);
}

void setCells(vtkPolyData* cells, const ElementGrid& grid) {
  Points2 corners(4 * static_cast<Eigen::Index>(grid.elements.size()), 2);
  Points3 centroids(static_cast<Eigen::Index>(grid.elements.size()), 3);
  vtkNew<vtkCellArray> quads;
  Eigen::Index e = 0;
  for (const Element& element : grid.elements) {
    const auto &low = element.lower, &high = element.upper;
    corners.middleRows(4 * e, 4) << low[0], low[1], high[0], low[1], high[0], high[1], low[0], high[1];
    quads->InsertNextCell({4 * e, 4 * e + 1, 4 * e + 2, 4 * e + 3});
    centroids.row(e++) = element.centroid.transpose();
  }
  setPoints(cells, corners);
  cells->SetPolys(quads);
  vtkCellData* data = cells->GetCellData();
  int id = 0;
  addArray(data, "ElementId", column<int>(grid, [&id](const Element&) { return ++id; }));
  addArray(data, "ElementArea", column<double>(grid, [](const Element& x) { return x.area; }));
  addArray(data, "TargetArea", column<double>(grid, [](const Element& x) { return x.targetArea; }));
  addArray(data, "ElementAreaRatio", column<double>(grid, [](const Element& x) { return x.area / x.targetArea; }));
  addArray(data, "Interior", column<char>(grid, [](const Element& x) { return static_cast<char>(x.interior); }));
  addArray(data, "Centroid", centroids);
}

ElementGridOptions gridOptionsOf(vtkPolyData* map) {
  vtkDataArray* stored = map->GetFieldData()->GetArray(optionsName);
  if (!stored || stored->GetNumberOfValues() != 4) {
    throw InvalidArgument(std::string("The map must come through vtkElementGrid first; it has no field array '") +
                          optionsName + "'.");
  }
  ElementGridOptions options;
  options.elements = static_cast<int>(stored->GetComponent(0, 0));
  options.elementArea = stored->GetComponent(1, 0);
  options.frame = static_cast<GridFrame>(static_cast<int>(stored->GetComponent(2, 0)));
  options.mergeBelow = stored->GetComponent(3, 0);
  return options;
}

}  // namespace authalic
