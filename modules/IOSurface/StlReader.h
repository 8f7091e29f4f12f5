/// @file
/// STL files, read here: VTK's own reader takes damaged text for binary and believes what it counts. Private to
/// IOSurface/.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

class vtkPolyData;

namespace authalic {

/// Reads an STL file, binary where its length is that of the triangles it counts, else text that begins with "solid".
///
/// Corners at the same place become one point, in the order in which they are met; triangles two of whose corners
/// coincide are dropped, as VTK does. Normals and attributes are passed over.
/// @throws FormatError
void readStl(const std::string& path, const std::vector<std::uint8_t>& bytes, vtkPolyData* output);

}  // namespace authalic
