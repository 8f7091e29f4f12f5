#include "Core/authalic/CircleDomainFinish.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "Core/authalic/AreaSolve.h"
#include "Core/authalic/CircleDomainStart.h"
#include "Core/authalic/FilledHolesStart.h"
#include "Core/authalic/Stopwatch.h"
#include "Core/base/Error.h"
#include "Core/geometry/Areas.h"
#include "Core/initial/Untangle.h"

namespace authalic {
namespace {

void requireOf(const PolyAnnulusMesh& surface, const Points2& image, const HolesInDisk& holes) {
  const Eigen::Index n = surface.mesh().vertexCount();
  if (image.rows() != n || !image.allFinite()) {
    throw GeometryError("An image with one finite point per vertex (" + std::to_string(n) +
                        ") is required, but it has " + std::to_string(image.rows()) + " points.");
  }
  const std::size_t count = surface.loops().size() - 1;
  if (static_cast<std::size_t>(holes.centres.rows()) != count || holes.areas.size() != count) {
    throw GeometryError("One centre and one area for each of the " + std::to_string(count) +
                        " holes are required, but there are " + std::to_string(holes.centres.rows()) + " and " +
                        std::to_string(holes.areas.size()) + ".");
  }
}

// Outer loop first; holes in the order of the surface's loops.
std::vector<LoopOnCircle> loopsOf(const PolyAnnulusMesh& surface, const HolesInDisk& holes) {
  double whole = faceAreas(surface.mesh()).sum();
  for (const double area : holes.areas) whole += area;
  std::vector<LoopOnCircle> loops(1);
  for (std::size_t k = 0, hole = 0; k < surface.loops().size(); ++k) {
    LoopOnCircle loop;
    for (const int v : surface.loops()[k]) {
      const bool pocket = std::find(holes.pockets.begin(), holes.pockets.end(), v) != holes.pockets.end();
      if (!pocket) loop.vertices.push_back(v);
    }
    if (static_cast<int>(k) == holes.outerLoop) {
      loops.front().vertices = std::move(loop.vertices);
      continue;
    }
    loop.centre = holes.centres.row(static_cast<Eigen::Index>(hole));
    loop.share = holes.areas[hole++] / whole;
    loops.push_back(std::move(loop));
  }
  return loops;
}

// How far a loop is from its centre, by direction: linear between its vertices.
class LoopRadius {
 public:
  LoopRadius(const Points2& image, const LoopOnCircle& loop) {
    for (const int v : loop.vertices) {
      const Eigen::RowVector2d arm = image.row(v) - loop.centre;
      places_.emplace_back(std::atan2(arm[1], arm[0]), arm.norm());
    }
    std::sort(places_.begin(), places_.end());
  }
  [[nodiscard]] double at(double angle) const {
    const auto above = std::lower_bound(places_.begin(), places_.end(), std::make_pair(angle, 0.0));
    const auto& next = above == places_.end() ? places_.front() : *above;
    const auto& last = above == places_.begin() ? places_.back() : *(above - 1);
    const auto turned = [](double x) { return x < 0 ? x + 2 * M_PI : x; };
    const double width = turned(next.first - last.first), from = turned(angle - last.first);
    return width > 0 ? last.second + (next.second - last.second) * from / width : last.second;
  }

 private:
  std::vector<std::pair<double, double>> places_;  // angle, radius
};

// The inner loop k onto its circle, and the plane around it after it.
void makeRound(const CircleDomainAreas& areas, const std::vector<LoopOnCircle>& loops, std::size_t k,
               Points2& image) {
  const LoopOnCircle& loop = loops[k];
  const LoopRadius outline(image, loop);
  const double onto = areas.radius(image, k);
  for (Eigen::Index v = 0; v < image.rows(); ++v) {
    const Eigen::RowVector2d arm = image.row(v) - loop.centre;
    const double r = arm.norm();
    if (r == 0) continue;
    const double from = outline.at(std::atan2(arm[1], arm[0]));
    const double moved = r < from ? r * onto / from : r + (onto - from) * std::exp(-(r - from) / onto);
    image.row(v) = loop.centre + arm * (moved / r);
  }
}

// Every loop exactly onto its circle.
void putOnCircles(const CircleDomainAreas& areas, const std::vector<LoopOnCircle>& loops, Points2& image) {
  for (const int v : loops.front().vertices) image.row(v).normalize();
  for (std::size_t k = 1; k < loops.size(); ++k) {
    const double onto = areas.radius(image, k);
    for (const int v : loops[k].vertices) {
      const Eigen::RowVector2d arm = image.row(v) - loops[k].centre;
      image.row(v) = loops[k].centre + arm * (onto / arm.norm());
    }
  }
}

// Circles around the middles of their cells. Folds may stay.
UnfoldResult roundedInPlace(const PolyAnnulusMesh& surface, const CircleDomainAreas& areas,
                            const std::vector<LoopOnCircle>& loops, Points2 image, const Execution& execution) {
  for (std::size_t k = 1; k < loops.size(); ++k) makeRound(areas, loops, k, image);
  putOnCircles(areas, loops, image);
  UnfoldResult unfolded = unfold(surface.topology(), image, execution, UnfoldReach::Patches);
  if (unfolded.flippedFaces > 0 && !execution.cancelled()) unfolded = untangle(surface.topology(), image);
  if (unfolded.flippedFaces > 0 && !execution.cancelled()) {
    unfolded = untangle(surface.topology(), unfold(surface.topology(), std::move(image), execution).image);
  }
  return unfolded;
}

// The image as one of a disk, holes closed by cones, unfolded: so that holes can be moved where there is room for them.
Points2 unfoldedWithCones(const PolyAnnulusMesh& surface, const Points2& image, const HolesInDisk& holes,
                          const Execution& execution) {
  const TriangleMesh mesh = closedByCones(surface, holes.outerLoop);
  const SurfaceTopology closed(mesh.faces(), mesh.vertexCount());
  Points2 places(image.rows() + holes.centres.rows(), 2);
  places << image, holes.centres;
  return unfold(closed, std::move(places), execution).image.topRows(image.rows());
}

// Fills in where circles are, and the image around them.
CircleFreedom makeHolesRound(const PolyAnnulusMesh& surface, const Points2& image, const HolesInDisk& holes,
                             SolverBackend backend, const Execution& execution, CircleDomainStart& start) {
  start.loops = loopsOf(surface, holes);
  const CircleDomainAreas areas(surface.mesh().faces(), start.loops, surface.mesh().vertexCount());
  UnfoldResult unfolded = roundedInPlace(surface, areas, start.loops, image, execution.part(0, 0.4));
  start.image = std::move(unfolded.image);
  if (unfolded.flippedFaces == 0 || execution.cancelled()) return {};
  std::vector<double> shares;
  for (std::size_t k = 1; k < start.loops.size(); ++k) shares.push_back(start.loops[k].share);
  RoundedHoles round = roundHoles(surface, unfoldedWithCones(surface, image, holes, execution.part(0.4, 0.6)), shares,
                                  holes.outerLoop, backend, execution.part(0.6, 1));
  if (round.folded > 0 && !execution.cancelled()) {
    throw GeometryError("An image that can be unfolded around round holes is required, but " +
                        std::to_string(round.folded) +
                        " faces stay folded; take smaller hole areas, or an authalic map to the circle domain.");
  }
  start.image = std::move(round.image);
  start.loops = std::move(round.loops);
  start.pockets = round.pockets;
  return {true, false};
}

}  // namespace

CircleDomainAuthalicMapResult finishCircleDomain(const PolyAnnulusMesh& surface, const TargetMeasure& target,
                                                 const Points2& image, const HolesInDisk& holes,
                                                 const AuthalicMapOptions& options, const Execution& execution) {
  options.validate();
  requireTargetOf(surface.mesh(), target);
  requireOf(surface, image, holes);
  Stopwatch watch;
  CircleDomainStart start;
  start.holeAreas = holes.areas;
  start.outerLoop = holes.outerLoop;
  start.pockets = static_cast<int>(holes.pockets.size());
  const CircleFreedom freedom =
      makeHolesRound(surface, image, holes, options.solver, execution.part(0, 0.2), start);
  const double startSeconds = watch.lap();
  const CircleDomainAreas areas(surface.mesh().faces(), start.loops, surface.mesh().vertexCount(), freedom);
  AreaSolveResult solved =
      solveAreas(areas, surface.mesh(), target, areas.begun(start.image), options, execution.part(0.2, 1));
  CircleDomainAuthalicMapResult result;
  static_cast<CircleDomainImage&>(result) = imageOf(start, areas.ended(solved.image, start.loops));
  static_cast<AuthalicSolution&>(result) = std::move(solved);
  result.startSeconds = startSeconds;
  result.flippedFaces = countFlippedFaces(result.image, surface.mesh().faces());
  execution.report(1, "Authalic map");
  return result;
}

}  // namespace authalic
