/// @file
/// What the maps by curvature flow report. Private to FiltersParameterization/.
#pragma once

#include "Core/conformal/RiemannMap.h"
#include "Core/conformal/YamabeMap.h"
#include "Reports/MapReport.h"

class vtkPolyData;

namespace authalic {

/// Status, residuals, seconds, and the arrays LogScale, CurvatureResidual, Holonomy, EdgeFlips, FlippedBeforeUnfolding
/// and Pockets on `map`, which is the image already.
/// @tparam Result  YamabeMapResult or RiemannMapResult
template <class Result>
[[nodiscard]] MapReport describeFlowMap(const Result& result, vtkPolyData* map);

/// The refinement as a map of its own (see vtkCurvatureFlowMapAlgorithm), and RefinementFlippedFaces on `map`; nothing
/// when there is none.
void fillRefinement(const std::optional<CommonRefinement>& refinement, vtkPolyData* map, vtkPolyData* output,
                    MapReport& report);

}  // namespace authalic
