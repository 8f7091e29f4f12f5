/// @file
/// A contractible set of voxels, grown inside a mask by simple points.
#pragma once

#include <array>

#include "Core/base/Execution.h"
#include "Core/imaging/Volume.h"

namespace authalic {

/// What growHomotopic found.
struct HomotopicGrowth {
  MaskVolume mask;       ///< 1 = in the grown set
  std::size_t kept = 0;  ///< voxels of the candidates in the set
  std::size_t rejected =
      0;  ///< candidate voxels left out, because they would close a handle or a cavity or are detached
  std::size_t added = 0;  ///< voxels outside the candidates that were added to close small tunnels
};

/// Grows a set from one voxel by simple points (see SimplePoint.h), highest priority first.
///
/// Candidates are the voxels with `priority > 0`. A loop of candidates is cut where its priority is smallest,
/// as in a watershed: with depth below the surface as priority, at the thinnest place. A voxel that was
/// refused is tried again whenever a neighbour joins.
///
/// Voxels with `priority < 0` may be used to close tunnels (nearest to 0 first): the set grows into them
/// after the candidates, which lets the candidates that had been refused around a small tunnel join, and then
/// gives back every such voxel that is still simple. What stays is a thin membrane across each tunnel.
///
/// Guarantees: the set is non-empty, 14-connected, collapsible (no handle, no cavity), does not touch the
/// outermost layer of the volume; the same input gives the same set. Complexity: O(voxels).
///
/// @param priority  in [−32767, 32767]; 0 = never
/// @param seed      voxel (i, j, k) with positive priority, not in the outermost layer
/// @throws InvalidArgument when the seed is not such a voxel; CancelledError
/// @cite bertrand1994 @cite kriegeskorte2001
[[nodiscard]] HomotopicGrowth growHomotopic(const VolumeOf<std::int16_t>& priority,
                                            const std::array<int, 3>& seed, const Execution& execution = {});

}  // namespace authalic
