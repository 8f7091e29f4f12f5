#include "Core/authalic/DiskFlowDomain.h"

#include <string>
#include <utility>

#include "Core/authalic/BalancedStart.h"
#include "Core/authalic/PlanarAreas.h"
#include "Core/authalic/PolygonStart.h"
#include "Core/base/Error.h"
#include "Core/geometry/Areas.h"
#include "Core/initial/Untangle.h"

namespace authalic {

DiskFlowDomain::DiskFlowDomain(const DiskMesh& disk, const PlanarDomain& domain, const BoundaryPlacement& placement,
                               const Points2& image, const TargetMeasure& target, SolverBackend backend)
    : LieFlowDomain(disk.mesh().faces(), target), disk_(disk), sliding_(placement, domain, image), backend_(backend),
      convex_(domain.convex()) {
  if (!placement.pockets.empty()) freeze(placement.inPocket);
}

std::unique_ptr<AreaFunctional> DiskFlowDomain::areasOn(const Faces& faces, const Points2&) const {
  return std::make_unique<PlanarAreas>(faces, sliding_, disk_.mesh().vertexCount());
}

Coordinates DiskFlowDomain::unfolded(const Coordinates& image, UnfoldReach reach) const {
  if (convex_) return unfold(disk_.topology(), Points2(image), {}, reach).image;
  return unfoldOrUntangle(disk_.topology(), Points2(image)).image;
}

Coordinates DiskFlowDomain::revived(const Coordinates& image) const {
  return reviveCollapsedFaces(disk_, Points2(image), target(), backend_);
}

void DiskFlowDomain::carryFrozen(Coordinates& image) const {
  Points2 points = image;
  sliding_.carryPockets(points);
  image = points;
}

Points2 unfoldedStart(const DiskMesh& disk, const PlanarDomain& domain, const BoundaryPlacement& placement,
                      Points2 image, const TargetMeasure& target, SolverBackend backend, const Execution& execution) {
  for (std::size_t i = 0; i < placement.vertices.size(); ++i) {
    image.row(placement.vertices[i]) = placement.points.row(static_cast<Eigen::Index>(i));
  }
  UnfoldResult start =
      unfold(disk.topology(), std::move(image), execution,
             domain.convex() ? UnfoldReach::WholeMesh : UnfoldReach::Patches);
  if (start.flippedFaces > 0 && !domain.convex() && !execution.cancelled()) {
    start.image = polygonStart(disk, domain, placement, target, backend, execution);
    start.flippedFaces = countFlippedFaces(start.image, disk.mesh().faces());
  }
  if (start.flippedFaces > 0 && !execution.cancelled()) {
    throw GeometryError("An initial map that can be unfolded is required, but " + std::to_string(start.flippedFaces) +
                        " faces stay folded; " +
                        (domain.convex() ? "start from a tutte or mean-value map to a convex domain."
                                         : "refine the surface along its boundary, or take a domain with fewer or "
                                           "blunter corners that point inwards."));
  }
  return std::move(start.image);
}

}  // namespace authalic
