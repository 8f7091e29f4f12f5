#include "Core/conformal/YamabeMap.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <string>
#include <utility>

#include "Core/base/Error.h"
#include "Core/conformal/Unfolding.h"
#include "Core/geometry/Areas.h"
#include "Core/geometry/Development.h"

namespace authalic {
namespace {

constexpr double kRounding = 1e-4;  // of the sum of target curvatures, radians

int startVertexOf(const DiskMesh& disk, int startVertex) {
  if (startVertex == -1) return disk.boundary().front();
  if (std::find(disk.boundary().begin(), disk.boundary().end(), startVertex) == disk.boundary().end()) {
    throw InvalidArgument("A boundary vertex is required on the x axis, but vertex " +
                          std::to_string(startVertex) + " is none.");
  }
  return startVertex;
}

void requireFlatInside(const DiskMesh& disk, const Eigen::VectorXd& curvature) {
  const int n = disk.mesh().vertexCount();
  if (curvature.size() == 0) return;
  if (curvature.size() != n) {
    throw GeometryError("One target curvature per vertex is required: there are " + std::to_string(n) +
                        " vertices and " + std::to_string(curvature.size()) + " targets.");
  }
  for (int v = 0; v < n; ++v) {
    if (disk.topology().onBoundary()[static_cast<std::size_t>(v)] || curvature[v] == 0) continue;
    throw InvalidArgument(
        "A target curvature of 0 at inner vertices is required for a map to the plane, but it is " +
        std::to_string(curvature[v]) + " at vertex " + std::to_string(v) + ".");
  }
}

// Files round the parts of a whole turn.
Eigen::VectorXd wholeTurn(const Eigen::VectorXd& curvature) {
  const double missing = 2 * M_PI - curvature.sum(), all = curvature.cwiseAbs().sum();
  if (!(std::abs(missing) <= kRounding)) return curvature;
  return curvature + missing / all * curvature.cwiseAbs();
}

// Area and centroid of the surface onto the image, the start vertex onto the positive x axis; u follows the scale.
Points2 place(const DiskMesh& disk, Points2 image, int start, Eigen::VectorXd& logScale) {
  const Eigen::VectorXd areas = faceAreas(disk.mesh());
  const Eigen::VectorXd masses = vertexStars(areas, disk.mesh().faces(), disk.mesh().vertexCount());
  image.rowwise() -= Eigen::RowVector2d(masses.transpose() * image / masses.sum());
  const double scale = std::sqrt(areas.sum() / std::abs(signedFaceAreas(image, disk.mesh().faces()).sum()));
  logScale.array() += std::log(scale);
  const Eigen::RowVector2d axis = image.row(start).normalized() * scale;
  Points2 placed(image.rows(), 2);
  for (Eigen::Index v = 0; v < image.rows(); ++v) {
    placed.row(v) << image.row(v).dot(axis), image(v, 1) * axis[0] - image(v, 0) * axis[1];
  }
  return placed;
}

YamabeFlowResult flowOf(const DiskMesh& disk, const YamabeMapOptions& options, const Execution& execution) {
  IntrinsicTriangulation triangulation(disk.mesh(), disk.topology());
  if (options.refine) triangulation.trackCrossings();
  std::vector<BoundaryCircle> circles;
  Eigen::VectorXd target = wholeTurn(options.curvature);
  if (target.size() == 0) {
    target = Eigen::VectorXd::Zero(disk.mesh().vertexCount());
    circles.emplace_back(triangulation, disk.boundary(), true);
  }
  return yamabeFlow(std::move(triangulation), target, std::move(circles), options.flow,
                    execution.part(0, 0.9));
}

}  // namespace

YamabeMapResult yamabeMap(const DiskMesh& disk, const YamabeMapOptions& options, const Execution& execution) {
  const int start = startVertexOf(disk, options.startVertex), n = disk.mesh().vertexCount();
  requireFlatInside(disk, options.curvature);
  const auto begin = std::chrono::steady_clock::now();
  YamabeFlowResult flow = flowOf(disk, options, execution);
  YamabeMapResult result;
  result.status = flow.status;
  result.residual = flow.residual;
  result.iterations = flow.iterations;
  result.edgeFlips = flow.initialFlips + flow.flips;
  result.addedVertices = flow.addedVertices;
  result.degenerateFaces = flow.degenerateFaces;
  result.history = std::move(flow.history);
  if (result.status != Status::Cancelled) {
    const Development development = develop(flow.triangulation, flow.logScale);
    result.holonomy = development.holonomy;
    result.logScale = flow.logScale.head(n);
    result.curvature = flow.curvature.head(n);
    const Points2 image = place(disk, development.points.topRows(n), start, result.logScale);
    if (options.refine)
      result.refinement = commonRefinement(disk.mesh(), disk.topology(), flow.triangulation, image);
    UnfoldedImage unfolded = unfoldImage(disk.mesh(), disk.topology(), image, options.unfold);
    result.image = std::move(unfolded.image);
    result.flippedBeforeUnfolding = unfolded.flippedBefore;
    result.flippedFaces = unfolded.flippedAfter;
    result.pockets = unfolded.pockets;
  }
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  execution.report(1, "curvature flow");
  return result;
}

}  // namespace authalic
