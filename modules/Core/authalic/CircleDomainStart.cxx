#include "Core/authalic/CircleDomainStart.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <utility>

#include "Core/authalic/AuthalicMap.h"
#include "Core/authalic/LevelShares.h"
#include "Core/authalic/RoundHoles.h"
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

double coneArea(const TriangleMesh& mesh, const std::vector<int>& loop) {
  Eigen::Vector3d tip = Eigen::Vector3d::Zero();
  for (const int v : loop) tip += mesh.point(v) / static_cast<double>(loop.size());
  double area = 0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Eigen::Vector3d a = mesh.point(loop[i]) - tip, b = mesh.point(loop[(i + 1) % loop.size()]) - tip;
    area += 0.5 * a.cross(b).norm();
  }
  return area;
}

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

// The surface with a cone on every hole.
TriangleMesh filled(const PolyAnnulusMesh& surface, int outer) {
  const TriangleMesh& mesh = surface.mesh();
  std::vector<Eigen::RowVector3i> cones;
  std::vector<Eigen::RowVector3d> tips;
  for (std::size_t k = 0; k < surface.loops().size(); ++k) {
    const std::vector<int>& loop = surface.loops()[k];
    if (static_cast<int>(k) == outer) continue;
    const int tip = mesh.vertexCount() + static_cast<int>(tips.size());
    Eigen::RowVector3d mean = Eigen::RowVector3d::Zero();
    for (std::size_t i = 0; i < loop.size(); ++i) {
      mean += mesh.points().row(loop[i]) / static_cast<double>(loop.size());
      cones.emplace_back(loop[(i + 1) % loop.size()], loop[i], tip);
    }
    tips.push_back(mean);
  }
  Points3 points(mesh.vertexCount() + static_cast<Eigen::Index>(tips.size()), 3);
  points.topRows(mesh.vertexCount()) = mesh.points();
  for (std::size_t t = 0; t < tips.size(); ++t) points.row(mesh.vertexCount() + static_cast<Eigen::Index>(t)) = tips[t];
  Faces faces(mesh.faceCount() + static_cast<Eigen::Index>(cones.size()), 3);
  faces.topRows(mesh.faceCount()) = mesh.faces();
  for (std::size_t c = 0; c < cones.size(); ++c) faces.row(mesh.faceCount() + static_cast<Eigen::Index>(c)) = cones[c];
  return TriangleMesh(std::move(points), std::move(faces));
}

CircleDomainStart filledStart(const PolyAnnulusMesh& surface, const TargetMeasure& target, CircleDomainStart start,
                              const Execution& execution) {
  const DiskMesh disk(filled(surface, start.outerLoop));
  const Eigen::VectorXd areas = faceAreas(disk.mesh());
  const double ground = areas.head(surface.mesh().faceCount()).sum();
  double whole = ground;
  for (const double area : start.holeAreas) whole += area;
  Eigen::VectorXd density(areas.size());
  density.head(surface.mesh().faceCount()) =
      (target.faces().array() * ground / areas.head(surface.mesh().faceCount()).array().max(1e-300)).max(1e-300);
  Eigen::Index f = surface.mesh().faceCount();
  std::vector<double> shares;
  for (std::size_t k = 0; k < surface.loops().size(); ++k) {
    if (static_cast<int>(k) == start.outerLoop) continue;
    const auto count = static_cast<Eigen::Index>(surface.loops()[k].size());
    density.segment(f, count).setConstant(start.holeAreas[shares.size()] / areas.segment(f, count).sum());
    shares.push_back(start.holeAreas[shares.size()] / whole);
    f += count;
  }
  AuthalicMapOptions near;
  near.tolerance = 0.1;
  near.vertexTolerance = 1e300;
  near.maxIterations = 30;
  const AuthalicMapResult map = authalicMap(disk, TargetMeasure::fromFaceDensity(disk.mesh(), density), near, {},
                                            execution.part(0, 0.7));
  const RoundedHoles round = roundHoles(surface, map.image.topRows(surface.mesh().vertexCount()), shares,
                                        start.outerLoop, near.solver, execution.part(0.7, 1));
  start.image = round.image;
  start.loops = round.loops;
  start.pockets = round.pockets;
  if (std::getenv("HOLESDBG")) fprintf(stderr, "filled: status %d it %d face %g folded %d, after rounding %d\n", int(map.status), map.iterations, map.faceResidual, map.flippedFaces, round.folded);
  return start;
}

}  // namespace

CircleDomainStart circleDomainStart(const PolyAnnulusMesh& surface, const TargetMeasure& target,
                                    const CircleDomainHoles& holes, const Execution& execution) {
  if (!holes.concentric && std::getenv("HOLESFILL")) {
    CircleDomainStart start;
    start.outerLoop = holes.outerLoop >= 0 ? holes.outerLoop : static_cast<int>(longestLoop(surface.mesh(), surface.loops()));
    start.holeAreas = holes.holeAreas;
    for (std::size_t k = 0; k < surface.loops().size() && holes.holeAreas.empty(); ++k) {
      if (static_cast<int>(k) != start.outerLoop) start.holeAreas.push_back(coneArea(surface.mesh(), surface.loops()[k]));
    }
    return filledStart(surface, target, start, execution);
  }
  const ConformalStart conformal = conformalStart(surface, holes, execution.part(0, 0.7));
  CircleDomainStart start;
  if (conformal.status == Status::Cancelled) return start;
  start.outerLoop = conformal.outerLoop;
  start.pockets = conformal.pockets;
  start.holeAreas = holes.holeAreas;
  for (std::size_t k = 0; k < surface.loops().size() && holes.holeAreas.empty(); ++k) {
    if (static_cast<int>(k) != conformal.outerLoop) {
      start.holeAreas.push_back(coneArea(surface.mesh(), surface.loops()[k]));
    }
  }
  start.loops = loopsOf(surface, conformal, start.holeAreas, holes.concentric);
  const CircleDomainAreas areas(surface.mesh().faces(), start.loops, surface.mesh().vertexCount());
  start.image = stretched(surface, target, areas, start.loops, holes.concentric, conformal.image,
                          execution.part(0.7, 1));
  return start;
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
