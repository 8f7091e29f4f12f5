#include "Core/conformal/Unfolding.h"

#include <utility>

#include "Core/geometry/Areas.h"
#include "Core/initial/FoldedPockets.h"
#include "Core/initial/Unfold.h"

namespace authalic {

UnfoldedImage unfoldImage(const TriangleMesh& surface, const SurfaceTopology& topology, Points2 image, bool repair) {
  UnfoldedImage result;
  result.flippedBefore = result.flippedAfter = countFlippedFaces(image, topology.faces());
  result.image = std::move(image);
  if (!repair || result.flippedBefore == 0) return result;
  FoldedPocketsResult bulged = bulgeFoldedPockets(surface, topology, std::move(result.image));
  UnfoldResult unfolded = unfold(topology, std::move(bulged.image), {}, UnfoldReach::Patches);
  result.image = std::move(unfolded.image);
  result.flippedAfter = unfolded.flippedFaces;
  result.pockets = bulged.pockets;
  return result;
}

}  // namespace authalic
