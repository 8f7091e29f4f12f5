/// @file
/// What all Lie flows report. Private to FiltersParameterization/.
#pragma once

#include "Core/authalic/DiscreteLieFlow.h"
#include "Core/authalic/LieAdvection.h"
#include "Reports/MapReport.h"

class vtkPolyData;

namespace authalic {

/// Method, status, residuals, seconds and counts, and the field data FinishIterations, FlippedBeforeFinish, EdgeFlips.
[[nodiscard]] MapReport describeLieFlow(const LieFlowSolution& flow, vtkPolyData* map);

/// Tolerances, limits and steps as the options of a report.
void addLieFlowOptions(Json& options, const DiscreteLieFlowOptions& values);

/// Method, status, residuals, seconds and counts, and the field data ShortenedSteps, FlippedBeforeUnfolding, EdgeFlips.
[[nodiscard]] MapReport describeLieAdvection(const LieAdvectionSolution& advection, vtkPolyData* map);

}  // namespace authalic
