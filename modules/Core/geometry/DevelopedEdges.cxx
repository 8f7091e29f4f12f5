#include "Core/geometry/DevelopedEdges.h"

#include <cmath>

namespace authalic {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

class Unflipping {
 public:
  Unflipping(const IntrinsicTriangulation& triangulation, const Eigen::VectorXd& u) {
    const std::size_t count = at(triangulation.halfEdgeCount());
    edges_.vector.resize(count);
    edges_.turn.resize(count);
    next_.resize(count);
    opposite_.resize(count);
    for (int h = 0; h < triangulation.halfEdgeCount(); ++h) {
      next_[at(h)] = triangulation.next(h);
      opposite_[at(h)] = triangulation.opposite(h);
    }
    for (int f = 0; f < triangulation.faceCount(); ++f) layOut(triangulation, u, f);
    for (int h = 0; h < triangulation.halfEdgeCount(); ++h) {
      const std::complex<double> turn = -edges_.vector[at(h)] / edges_.vector[at(opposite_[at(h)])];
      edges_.turn[at(h)] = turn / std::abs(turn);
    }
  }

  // The inverse of IntrinsicTriangulation::flip: faces (h, ki, il) and (g, lj, jk) become (h, jk, ki) and (g, il, lj).
  void takeBack(int h) {
    const int g = opposite_[at(h)], ki = next_[at(h)], il = next_[at(ki)], lj = next_[at(g)], jk = next_[at(lj)];
    const std::complex<double> turn = edges_.turn[at(h)];
    for (const int side : {lj, jk}) {
      edges_.vector[at(side)] *= turn;
      edges_.turn[at(side)] *= turn;
      edges_.turn[at(opposite_[at(side)])] = std::conj(edges_.turn[at(side)]);
    }
    edges_.vector[at(h)] = edges_.vector[at(il)] + edges_.vector[at(lj)];
    edges_.vector[at(g)] = -edges_.vector[at(h)];
    edges_.turn[at(h)] = edges_.turn[at(g)] = 1;
    next_[at(h)] = jk;
    next_[at(jk)] = ki;
    next_[at(ki)] = h;
    next_[at(g)] = il;
    next_[at(il)] = lj;
    next_[at(lj)] = g;
  }

  [[nodiscard]] DevelopedEdges take() { return std::move(edges_); }

 private:
  void layOut(const IntrinsicTriangulation& triangulation, const Eigen::VectorXd& u, int face) {
    const int h = triangulation.first(face), jk = triangulation.next(h), ki = triangulation.next(jk);
    const FaceShape shape = triangulation.shape(face, u);
    const double ij = std::exp(triangulation.logLength(h, u)), ik = std::exp(triangulation.logLength(ki, u));
    const std::complex<double> apex = std::polar(ik, shape.angle[1]);
    edges_.vector[at(h)] = ij;
    edges_.vector[at(jk)] = apex - ij;
    edges_.vector[at(ki)] = -apex;
  }

  DevelopedEdges edges_;
  std::vector<int> next_, opposite_;
};

}  // namespace

DevelopedEdges developOriginalEdges(const IntrinsicTriangulation& triangulation, const Eigen::VectorXd& u) {
  Unflipping unflipping(triangulation, u);
  const std::vector<int>& flips = triangulation.recordedFlips();
  for (auto h = flips.rbegin(); h != flips.rend(); ++h) unflipping.takeBack(*h);
  return unflipping.take();
}

}  // namespace authalic
