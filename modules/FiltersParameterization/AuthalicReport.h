/// @file
/// What all authalic maps report. Private to FiltersParameterization/.
#pragma once

#include "Core/authalic/AuthalicMap.h"
#include "MapArrays.h"
#include "Reports/MapReport.h"

class vtkPolyData;

namespace authalic {

/// Method, status, residuals, seconds, and the members and field data FaceResidual and VertexResidual.
[[nodiscard]] MapReport describeAuthalicMap(const AuthalicSolution& result, vtkPolyData* map);

/// The option balance (a number, or the name of the array), and for a number the field data Balance.
void describeBalance(const Balance& balance, Json& options, vtkPolyData* map);

/// Tolerances and limits as the options of a report.
void addAuthalicOptions(Json& options, const AuthalicMapOptions& values);

}  // namespace authalic
