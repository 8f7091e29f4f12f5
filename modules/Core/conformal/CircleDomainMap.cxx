#include "Core/conformal/CircleDomainMap.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <string>
#include <utility>

#include "Core/base/Error.h"
#include "Core/conformal/KoebeIteration.h"
#include "Core/conformal/Unfolding.h"
#include "Core/geometry/Development.h"
#include "Core/topology/LoopLength.h"

namespace authalic {
namespace {

// Returns the flow's triangulation.
IntrinsicTriangulation byCurvature(const PolyAnnulusMesh& surface, const CircleDomainOptions& options,
                                   const Execution& execution, CircleDomainResult& result) {
  const int n = surface.mesh().vertexCount();
  IntrinsicTriangulation triangulation(surface.mesh(), surface.topology());
  if (options.refine) triangulation.trackCrossings();
  std::vector<BoundaryCircle> circles;
  for (std::size_t k = 0; k < surface.loops().size(); ++k) {
    circles.emplace_back(triangulation, surface.loops()[k], static_cast<int>(k) == result.outerLoop);
  }
  YamabeFlowResult flow = yamabeFlow(std::move(triangulation), Eigen::VectorXd::Zero(n), std::move(circles),
                                     options.flow, execution.part(0, 0.9));
  result.status = flow.status;
  result.residual = flow.residual;
  result.iterations = flow.iterations;
  result.edgeFlips = flow.initialFlips + flow.flips;
  result.history = std::move(flow.history);
  if (flow.status == Status::Cancelled) return {};
  const Development development = develop(flow.triangulation, flow.logScale);
  result.holonomy = development.holonomy;
  result.image = development.points.topRows(n);
  result.logScale = flow.logScale.head(n);
  return std::move(flow.triangulation);
}

// Vertices of every loop onto its circle, the outer circle onto the unit circle; u follows.
void settle(const PolyAnnulusMesh& surface, const CircleDomainOptions& options,
            const IntrinsicTriangulation& flipped, CircleDomainResult& result) {
  const auto& loops = surface.loops();
  const std::vector<int>& outerLoop = loops[static_cast<std::size_t>(result.outerLoop)];
  const FittedCircle outer = fitCircle(result.image, outerLoop);
  result.image = (result.image.rowwise() - outer.centre) / outer.radius;
  result.logScale.array() -= std::log(outer.radius);
  for (const std::vector<int>& loop : loops) {
    const FittedCircle circle = fitCircle(result.image, loop);
    result.roundness = std::max(result.roundness, circle.deviation);
    for (const int v : loop) {
      const Eigen::RowVector2d arm = result.image.row(v) - circle.centre;
      result.image.row(v) = circle.centre + arm * (circle.radius / arm.norm());
    }
  }
  for (const int v : outerLoop) result.image.row(v).normalize();
  const Mobius normal =
      normalisingMap(surface.mesh(), surface.topology(), outerLoop, result.image, options.normalisation);
  for (Eigen::Index v = 0; v < result.logScale.size(); ++v) {
    result.logScale[v] += std::log(std::abs(normal.derivative({result.image(v, 0), result.image(v, 1)})));
  }
  result.image = normal(result.image);
  for (const int v : outerLoop) result.image.row(v).normalize();
  for (const std::vector<int>& loop : loops) result.circles.push_back(fitCircle(result.image, loop));
  if (options.refine)
    result.refinement = commonRefinement(surface.mesh(), surface.topology(), flipped, result.image);
  UnfoldedImage unfolded =
      unfoldImage(surface.mesh(), surface.topology(), std::move(result.image), options.unfold);
  result.image = std::move(unfolded.image);
  result.flippedBeforeUnfolding = unfolded.flippedBefore;
  result.flippedFaces = unfolded.flippedAfter;
  result.pockets = unfolded.pockets;
}

}  // namespace

const char* circleDomainRoadName(CircleDomainRoad road) noexcept {
  return road == CircleDomainRoad::Curvature ? "curvature" : "koebe";
}

void CircleDomainOptions::validate(const PolyAnnulusMesh& surface) const {
  const int loops = static_cast<int>(surface.loops().size());
  if (outerLoop < -1 || outerLoop >= loops) {
    throw InvalidArgument("A loop from 0 to " + std::to_string(loops - 1) +
                          " is required as the outer one, but it is " + std::to_string(outerLoop) + ".");
  }
  if (!(roundness > 0)) {
    throw InvalidArgument("A positive roundness is required, but it is " + std::to_string(roundness) + ".");
  }
  if (maxRounds < 0) {
    throw InvalidArgument("A non-negative number of rounds is required, but it is " +
                          std::to_string(maxRounds) + ".");
  }
  if (refine && road == CircleDomainRoad::Koebe) {
    throw InvalidArgument("The road 'curvature' is required for a common refinement, but it is 'koebe'.");
  }
  flow.validate();
}

CircleDomainResult circleDomainMap(const PolyAnnulusMesh& surface, const CircleDomainOptions& options,
                                   const Execution& execution) {
  options.validate(surface);
  const auto start = std::chrono::steady_clock::now();
  CircleDomainResult result;
  result.outerLoop = options.outerLoop >= 0 ? options.outerLoop
                                            : static_cast<int>(longestLoop(surface.mesh(), surface.loops()));
  options.normalisation.validate(surface.mesh(), surface.loops()[static_cast<std::size_t>(result.outerLoop)],
                                 surface.topology().onBoundary());
  IntrinsicTriangulation flipped;
  if (options.road == CircleDomainRoad::Curvature) {
    flipped = byCurvature(surface, options, execution, result);
  } else {
    koebeIteration(surface, options, execution, result);
  }
  if (result.status == Status::Cancelled) {
    result.image.resize(0, 2);
  } else {
    settle(surface, options, flipped, result);
  }
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  execution.report(1, "circle domain");
  return result;
}

}  // namespace authalic
