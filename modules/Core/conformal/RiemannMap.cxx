#include "Core/conformal/RiemannMap.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <queue>
#include <string>
#include <utility>

#include "Core/base/Error.h"
#include "Core/conformal/FlatCylinder.h"
#include "Core/conformal/Unfolding.h"
#include "Core/geometry/Development.h"
#include "Core/numerics/CircleFit.h"

namespace authalic {
namespace {

bool touchesBoundary(const DiskMesh& disk, int face) {
  for (int k = 0; k < 3; ++k) {
    if (disk.topology().onBoundary()[static_cast<std::size_t>(disk.mesh().faces()(face, k))]) return true;
  }
  return false;
}

// The face whose corners are most edges away from the boundary; of equals the first.
int deepestFace(const DiskMesh& disk) {
  std::vector<int> depth(static_cast<std::size_t>(disk.mesh().vertexCount()), -1);
  std::vector<std::vector<int>> neighbours(depth.size());
  const Faces& faces = disk.mesh().faces();
  for (Eigen::Index h = 0; h < faces.size(); ++h) {
    const int half = static_cast<int>(h);
    neighbours[static_cast<std::size_t>(disk.topology().tail(half))].push_back(disk.topology().head(half));
  }
  std::queue<int> front;
  for (const int v : disk.boundary()) {
    depth[static_cast<std::size_t>(v)] = 0;
    front.push(v);
  }
  // One direction of every inner edge leaves each of its ends; those of the boundary only lead along it.
  while (!front.empty()) {
    const int v = front.front();
    front.pop();
    for (const int w : neighbours[static_cast<std::size_t>(v)]) {
      if (depth[static_cast<std::size_t>(w)] >= 0) continue;
      depth[static_cast<std::size_t>(w)] = depth[static_cast<std::size_t>(v)] + 1;
      front.push(w);
    }
  }
  int deepest = 0, most = -1;
  for (int f = 0; f < disk.mesh().faceCount(); ++f) {
    int least = std::numeric_limits<int>::max();
    for (int k = 0; k < 3; ++k) least = std::min(least, depth[static_cast<std::size_t>(faces(f, k))]);
    if (least > most) {
      most = least;
      deepest = f;
    }
  }
  return deepest;
}

Faces without(const Faces& faces, int face) {
  Faces rest(faces.rows() - 1, 3);
  rest.topRows(face) = faces.topRows(face);
  rest.bottomRows(faces.rows() - 1 - face) = faces.bottomRows(faces.rows() - 1 - face);
  return rest;
}

void takeOver(YamabeFlowResult&& flow, RiemannMapResult& result) {
  result.status = flow.status;
  result.residual = flow.residual;
  result.iterations = flow.iterations;
  result.edgeFlips = flow.initialFlips + flow.flips;
  result.history = std::move(flow.history);
}

// Returns the flow's triangulation.
IntrinsicTriangulation byBoundary(const DiskMesh& disk, const RiemannMapOptions& options,
                                  const Execution& execution, RiemannMapResult& result) {
  const int n = disk.mesh().vertexCount();
  IntrinsicTriangulation triangulation(disk.mesh(), disk.topology());
  if (options.refine) triangulation.trackCrossings();
  std::vector<BoundaryCircle> circle{BoundaryCircle(triangulation, disk.boundary(), true)};
  YamabeFlowResult flow = yamabeFlow(std::move(triangulation), Eigen::VectorXd::Zero(n), std::move(circle),
                                     options.flow, execution.part(0, 0.9));
  if (flow.status != Status::Cancelled) {
    const Development development = develop(flow.triangulation, flow.logScale);
    result.image = development.points.topRows(n);
    result.holonomy = development.holonomy;
    const FittedCircle fitted = fitCircle(result.image, disk.boundary());
    result.roundness = fitted.deviation;
    result.image = (result.image.rowwise() - fitted.centre) / fitted.radius;
    result.logScale = flow.logScale.head(n).array() - std::log(fitted.radius);
  }
  IntrinsicTriangulation flipped = std::move(flow.triangulation);
  takeOver(std::move(flow), result);
  return flipped;
}

void byPuncture(const DiskMesh& disk, const RiemannMapOptions& options, const Execution& execution,
                RiemannMapResult& result) {
  const int face = options.puncture >= 0 ? options.puncture : deepestFace(disk);
  if (face >= disk.mesh().faceCount() || touchesBoundary(disk, face)) {
    throw InvalidArgument("A face without a vertex on the boundary is required for the puncture, but face " +
                          std::to_string(face) + (options.puncture < 0 ? ", the deepest," : "") +
                          " has one or does not exist; refine the surface or take the road 'boundary'.");
  }
  const TriangleMesh punctured(disk.mesh().points(), without(disk.mesh().faces(), face));
  const SurfaceTopology topology(punctured.faces(), punctured.vertexCount());
  const auto& loops = topology.boundaryLoops();
  const bool first = loops.front().front() == disk.boundary().front();
  FlatCylinder cylinder = flatCylinder(punctured, topology, loops[first ? 0 : 1], loops[first ? 1 : 0],
                                       options.flow, execution.part(0, 0.9));
  if (cylinder.flow.status != Status::Cancelled) {
    result.image = exponential(cylinder.strip);
    result.logScale = cylinder.flow.logScale.head(disk.mesh().vertexCount()) + cylinder.strip.col(0);
    result.holonomy = cylinder.holonomy;
    result.roundness = 2 * M_PI * cylinder.straightness;
  }
  takeOver(std::move(cylinder.flow), result);
}

// The normal position; u follows the derivative of the Möbius transformation, |φ(z) − φ(w)|² = |φ'(z) φ'(w)| |z − w|².
void normalise(const DiskMesh& disk, const DiskNormalisation& normalisation, RiemannMapResult& result) {
  for (const int v : disk.boundary()) result.image.row(v).normalize();
  const Mobius map = normalisingMap(disk.mesh(), disk.topology(), disk.boundary(), result.image, normalisation);
  for (Eigen::Index v = 0; v < result.image.rows(); ++v) {
    result.logScale[v] += std::log(std::abs(map.derivative({result.image(v, 0), result.image(v, 1)})));
  }
  result.image = map(result.image);
  for (const int v : disk.boundary()) result.image.row(v).normalize();
}

}  // namespace

const char* riemannRoadName(RiemannRoad road) noexcept {
  return road == RiemannRoad::Boundary ? "boundary" : "puncture";
}

RiemannMapResult riemannMap(const DiskMesh& disk, const RiemannMapOptions& options,
                            const Execution& execution) {
  options.normalisation.validate(disk.mesh(), disk.boundary(), disk.topology().onBoundary());
  options.flow.validate();
  if (options.refine && options.road == RiemannRoad::Puncture) {
    throw InvalidArgument("The road 'boundary' is required for a common refinement, but it is 'puncture'.");
  }
  const auto start = std::chrono::steady_clock::now();
  RiemannMapResult result;
  IntrinsicTriangulation flipped;
  if (options.road == RiemannRoad::Boundary) {
    flipped = byBoundary(disk, options, execution, result);
  } else {
    byPuncture(disk, options, execution, result);
  }
  if (result.status != Status::Cancelled) {
    normalise(disk, options.normalisation, result);
    if (options.refine)
      result.refinement = commonRefinement(disk.mesh(), disk.topology(), flipped, result.image);
    UnfoldedImage unfolded =
        unfoldImage(disk.mesh(), disk.topology(), std::move(result.image), options.unfold);
    result.image = std::move(unfolded.image);
    result.flippedBeforeUnfolding = unfolded.flippedBefore;
    result.flippedFaces = unfolded.flippedAfter;
    result.pockets = unfolded.pockets;
  }
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  execution.report(1, "Riemann map");
  return result;
}

}  // namespace authalic
