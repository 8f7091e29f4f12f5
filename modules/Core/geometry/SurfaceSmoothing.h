/// @file
/// Smoothing of a closed surface that keeps its enclosed volume.
#pragma once

#include "Core/base/Execution.h"
#include "Core/mesh/TriangleMesh.h"

namespace authalic {

/// Choices of smoothSurface.
struct SmoothingOptions {
  int iterations = 20;    ///< pairs of a shrinking and a growing step, 0…1000
  double passBand = 0.1;  ///< spatial frequencies (eigenvalues of the umbrella operator, 0…2) below this pass
  bool restoreVolume = true;  ///< finish with a normal offset that restores the enclosed volume

  /// @throws InvalidArgument naming the first field out of range
  void validate() const;
};

/// What smoothSurface did.
struct SmoothedSurface {
  TriangleMesh mesh;
  double volumeBefore = 0, volumeAfter = 0;  ///< mm³ enclosed
  double areaBefore = 0, areaAfter = 0;      ///< mm²
  int turnedFaces = 0;                       ///< faces whose normal turned by more than 90°
};

/// Taubin's λ|μ smoothing with the umbrella operator: x ← x + λ U x, then x ← x + μ U x, with U x_i = mean of
/// the neighbours − x_i, λ = 0.6307 and 1/λ + 1/μ = passBand. Frequencies below the pass band are kept, those
/// above are damped; uniform weights also even out the triangles (tangential regularisation), which marching
/// cubes' slivers need.
///
/// Guarantees: connectivity unchanged; with restoreVolume the enclosed volume is that of the input to 1e-9
/// relative (Newton on a uniform normal offset); same bits at any thread count. Not guaranteed: absence of
/// self-intersections; turned faces are counted. O(iterations · faces).
///
/// @param mesh  closed, consistently oriented
/// @throws InvalidArgument for bad options; TopologyError when the mesh is not closed and manifold;
/// CancelledError
/// @cite taubin1995
[[nodiscard]] SmoothedSurface smoothSurface(const TriangleMesh& mesh, const SmoothingOptions& options = {},
                                            const Execution& execution = {});

/// Σ x_a · (x_b × x_c) / 6 over the faces: the volume in mm³ inside a closed surface with outward faces
/// (negative when inward).
[[nodiscard]] double enclosedVolume(const TriangleMesh& mesh);

}  // namespace authalic
