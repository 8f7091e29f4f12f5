/// @file
/// The domains of area-preserving maps of surfaces with holes, and what these report. Private to
/// FiltersParameterization/.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "Core/authalic/CircleDomainHoles.h"
#include "Core/authalic/PeriodicRectangle.h"
#include "Core/authalic/TargetMeasure.h"
#include "Core/mesh/AnnulusMesh.h"
#include "Reports/MapReport.h"

class vtkPolyData;

namespace authalic {

/// In the order of the filters' enumerations.
enum class HoledDomain { CircleDomain, Annulus, PeriodicRectangle };

/// Loops and holes as they are asked for.
/// @param outerVertex  on the outer loop; −1 = the longest
[[nodiscard]] CircleDomainHoles holesOf(const PolyAnnulusMesh& surface, HoledDomain domain, int outerVertex,
                                        const std::vector<double>& areas);

/// @throws InvalidArgument when there are hole areas: a periodic rectangle has no holes
void requireNoHoleAreas(const std::vector<double>& areas);

/// Fills the map and makes its report: what `describe` says of the method, then field data Circles, OuterLoop,
/// HoleAreas, HoleResidual and Pockets.
/// @throws CancelledError when there is no image
[[nodiscard]] MapReport reportCircles(vtkPolyData* input, vtkPolyData* map, const PolyAnnulusMesh& surface,
                                      const CircleDomainImage& image, const TargetMeasure& target,
                                      const std::function<MapReport()>& describe);

/// The same with field data Height, Circumference (mm), Pockets, OuterLoop and Cut.
[[nodiscard]] MapReport reportRectangle(vtkPolyData* input, vtkPolyData* map, const AnnulusMesh& annulus,
                                        const PeriodicRectangleImage& image, const TargetMeasure& target,
                                        const std::function<MapReport()>& describe);

/// The options that both methods have.
void addHoledOptions(Json& options, HoledDomain domain, const std::string& measure, int outerVertex,
                     const std::vector<double>& areas);

}  // namespace authalic
