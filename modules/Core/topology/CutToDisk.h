/// @file
/// Opening a closed cortex by removing its medial wall, so that what is left is a disk.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "Core/base/Execution.h"
#include "Core/mesh/TriangleMesh.h"

namespace authalic {

/// How to turn a removal region into a disk.
struct CutToDiskOptions {
  /// Keep only the largest connected piece of the removal region (true), or every piece: then each piece opens a
  /// hole of its own and the result is a disk only if there is one.
  bool largestRegionOnly = true;
  /// Averaging passes over the region's indicator function before it is cut at one half: takes spikes, bays and
  /// specks narrower than about √passes edges off the loop. Points never move. 0 = cut exactly where the flags say.
  int loopSmoothing = 10;

  /// @throws InvalidArgument when loopSmoothing is negative
  void validate() const;
};

/// A disk and where its vertices and faces come from.
struct CutToDiskResult {
  TriangleMesh mesh;
  std::vector<int> originalPointIds;  ///< n': vertex of the input for each vertex of the result
  std::vector<int> originalFaceIds;   ///< m': face of the input for each face of the result
  double removedArea = 0;             ///< mm²
  double keptArea = 0;                ///< mm²
  double loopLength = 0;              ///< mm, of the boundary loop
  int removedRegions = 0;             ///< pieces of the removal region that were removed
  int ignoredRegions = 0;             ///< smaller pieces that were kept as surface
  int filledIslands = 0;              ///< pieces of surface cut off by the region that went with it
};

/// Removes the faces that touch a marked vertex and keeps the largest piece of what is left.
///
/// For a closed surface of genus 0 and one connected region the result is a disk by construction: pieces of surface
/// enclosed by the region go with it (filledIslands), and where the rim touches itself in a vertex the smaller fan of
/// faces goes. Points are those of the input, bit for bit; vertices and faces keep their order. O(m) per pass.
///
/// @param surface  any oriented manifold surface, closed or not
/// @param remove   n flags, non-zero where the surface is to be opened
/// @throws GeometryError  when the flags do not match the vertices, mark nothing, or mark everything
/// @throws TopologyError  when what is left is not a disk (the surface has handles or other boundary loops)
[[nodiscard]] CutToDiskResult cutToDisk(const TriangleMesh& surface, const std::vector<char>& remove,
                                        const CutToDiskOptions& options = {}, const Execution& execution = {});

/// Flags the vertices on the side of a plane to which its normal points.
/// @param origin, normal  mm; the normal need not have unit length
/// @throws InvalidArgument when the normal is zero or not finite
[[nodiscard]] std::vector<char> verticesBeyondPlane(const TriangleMesh& surface, const Eigen::Vector3d& origin,
                                                    const Eigen::Vector3d& normal);

}  // namespace authalic
