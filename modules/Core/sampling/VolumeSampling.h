/// @file
/// A volume read at, below, or between surfaces: one number per vertex.
#pragma once

#include <vector>

#include "Core/base/Execution.h"
#include "Core/imaging/Interpolation.h"
#include "Core/imaging/Volume.h"
#include "Core/mesh/TriangleMesh.h"

namespace authalic {

/// Where the samples of a vertex lie.
enum class SamplingMode {
  AtVertex,         ///< one sample, at the vertex
  AlongNormal,      ///< x − d·N for the depths d, N the outward unit normal: d > 0 is inward
  BetweenSurfaces,  ///< (1 − t)·x + t·y for the fractions t, y the same vertex of the other surface
};

/// How the samples of a vertex become one number.
enum class SamplingReducer {
  Mean,
  Median,  ///< of an even number, the mean of the middle two
  Maximum,
  Minimum,
  Mode,  ///< the most frequent value, for labels; of equally frequent ones the smallest
};

/// "at-vertex", "along-normal", "between-surfaces".
[[nodiscard]] const char* samplingModeName(SamplingMode mode) noexcept;
/// "mean", "median", "maximum", "minimum", "mode".
[[nodiscard]] const char* samplingReducerName(SamplingReducer reducer) noexcept;
/// "trilinear", "nearest".
[[nodiscard]] const char* interpolationName(Interpolation interpolation) noexcept;

struct VolumeSamplingOptions {
  SamplingMode mode = SamplingMode::AtVertex;
  SamplingReducer reducer = SamplingReducer::Mean;
  Interpolation interpolation = Interpolation::Trilinear;
  double depthFrom = 0.0;     ///< mm, inward; AlongNormal
  double depthTo = 10.0;      ///< mm, inward; AlongNormal
  double depthStep = 1.0;     ///< mm, > 0; AlongNormal
  double fractionFrom = 0.0;  ///< 0 = the surface, 1 = the other surface; BetweenSurfaces
  double fractionTo = 1.0;    ///< BetweenSurfaces
  double fractionStep = 0.1;  ///< > 0; BetweenSurfaces
  bool skipZero = false;      ///< true: a sample of exactly 0 is background and counts as n/a (label volumes)

  /// @throws InvalidArgument when a number is not finite, a step is not positive, from > to, or more than
  ///         10,000 samples per vertex would result.
  void validate() const;
};

/// What sampling leaves at each vertex.
struct VolumeSamples {
  std::vector<double> values;    ///< n; NaN = n/a
  std::vector<double> coverage;  ///< n, in [0, 1]: valid samples over all samples of the vertex
  int samplesPerVertex = 0;
  int verticesWithoutValue = 0;
};

/// Reads `volume` at every vertex of `surface`.
///
/// The depths are from, from + step, … up to `to` (included when it is reached to 1e-9 of a step); the
/// defaults read 0, 1, …, 10 mm along the inward normal and average, as @cite zou2011 does for PET. A sample
/// outside the field of view (see Interpolator) or on a voxel without data is left out of the reduction and
/// lowers the coverage; a vertex with no valid sample is n/a, never 0.
///
/// The normal of a vertex is the sum of its faces' unit normals weighted by the angles at the vertex
/// (@cite thurmer1998). It points outward when faces are counter-clockwise seen from outside, which is the
/// caller's to ensure (MeshReport says when a closed surface is inside out). A vertex without faces has no
/// normal: n/a.
///
/// Surface and volume must both be in scanner RAS mm; nothing here can detect that they are not.
/// T is float, double, std::int16_t, std::int32_t or std::uint8_t. Complexity: O(vertices × samples),
/// parallel; same bits at any thread count.
///
/// @throws InvalidArgument for bad options, for BetweenSurfaces (see sampleVolumeBetween), or a malformed
///         volume.
/// @throws CancelledError
template <class T>
[[nodiscard]] VolumeSamples sampleVolume(const TriangleMesh& surface, const VolumeOf<T>& volume,
                                         const VolumeSamplingOptions& options = {},
                                         const Execution& execution = {});

/// The same along given outward normals (n×3; need not be unit; a zero or non-finite row makes its vertex
/// n/a).
/// @throws GeometryError when there is not one normal per vertex.
template <class T>
[[nodiscard]] VolumeSamples sampleVolume(const TriangleMesh& surface, const Points3& normals,
                                         const VolumeOf<T>& volume, const VolumeSamplingOptions& options = {},
                                         const Execution& execution = {});

/// Reads `volume` on the straight lines from each vertex of `surface` to the same row of `otherPoints` (n×3
/// mm), at the fractions of the options whatever their mode says.
/// @throws GeometryError when the two have different numbers of vertices, or a coordinate is not finite.
template <class T>
[[nodiscard]] VolumeSamples sampleVolumeBetween(const TriangleMesh& surface, const Points3& otherPoints,
                                                const VolumeOf<T>& volume,
                                                const VolumeSamplingOptions& options = {},
                                                const Execution& execution = {});

/// Outward unit normals, n×3, weighted by angle (@cite thurmer1998); zero where a vertex has no face of
/// positive area.
[[nodiscard]] Points3 angleWeightedNormals(const TriangleMesh& surface);

}  // namespace authalic
