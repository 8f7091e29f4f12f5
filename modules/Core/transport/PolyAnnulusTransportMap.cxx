#include "Core/transport/PolyAnnulusTransportMap.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "Core/base/Error.h"
#include "Core/geometry/Areas.h"
#include "Core/transport/DistinctSites.h"

namespace authalic {
namespace {

constexpr double kOnCircle = 1e-9;         // of the radius: loop vertices farther off belong to pockets
constexpr double kSmallestRadius = 1e-12;  // of a hole anywhere in the disk: coordinates have 16 digits

double secondsSince(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

std::string text(double value) { return std::to_string(value); }

void requireSharesOf(const Eigen::VectorXd& shares, const PolyAnnulusMesh& surface) {
  if (shares.size() == surface.mesh().vertexCount()) return;
  throw GeometryError("One share per vertex (" + std::to_string(surface.mesh().vertexCount()) +
                      ") is required, but there are " + std::to_string(shares.size()) + ".");
}

// The loops that become holes, in the order of loops().
std::vector<std::size_t> holesOf(const CircleDomainResult& conformal) {
  std::vector<std::size_t> holes;
  for (std::size_t k = 0; k < conformal.circles.size(); ++k) {
    if (static_cast<int>(k) == conformal.outerLoop) continue;
    if (!(conformal.circles[k].radius > kSmallestRadius)) {
      throw GeometryError("Boundary loops that are circles in the conformal map are required, but loop " +
                          std::to_string(k) + " is shrunk to a radius of " + text(conformal.circles[k].radius) +
                          "; for a long tube take an authalic map to the domain periodic-rectangle.");
    }
    holes.push_back(k);
  }
  return holes;
}

// The conformal map, then the centres of its holes.
Points2 sitesOf(const CircleDomainResult& conformal, const std::vector<std::size_t>& holes) {
  const Eigen::Index n = conformal.image.rows();
  Points2 sites(n + static_cast<Eigen::Index>(holes.size()), 2);
  sites.topRows(n) = conformal.image;
  for (std::size_t j = 0; j < holes.size(); ++j) {
    sites.row(n + static_cast<Eigen::Index>(j)) = conformal.circles[holes[j]].centre;
  }
  for (Eigen::Index i = 0; i < sites.rows(); ++i) {
    if (sites.row(i).norm() > 1) sites.row(i).normalize();
  }
  return sites;
}

// H_j, mm².
std::vector<double> areasOf(const PolyAnnulusMesh& surface, const CircleDomainResult& conformal,
                            const std::vector<std::size_t>& holes, const PolyAnnulusTransportOptions& options) {
  std::vector<double> areas = options.holeAreas;
  for (std::size_t j = 0; j < holes.size() && options.holeAreas.empty(); ++j) {
    const double radius = conformal.circles[holes[j]].radius;
    areas.push_back(options.holeShare > 0 ? M_PI * radius * radius
                                          : loopConeArea(surface.mesh(), surface.loops()[holes[j]]));
  }
  if (!(options.holeShare > 0)) return areas;
  double sum = 0;
  for (const double area : areas) sum += area;
  const double whole = faceAreas(surface.mesh()).sum() * options.holeShare / (1 - options.holeShare);
  for (double& area : areas) area *= whole / sum;
  return areas;
}

// a μ, then b.
Eigen::VectorXd massesOf(const PolyAnnulusMesh& surface, const Eigen::VectorXd& shares,
                         const std::vector<double>& holeAreas) {
  const double area = faceAreas(surface.mesh()).sum();
  double whole = area;
  for (const double hole : holeAreas) whole += hole;
  Eigen::VectorXd masses(shares.size() + static_cast<Eigen::Index>(holeAreas.size()));
  masses.head(shares.size()) = M_PI * area / whole * shares;
  for (std::size_t j = 0; j < holeAreas.size(); ++j) {
    masses[shares.size() + static_cast<Eigen::Index>(j)] = M_PI * holeAreas[j] / whole;
  }
  return masses;
}

// The point of a closed polygon that is nearest to p.
Eigen::RowVector2d nearestOnPolygon(const Eigen::RowVector2d& p, const Points2& corners) {
  Eigen::RowVector2d nearest = p;
  double distance = std::numeric_limits<double>::infinity();
  for (Eigen::Index k = 0; k < corners.rows(); ++k) {
    const Eigen::RowVector2d a = corners.row(k), along = corners.row((k + 1) % corners.rows()) - a;
    const double length = along.squaredNorm();
    const double t = length > 0 ? std::clamp((p - a).dot(along) / length, 0.0, 1.0) : 0.0;
    const Eigen::RowVector2d candidate = a + t * along;
    if ((candidate - p).squaredNorm() < distance) distance = (candidate - p).squaredNorm(), nearest = candidate;
  }
  return nearest;
}

void putLoopsBack(const PolyAnnulusMesh& surface, const std::vector<std::size_t>& holes,
                  PolyAnnulusTransportResult& result) {
  for (const int v : surface.loops()[static_cast<std::size_t>(result.outerLoop)]) result.image.row(v).normalize();
  const Eigen::Index n = result.image.rows();
  for (std::size_t j = 0; j < holes.size(); ++j) {
    const FittedCircle& circle = result.circles[holes[j]];
    const std::size_t cell = static_cast<std::size_t>(n) + j;
    const int begin = result.cells.starts[cell], end = result.cells.starts[cell + 1];
    const Points2 outline = result.cells.corners.middleRows(begin, end - begin);
    for (const int v : surface.loops()[holes[j]]) {
      const double off = (result.sites.row(v) - circle.centre).norm() / circle.radius - 1;
      if (std::abs(off) > kOnCircle) result.pockets.push_back(v);
      else result.image.row(v) = nearestOnPolygon(result.image.row(v), outline);
    }
  }
}

void takeCells(const PolyAnnulusMesh& surface, const std::vector<std::size_t>& holes, const PowerDiagram& diagram,
               PolyAnnulusTransportResult& result) {
  const PowerCells& cells = diagram.cells();
  const Eigen::Index n = surface.mesh().vertexCount(), m = static_cast<Eigen::Index>(holes.size());
  result.image = cells.centroids.topRows(n);
  result.holeCentres = cells.centroids.bottomRows(m);
  result.cellAreas = cells.areas;
  result.emptyCells = cells.emptyCells;
  result.transportCost = cells.costs.sum();
  result.cells = diagram.polygons();
  putLoopsBack(surface, holes, result);
  Points2 places(n + m, 2);
  places << result.image, result.holeCentres;
  result.potential = places.cwiseProduct(result.sites).rowwise().sum() + result.heights.cast<double>();
  result.flippedFaces = countFlippedFaces(result.image, surface.mesh().faces());
}

}  // namespace

void PolyAnnulusTransportOptions::validate(const PolyAnnulusMesh& surface) const {
  SemiDiscreteTransportOptions::validate();
  const std::size_t holes = surface.loops().size() - 1;
  if (!holeAreas.empty() && holeAreas.size() != holes) {
    throw InvalidArgument("One area for each of the " + std::to_string(holes) + " holes is required, but there are " +
                          std::to_string(holeAreas.size()) + ".");
  }
  for (const double area : holeAreas) {
    if (area > 0 && std::isfinite(area)) continue;
    throw InvalidArgument("Positive hole areas are required, but one is " + text(area) + ".");
  }
  if (!(holeShare >= 0 && holeShare < 1)) {
    throw InvalidArgument("A share of the disk below 1 for the holes, or 0 for their own areas, is required, but it "
                          "is " + text(holeShare) + ".");
  }
  if (holeShare > 0 && holes == 0) {
    throw InvalidArgument(
        "A surface with 2 boundary loops or more is required for a share of the holes, but it has 1.");
  }
}

PolyAnnulusTransportResult polyAnnulusTransportMap(const PolyAnnulusMesh& surface, const Eigen::VectorXd& shares,
                                                   const PolyAnnulusTransportOptions& options,
                                                   const Execution& execution) {
  options.validate(surface);
  requireSharesOf(shares, surface);
  const auto begun = std::chrono::steady_clock::now();
  CircleDomainOptions round;
  round.outerLoop = options.outerLoop;
  const CircleDomainResult conformal = circleDomainMap(surface, round, execution.part(0, 0.4));
  PolyAnnulusTransportResult result;
  result.status = Status::Cancelled;
  if (conformal.status == Status::Cancelled) return result;
  const std::vector<std::size_t> holes = holesOf(conformal);
  result.circles = conformal.circles;
  result.outerLoop = conformal.outerLoop;
  result.sites = sitesOf(conformal, holes);
  result.holeAreas = areasOf(surface, conformal, holes, options);
  result.masses = massesOf(surface, shares, result.holeAreas);
  requireDistinctImages(result.sites);
  result.startSeconds = secondsSince(begun);
  PowerDiagram diagram(result.sites, PlanarDomain::disk());
  static_cast<TransportSolution&>(result) =
      semiDiscreteTransport(diagram, result.masses, options, {}, execution.part(0.4, 0.95));
  takeCells(surface, holes, diagram, result);
  result.transportSeconds = secondsSince(begun) - result.startSeconds;
  execution.report(1, "Optimal transport");
  return result;
}

}  // namespace authalic
