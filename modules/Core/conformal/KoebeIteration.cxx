#include "Core/conformal/KoebeIteration.h"

#include <algorithm>
#include <utility>

#include "Core/conformal/RiemannMap.h"
#include "Core/mesh/DiskMesh.h"
#include "Core/numerics/Mobius.h"

namespace authalic {
namespace {

using Loops = std::vector<std::vector<int>>;

// All loops but one closed by a fan around a new vertex, which the caller has put at the end of the points.
DiskMesh fillHoles(Points3 points, const Faces& faces, const Loops& loops, std::size_t open) {
  Eigen::Index fans = 0;
  for (std::size_t k = 0; k < loops.size(); ++k) fans += k == open ? 0 : static_cast<Eigen::Index>(loops[k].size());
  Faces filled(faces.rows() + fans, 3);
  filled.topRows(faces.rows()) = faces;
  Eigen::Index row = faces.rows();
  int apex = static_cast<int>(points.rows() - static_cast<Eigen::Index>(loops.size()) + 1);
  for (std::size_t k = 0; k < loops.size(); ++k) {
    if (k == open) continue;
    for (std::size_t i = 0; i < loops[k].size(); ++i) filled.row(row++) << loops[k][(i + 1) % loops[k].size()], loops[k][i], apex;
    ++apex;
  }
  return DiskMesh(TriangleMesh(std::move(points), std::move(filled)));
}

// The surface in space, its holes closed at their means.
DiskMesh fillSurface(const TriangleMesh& mesh, const Loops& loops, std::size_t open) {
  Points3 points(mesh.vertexCount() + static_cast<Eigen::Index>(loops.size()) - 1, 3);
  points.topRows(mesh.vertexCount()) = mesh.points();
  Eigen::Index apex = mesh.vertexCount();
  for (std::size_t k = 0; k < loops.size(); ++k) {
    if (k == open) continue;
    points.row(apex).setZero();
    for (const int v : loops[k]) points.row(apex) += mesh.points().row(v) / static_cast<double>(loops[k].size());
    ++apex;
  }
  return fillHoles(std::move(points), mesh.faces(), loops, open);
}

// The planar image turned inside out around one loop, its other holes closed at the centres of their circles.
DiskMesh fillImage(Points2 image, const Faces& faces, const Loops& loops, std::size_t open, std::size_t outermost) {
  if (open != outermost) {
    const FittedCircle hole = fitCircle(image, loops[open]);
    image = Mobius(0, hole.radius, 1, -Mobius::Complex(hole.centre[0], hole.centre[1]))(image);
  }
  Points3 points = Points3::Zero(image.rows() + static_cast<Eigen::Index>(loops.size()) - 1, 3);
  points.topLeftCorner(image.rows(), 2) = image;
  Eigen::Index apex = image.rows();
  for (std::size_t k = 0; k < loops.size(); ++k) {
    if (k != open) points.row(apex++).head(2) = fitCircle(image, loops[k]).centre;
  }
  return fillHoles(std::move(points), faces, loops, open);
}

// Make one loop the unit circle. Returns false when the flow gave up or was cancelled.
bool makeRound(const DiskMesh& filled, const CircleDomainOptions& options, const Execution& execution, int vertexCount,
               CircleDomainResult& result) {
  RiemannMapOptions riemann;
  riemann.flow = options.flow;
  const RiemannMapResult step = riemannMap(filled, riemann, execution);
  result.iterations += step.iterations;
  result.edgeFlips += step.edgeFlips;
  result.residual = step.residual;
  result.holonomy = step.holonomy;
  if (step.status != Status::Converged) result.status = step.status;
  if (step.status == Status::Cancelled) return false;
  result.image = step.image.topRows(vertexCount);
  return step.status == Status::Converged;
}

double worstDeviation(const Points2& image, const Loops& loops) {
  double worst = 0;
  for (const auto& loop : loops) worst = std::max(worst, fitCircle(image, loop).deviation);
  return worst;
}

}  // namespace

void koebeIteration(const PolyAnnulusMesh& surface, const CircleDomainOptions& options, const Execution& execution,
                    CircleDomainResult& result) {
  const Loops& loops = surface.loops();
  const TriangleMesh& mesh = surface.mesh();
  const auto outer = static_cast<std::size_t>(result.outerLoop);
  const Execution silent = Execution({}, [&execution] { return execution.cancelled(); }, execution.threads());
  std::size_t outermost = outer;
  if (!makeRound(fillSurface(mesh, loops, outer), options, silent, mesh.vertexCount(), result)) return;
  while (result.status == Status::NotRun) {
    if (worstDeviation(result.image, loops) <= options.roundness) {
      result.status = Status::Converged;
    } else if (result.rounds >= options.maxRounds) {
      result.status = Status::NotConverged;
    } else {
      execution.report(0.9 * result.rounds / (result.rounds + 10.0), "Koebe iteration");
      // The outer loop comes last, so that it is outermost at the end of every round.
      for (std::size_t k = 1; k <= loops.size(); ++k) {
        const std::size_t open = (outer + k) % loops.size();
        const DiskMesh filled = fillImage(result.image, mesh.faces(), loops, open, outermost);
        outermost = open;
        if (!makeRound(filled, options, silent, mesh.vertexCount(), result)) return;
      }
      ++result.rounds;
    }
  }
}

}  // namespace authalic
