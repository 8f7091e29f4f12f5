#include "Core/conformal/FlatConeSurface.h"

#include <cmath>
#include <queue>
#include <utility>

#include "Core/conformal/ConePlacement.h"
#include "Core/geometry/DevelopedEdges.h"

namespace authalic {
namespace {

using Complex = std::complex<double>;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// Places of the corners of the disk, laid out face after face along the longest edges first.
std::vector<Complex> layOut(const SurfaceTopology& topology, const CutGraph& cut, const DevelopedEdges& edges) {
  const int count = static_cast<int>(edges.vector.size());
  std::vector<Complex> place(at(count)), frame(at(count / 3));  // frame: turns a face's coordinates into the plane's
  std::vector<char> laid(frame.size(), 0);
  std::priority_queue<std::pair<double, int>> queue;  // half-edges of laid faces
  const auto lay = [&](int h, Complex tail, Complex turn) {
    laid[at(h / 3)] = 1;
    frame[at(h / 3)] = turn;
    for (int k = 0; k < 3; ++k, h = SurfaceTopology::next(h)) {
      place[at(h)] = tail;
      tail += turn * edges.vector[at(h)];
      if (!cut.onCut[at(h)]) queue.push({std::abs(edges.vector[at(h)]), -h});
    }
  };
  for (lay(0, 0, 1); !queue.empty();) {
    const int h = -queue.top().second, across = topology.opposite(h);
    queue.pop();
    if (laid[at(across / 3)]) continue;
    lay(across, place[at(SurfaceTopology::next(h))], frame[at(h / 3)] * edges.turn[at(h)]);
  }
  return place;
}

void scaleToUnitArea(DevelopedEdges& edges) {
  double area = 0;
  for (std::size_t h = 0; h < edges.vector.size(); h += 3) {
    area += 0.5 * (std::conj(edges.vector[h]) * edges.vector[h + 1]).imag();
  }
  for (Complex& vector : edges.vector) vector /= std::sqrt(area);
}

}  // namespace

FlatConeSurface flatConeSurface(const HighGenusMesh& surface, SolverBackend backend, const Execution& execution) {
  FlatConeSurface flat;
  const SurfaceTopology& topology = surface.topology();
  for (const Cone& cone : placeCones(surface, backend)) {
    flat.cones.push_back(cone.vertex);
    flat.curvature.push_back(cone.curvature);
  }
  Eigen::VectorXd curvature = Eigen::VectorXd::Zero(surface.mesh().vertexCount());
  for (std::size_t i = 0; i < flat.cones.size(); ++i) curvature[flat.cones[i]] = flat.curvature[i];
  IntrinsicTriangulation triangulation(surface.mesh(), topology);
  triangulation.recordFlips();
  YamabeFlowOptions options;
  options.solver = backend;
  flat.flow = yamabeFlow(std::move(triangulation), curvature, {}, options, execution);
  DevelopedEdges edges = developOriginalEdges(flat.flow.triangulation, flat.flow.logScale);
  flat.flow.triangulation = {};
  scaleToUnitArea(edges);
  flat.cut = cutToFundamentalDomain(surface.mesh(), topology, flat.cones.front(), flat.cones);
  const std::vector<Complex> image = layOut(topology, flat.cut, edges);
  flat.holonomy = ConeHolonomy(topology, flat.cut, flat.cones, flat.curvature, image);
  flat.places.resize(surface.mesh().vertexCount(), 2);
  for (int v = 0; v < surface.mesh().vertexCount(); ++v) {
    const Complex place = image[at(flat.holonomy.chart(v))];
    flat.places.row(v) << place.real(), place.imag();
  }
  flat.translations = flat.holonomy.parameters();
  setMotions(flat, flat.holonomy.motions(topology, flat.cut, flat.translations));
  return flat;
}

void setMotions(FlatConeSurface& flat, ConeMotions motions) {
  for (std::size_t i = 0; i < flat.cones.size(); ++i) {
    flat.places.row(flat.cones[i]) << motions.places[i].real(), motions.places[i].imag();
  }
  flat.motions = std::move(motions);
}

Points2 openImage(const FlatConeSurface& flat, const Faces& faces, const Points2& places) {
  Points2 open(static_cast<Eigen::Index>(flat.cut.originalPointIds.size()), 2);
  for (Eigen::Index c = 0; c < faces.size(); ++c) {
    const int v = faces.data()[c];
    const Complex place = flat.motions.corners[static_cast<std::size_t>(c)]({places(v, 0), places(v, 1)});
    open.row(flat.cut.faces.data()[c]) << place.real(), place.imag();
  }
  return open;
}

}  // namespace authalic
