/// @file
/// What all authalic maps report.
#pragma once

#include "Core/authalic/AuthalicMap.h"
#include "Core/authalic/CircleDomainAuthalicMap.h"
#include "Core/authalic/SphericalAuthalicMap.h"
#include "Core/authalic/ToroidalAuthalicMap.h"
#include "Reports/MapReport.h"

class vtkPolyData;

namespace authalic {

/// Method, status, residuals, seconds, and the members and field data FaceResidual and VertexResidual.
/// @tparam Result  AuthalicMapResult, SphericalAuthalicMapResult, ToroidalAuthalicMapResult or
///                 CircleDomainAuthalicMapResult
template <class Result>
[[nodiscard]] MapReport describeAuthalicMap(const Result& result, vtkPolyData* map);

/// Tolerances and limits as the options of a report.
void addAuthalicOptions(Json& options, const AuthalicMapOptions& values);

}  // namespace authalic
