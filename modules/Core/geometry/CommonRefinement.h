/// @file
/// The mesh in which the edges of a surface and those of its flipped triangulation both run.
#pragma once

#include <vector>

#include "Core/geometry/IntrinsicTriangulation.h"
#include "Core/mesh/SurfaceTopology.h"
#include "Core/mesh/TriangleMesh.h"

namespace authalic {

/// A refinement of a surface and of its planar image at once.
struct CommonRefinement {
  TriangleMesh mesh;                  ///< n' vertices (mm): the surface's n, then the crossings
  Points2 image;                      ///< n'×2
  std::vector<int> originalPointIds;  ///< n': vertex of the surface, −1 at crossings
  std::vector<int> originalFaceIds;   ///< m': face of the surface that the face is part of
  int flippedFaces = 0;               ///< folded faces of the image: 0 where no face of the flipped triangulation
                                      ///< is folded
};

/// Cuts the faces of the surface along the edges of the flipped triangulation.
///
/// A map that is one-to-one on the flipped triangulation may fold faces of the surface. On the common refinement
/// it is one-to-one on faces of both. Which edges cross, and in which order, is known from the normal coordinates
/// that the triangulation carries, as integers @cite gillespie2021. Where they cross is chosen: at the
/// intersection of both as straight lines in the image; where these do not intersect in that order (a fold),
/// evenly spaced. Any choice in the right order gives convex cells on both sides, so none can fold; with this one
/// the map is the piecewise linear one of the surface's own faces wherever it does not fold.
///
/// @param surface   the triangulation when trackCrossings() was called
/// @param flipped   what flips have made of it
/// @param image     n×2
/// @throws InvalidArgument when the flipped triangulation does not track the edges of this surface (it was split,
///         or has other vertices)
/// Complexity O(m + crossings).
[[nodiscard]] CommonRefinement commonRefinement(const TriangleMesh& surface, const SurfaceTopology& topology,
                                                const IntrinsicTriangulation& flipped, const Points2& image);

}  // namespace authalic
