/// @file
/// An element grid as polydata, and its options as field data so that a later filter can repeat it.
#pragma once

#include "Core/sampling/ElementGrid.h"
#include "vtkAuthalicFiltersSamplingModule.h"

class vtkPolyData;

namespace authalic {

/// ElementId per point and cell, options, counts and deviations on the map.
VTKAUTHALICFILTERSSAMPLING_EXPORT void addGrid(vtkPolyData* map, const ElementGrid& grid,
                                               const ElementGridOptions& options);

/// The borders between elements as lines on the surface.
VTKAUTHALICFILTERSSAMPLING_EXPORT void setOutline(vtkPolyData* lines, const ElementOutline& outline);

/// The cells of the grid in the domain, one quadrilateral per element.
VTKAUTHALICFILTERSSAMPLING_EXPORT void setCells(vtkPolyData* cells, const ElementGrid& grid);

/// The options that addGrid left.
/// @throws InvalidArgument when `map` did not come through vtkElementGrid
[[nodiscard]] VTKAUTHALICFILTERSSAMPLING_EXPORT ElementGridOptions gridOptionsOf(vtkPolyData* map);

}  // namespace authalic
