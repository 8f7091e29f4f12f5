/// @file
/// Two surfaces with their maps to the unit disk, glued along their boundaries into one surface on the sphere.
#pragma once

#include <array>
#include <vector>

#include "Core/base/Execution.h"
#include "Core/conformal/ConformalWelding.h"
#include "Core/mesh/DiskMesh.h"
#include "Core/mesh/SphereMesh.h"

namespace authalic {

/// Which boundary vertices are glued: pairs (vertex of the first disk, vertex of the second).
using SeamPairs = std::vector<std::array<int, 2>>;

/// The pairs of boundary vertices at the same place (to the bit, mm), in the order of first.boundary().
/// @throws GeometryError when a boundary vertex has no partner, or the loops have different lengths
[[nodiscard]] SeamPairs matchByPlace(const DiskMesh& first, const DiskMesh& second);

/// The pairs of boundary vertices with the same number, in the order of first.boundary(): the welding signature.
/// @param firstNumbers, secondNumbers  one number per vertex; those of inner vertices are not looked at
/// @throws GeometryError as matchByPlace, and when a number stands at two vertices of one boundary
[[nodiscard]] SeamPairs matchByNumber(const DiskMesh& first, const std::vector<int>& firstNumbers,
                                      const DiskMesh& second, const std::vector<int>& secondNumbers);

struct WeldedDisks {
  SphereMesh surface;               ///< vertices and faces of the first disk, then what the second adds to them
  Points3 image;                    ///< N×3 on the unit sphere; Φ1(0) at (0, 0, 1), Φ2(0) at (0, 0, −1)
  std::vector<int> secondVertices;  ///< vertex of the surface for every vertex of the second disk
  ConformalWelding welding;
};

/// Follows the maps f_1, f_2 of two surfaces to the unit disk by the maps of the welding f_1(seam) ~ f_2(seam), and
/// lifts the plane to the sphere. Where f_1 and f_2 are conformal so is the image, across the seam too as far as its
/// points resolve the signature; of other maps it is a common image all the same. @cite sharon2006 @cite nadeem2017
///
/// @param firstImage, secondImage  n×2: the boundary on the unit circle (only its directions are used), the rest
///        inside; counter-clockwise
/// @param seam  every boundary vertex of both disks once, in the order of first.boundary()
/// @throws InvalidArgument when sizes do not match, a vertex lies outside the disk, or an image of a boundary is not in
///         order
/// @throws GeometryError when the boundaries do not run in opposite directions along the seam
/// @throws TopologyError when gluing does not give a closed surface
/// Complexity O((n + s) s) for a seam of s points.
[[nodiscard]] WeldedDisks weldDisks(const DiskMesh& first, const Points2& firstImage, const DiskMesh& second,
                                    const Points2& secondImage, const SeamPairs& seam,
                                    const Execution& execution = {});

}  // namespace authalic
