#include "Core/transport/OptimalTransportMap.h"

#include <algorithm>
#include <chrono>
#include <limits>
#include <string>
#include <utility>

#include "Core/base/Error.h"
#include "Core/geometry/Areas.h"
#include "Core/initial/BarycentricMap.h"
#include "Core/transport/DistinctSites.h"

namespace authalic {
namespace {

double secondsSince(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

Eigen::RowVector2d nearestOnSide(const Eigen::RowVector2d& p, const Points2& corners, Eigen::Index side) {
  const Eigen::RowVector2d a = corners.row(side), along = corners.row((side + 1) % corners.rows()) - a;
  return a + std::clamp((p - a).dot(along) / along.squaredNorm(), 0.0, 1.0) * along;
}

// The point of the domain that is nearest to p.
Eigen::RowVector2d nearestInDomain(const Eigen::RowVector2d& p, const PlanarDomain& domain) {
  if (domain.isDisk()) return p.norm() > 1 ? Eigen::RowVector2d(p.normalized()) : p;
  const Points2& corners = domain.corners();
  bool inside = true;
  Eigen::RowVector2d nearest = p;
  double distance = std::numeric_limits<double>::infinity();
  for (Eigen::Index k = 0; k < corners.rows(); ++k) {
    const Eigen::RowVector2d a = corners.row(k), along = corners.row((k + 1) % corners.rows()) - a, from = p - a;
    inside = inside && along[0] * from[1] - along[1] * from[0] >= 0;
    const Eigen::RowVector2d candidate = nearestOnSide(p, corners, k);
    if ((candidate - p).squaredNorm() < distance) distance = (candidate - p).squaredNorm(), nearest = candidate;
  }
  return inside ? p : nearest;
}

void putBoundaryBack(const BoundaryPlacement& boundary, const PlanarDomain& domain, Points2& image) {
  for (std::size_t k = 0; k < boundary.vertices.size(); ++k) {
    auto place = image.row(boundary.vertices[k]);
    switch (boundary.role[k]) {
      case BoundaryRole::Circle: place.normalize(); break;
      case BoundaryRole::Corner: place = boundary.points.row(static_cast<Eigen::Index>(k)); break;
      case BoundaryRole::Side: place = nearestOnSide(place, domain.corners(), boundary.side[k]); break;
      case BoundaryRole::Pocket: break;
    }
  }
}

Eigen::VectorXd potentialAt(const Points2& places, const Points2& sites, const Heights& heights) {
  return places.cwiseProduct(sites).rowwise().sum() + heights.cast<double>();
}

void requireShares(const Eigen::VectorXd& shares, const DiskMesh& disk) {
  if (shares.size() == disk.mesh().vertexCount()) return;
  throw GeometryError("One share per vertex (" + std::to_string(disk.mesh().vertexCount()) +
                      ") is required, but there are " + std::to_string(shares.size()) + ".");
}

void requireInitialOf(const Points2& initial, const DiskMesh& disk) {
  if (initial.rows() == disk.mesh().vertexCount() && initial.allFinite()) return;
  throw GeometryError("An initial map with one finite point per vertex (" + std::to_string(disk.mesh().vertexCount()) +
                      ") is required, but it has " + std::to_string(initial.rows()) + " points.");
}

BarycentricMapResult harmonicMap(const DiskMesh& disk, const OptimalTransportMapOptions& options,
                                 const Execution& execution) {
  BarycentricMapOptions harmonic;
  harmonic.weights = BarycentricWeights::Harmonic;
  harmonic.domain = options.domain;
  harmonic.solver = options.solver;
  return barycentricMap(disk, harmonic, execution);
}

}  // namespace

void OptimalTransportMapOptions::validate() const {
  SemiDiscreteTransportOptions::validate();
  if (!domain.convex()) {
    throw InvalidArgument("A convex domain is required for transport, but the polygon of " +
                          std::to_string(domain.corners().rows()) + " corners is not convex.");
  }
  const bool apart = source && (source->domain().corners().rows() != domain.corners().rows() ||
                                source->domain().corners() != domain.corners());
  if (!apart) return;
  throw InvalidArgument("A source density on the domain of the map is required, but it was made for another domain.");
}

double displacementCost(const Eigen::VectorXd& masses, const Points2& sites, const Points2& places) {
  return masses.dot((places - sites).rowwise().squaredNorm());
}

OptimalTransportMapResult optimalTransportMap(const DiskMesh& disk, const Eigen::VectorXd& shares,
                                              const OptimalTransportMapOptions& options, const Points2& initial,
                                              const Execution& execution, const Heights& start) {
  options.validate();
  requireShares(shares, disk);
  const auto begun = std::chrono::steady_clock::now();
  OptimalTransportMapResult result;
  BoundaryPlacement boundary;
  if (initial.size() > 0) {
    requireInitialOf(initial, disk);
    result.sites = initial;
    boundary = recogniseBoundary(disk, options.domain, initial);
  } else {
    BarycentricMapResult harmonic = harmonicMap(disk, options, execution.part(0, 0.1));
    result.sites = std::move(harmonic.image);
    boundary = std::move(harmonic.boundary);
  }
  for (Eigen::Index i = 0; i < result.sites.rows(); ++i) {
    result.sites.row(i) = nearestInDomain(result.sites.row(i), options.domain);
  }
  requireDistinctImages(result.sites);
  result.startSeconds = secondsSince(begun);
  PowerDiagram diagram = options.source ? PowerDiagram(result.sites, options.source)
                                        : PowerDiagram(result.sites, options.domain);
  result.masses = diagram.total() * shares;
  const bool usable = start.size() > 0 && diagram.computeUnlessHidden(start, execution) &&
                      diagram.cells().masses.minCoeff() > 0;
  static_cast<TransportSolution&>(result) =
      semiDiscreteTransport(diagram, result.masses, options, usable ? start : Heights(), execution.part(0.1, 0.95));
  const PowerCells& cells = diagram.cells();
  result.image = cells.centroids;
  putBoundaryBack(boundary, options.domain, result.image);
  result.cellAreas = cells.areas;
  result.cellMasses = cells.masses;
  result.emptyCells = cells.emptyCells;
  result.transportCost = cells.costs.sum();
  result.potential = potentialAt(result.image, result.sites, result.heights);
  result.cells = diagram.polygons();
  result.flippedFaces = countFlippedFaces(result.image, disk.mesh().faces());
  result.transportSeconds = secondsSince(begun) - result.startSeconds;
  execution.report(1, "Optimal transport");
  return result;
}

}  // namespace authalic
