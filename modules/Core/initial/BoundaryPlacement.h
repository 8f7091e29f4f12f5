/// @file
/// Where the boundary loop of a disk goes on the boundary of a planar domain.
#pragma once

#include <array>
#include <vector>

#include "Core/geometry/PlanarDomain.h"
#include "Core/mesh/DiskMesh.h"

namespace authalic {

/// What a boundary vertex may do on the boundary of the domain.
enum class BoundaryRole : char {
  Circle,  ///< slides on the unit circle
  Side,    ///< slides on a straight side
  Corner,  ///< stays in a corner of the polygon
  Pocket,  ///< belongs to a pocket: may move freely
};

/// Role and place of every boundary vertex, in the order of DiskMesh::boundary() rotated to `first`.
///
/// **Pockets.** An inner edge that joins two boundary vertices of the same straight side cuts off a small disk
/// whose whole boundary would lie on one line: its faces (an ear triangle is the smallest case) have no area in
/// any map that keeps the side straight. Such a pocket is bulged out of the side just enough to hold its share of
/// the area; its chord lies on the side. The rest of the domain then has no chord within a side, which is what
/// convex-weight maps need to be without flips @cite floater2003. The circle needs no pockets.
struct BoundaryPlacement {
  std::vector<int> vertices;       ///< boundary vertices, counter-clockwise in the image, corner 0 (angle 0) first
  std::vector<BoundaryRole> role;  ///< per entry of `vertices`
  std::vector<int> side;           ///< side per entry (a corner: the side that starts there), −1 on the circle
  Points2 points;                  ///< place per entry
  std::vector<int> corners;        ///< entries that are corners, in the order of the polygon's corners
  std::vector<char> inPocket;      ///< per face of the mesh: 1 when it belongs to a pocket
  std::vector<int> pocketOf;       ///< per vertex of the mesh: pocket it lies in (chord ends excepted) or −1
  std::vector<std::array<int, 2>> pockets;  ///< vertices at the two ends of each pocket's chord
};

/// Spread the boundary over the domain's by arc length (mm).
///
/// The start vertex goes to angle 0 of the circle or to corner 0; each further corner takes the boundary vertex
/// nearest to its own arc length; in between, arc length is proportional on every side.
/// @param startVertex  a boundary vertex, or −1 for the one with the smallest id
/// @throws InvalidArgument when startVertex is not on the boundary
/// @throws TopologyError   when the boundary has fewer vertices than the polygon corners
/// @throws GeometryError   when the boundary has no length
[[nodiscard]] BoundaryPlacement placeBoundary(const DiskMesh& disk, const PlanarDomain& domain,
                                              int startVertex = -1);

/// Recognise the boundary of an image that was made elsewhere, and put it exactly on the domain's.
///
/// @param image  n×2; its boundary within 1e-6 of the domain's size, one vertex in each corner
/// @throws GeometryError naming the first vertex that is not on the boundary of the domain
[[nodiscard]] BoundaryPlacement recogniseBoundary(const DiskMesh& disk, const PlanarDomain& domain,
                                                  const Points2& image);

}  // namespace authalic
