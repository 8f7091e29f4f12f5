#include "Core/conformal/FlatConeSurface.h"

#include <cmath>
#include <functional>
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

/// Goes around vertices and across the cut.
class Closing {
 public:
  Closing(const SurfaceTopology& topology, const std::vector<Complex>& place, FlatConeSurface& flat)
      : topology_(topology), place_(place), flat_(flat), curvature_(at(topology.vertexCount()), 0.0) {
    for (std::size_t i = 0; i < flat.cones.size(); ++i) curvature_[at(flat.cones[i])] = flat.curvature[i];
    flat_.across.resize(place.size());
    flat_.corners.resize(place.size());
    flat_.places.resize(topology.vertexCount(), 2);
  }

  void run(const DevelopedEdges& edges) {
    spanCut(edges);
    for (auto h = branches_.rbegin(); h != branches_.rend(); ++h) close(*h);
    for (int corner = static_cast<int>(place_.size()) - 1; corner >= 0; --corner) {
      if (flat_.cut.faces.data()[corner] == topology_.tail(corner)) first_[at(topology_.tail(corner))] = corner;
    }
    for (int v = 0; v < topology_.vertexCount(); ++v) placeVertex(v);
    placeRoot();
  }

 private:
  // A spanning tree of the cut by shortest edges, from a cone; the edges left over take their motions from the layout.
  void spanCut(const DevelopedEdges& edges) {
    std::vector<std::vector<int>> leaving(at(topology_.vertexCount()));
    for (int h = 0; h < static_cast<int>(place_.size()); ++h) {
      if (flat_.cut.onCut[at(h)]) leaving[at(topology_.tail(h))].push_back(h);
    }
    std::vector<char> reached(leaving.size(), 0), inTree(place_.size(), 0);
    using Entry = std::pair<double, int>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
    const auto reach = [&](int v) {
      reached[at(v)] = 1;
      for (const int h : leaving[at(v)]) queue.push({std::abs(edges.vector[at(h)]), h});
    };
    for (reach(flat_.cones.front()); !queue.empty();) {
      const int h = queue.top().second;
      queue.pop();
      if (reached[at(topology_.head(h))]) continue;
      inTree[at(h)] = inTree[at(topology_.opposite(h))] = 1;
      branches_.push_back(topology_.opposite(h));  // leaves the new vertex
      reach(topology_.head(h));
    }
    for (int h = 0; h < static_cast<int>(place_.size()); ++h) {
      if (flat_.cut.onCut[at(h)] && !inTree[at(h)] && h < topology_.opposite(h)) setAcross(h, fromLayout(h));
    }
  }

  [[nodiscard]] RigidMotion fromLayout(int h) const {
    const int g = topology_.opposite(h);
    const Complex tail = place_[at(h)], head = place_[at(SurfaceTopology::next(h))],
                  tailAcross = place_[at(SurfaceTopology::next(g))], headAcross = place_[at(g)];
    Complex turn = (headAcross - tailAcross) / (head - tail);
    turn /= std::abs(turn);
    return {turn, 0.5 * (tailAcross + headAcross) - turn * 0.5 * (tail + head)};
  }

  void setAcross(int h, const RigidMotion& motion) {
    flat_.across[at(h)] = motion;
    flat_.across[at(topology_.opposite(h))] = motion.inverse();
  }

  // Counter-clockwise from one corner of a vertex to the last; visit(corner, motion from the first corner's side).
  // Returns that of the last corner.
  template <class Visit>
  RigidMotion goAround(int first, Visit visit) const {
    RigidMotion motion;
    for (int corner = first;;) {
      visit(corner, motion);
      const int side = SurfaceTopology::previous(corner), next = topology_.opposite(side);
      if (next == first) return motion;
      if (flat_.cut.onCut[at(side)]) motion = flat_.across[at(side)].after(motion);
      corner = next;
    }
  }

  // The motion across a half-edge that leaves a vertex whose others are known.
  void close(int h) {
    const int v = topology_.tail(h);
    const RigidMotion known = goAround(h, [](int, const RigidMotion&) {});
    const bool cone = curvature_[at(v)] != 0;
    const RigidMotion whole = cone ? RigidMotion::about(place_[at(h)], curvature_[at(v)]) : RigidMotion{};
    if (cone) fixed_.push_back({h, place_[at(h)]});
    setAcross(topology_.opposite(h), whole.after(known.inverse()));
  }

  void placeVertex(int v) {
    goAround(first_[at(v)], [&](int corner, const RigidMotion& motion) { flat_.corners[at(corner)] = motion; });
    const Complex place = place_[at(first_[at(v)])];
    flat_.places.row(v) << place.real(), place.imag();
  }

  void setPlace(int corner, Complex seenThere) {
    const Complex place = flat_.corners[at(corner)].inverse()(seenThere);
    flat_.places.row(topology_.tail(corner)) << place.real(), place.imag();
  }

  // The cones stand where the motions around them do not move.
  void placeRoot() {
    for (const auto& [corner, place] : fixed_) setPlace(corner, place);
    const int first = first_[at(flat_.cones.front())];
    RigidMotion whole = goAround(first, [](int, const RigidMotion&) {});
    int last = first;
    goAround(first, [&](int corner, const RigidMotion&) { last = corner; });
    const int side = SurfaceTopology::previous(last);
    if (flat_.cut.onCut[at(side)]) whole = flat_.across[at(side)].after(whole);
    setPlace(first, whole.shift / (1.0 - whole.turn));
  }

  const SurfaceTopology& topology_;
  const std::vector<Complex>& place_;
  FlatConeSurface& flat_;
  std::vector<double> curvature_;                // per vertex
  std::vector<int> branches_;                    // half-edges to the parent, parents first
  std::vector<int> first_ = std::vector<int>(at(topology_.vertexCount()), -1);  // corner whose chart the vertex has
  std::vector<std::pair<int, Complex>> fixed_;   // corners of cones and where they are
};

}  // namespace

FlatConeSurface flatConeSurface(const HighGenusMesh& surface, SolverBackend backend, const Execution& execution) {
  FlatConeSurface flat;
  for (const Cone& cone : placeCones(surface, backend)) {
    flat.cones.push_back(cone.vertex);
    flat.curvature.push_back(cone.curvature);
  }
  Eigen::VectorXd curvature = Eigen::VectorXd::Zero(surface.mesh().vertexCount());
  for (std::size_t i = 0; i < flat.cones.size(); ++i) curvature[flat.cones[i]] = flat.curvature[i];
  IntrinsicTriangulation triangulation(surface.mesh(), surface.topology());
  triangulation.recordFlips();
  YamabeFlowOptions options;
  options.solver = backend;
  flat.flow = yamabeFlow(std::move(triangulation), curvature, {}, options, execution);
  DevelopedEdges edges = developOriginalEdges(flat.flow.triangulation, flat.flow.logScale);
  flat.flow.triangulation = {};
  scaleToUnitArea(edges);
  flat.cut = cutToFundamentalDomain(surface.mesh(), surface.topology(), flat.cones.front(), flat.cones);
  const std::vector<Complex> places = layOut(surface.topology(), flat.cut, edges);
  Closing(surface.topology(), places, flat).run(edges);
  return flat;
}

Points2 openImage(const FlatConeSurface& flat, const Faces& faces, const Points2& places) {
  Points2 open(static_cast<Eigen::Index>(flat.cut.originalPointIds.size()), 2);
  for (Eigen::Index c = 0; c < faces.size(); ++c) {
    const int v = faces.data()[c];
    const Complex place = flat.corners[static_cast<std::size_t>(c)]({places(v, 0), places(v, 1)});
    open.row(flat.cut.faces.data()[c]) << place.real(), place.imag();
  }
  return open;
}

}  // namespace authalic
