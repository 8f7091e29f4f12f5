/// @file
/// The normal position of an image on the unit disk.
#pragma once

#include <vector>

#include "Core/mesh/SurfaceTopology.h"
#include "Core/mesh/TriangleMesh.h"
#include "Core/numerics/Mobius.h"

namespace authalic {

/// What goes to the centre of the disk.
enum class DiskCentre {
  AreaCentroid,  ///< Σ A_i z_i = 0 with the surface areas A_i of the vertex stars: needs no choice, hides no part
  Vertex,        ///< a given vertex
  Face,          ///< the centroid of a given face
};

/// The freedom of a map to the disk: what goes to the centre, what to angle 0.
struct DiskNormalisation {
  DiskCentre centre = DiskCentre::AreaCentroid;
  int centreId = -1;     ///< vertex or face id, for Vertex and Face
  int startVertex = -1;  ///< vertex of the outer loop at angle 0; −1 = the one with the smallest id

  /// @throws InvalidArgument when an id does not belong to the surface
  void validate(const TriangleMesh& mesh, const std::vector<int>& outerLoop,
                const std::vector<char>& onBoundary) const;
};

/// The Möbius transformation that puts an image on the unit disk into its normal position.
/// @param image      n×2, outer loop on the unit circle, all inside it
/// @param outerLoop  vertices of the loop on the circle
/// @throws InvalidArgument from the normalisation; GeometryError when the image is not in the disk
[[nodiscard]] Mobius normalisingMap(const TriangleMesh& mesh, const SurfaceTopology& topology,
                                    const std::vector<int>& outerLoop, const Points2& image,
                                    const DiskNormalisation& normalisation);

/// Puts an image on the unit disk into its normal position by normalisingMap().
/// The vertices of the outer loop are on the circle to rounding afterwards.
/// @throws as normalisingMap()
[[nodiscard]] Points2 normaliseDisk(const TriangleMesh& mesh, const SurfaceTopology& topology,
                                    const std::vector<int>& outerLoop, const Points2& image,
                                    const DiskNormalisation& normalisation);

/// "area-centroid", "vertex", "face".
[[nodiscard]] const char* diskCentreName(DiskCentre centre) noexcept;

}  // namespace authalic
