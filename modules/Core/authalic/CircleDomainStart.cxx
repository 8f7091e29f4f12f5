#include "Core/authalic/CircleDomainStart.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "Core/authalic/FilledHolesStart.h"
#include "Core/authalic/LevelShares.h"
#include "Core/authalic/LieFlowStages.h"
#include "Core/authalic/PeriodicRectangleAuthalicMap.h"
#include "Core/base/Error.h"
#include "Core/conformal/AnnulusMap.h"
#include "Core/conformal/CircleDomainMap.h"
#include "Core/geometry/Areas.h"
#include "Core/initial/Untangle.h"
#include "Core/topology/LoopLength.h"

namespace authalic {
namespace {

constexpr double kOnCircle = 1e-9;  // of the radius: loop vertices farther off belong to pockets
constexpr double kSmallestRadius = 1e-12;  // of a hole anywhere in the disk: coordinates have 16 digits
constexpr double kTight = 0.95;     // of the room around a hole
constexpr double kNear = 0.1;       // residual of the faces on the rectangle
constexpr double kWithinSight = 0.5;  // mean |ln r| of the stars: a conformal start is good enough

// The start before holes have their areas.
struct ConformalStart {
  Status status = Status::NotRun;
  Points2 image;
  std::vector<FittedCircle> circles;  // of every loop
  int outerLoop = 0, pockets = 0;
};

ConformalStart conformalStart(const PolyAnnulusMesh& surface, const CircleDomainHoles& holes,
                              const Execution& execution) {
  if (!holes.concentric) {
    CircleDomainOptions round;
    round.outerLoop = holes.outerLoop;
    CircleDomainResult map = circleDomainMap(surface, round, execution);
    return {map.status, std::move(map.image), std::move(map.circles), map.outerLoop, map.pockets};
  }
  AnnulusMapOptions ring;
  ring.outerLoop = holes.outerLoop;
  AnnulusMapResult map = annulusMap(AnnulusMesh(surface.mesh()), ring, execution);
  const int outer = holes.outerLoop >= 0 ? holes.outerLoop
                                           : static_cast<int>(longestLoop(surface.mesh(), surface.loops()));
  std::vector<FittedCircle> circles(2);
  circles[static_cast<std::size_t>(outer)].radius = 1;
  circles[static_cast<std::size_t>(1 - outer)].radius = map.innerRadius;
  return {map.status, std::move(map.image), std::move(circles), outer, map.pockets};
}

// Outer loop first; holes in the order of the surface's loops.
std::vector<LoopOnCircle> loopsOf(const PolyAnnulusMesh& surface, const ConformalStart& conformal,
                                  const std::vector<double>& holeAreas, bool concentric) {
  double whole = faceAreas(surface.mesh()).sum();
  for (const double area : holeAreas) whole += area;
  std::vector<LoopOnCircle> loops(1);
  for (std::size_t k = 0, hole = 0; k < surface.loops().size(); ++k) {
    const FittedCircle& circle = conformal.circles[k];
    const bool outer = static_cast<int>(k) == conformal.outerLoop;
    LoopOnCircle loop;
    if (!outer) {
      loop.centre = circle.centre;
      loop.share = holeAreas[hole++] / whole;
    }
    for (const int v : surface.loops()[k]) {
      const double off = (conformal.image.row(v) - circle.centre).norm() / circle.radius - 1;
      if (std::abs(off) < kOnCircle) loop.vertices.push_back(v);
    }
    if (loop.vertices.size() < 3 || (!concentric && !(circle.radius > kSmallestRadius))) {
      throw GeometryError("Boundary loops that are circles in the conformal map are required, but loop " +
                          std::to_string(k) + " of " + std::to_string(surface.loops()[k].size()) +
                          " vertices is shrunk so far that they do not lie on a circle any more; for a long tube take "
                          "the domain periodic-rectangle.");
    }
    if (outer) loops.front() = std::move(loop);
    else loops.push_back(std::move(loop));
  }
  return loops;
}

// How far around a hole the plane may be stretched: to the outer circle, and half of the way to other holes.
double roomAround(std::size_t hole, const std::vector<LoopOnCircle>& loops, const std::vector<double>& radii) {
  double room = 1 - loops[hole].centre.norm();
  for (std::size_t k = 1; k < loops.size(); ++k) {
    if (k == hole) continue;
    const double distance = (loops[k].centre - loops[hole].centre).norm();
    room = std::min(room, 0.5 * (distance + radii[hole] - radii[k]));
  }
  return room;
}

// Every hole to its radius by a radial map that is the identity where the room around it ends.
void stretchHoles(const CircleDomainAreas& areas, const std::vector<LoopOnCircle>& loops, Points2& image) {
  std::vector<double> radii(loops.size(), 1), wanted(loops.size(), 1);
  for (std::size_t k = 1; k < loops.size(); ++k) {
    radii[k] = (image.row(loops[k].vertices.front()) - loops[k].centre).norm();
    wanted[k] = areas.radius(image, k);
  }
  for (std::size_t k = 1; k < loops.size(); ++k) {
    const double room = roomAround(k, loops, radii);
    if (!(wanted[k] < kTight * room)) {
      throw GeometryError("Hole areas that fit beside each other are required, but a hole around (" +
                          std::to_string(loops[k].centre[0]) + ", " + std::to_string(loops[k].centre[1]) +
                          ") of the unit disk needs the radius " + std::to_string(wanted[k]) + " and has room for " +
                          std::to_string(kTight * room) + "; take smaller hole areas.");
    }
    for (Eigen::Index v = 0; v < image.rows(); ++v) {
      const Eigen::RowVector2d arm = image.row(v) - loops[k].centre;
      const double r = arm.norm();
      if (!(r < room) || r == 0) continue;
      const double onto = r <= radii[k] ? r * wanted[k] / radii[k]
                                        : wanted[k] + (r - radii[k]) * (room - wanted[k]) / (room - radii[k]);
      image.row(v) = loops[k].centre + arm * (onto / r);
    }
  }
}

// Every circle around the middle to the radius at which it has its share of the target inside.
// What lies in the hole goes with its circle.
void spreadRings(const TargetMeasure& target, const std::vector<LoopOnCircle>& loops, double inner, Points2& image) {
  const double before = image.row(loops[1].vertices.front()).norm();
  const Eigen::VectorXd radii = image.rowwise().norm();
  const LevelShares within(radii.array().max(before).log(), target.vertices());
  const double hole = inner * inner;
  for (Eigen::Index v = 0; v < image.rows(); ++v) {
    const double onto = std::sqrt(hole + (1 - hole) * within.at(std::log(radii[v])));
    image.row(v) *= radii[v] < before ? inner / before : onto / radii[v];
  }
  for (const LoopOnCircle& loop : loops) {
    const double onto = &loop == &loops.front() ? 1 : inner;
    for (const int v : loop.vertices) image.row(v) *= onto / image.row(v).norm();
  }
}

Points2 stretched(const PolyAnnulusMesh& surface, const TargetMeasure& target, const CircleDomainAreas& areas,
                  const std::vector<LoopOnCircle>& loops, bool concentric, Points2 image, const Execution& execution) {
  if (concentric) spreadRings(target, loops, areas.radius(image, 1), image);
  else stretchHoles(areas, loops, image);
  UnfoldResult unfolded = unfold(surface.topology(), image, execution);
  if (unfolded.flippedFaces > 0 && !execution.cancelled()) unfolded = untangle(surface.topology(), std::move(image));
  if (unfolded.flippedFaces > 0 && !execution.cancelled()) {
    throw GeometryError("A start that can be unfolded is required, but " + std::to_string(unfolded.flippedFaces) +
                        " faces stay folded around the holes; take hole areas nearer to those of the conformal map.");
  }
  return std::move(unfolded.image);
}

// Where the surface's own areas are asked for, those of the cones.
std::vector<double> areasOfHoles(const PolyAnnulusMesh& surface, const std::vector<double>& asked, int outer) {
  std::vector<double> areas = asked;
  for (std::size_t k = 0; k < surface.loops().size() && asked.empty(); ++k) {
    if (static_cast<int>(k) != outer) areas.push_back(loopConeArea(surface.mesh(), surface.loops()[k]));
  }
  return areas;
}

CircleDomainStart fromConformal(const PolyAnnulusMesh& surface, const TargetMeasure& target,
                                const CircleDomainHoles& holes, const Execution& execution) {
  const ConformalStart conformal = conformalStart(surface, holes, execution.part(0, 0.7));
  CircleDomainStart start;
  if (conformal.status == Status::Cancelled) return start;
  start.outerLoop = conformal.outerLoop;
  start.pockets = conformal.pockets;
  start.holeAreas = areasOfHoles(surface, holes.holeAreas, start.outerLoop);
  start.loops = loopsOf(surface, conformal, start.holeAreas, holes.concentric);
  const CircleDomainAreas areas(surface.mesh().faces(), start.loops, surface.mesh().vertexCount());
  start.image = stretched(surface, target, areas, start.loops, holes.concentric, conformal.image,
                          execution.part(0.7, 1));
  return start;
}

CircleDomainStart fromFilled(const PolyAnnulusMesh& surface, const TargetMeasure& target,
                             const CircleDomainHoles& holes, SolverBackend backend, const Execution& execution) {
  CircleDomainStart start;
  start.road = HolesRoad::AreasFirst;
  start.outerLoop = holes.outerLoop >= 0 ? holes.outerLoop
                                           : static_cast<int>(longestLoop(surface.mesh(), surface.loops()));
  start.holeAreas = areasOfHoles(surface, holes.holeAreas, start.outerLoop);
  RoundedHoles round = filledHolesStart(surface, target, start.holeAreas, start.outerLoop, backend, execution);
  if (execution.cancelled()) return start;
  if (round.folded > 0) {
    throw GeometryError("Hole areas that fit beside each other are required, but " + std::to_string(round.folded) +
                        " faces stay folded between round holes; take smaller hole areas.");
  }
  start.loops = std::move(round.loops);
  start.pockets = round.pockets;
  start.image = std::move(round.image);
  return start;
}

// The periodic rectangle with areas near their targets, rolled up: what lies below y lies outside of its circle.
CircleDomainStart fromRectangle(const PolyAnnulusMesh& surface, const TargetMeasure& target,
                                const CircleDomainHoles& holes, SolverBackend backend, const Execution& execution) {
  PeriodicRectangleAuthalicMapOptions near;
  near.outerLoop = holes.outerLoop;
  near.solve.tolerance = kNear;
  near.solve.vertexTolerance = std::numeric_limits<double>::infinity();
  near.solve.solver = backend;
  const auto map = periodicRectangleAuthalicMap(AnnulusMesh(surface.mesh()), target, near, execution);
  CircleDomainStart start;
  start.road = HolesRoad::AreasFirst;
  if (execution.cancelled()) return start;
  start.outerLoop = map.outerLoop;
  start.holeAreas = areasOfHoles(surface, holes.holeAreas, start.outerLoop);
  start.pockets = map.pockets;
  const double ground = faceAreas(surface.mesh()).sum(), hole = start.holeAreas[0] / (ground + start.holeAreas[0]);
  start.image.resize(surface.mesh().vertexCount(), 2);
  for (Eigen::Index v = 0; v < start.image.rows(); ++v) {
    const double up = std::max(map.image(v, 1) / map.height, 0.0), angle = 2 * M_PI * map.image(v, 0),
                 radius = std::sqrt(std::max(hole + (1 - hole) * (1 - up), 0.25 * hole));
    start.image.row(v) << radius * std::cos(angle), radius * std::sin(angle);
  }
  start.loops.resize(2);
  start.loops[1].share = hole;
  for (std::size_t k = 0; k < 2; ++k) {
    const bool outer = static_cast<int>(k) == start.outerLoop;
    for (const int v : surface.loops()[k]) {
      if (outer || std::abs(map.image(v, 1) / map.height - 1) < kOnCircle) {
        start.loops[outer ? 0 : 1].vertices.push_back(v);
      }
    }
  }
  const CircleDomainAreas areas(surface.mesh().faces(), start.loops, surface.mesh().vertexCount());
  start.image = areas.moved(start.image, Coordinates::Zero(start.image.rows(), 2), 0);
  UnfoldResult unfolded = unfoldOrUntangle(surface.topology(), start.image);
  if (unfolded.flippedFaces > 0) {
    throw GeometryError("A start that can be unfolded is required, but " + std::to_string(unfolded.flippedFaces) +
                        " faces stay folded on the annulus; take the domain periodic-rectangle.");
  }
  start.image = std::move(unfolded.image);
  return start;
}

CircleDomainStart areasFirst(const PolyAnnulusMesh& surface, const TargetMeasure& target,
                             const CircleDomainHoles& holes, SolverBackend backend, const Execution& execution) {
  return holes.concentric ? fromRectangle(surface, target, holes, backend, execution)
                          : fromFilled(surface, target, holes, backend, execution);
}

double meanAbsLog(const PolyAnnulusMesh& surface, const TargetMeasure& target, const Points2& image) {
  const Faces& faces = surface.mesh().faces();
  return measureStars(vertexStars(signedFaceAreas(image, faces), faces, surface.mesh().vertexCount()),
                      target.vertices()).meanAbsLog;
}

}  // namespace

CircleDomainStart circleDomainStart(const PolyAnnulusMesh& surface, const TargetMeasure& target,
                                    const CircleDomainHoles& holes, HolesRoad road, SolverBackend backend,
                                    const Execution& execution) {
  if (road == HolesRoad::AreasFirst) return areasFirst(surface, target, holes, backend, execution);
  if (road == HolesRoad::Conformal) return fromConformal(surface, target, holes, execution);
  CircleDomainStart conformal;
  std::string refused;
  try {
    conformal = fromConformal(surface, target, holes, execution.part(0, 0.4));
    if (conformal.image.rows() == 0) return conformal;  // cancelled
    if (meanAbsLog(surface, target, conformal.image) <= kWithinSight) return conformal;
  } catch (const GeometryError& error) {
    refused = error.what();
  }
  try {
    CircleDomainStart filled = areasFirst(surface, target, holes, backend, execution.part(0.4, 1));
    const bool nearer = filled.image.rows() == 0 || conformal.image.rows() == 0 ||
                        meanAbsLog(surface, target, filled.image) < meanAbsLog(surface, target, conformal.image);
    return nearer ? filled : conformal;
  } catch (const GeometryError&) {
    if (conformal.image.rows() > 0) return conformal;
    throw GeometryError(refused);
  }
}

CircleDomainImage imageOf(const CircleDomainStart& start, const Points2& image) {
  CircleDomainImage result;
  result.image = image;
  result.outerLoop = start.outerLoop;
  result.holeAreas = start.holeAreas;
  result.pockets = start.pockets;
  const std::vector<LoopOnCircle>& loops = start.loops;
  const double whole = polygonArea(image, loops.front().vertices);
  for (std::size_t k = 1; k < loops.size(); ++k) {
    const double ratio = -polygonArea(image, loops[k].vertices) / (whole * loops[k].share);
    result.holeResidual = std::max(result.holeResidual, std::abs(std::log(ratio)));
    result.circles.push_back(fitCircle(image, loops[k].vertices));
  }
  result.circles.insert(result.circles.begin() + start.outerLoop, fitCircle(image, loops.front().vertices));
  return result;
}

}  // namespace authalic
