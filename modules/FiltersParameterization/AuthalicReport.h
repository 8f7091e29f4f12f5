/// @file
/// What all authalic maps report. Private to FiltersParameterization/.
#pragma once

#include "Core/authalic/AuthalicMap.h"
#include "Reports/MapReport.h"

class vtkPolyData;

namespace authalic {

/// Method, status, residuals, seconds, and the members and field data FaceResidual and VertexResidual.
[[nodiscard]] MapReport describeAuthalicMap(const AuthalicSolution& result, vtkPolyData* map);

/// Tolerances and limits as the options of a report.
void addAuthalicOptions(Json& options, const AuthalicMapOptions& values);

}  // namespace authalic
