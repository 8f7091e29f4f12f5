/// @file
/// What all conformal maps by curvature flow report. Private to FiltersParameterization/.
#pragma once

#include <string>

#include "Core/distortion/Distortion.h"
#include "Core/geometry/CommonRefinement.h"
#include "FieldArrays.h"
#include "Reports/MapReport.h"

class vtkPolyData;

namespace authalic {

/// Status, residuals, seconds and the members and field data of vtkConformalFlowAlgorithm.
/// @tparam Result  RiemannMapResult, YamabeMapResult, AnnulusMapResult or CircleDomainResult
template <class Result>
[[nodiscard]] MapReport describeConformalMap(const std::string& method, const Result& result, vtkPolyData* map) {
  MapReport report;
  report.method = method;
  report.status = result.status;
  report.iterations = result.iterations;
  for (const auto& step : result.history) report.residuals.push_back(step.residual);
  report.residuals.push_back(result.residual);
  report.seconds = {{"map", result.seconds}};
  report.more.set("residual", result.residual);
  report.more.set("holonomy", result.holonomy);
  report.more.set("edge_flips", result.edgeFlips);
  report.more.set("flipped_before_unfolding", result.flippedBeforeUnfolding);
  addField(map, "Holonomy", result.holonomy);
  addField(map, "EdgeFlips", result.edgeFlips);
  addField(map, "FlippedBeforeUnfolding", result.flippedBeforeUnfolding);
  return report;
}

/// Makes `map` the image on the common refinement of input and flow: cell arrays of the faces that the new ones are
/// part of, OriginalPointIds (−1 where edges cross) and OriginalCellIds.
Distortion fillRefinedMap(vtkPolyData* input, vtkPolyData* map, const CommonRefinement& refinement);

}  // namespace authalic
