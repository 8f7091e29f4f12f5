#include "Core/transport/SphericalTransportMap.h"

#include <chrono>
#include <cmath>
#include <string>
#include <utility>

#include "Core/base/Error.h"
#include "Core/conformal/SphericalConformalMap.h"
#include "Core/geometry/SphericalAreas.h"
#include "Core/transport/DistinctSites.h"
#include "Core/transport/StereographicTransport.h"

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

bool leavesNoneEmpty(StereographicPowerDiagram& diagram, const Heights& heights, const Execution& execution) {
  return diagram.compute(heights, execution) && diagram.cells().areas.minCoeff() > 0;
}

// Transport from the sites of the result, on the sphere.
void moveOnSphere(SphericalTransportMapResult& result, const SemiDiscreteTransportOptions& options,
                  const Heights& start, const Execution& execution) {
  SphericalPowerDiagram diagram(std::move(result.sites));
  result.sites = diagram.sites();
  const bool usable = start.size() > 0 && leavesNoneEmpty(diagram, start, execution);
  static_cast<TransportSolution&>(result) =
      sphericalTransport(diagram, result.masses, options, usable ? start : Heights(), execution);
  const SphericalPowerCells& cells = diagram.cells();
  result.image = cells.centroids;
  result.cellAreas = cells.areas;
  result.emptyCells = cells.emptyCells;
  result.transportCost = diagram.transportCost();
  result.potential = result.image.cwiseProduct(result.sites).rowwise().sum().array().log().matrix() +
                     result.heights.cast<double>();
  result.cells = diagram.polygons();
}

// The same in the plane of the projection from result.pole.
void moveInPlane(SphericalTransportMapResult& result, const SemiDiscreteTransportOptions& options,
                 const Heights& start, const Execution& execution) {
  StereographicPowerDiagram diagram(std::move(result.sites), result.pole);
  result.sites = diagram.sites();
  result.pole = diagram.pole();
  const bool usable = start.size() > 0 && leavesNoneEmpty(diagram, start, execution);
  static_cast<TransportSolution&>(result) =
      stereographicTransport(diagram, result.masses, options, usable ? start : Heights(), execution);
  result.image = diagram.cells().centroids;
  result.cellAreas = diagram.cells().areas;
  result.potential = diagram.planesAt(result.image);
  result.cells = diagram.polygons();
}

}  // namespace

void SphericalTransportMapOptions::validate() const {
  SemiDiscreteTransportOptions::validate();
  if (!pole.allFinite()) throw InvalidArgument("A finite pole is required for transport, but it is not.");
  if (formulation == SphereFormulation::Spherical && pole != Eigen::Vector3d::Zero()) {
    throw InvalidArgument("A pole is for the stereographic formulation of transport; leave it out or take that one.");
  }
}

Eigen::Vector3d defaultPole(const Points3& image, const Faces& faces) {
  Eigen::Index largest = 0;
  signedSolidAngles(image, faces).maxCoeff(&largest);
  const auto corner = [&](int k) { return Eigen::Vector3d(image.row(faces(largest, k)).transpose()); };
  return (corner(0) + corner(1) + corner(2)).normalized();
}

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
                                                  const SphericalTransportMapOptions& options, const Points3& initial,
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
  result.masses = kSphere * shares;
  if (options.formulation == SphereFormulation::Stereographic) {
    const bool chosen = options.pole != Eigen::Vector3d::Zero();
    result.pole = chosen ? options.pole : defaultPole(result.sites, sphere.mesh().faces());
    moveInPlane(result, options, start, execution.part(0.2, 0.95));
  } else {
    moveOnSphere(result, options, start, execution.part(0.2, 0.95));
  }
  result.flippedFaces = countFlippedOnSphere(result.image, sphere.mesh().faces());
  result.transportSeconds = secondsSince(begun) - result.startSeconds;
  execution.report(1, "Optimal transport");
  return result;
}

}  // namespace authalic
