/// @file
/// How the surface passes through one cube of the lattice, for each of the 256 sign patterns of its corners.
#pragma once

#include <array>
#include <vector>

namespace authalic {

/// The pieces of surface in one cube. Vertices 0…11 lie on the cube's edges (kCubeEdges); 12, 13, … are
/// centres of polygons that could not be triangulated without a chord in a face of the cube.
struct LatticeSurfaceCell {
  std::vector<std::array<int, 3>> triangles;  ///< counter-clockwise seen from the negative side
  std::vector<std::vector<int>> centres;      ///< the edge vertices whose mean is vertex 12 + index
};

/// Corner c of a cube lies at (c & 1, c >> 1 & 1, c >> 2 & 1). The two corners of each edge, lower first:
/// 0–3 along x, 4–7 along y, 8–11 along z.
inline constexpr std::array<std::array<int, 2>, 12> kCubeEdges{
    {{0, 1}, {2, 3}, {4, 5}, {6, 7}, {0, 2}, {1, 3}, {4, 6}, {5, 7}, {0, 4}, {1, 5}, {2, 6}, {3, 7}}};

/// The cell for a sign pattern (bit c set = corner c positive, i.e. inside).
///
/// The table is derived, not typed in: the piecewise-linear interpolant on the six tetrahedra of the cube
/// (see SimplePoint.h) gives the true pieces, each a disk, or a tube around the cube's diagonal; the
/// crossings on diagonals are then dropped and each piece is triangulated again over its crossings with the
/// cube's own edges. Neighbouring cubes share the arcs on their common face, because both cut that face along
/// the same diagonal, and no inner chord lies in a face of the cube, so that the union over all cubes is a
/// closed manifold with exactly the topology of the piecewise-linear interpolant, at about a third of its
/// triangles.
/// @cite lorensen1987 @cite kuhn1960
[[nodiscard]] const LatticeSurfaceCell& latticeSurfaceCell(int signs);

}  // namespace authalic
