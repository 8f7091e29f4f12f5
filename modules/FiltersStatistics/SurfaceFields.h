/// @file
/// Point arrays as the fields and labels of element statistics, and report tables as vtkTable.
/// Private to FiltersStatistics/.
#pragma once

#include <string>
#include <vector>

#include "Core/statistics/ElementTable.h"
#include "Reports/Table.h"

class vtkPolyData;
class vtkTable;

namespace authalic {

/// Names of the point arrays X that have a companion XCoverage.
[[nodiscard]] std::vector<std::string> sampledArrays(vtkPolyData* map);

/// The point array `name` with its coverage, if there is a companion.
/// @throws InvalidArgument when the array is missing
[[nodiscard]] SurfaceField surfaceField(vtkPolyData* map, const std::string& name);

/// The labels of the point array `name`; without `regions`, every label but 0 is a region named by its number.
[[nodiscard]] SurfaceLabels surfaceLabels(vtkPolyData* map, const std::string& name, std::vector<RegionName> regions);

/// Replaces the columns of `output`.
void setTable(vtkTable* output, const Table& table);

}  // namespace authalic
