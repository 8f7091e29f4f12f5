/// @file
/// VTK's own surface formats: legacy VTK by VTK's reader behind a gate, STL and VTP by readers of ours, all by VTK's
/// writers. Private to IOSurface/.
#pragma once

#include <string>

#include "Formats/Space.h"

class vtkPolyData;

namespace authalic {

/// Whether the name ends in .vtp, .vtk or .stl.
[[nodiscard]] bool isVtkSurfaceName(const std::string& path);

/// Counts that the file cannot hold are refused before VTK sees them; VTK's errors and cells
/// that point outside the vertices are refused after. Polygons and strips become triangles, lines and
/// vertices are dropped, equal points of STL are merged; arrays are kept; points become double precision.
/// @throws FormatError
void readVtkSurface(const std::string& path, vtkPolyData* output);

/// What a file says of its space as 3D Slicer does: in the header of .vtk and .stl, in the field SPACE of .vtp, which
/// is taken off the surface, because it is of the file. Unknown when the file says nothing.
[[nodiscard]] CoordinateSpace takeSpaceOfFile(const std::string& path, vtkPolyData* surface);

/// Writes with VTK, whole or not at all: .vtp (appended, compressed), .stl (binary), .vtk
/// (legacy 4.2, binary). A space that is known is stated as 3D Slicer does.
/// @throws FormatError
void writeVtkSurface(const std::string& path, vtkPolyData* surface);

}  // namespace authalic
