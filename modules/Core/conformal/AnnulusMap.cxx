#include "Core/conformal/AnnulusMap.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <string>
#include <utility>

#include "Core/base/Error.h"
#include "Core/conformal/FlatCylinder.h"
#include "Core/conformal/Unfolding.h"
#include "Core/topology/LoopLength.h"

namespace authalic {
namespace {

std::size_t outerLoopOf(const AnnulusMesh& annulus, const AnnulusMapOptions& options) {
  if (options.outerLoop < -1 || options.outerLoop > 1) {
    throw InvalidArgument("A loop of the annulus (0 or 1) is required as the outer one, but it is " +
                          std::to_string(options.outerLoop) + ".");
  }
  if (options.outerLoop >= 0) return static_cast<std::size_t>(options.outerLoop);
  return longestLoop(annulus.mesh(), annulus.loops());
}

int startVertexOf(const std::vector<int>& outer, const AnnulusMapOptions& options) {
  if (options.startVertex == -1) return outer.front();
  if (std::find(outer.begin(), outer.end(), options.startVertex) == outer.end()) {
    throw InvalidArgument("A vertex of the outer loop is required at angle 0, but vertex " +
                          std::to_string(options.startVertex) + " is none.");
  }
  return options.startVertex;
}

PeriodicRectangle unroll(const FlatCylinder& cylinder, const Faces& faces, int vertexCount) {
  PeriodicRectangle rectangle;
  CutFaces open = openAlong(faces, vertexCount, cylinder.cut);
  rectangle.faces = std::move(open.faces);
  rectangle.originalPointIds = std::move(open.originalPointIds);
  rectangle.points.resize(static_cast<Eigen::Index>(rectangle.originalPointIds.size()), 2);
  rectangle.logScale.resize(rectangle.points.rows());
  for (Eigen::Index i = 0; i < rectangle.points.rows(); ++i) {
    const int v = rectangle.originalPointIds[static_cast<std::size_t>(i)];
    const double turns = i < vertexCount ? 0 : cylinder.turns;  // copies lie one period on
    rectangle.logScale[i] = cylinder.flow.logScale[v] - std::log(2 * M_PI);
    rectangle.points.row(i) << cylinder.strip(v, 1) / (2 * M_PI) + turns, -cylinder.strip(v, 0) / (2 * M_PI);
  }
  return rectangle;
}

void unfoldBoth(const AnnulusMesh& annulus, bool repair, AnnulusMapResult& result) {
  UnfoldedImage ring = unfoldImage(annulus.mesh(), annulus.topology(), std::move(result.image), repair);
  PeriodicRectangle& rectangle = result.rectangle;
  Points3 places(rectangle.points.rows(), 3);
  for (Eigen::Index i = 0; i < places.rows(); ++i) {
    places.row(i) = annulus.mesh().points().row(rectangle.originalPointIds[static_cast<std::size_t>(i)]);
  }
  const TriangleMesh opened(std::move(places), rectangle.faces);
  const SurfaceTopology topology(rectangle.faces, opened.vertexCount());
  UnfoldedImage flat = unfoldImage(opened, topology, std::move(rectangle.points), repair);
  result.image = std::move(ring.image);
  rectangle.points = std::move(flat.image);
  result.flippedBeforeUnfolding = ring.flippedBefore + flat.flippedBefore;
  result.flippedFaces = ring.flippedAfter;
  result.flippedRectangleFaces = flat.flippedAfter;
  result.pockets = ring.pockets;
  result.rectanglePockets = flat.pockets;
}

}  // namespace

AnnulusMapResult annulusMap(const AnnulusMesh& annulus, const AnnulusMapOptions& options,
                            const Execution& execution) {
  const auto begin = std::chrono::steady_clock::now();
  const std::size_t outer = outerLoopOf(annulus, options);
  const int start = startVertexOf(annulus.loops()[outer], options);
  const TriangleMesh& mesh = annulus.mesh();
  FlatCylinder cylinder =
      flatCylinder(mesh, annulus.topology(), annulus.loops()[outer], annulus.loops()[1 - outer], options.flow,
                   execution.part(0, 0.9), options.refine);
  AnnulusMapResult result;
  result.status = cylinder.flow.status;
  result.residual = cylinder.flow.residual;
  result.iterations = cylinder.flow.iterations;
  result.edgeFlips = cylinder.flow.initialFlips + cylinder.flow.flips;
  result.cut = cylinder.cut.path;
  if (result.status != Status::Cancelled) {
    const double angle = cylinder.strip(start, 1);
    cylinder.strip.col(1).array() -= angle;
    result.holonomy = cylinder.holonomy;
    result.straightness = cylinder.straightness;
    result.modulus = cylinder.height / (2 * M_PI);
    result.innerRadius = std::exp(-cylinder.height);
    result.image = exponential(cylinder.strip);
    result.logScale = cylinder.flow.logScale.head(mesh.vertexCount()) + cylinder.strip.col(0);
    if (options.refine) {
      result.refinement = commonRefinement(mesh, annulus.topology(), cylinder.flow.triangulation, result.image);
    }
    result.rectangle = unroll(cylinder, mesh.faces(), mesh.vertexCount());
    unfoldBoth(annulus, options.unfold, result);
  }
  result.history = std::move(cylinder.flow.history);
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  execution.report(1, "annulus map");
  return result;
}

}  // namespace authalic
