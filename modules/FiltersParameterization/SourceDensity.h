/// @file
/// The source density of a transport, from a mesh with a point array. Private to FiltersParameterization/.
#pragma once

#include <memory>
#include <string>

#include "Core/transport/PiecewiseLinearDensity.h"
#include "Reports/MapReport.h"

class vtkPolyData;

namespace authalic {

/// @throws InvalidArgument when there is no point array of one component of that name; TopologyError when the mesh is
///         no disk; or as PiecewiseLinearDensity
[[nodiscard]] std::shared_ptr<const PiecewiseLinearDensity> sourceDensityOf(vtkPolyData* mesh,
                                                                            const std::string& array,
                                                                            const PlanarDomain& domain);

/// Its integral as `source_mass` of the report and SourceMass of the map.
void describeSource(const PiecewiseLinearDensity& density, MapReport& report, vtkPolyData* map);

}  // namespace authalic
