#include "Core/conformal/FlatCylinder.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <utility>

namespace authalic {
namespace {

double meanOf(const Points2& points, const std::vector<int>& vertices) {
  double sum = 0;
  for (const int v : vertices) sum += points(v, 0);
  return sum / static_cast<double>(vertices.size());
}

double deviationFrom(double value, const Points2& points, const std::vector<int>& vertices) {
  double worst = 0;
  for (const int v : vertices) worst = std::max(worst, std::abs(points(v, 0) - value));
  return worst;
}

}  // namespace

FlatCylinder flatCylinder(const TriangleMesh& mesh, const SurfaceTopology& topology,
                          const std::vector<int>& outer, const std::vector<int>& inner,
                          const YamabeFlowOptions& options, const Execution& execution, bool trackCrossings) {
  FlatCylinder cylinder;
  cylinder.cut = cutAnnulus(mesh, topology, outer, inner);
  IntrinsicTriangulation triangulation(mesh, topology);
  triangulation.attachWinding(cylinder.cut.winding);
  if (trackCrossings) triangulation.trackCrossings();
  cylinder.flow =
      yamabeFlow(std::move(triangulation), Eigen::VectorXd::Zero(mesh.vertexCount()), {}, options, execution);
  if (cylinder.flow.status == Status::Cancelled) return cylinder;
  const Development development = develop(cylinder.flow.triangulation, cylinder.flow.logScale);
  cylinder.holonomy = development.holonomy;
  const std::complex<double> turn =
      std::complex<double>(0, 2 * M_PI) / std::complex<double>(development.period[0], development.period[1]);
  cylinder.flow.logScale.array() += std::log(std::abs(turn));
  cylinder.strip.resize(mesh.vertexCount(), 2);
  for (Eigen::Index v = 0; v < cylinder.strip.rows(); ++v) {
    const std::complex<double> z =
        turn * std::complex<double>(development.points(v, 0), development.points(v, 1));
    cylinder.strip.row(v) << z.real(), z.imag();
  }
  // The outer loop is to be on the right; half a turn carries it there and turns the period over.
  if (meanOf(cylinder.strip, outer) < meanOf(cylinder.strip, inner)) {
    cylinder.strip = -cylinder.strip;
    cylinder.turns = -1;
  }
  cylinder.strip.col(0).array() -= meanOf(cylinder.strip, outer);
  cylinder.height = -meanOf(cylinder.strip, inner);
  cylinder.straightness = std::max(deviationFrom(0, cylinder.strip, outer),
                                   deviationFrom(-cylinder.height, cylinder.strip, inner)) /
                          (2 * M_PI);
  for (const int v : outer) cylinder.strip(v, 0) = 0;
  for (const int v : inner) cylinder.strip(v, 0) = -cylinder.height;
  return cylinder;
}

Points2 exponential(const Points2& strip) {
  Points2 image(strip.rows(), 2);
  for (Eigen::Index v = 0; v < strip.rows(); ++v) {
    const double radius = std::exp(strip(v, 0));
    image.row(v) << radius * std::cos(strip(v, 1)), radius * std::sin(strip(v, 1));
  }
  return image;
}

}  // namespace authalic
