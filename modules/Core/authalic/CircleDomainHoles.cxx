#include "Core/authalic/CircleDomainHoles.h"

#include <cmath>
#include <string>

#include "Core/base/Error.h"

namespace authalic {

void CircleDomainHoles::validate(const PolyAnnulusMesh& surface) const {
  const std::size_t holes = surface.loops().size() - 1;
  if (concentric && holes != 1) {
    throw TopologyError("A surface with 2 boundary loops is required for a concentric map, but it has " +
                        std::to_string(holes + 1) + "; take the domain circle-domain.");
  }
  if (!holeAreas.empty() && holeAreas.size() != holes) {
    throw InvalidArgument("One area for each of the " + std::to_string(holes) + " holes is required, but there are " +
                          std::to_string(holeAreas.size()) + ".");
  }
  for (const double area : holeAreas) {
    if (!(area > 0 && std::isfinite(area))) {
      throw InvalidArgument("Positive hole areas are required, but one is " + std::to_string(area) + ".");
    }
  }
}

}  // namespace authalic
