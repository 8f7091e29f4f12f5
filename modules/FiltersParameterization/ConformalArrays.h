/// @file
/// What the maps by curvature flow report. Private to FiltersParameterization/.
#pragma once

#include <vector>

#include "Core/conformal/AnnulusMap.h"
#include "Core/conformal/CircleDomainMap.h"
#include "Core/conformal/RiemannMap.h"
#include "Core/conformal/YamabeMap.h"
#include "Reports/MapReport.h"

class vtkPolyData;

namespace authalic {

/// Status, residuals, seconds, and the arrays LogScale, CurvatureResidual, Holonomy, EdgeFlips, FlippedBeforeUnfolding
/// and Pockets on `map`, which is the image already. LogScale only where there is one for every point of `map`.
/// @tparam Result  YamabeMapResult, RiemannMapResult, AnnulusMapResult or CircleDomainResult
template <class Result>
[[nodiscard]] MapReport describeFlowMap(const Result& result, vtkPolyData* map);

/// Which loop a vertex is on; −1 for vertex −1.
/// @throws InvalidArgument when the vertex is on none
[[nodiscard]] int loopThrough(int vertex, const std::vector<std::vector<int>>& loops);

/// Circles (x, y, radius of every loop) and CircleRoundness (deviation over radius) on `map` and in the report.
void addCircles(const std::vector<FittedCircle>& circles, vtkPolyData* map, MapReport& report);

/// The refinement as a map of its own (see vtkCurvatureFlowMapAlgorithm), and RefinementFlippedFaces on `map`; nothing
/// when there is none.
void fillRefinement(const std::optional<CommonRefinement>& refinement, vtkPolyData* map, vtkPolyData* output,
                    MapReport& report);

}  // namespace authalic
