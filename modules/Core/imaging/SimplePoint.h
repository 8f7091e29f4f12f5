/// @file
/// Digital topology of a voxel lattice whose cubes are cut into six tetrahedra (Freudenthal's subdivision).
///
/// Every cube is cut along its diagonal (0,0,0)–(1,1,1) into the six tetrahedra
/// 0 → e_a → e_a+e_b → (1,1,1), one per order of the axes. A voxel centre then has 14 neighbours,
///
///     ±e1, ±e2, ±e3, ±(e1+e2), ±(e2+e3), ±(e1+e3), ±(e1+e2+e3),
///
/// and their tetrahedra form a triangulated sphere around it, its *link* (14 vertices, 24 triangles).
/// Object and background use the same 14-adjacency: it is self-dual, so none of the choices "26 for the
/// object, 6 for the background" arises, and the interface between object and background of the
/// *piecewise-linear* interpolant is a manifold for every set of voxels.
///
/// A voxel is **simple** when changing its side keeps the homotopy type of object and of background. The
/// object near it is a cone over the object's part of the link, so it is simple exactly when that part is
/// contractible; on a sphere that is the case exactly when the object's neighbours are connected along the
/// link and so are the background's, and neither is empty. Both are properties of 14 bits: one table of 2^14
/// answers.
///
/// A set grown from one voxel by simple voxels is therefore collapsible, and its interface is a sphere.
/// @cite bertrand1994 @cite kuhn1960
#pragma once

#include <array>
#include <cstdint>

namespace authalic {

/// The 14 neighbours of a voxel in Freudenthal's subdivision; neighbour k and 13 − k are opposite.
inline constexpr std::array<std::array<int, 3>, 14> kLatticeNeighbours{{{-1, -1, -1},
                                                                        {0, -1, -1},
                                                                        {-1, 0, -1},
                                                                        {0, 0, -1},
                                                                        {-1, -1, 0},
                                                                        {0, -1, 0},
                                                                        {-1, 0, 0},
                                                                        {1, 0, 0},
                                                                        {0, 1, 0},
                                                                        {1, 1, 0},
                                                                        {0, 0, 1},
                                                                        {1, 0, 1},
                                                                        {0, 1, 1},
                                                                        {1, 1, 1}}};

/// For each neighbour, the set (bits) of the neighbours that it shares an edge of the link with.
[[nodiscard]] const std::array<std::uint16_t, 14>& latticeLinkAdjacency();

/// True when a voxel may change sides without changing topology.
/// @param objectNeighbours  bit k set when neighbour k of kLatticeNeighbours belongs to the object
[[nodiscard]] bool isSimplePoint(std::uint16_t objectNeighbours);

}  // namespace authalic
