#include "Core/authalic/AuthalicMap.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <string>
#include <utility>

#include "Core/authalic/AreaSolve.h"
#include "Core/authalic/BalancedStart.h"
#include "Core/authalic/PlanarAreas.h"
#include "Core/authalic/RoomOnCircle.h"
#include "Core/initial/Unfold.h"
#include "Core/base/Error.h"
#include "Core/geometry/Areas.h"

namespace authalic {
namespace {

constexpr double kWithinSight = 0.2;  // mean |ln r| of the stars, from where face steps converge
constexpr double kUsable = 2;         // the same for a given initial map, which is then not balanced

void require(bool condition, const std::string& required, double found) {
  if (condition) return;
  throw InvalidArgument("Authalic map: " + required + " is required, but it is " + std::to_string(found) + ".");
}

// Largest |ln r| of the vertex stars.
double farthestStar(const DiskMesh& disk, const TargetMeasure& target, const Points2& image) {
  const Faces& faces = disk.mesh().faces();
  const Eigen::VectorXd stars = vertexStars(signedFaceAreas(image, faces), faces, disk.mesh().vertexCount());
  const double scale = target.vertices().sum() / stars.sum();
  double farthest = 0;
  for (Eigen::Index v = 0; v < stars.size(); ++v) {
    const double share = target.vertices()[v];
    if (share > 0) farthest = std::max(farthest, std::abs(std::log(std::max(stars[v] * scale / share, 1e-300))));
  }
  return farthest;
}

BoundaryPlacement placed(const DiskMesh& disk, const TargetMeasure& target, const PlanarDomain& domain,
                         const Points2& initial) {
  if (initial.size() > 0) return recogniseBoundary(disk, domain, initial);
  BoundaryPlacement placement = placeBoundary(disk, domain);
  if (domain.isDisk()) makeRoomOnCircle(disk, target, placement);
  return placement;
}

Points2 makeStart(const DiskMesh& disk, const BoundaryPlacement& placement, Points2 image, const TargetMeasure& target,
                  const AuthalicMapOptions& options, bool given, const Execution& execution) {
  for (std::size_t i = 0; i < placement.vertices.size(); ++i) {
    image.row(placement.vertices[i]) = placement.points.row(static_cast<Eigen::Index>(i));
  }
  if (!given || farthestStar(disk, target, image) > kUsable) {
    image = balancedStart(disk, image, target, options.solver, kWithinSight, execution);
    image = reviveCollapsedFaces(disk, image, target, options.solver);
  }
  UnfoldResult unfolded = unfold(disk.topology(), std::move(image), execution);
  if (unfolded.flippedFaces > 0 && !execution.cancelled()) {
    throw GeometryError("An initial map that can be unfolded is required, but " +
                        std::to_string(unfolded.flippedFaces) + " faces stay folded; take a convex domain.");
  }
  return std::move(unfolded.image);
}

}  // namespace

void AuthalicMapOptions::validate() const {
  require(tolerance > 0, "a tolerance above 0", tolerance);
  require(vertexTolerance > 0, "a vertex tolerance above 0", vertexTolerance);
  require(maxIterations >= 0, "a number of iterations of at least 0", maxIterations);
  if (!SparseSolver::available(solver)) {
    throw InvalidArgument("A solver that is part of this build is required, but " +
                          std::string(solverBackendName(solver)) + " was not built in.");
  }
}

AuthalicMapResult authalicMap(const DiskMesh& disk, const TargetMeasure& target, const AuthalicMapOptions& options,
                              const Points2& initial, const Execution& execution) {
  options.validate();
  requireTargetOf(disk.mesh(), target);
  const auto begun = std::chrono::steady_clock::now();
  const bool given = initial.size() > 0;
  const BoundaryPlacement placement = placed(disk, target, options.domain, initial);
  Points2 image = given ? initial : Points2(Points2::Zero(disk.mesh().vertexCount(), 2));
  image = makeStart(disk, placement, std::move(image), target, options, given, execution.part(0, 0.2));
  const SlidingBoundary sliding(placement, options.domain, image);
  const PlanarAreas areas(disk.mesh().faces(), sliding, disk.mesh().vertexCount());
  AuthalicMapResult result;
  const double startSeconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
  AreaSolveResult solved = solveAreas(areas, target, image, options, execution.part(0.2, 1));
  result.image = solved.image;
  static_cast<AuthalicSolution&>(result) = std::move(solved);
  result.startSeconds = startSeconds;
  result.flippedFaces = countFlippedFaces(result.image, disk.mesh().faces());
  execution.report(1, "Authalic map");
  return result;
}

}  // namespace authalic
