#include "Core/conformal/ConeHolonomy.h"

#include <functional>
#include <queue>
#include <utility>

namespace authalic {
namespace {

using Complex = std::complex<double>;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

// A spanning tree of the cut by shortest edges, from a vertex.
struct SpannedCut {
  std::vector<int> branches;    // half-edges to the parent, parents first
  std::vector<int> generators;  // one half-edge of each edge left over
};

SpannedCut spanCut(const SurfaceTopology& topology, const CutGraph& cut, int root, const std::vector<Complex>& image) {
  const int count = static_cast<int>(image.size());
  std::vector<std::vector<int>> leaving(at(topology.vertexCount()));
  for (int h = 0; h < count; ++h) {
    if (cut.onCut[at(h)]) leaving[at(topology.tail(h))].push_back(h);
  }
  SpannedCut spanned;
  std::vector<char> reached(leaving.size(), 0), inTree(image.size(), 0);
  using Entry = std::pair<double, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  const auto reach = [&](int v) {
    reached[at(v)] = 1;
    for (const int h : leaving[at(v)]) {
      queue.push({std::abs(image[at(SurfaceTopology::next(h))] - image[at(h)]), h});
    }
  };
  for (reach(root); !queue.empty();) {
    const int h = queue.top().second;
    queue.pop();
    if (reached[at(topology.head(h))]) continue;
    inTree[at(h)] = inTree[at(topology.opposite(h))] = 1;
    spanned.branches.push_back(topology.opposite(h));
    reach(topology.head(h));
  }
  for (int h = 0; h < count; ++h) {
    if (cut.onCut[at(h)] && !inTree[at(h)] && h < topology.opposite(h)) spanned.generators.push_back(h);
  }
  return spanned;
}

// From one side of an edge of the cut to the other.
RigidMotion motionAcross(const SurfaceTopology& topology, const std::vector<Complex>& image, int h) {
  const int g = topology.opposite(h);
  const Complex tail = image[at(h)], head = image[at(SurfaceTopology::next(h))],
                tailAcross = image[at(SurfaceTopology::next(g))], headAcross = image[at(g)];
  Complex turn = (headAcross - tailAcross) / (head - tail);
  turn /= std::abs(turn);
  return {turn, 0.5 * (tailAcross + headAcross) - turn * 0.5 * (tail + head)};
}

}  // namespace

ConeHolonomy::ConeHolonomy(const SurfaceTopology& topology, const CutGraph& cut, const std::vector<int>& cones,
                           const std::vector<double>& curvature, const std::vector<Complex>& image)
    : cones_(cones), coneOf_(at(topology.vertexCount()), -1), chart_(coneOf_), curvature_(curvature) {
  for (std::size_t i = 0; i < cones.size(); ++i) coneOf_[at(cones[i])] = static_cast<int>(i);
  for (int corner = static_cast<int>(image.size()) - 1; corner >= 0; --corner) {
    if (cut.faces.data()[corner] == topology.tail(corner)) chart_[at(topology.tail(corner))] = corner;
  }
  SpannedCut spanned = spanCut(topology, cut, cones.front(), image);
  branches_ = std::move(spanned.branches);
  generators_ = std::move(spanned.generators);
  const auto cutCones = static_cast<Eigen::Index>(cones.size()) - 1;
  parameters_.resize(cutCones + static_cast<Eigen::Index>(generators_.size()));
  for (const int h : branches_) {
    if (const int i = coneOf_[at(topology.tail(h))]; i > 0) parameters_[i - 1] = image[at(h)];
  }
  for (std::size_t k = 0; k < generators_.size(); ++k) {
    const RigidMotion motion = motionAcross(topology, image, generators_[k]);
    turns_.push_back(motion.turn);
    parameters_[cutCones + static_cast<Eigen::Index>(k)] = motion.shift;
  }
}

/// Goes around vertices and across the cut.
class ConeClosing {
 public:
  ConeClosing(const SurfaceTopology& topology, const CutGraph& cut, const ConeHolonomy& holonomy)
      : topology_(topology), cut_(cut), holonomy_(holonomy) {
    motions_.across.resize(cut.onCut.size());
    motions_.corners.resize(cut.onCut.size());
    motions_.places.resize(holonomy.cones_.size());
  }

  ConeMotions run(const Eigen::VectorXcd& parameters) {
    const auto cones = static_cast<Eigen::Index>(holonomy_.cones_.size()) - 1;
    for (std::size_t k = 0; k < holonomy_.generators_.size(); ++k) {
      setAcross(holonomy_.generators_[k],
                {holonomy_.turns_[k], parameters[cones + static_cast<Eigen::Index>(k)]});
    }
    for (auto h = holonomy_.branches_.rbegin(); h != holonomy_.branches_.rend(); ++h) close(*h, parameters);
    for (int v = 0; v < topology_.vertexCount(); ++v) {
      goAround(holonomy_.chart(v), [&](int corner, const RigidMotion& m) { motions_.corners[at(corner)] = m; });
    }
    placeCones(parameters);
    return std::move(motions_);
  }

 private:
  void setAcross(int h, const RigidMotion& motion) {
    motions_.across[at(h)] = motion;
    motions_.across[at(topology_.opposite(h))] = motion.inverse();
  }

  // Counter-clockwise around a vertex, from one of its corners; visit(corner, motion from the first corner's side).
  // Returns that of the last corner.
  template <class Visit>
  RigidMotion goAround(int first, Visit visit) const {
    RigidMotion motion;
    for (int corner = first;;) {
      visit(corner, motion);
      const int side = SurfaceTopology::previous(corner), next = topology_.opposite(side);
      if (next == first) return motion;
      if (cut_.onCut[at(side)]) motion = motions_.across[at(side)].after(motion);
      corner = next;
    }
  }

  // The motion across a half-edge that leaves a vertex whose others are known.
  void close(int h, const Eigen::VectorXcd& parameters) {
    const int cone = holonomy_.coneOf_[at(topology_.tail(h))];
    const RigidMotion known = goAround(h, [](int, const RigidMotion&) {});
    const RigidMotion whole =
        cone < 0 ? RigidMotion{} : RigidMotion::about(parameters[cone - 1], holonomy_.curvature_[at(cone)]);
    setAcross(topology_.opposite(h), whole.after(known.inverse()));
  }

  // Cones stand where the motions around them do not move.
  void placeCones(const Eigen::VectorXcd& parameters) {
    for (const int h : holonomy_.branches_) {
      const int cone = holonomy_.coneOf_[at(topology_.tail(h))];
      if (cone > 0) motions_.places[at(cone)] = motions_.corners[at(h)].inverse()(parameters[cone - 1]);
    }
    const int first = holonomy_.chart(holonomy_.cones_.front());
    int last = first;
    RigidMotion whole = goAround(first, [&](int corner, const RigidMotion&) { last = corner; });
    const int side = SurfaceTopology::previous(last);
    if (cut_.onCut[at(side)]) whole = motions_.across[at(side)].after(whole);
    motions_.places[0] = whole.shift / (1.0 - whole.turn);
  }

  const SurfaceTopology& topology_;
  const CutGraph& cut_;
  const ConeHolonomy& holonomy_;
  ConeMotions motions_;
};

ConeMotions ConeHolonomy::motions(const SurfaceTopology& topology, const CutGraph& cut,
                                  const Eigen::VectorXcd& parameters) const {
  return ConeClosing(topology, cut, *this).run(parameters);
}

}  // namespace authalic
