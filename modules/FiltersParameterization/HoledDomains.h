/// @file
/// The domains of area-preserving maps of surfaces with holes, and what these report. Private to
/// FiltersParameterization/.
#pragma once

#include "Core/authalic/CircleDomainHoles.h"
#include "Core/authalic/PeriodicRectangle.h"
#include "Core/mesh/TriangleMesh.h"
#include "Reports/MapReport.h"

class vtkPolyData;

namespace authalic {

/// In the order of the filters' enumerations.
enum class HoledDomain { CircleDomain, Annulus, PeriodicRectangle };

/// circle-domain, annulus, periodic-rectangle.
[[nodiscard]] const char* holedDomainName(HoledDomain domain);

/// Loops and holes as they are asked for.
/// @param outerVertex  on the outer loop; −1 = the longest
[[nodiscard]] CircleDomainHoles holesOf(const PolyAnnulusMesh& surface, HoledDomain domain, int outerVertex,
                                        const std::vector<double>& areas);

/// Field data Circles, OuterLoop, HoleAreas, HoleResidual and Pockets, and the same in the report.
void addHoles(const CircleDomainImage& image, vtkPolyData* map, MapReport& report);

/// Field data Height, Circumference (mm), Pockets, OuterLoop and Cut, and the same in the report.
void addRectangle(const TriangleMesh& surface, const PeriodicRectangleImage& image, vtkPolyData* map,
                  MapReport& report);

}  // namespace authalic
