#include "Core/authalic/RectangleStart.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "Core/authalic/BalancedStart.h"
#include "Core/authalic/LevelShares.h"
#include "Core/authalic/LieFlowStages.h"
#include "Core/authalic/PeriodicStretch.h"
#include "Core/base/Error.h"
#include "Core/conformal/AnnulusMap.h"
#include "Core/geometry/Areas.h"
#include "Core/initial/Unfold.h"
#include "Core/topology/LoopLength.h"

namespace authalic {
namespace {

constexpr double kOnLine = 1e-9;       // of the height: loop vertices farther off belong to pockets
constexpr double kWithinSight = 0.3;   // mean |ln r| of the stars, from where face steps converge

std::size_t at(int i) { return static_cast<std::size_t>(i); }

// Corners that the cut has given copies lie one period on.
Points2 shiftsOf(const PeriodicRectangle& rectangle, int vertexCount) {
  const double period =
      rectangle.points(vertexCount, 0) - rectangle.points(rectangle.originalPointIds[at(vertexCount)], 0);
  Points2 shifts = Points2::Zero(rectangle.faces.size(), 2);
  for (Eigen::Index c = 0; c < shifts.rows(); ++c) {
    if (rectangle.faces.data()[c] >= vertexCount) shifts(c, 0) = period > 0 ? 1 : -1;
  }
  return shifts;
}

void findSides(const AnnulusMesh& annulus, RectangleStart& start) {
  start.freedom.assign(at(annulus.mesh().vertexCount()), 2);
  const std::vector<int>& outer = annulus.loops()[at(start.opened.outerLoop)];
  for (const std::vector<int>& loop : annulus.loops()) {
    const double line = &loop == &outer ? 0 : start.height;
    for (const int v : loop) {
      if (std::abs(start.image(v, 1) - line) < kOnLine * start.height) start.freedom[at(v)] = 1;
    }
  }
  start.held = *std::find_if(outer.begin(), outer.end(), [&](int v) { return start.freedom[at(v)] == 1; });
}

// Every row to the height below which its share of the target lies; pockets stay beyond the sides.
void spreadRows(const TargetMeasure& target, double height, Points2& image) {
  const LevelShares below(2 * M_PI * image.col(1).array().max(0).min(height), target.vertices());
  for (Eigen::Index v = 0; v < image.rows(); ++v) {
    double& y = image(v, 1);
    if (y > 0 && y < height) y = height * below.at(2 * M_PI * y);
  }
}

double meanAbsLog(const AnnulusMesh& annulus, const TargetMeasure& target, const RectangleStart& start) {
  const Faces& faces = annulus.mesh().faces();
  const Eigen::VectorXd areas = periodicFaceAreas(start.image, start.shifts, faces);
  return measureStars(vertexStars(areas, faces, annulus.mesh().vertexCount()), target.vertices()).meanAbsLog;
}

// Shear and height with the least Dirichlet energy, in place; see openRectangle().
void relax(const TriangleMesh& surface, const Points2& shifts, double& height, Points2& image) {
  const Eigen::Matrix2d m = periodicStretch(surface, image, shifts);
  const double shear = -m(0, 1) / m(1, 1), taller = std::sqrt((m(0, 0) + shear * m(0, 1)) / m(1, 1));
  image.col(0) += shear * image.col(1);
  image.col(1) *= taller;
  height *= taller;
}

void requireUnfolded(const AnnulusMesh& annulus, const RectangleStart& start) {
  const Eigen::VectorXd areas = periodicFaceAreas(start.image, start.shifts, annulus.mesh().faces());
  const auto folded = static_cast<int>((areas.array() <= 0).count());
  if (folded == 0) return;
  throw GeometryError("A start without folded faces is required, but " + std::to_string(folded) +
                      " faces stay folded on the periodic rectangle; refine the surface along its boundary.");
}

}  // namespace

std::vector<char> RectangleStart::heldFreedom() const {
  std::vector<char> result = freedom;
  result[at(held)] = 0;
  return result;
}

RectangleStart rectangleStart(const AnnulusMesh& annulus, const TargetMeasure& target, int outerLoop,
                              SolverBackend backend, const Execution& execution) {
  AnnulusMapOptions conformal;
  conformal.outerLoop = outerLoop;
  AnnulusMapResult map = annulusMap(annulus, conformal, execution.part(0, 0.7));
  RectangleStart start;
  if (map.status == Status::Cancelled) return start;
  const TriangleMesh& mesh = annulus.mesh();
  start.opened.outerLoop = outerLoop >= 0 ? outerLoop : static_cast<int>(longestLoop(mesh, annulus.loops()));
  start.opened.pockets = map.rectanglePockets;
  start.opened.cut = std::move(map.cut);
  start.shifts = shiftsOf(map.rectangle, mesh.vertexCount());
  start.image = map.rectangle.points.topRows(mesh.vertexCount());
  start.opened.faces = std::move(map.rectangle.faces);
  start.opened.originalPointIds = std::move(map.rectangle.originalPointIds);
  start.height = map.modulus;
  findSides(annulus, start);
  spreadRows(target, start.height, start.image);
  const Execution rest = execution.part(0.7, 1);
  UnfoldResult unfolded = unfold(annulus.topology(), start.image, rest, UnfoldReach::WholeMesh, start.shifts);
  start.image = std::move(unfolded.image);
  if (unfolded.flippedFaces > 0 || meanAbsLog(annulus, target, start) > kWithinSight) {
    start.image = balancedPeriodicStart(annulus.topology(), start.image, start.shifts, annulus.topology().onBoundary(),
                                        target, backend, kWithinSight, rest);
  }
  if (!execution.cancelled()) requireUnfolded(annulus, start);
  relax(mesh, start.shifts, start.height, start.image);
  return start;
}

PeriodicRectangleImage openRectangle(const AnnulusMesh& annulus, const RectangleStart& start, Points2 image) {
  PeriodicRectangleImage result = start.opened;
  result.height = start.height;
  relax(annulus.mesh(), start.shifts, result.height, image);
  image.col(0).array() -= image(start.held, 0);
  result.image.resize(static_cast<Eigen::Index>(result.originalPointIds.size()), 2);
  for (Eigen::Index c = 0; c < result.faces.size(); ++c) {
    result.image.row(result.faces.data()[c]) = image.row(annulus.mesh().faces().data()[c]) + start.shifts.row(c);
  }
  return result;
}

}  // namespace authalic
