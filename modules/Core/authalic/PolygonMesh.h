/// @file
/// A triangulation of the inside of a polygon. Private to authalic/.
#pragma once

#include <vector>

#include "Core/base/Arrays.h"

namespace authalic {

struct PolygonMesh {
  Points2 points;              ///< corners and points of the sides in order, counter-clockwise, then inner points
  Faces faces;
  Eigen::Index boundarySize = 0;  ///< rows of `points` on the boundary
};

/// Triangulates a simple polygon whose sides may carry further points.
///
/// Ears of the corners are cut off, the points of the sides split the faces beside them, and the middles of faces
/// larger than `largestFace` are inserted, with flips to the Delaunay triangulation in between.
/// @param boundary  k×2, counter-clockwise
/// @param corners   rows of `boundary` that are corners of the polygon, in order, at least 3; the rows between two of
///                  them lie on the side that joins them, in order
/// @throws GeometryError when no ear is found: the sides cross
[[nodiscard]] PolygonMesh polygonMesh(const Points2& boundary, const std::vector<int>& corners, double largestFace);

}  // namespace authalic
