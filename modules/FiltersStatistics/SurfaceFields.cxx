#include "SurfaceFields.h"

#include <cmath>
#include <set>
#include <variant>

#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkTable.h>
#include <vtkTypeInt64Array.h>

#include "FieldArrays.h"

namespace authalic {
namespace {

std::vector<double> doubles(vtkDataArray* array) {
  const Eigen::VectorXd values = toVector(array);
  return {values.data(), values.data() + values.size()};
}

template <class Array, class Value>
void addColumn(vtkTable* output, const std::string& name, const std::vector<Value>& values) {
  vtkNew<Array> column;
  column->SetName(name.c_str());
  column->SetNumberOfValues(static_cast<vtkIdType>(values.size()));
  for (std::size_t i = 0; i < values.size(); ++i) column->SetValue(static_cast<vtkIdType>(i), values[i]);
  output->AddColumn(column);
}

}  // namespace

std::vector<std::string> sampledArrays(vtkPolyData* map) {
  std::vector<std::string> names;
  vtkPointData* data = map->GetPointData();
  for (int i = 0; i < data->GetNumberOfArrays(); ++i) {
    const std::string name = data->GetArrayName(i) ? data->GetArrayName(i) : "";
    if (data->HasArray((name + "Coverage").c_str())) names.push_back(name);
  }
  return names;
}

SurfaceField surfaceField(vtkPolyData* map, const std::string& name) {
  SurfaceField field;
  field.name = name;
  field.values = doubles(requireArray(map->GetPointData(), name, 1, "map"));
  if (vtkDataArray* coverage = map->GetPointData()->GetArray((name + "Coverage").c_str())) {
    field.coverage = doubles(coverage);
  }
  return field;
}

SurfaceLabels surfaceLabels(vtkPolyData* map, const std::string& name, std::vector<RegionName> regions) {
  SurfaceLabels result;
  vtkDataArray* array = requireArray(map->GetPointData(), name, 1, "map");
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i) {
    const double label = array->GetComponent(i, 0);
    result.labels.push_back(std::isfinite(label) ? static_cast<int>(std::lround(label)) : 0);
  }
  result.regions = std::move(regions);
  if (!result.regions.empty()) return result;
  for (const int label : std::set<int>(result.labels.begin(), result.labels.end())) {
    if (label != 0) result.regions.push_back({label, std::to_string(label)});
  }
  return result;
}

void setTable(vtkTable* output, const Table& table) {
  output->Initialize();
  for (const Table::Column& column : table.columns()) {
    if (const auto* integers = std::get_if<std::vector<std::int64_t>>(&column.values)) {
      addColumn<vtkTypeInt64Array>(output, column.name, *integers);
    } else if (const auto* numbers = std::get_if<std::vector<double>>(&column.values)) {
      addColumn<vtkDoubleArray>(output, column.name, *numbers);
    } else {
      addColumn<vtkStringArray>(output, column.name, std::get<std::vector<std::string>>(column.values));
    }
  }
}

}  // namespace authalic
