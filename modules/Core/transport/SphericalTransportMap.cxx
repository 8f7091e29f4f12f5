#include "Core/transport/SphericalTransportMap.h"

#include <chrono>
#include <cmath>
#include <string>
#include <utility>

#include "Core/base/Error.h"
#include "Core/conformal/SphericalConformalMap.h"
#include "Core/geometry/SphericalAreas.h"
#include "Core/transport/DistinctSites.h"

namespace authalic {
namespace {

constexpr double kSphere = 4 * 3.14159265358979323846;

double secondsSince(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void requireRows(Eigen::Index found, const SphereMesh& sphere, const char* what) {
  if (found == sphere.mesh().vertexCount()) return;
  throw GeometryError(std::string(what) + " per vertex (" + std::to_string(sphere.mesh().vertexCount()) +
                      ") is required, but there are " + std::to_string(found) + ".");
}

bool leavesNoneEmpty(SphericalPowerDiagram& diagram, const Heights& heights, const Execution& execution) {
  const SphericalPowerCells& cells = diagram.compute(heights, execution);
  return cells.surrounded && cells.areas.minCoeff() > 0;
}

}  // namespace

double displacementCost(const Eigen::VectorXd& masses, const Points3& sites, const Points3& places) {
  double cost = 0;
  for (Eigen::Index i = 0; i < masses.size(); ++i) {
    const double distance =
        2 * std::atan2((places.row(i) - sites.row(i)).norm(), (places.row(i) + sites.row(i)).norm());
    cost += masses[i] * distance * distance;
  }
  return cost;
}

SphericalTransportMapResult sphericalTransportMap(const SphereMesh& sphere, const Eigen::VectorXd& shares,
                                                  const SemiDiscreteTransportOptions& options, const Points3& initial,
                                                  const Execution& execution, const Heights& start) {
  options.validate();
  requireRows(shares.size(), sphere, "One share");
  const auto begun = std::chrono::steady_clock::now();
  SphericalTransportMapResult result;
  if (initial.size() > 0) {
    requireRows(initial.rows(), sphere, "An initial map with one point");
    requireOnUnitSphere(initial);
    result.sites = initial;
  } else {
    SphericalConformalMapOptions conformal;
    conformal.solver = options.solver;
    result.sites = sphericalConformalMap(sphere, conformal, execution.part(0, 0.2)).image;
  }
  requireDistinctImages(result.sites);
  result.startSeconds = secondsSince(begun);
  SphericalPowerDiagram diagram(std::move(result.sites));
  result.sites = diagram.sites();
  result.masses = kSphere * shares;
  const bool usable = start.size() > 0 && leavesNoneEmpty(diagram, start, execution);
  static_cast<TransportSolution&>(result) =
      sphericalTransport(diagram, result.masses, options, usable ? start : Heights(), execution.part(0.2, 0.95));
  const SphericalPowerCells& cells = diagram.cells();
  result.image = cells.centroids;
  result.cellAreas = cells.areas;
  result.emptyCells = cells.emptyCells;
  result.transportCost = diagram.transportCost();
  result.potential = result.image.cwiseProduct(result.sites).rowwise().sum().array().log().matrix() +
                     result.heights.cast<double>();
  result.cells = diagram.polygons();
  result.flippedFaces = countFlippedOnSphere(result.image, sphere.mesh().faces());
  result.transportSeconds = secondsSince(begun) - result.startSeconds;
  execution.report(1, "Optimal transport");
  return result;
}

}  // namespace authalic
