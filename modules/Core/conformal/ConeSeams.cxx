#include "Core/conformal/ConeSeams.h"

#include <algorithm>
#include <cmath>

namespace authalic {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

class SeamTracer {
 public:
  SeamTracer(const SurfaceTopology& topology, const FlatConeSurface& flat)
      : topology_(topology), flat_(flat), valence_(at(topology.vertexCount()), 0), done_(flat.cut.onCut.size(), 0) {
    for (int h = 0; h < halfEdges(); ++h) valence_[at(topology.tail(h))] += flat.cut.onCut[at(h)] ? 1 : 0;
    for (const int v : flat.cones) valence_[at(v)] += 3;  // ends, however many branches meet there
  }

  [[nodiscard]] std::vector<ConeSeam> run() {
    std::vector<ConeSeam> seams;
    for (int h = 0; h < halfEdges(); ++h) {
      if (flat_.cut.onCut[at(h)] && !done_[at(h)] && valence_[at(topology_.tail(h))] != 2) seams.push_back(follow(h));
    }
    return seams;
  }

 private:
  [[nodiscard]] int halfEdges() const { return static_cast<int>(done_.size()); }
  [[nodiscard]] int vertex(int corner) const { return flat_.cut.faces.data()[corner]; }

  // The half-edge of the cut that goes on from the head of h, with the disk on the same side.
  [[nodiscard]] int after(int h) const {
    int next = SurfaceTopology::next(h);
    while (!flat_.cut.onCut[at(next)]) next = SurfaceTopology::next(topology_.opposite(next));
    return next;
  }

  ConeSeam follow(int h) {
    ConeSeam seam;
    seam.motion = flat_.motions.across[at(h)];
    for (;; h = after(h)) {
      const int g = topology_.opposite(h);
      done_[at(h)] = done_[at(g)] = 1;
      seam.side.push_back(vertex(h));
      seam.otherSide.push_back(vertex(SurfaceTopology::next(g)));
      if (valence_[at(topology_.head(h))] == 2) continue;
      seam.side.push_back(vertex(SurfaceTopology::next(h)));
      seam.otherSide.push_back(vertex(g));
      return seam;
    }
  }

  const SurfaceTopology& topology_;
  const FlatConeSurface& flat_;
  std::vector<int> valence_;
  std::vector<char> done_;
};

}  // namespace

std::vector<ConeSeam> coneSeams(const SurfaceTopology& topology, const FlatConeSurface& flat, const Points2& image) {
  std::vector<ConeSeam> seams = SeamTracer(topology, flat).run();
  const auto place = [&](int v) { return std::complex<double>(image(v, 0), image(v, 1)); };
  for (ConeSeam& seam : seams) {
    for (std::size_t i = 0; i < seam.side.size(); ++i) {
      seam.error = std::max(seam.error, std::abs(seam.motion(place(seam.side[i])) - place(seam.otherSide[i])));
    }
  }
  return seams;
}

Eigen::VectorXd angleSums(const Faces& faces, const CutGraph& cut, const Points2& image) {
  Eigen::VectorXd sums = Eigen::VectorXd::Zero(faces.maxCoeff() + 1);
  for (Eigen::Index f = 0; f < faces.rows(); ++f) {
    for (int k = 0; k < 3; ++k) {
      const Eigen::RowVector2d x = image.row(cut.faces(f, k)), a = image.row(cut.faces(f, (k + 1) % 3)) - x,
                               b = image.row(cut.faces(f, (k + 2) % 3)) - x;
      sums[faces(f, k)] += std::atan2(a[0] * b[1] - a[1] * b[0], a.dot(b));
    }
  }
  return sums;
}

}  // namespace authalic
