#include "Core/authalic/AuthalicMap.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <string>
#include <utility>

#include "Core/authalic/AreaSolve.h"
#include "Core/authalic/PlanarAreas.h"
#include "Core/authalic/RoomOnCircle.h"
#include "Core/authalic/StretchStart.h"
#include "Core/initial/Unfold.h"
#include "Core/base/Error.h"
#include "Core/geometry/Areas.h"

namespace authalic {
namespace {

constexpr double kWithinSight = 0.2;  // mean |ln r| of the stars, from where face steps converge
constexpr double kWellInSight = 0.1;  // the same for a start that gets better with every round
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

struct Start {
  Points2 image;
  int folded = 0;
  bool stretched = false;  // another one may lead farther
};

Start makeStart(const DiskMesh& disk, const BoundaryPlacement& placement, Points2& image, const TargetMeasure& target,
                const AuthalicMapOptions& options, bool given, const Execution& execution) {
  for (std::size_t i = 0; i < placement.vertices.size(); ++i) {
    image.row(placement.vertices[i]) = placement.points.row(static_cast<Eigen::Index>(i));
  }
  Start start;
  if (given && farthestStar(disk, target, image) <= kUsable) {
    UnfoldResult unfolded = unfold(disk.topology(), image, execution);
    start = {std::move(unfolded.image), unfolded.flippedFaces};
  } else {
    for (const StretchRounds rounds : kStretchRoundsInTurn) {
      StretchStart made =
          stretchStart(disk, image, target, options.solver, kWithinSight, kWellInSight, rounds, execution);
      start = {std::move(made.opened.image), made.opened.flippedFaces, made.stretched};
      if (start.folded == 0 || !start.stretched || execution.cancelled()) break;
    }
  }
  if (start.folded > 0 && !execution.cancelled()) {
    throw GeometryError("An initial map that can be unfolded is required, but " + std::to_string(start.folded) +
                        " faces stay folded; take a convex domain.");
  }
  return start;
}

// A stretched start has half of the iterations; where they do not suffice, a balanced one has the rest.
AreaSolveResult solve(const PlanarAreas& areas, const DiskMesh& disk, const TargetMeasure& target, const Start& start,
                      const Points2& boundary, AuthalicMapOptions options, const Execution& execution,
                      AnalysedSystems& systems) {
  if (!start.stretched) {
    return solveAreas(areas, disk.mesh(), target, start.image, options, execution, Shapes::Kept, &systems);
  }
  const int all = options.maxIterations;
  options.maxIterations = (all + 1) / 2;
  AreaSolveResult solved = solveAreas(areas, disk.mesh(), target, start.image, options, execution.part(0, 0.6),
                                      Shapes::Kept, &systems);
  options.maxIterations = all - solved.iterations;
  if (solved.status == Status::Converged || solved.status == Status::Cancelled || options.maxIterations == 0) {
    return solved;
  }
  const UnfoldResult other = stretchStart(disk, boundary, target, options.solver, kWithinSight, kWellInSight,
                                          StretchRounds::None, execution.part(0.6, 0.7)).opened;
  if (other.flippedFaces > 0) return solved;
  AreaSolveResult second =
      solveAreas(areas, disk.mesh(), target, other.image, options, execution.part(0.7, 1), Shapes::Free, &systems);
  const bool cancelled = second.status == Status::Cancelled;
  AreaSolveResult& better = giveBetterTheEffortOfBoth(solved, second) ? second : solved;
  if (cancelled) better.status = Status::Cancelled;
  return std::move(better);
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
                              const Points2& initial, const Execution& execution, AnalysedSystems* systems) {
  options.validate();
  requireTargetOf(disk.mesh(), target);
  const auto begun = std::chrono::steady_clock::now();
  const bool given = initial.size() > 0;
  const BoundaryPlacement placement = placed(disk, target, options.domain, initial);
  Points2 image = given ? initial : Points2(Points2::Zero(disk.mesh().vertexCount(), 2));
  const Start start = makeStart(disk, placement, image, target, options, given, execution.part(0, 0.2));
  const SlidingBoundary sliding(placement, options.domain, image);
  const PlanarAreas areas(disk.mesh().faces(), sliding, target.vertices());
  AuthalicMapResult result;
  result.startSeconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
  AnalysedSystems own(execution.threads());
  AreaSolveResult solved = solve(areas, disk, target, start, image, options, execution.part(0.2, 1),
                                 systems != nullptr ? *systems : own);
  result.image = solved.image;
  solved.startSeconds = result.startSeconds;
  static_cast<AuthalicSolution&>(result) = std::move(solved);
  result.flippedFaces = countFlippedFaces(result.image, disk.mesh().faces());
  execution.report(1, "Authalic map");
  return result;
}

}  // namespace authalic
