/// @file
/// One surface from the pieces of several processes.
#pragma once

#include <vector>

#include <vtkSmartPointer.h>

#include "vtkAuthalicFiltersCommonModule.h"

class vtkPolyData;

namespace authalic {

/// Joins pieces of one surface: vertices of different pieces in the same place (to 1e-6 of the size of the whole, the
/// precision of single-precision coordinates) are the same vertex. Vertices of one piece are never joined.
///
/// Points, then cells, come in the order of the pieces; ghost cells are left out. Arrays that every piece has are kept,
/// with the values of the first piece that has the vertex; field data are those of the first piece. A single piece that
/// is not empty comes back as it is. O(n) for evenly spread points.
///
/// @param pieces  polygons; empty pieces and null pointers are allowed
/// @returns an empty surface when every piece is empty
/// @throws GeometryError when two vertices of one piece coincide where it meets another piece (a seam): nothing says
///         then which belong together
[[nodiscard]] VTKAUTHALICFILTERSCOMMON_EXPORT vtkSmartPointer<vtkPolyData> joinPieces(
    const std::vector<vtkSmartPointer<vtkPolyData>>& pieces);

}  // namespace authalic
