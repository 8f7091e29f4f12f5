#include "Core/geometry/Development.h"

#include <algorithm>
#include <cmath>
#include <queue>
#include <vector>

namespace authalic {
namespace {

/// A half-edge whose face can be laid out next: where its ends are, and in which copy of the universal cover its
/// tail is.
struct Front {
  double logLength;
  int halfEdge;
  int copy;
  Eigen::RowVector2d tail, head;

  bool operator<(const Front& other) const {  // the largest comes first, of equals the smallest id
    return logLength != other.logLength ? logLength < other.logLength : halfEdge > other.halfEdge;
  }
};

class Unfolding {
 public:
  Unfolding(const IntrinsicTriangulation& triangulation, const Eigen::VectorXd& u)
      : triangulation_(triangulation),
        u_(u),
        laid_(static_cast<std::size_t>(triangulation.faceCount()), 0),
        placed_(static_cast<std::size_t>(triangulation.vertexCount()), 0),
        copy_(placed_.size(), 0),
        raw_(Points2::Zero(triangulation.vertexCount(), 2)) {}

  Development run();

 private:
  void start();
  void layFace(const Front& front);
  void place(int vertex, int copy, const Eigen::RowVector2d& at);
  [[nodiscard]] double holonomy(const Development& development) const;

  const IntrinsicTriangulation& triangulation_;
  const Eigen::VectorXd& u_;
  std::vector<char> laid_, placed_;
  std::vector<int> copy_;  // of the universal cover in which the vertex was reached first
  Points2 raw_;            // its place there
  std::priority_queue<Front> queue_;
  Eigen::RowVector2d shifts_{0, 0};  // Σ m (place − first place) and Σ m² of vertices reached again in another copy
  double weight_ = 0;
};

void Unfolding::place(int vertex, int copy, const Eigen::RowVector2d& at) {
  const auto v = static_cast<std::size_t>(vertex);
  if (!placed_[v]) {
    placed_[v] = 1;
    copy_[v] = copy;
    raw_.row(vertex) = at;
  } else if (const int turns = copy - copy_[v]; turns != 0) {
    shifts_ += turns * (at - raw_.row(vertex));
    weight_ += static_cast<double>(turns) * turns;
  }
}

void Unfolding::start() {
  int longest = 0;
  for (int h = 1; h < triangulation_.halfEdgeCount(); ++h) {
    if (triangulation_.logLength(h, u_) > triangulation_.logLength(longest, u_)) longest = h;
  }
  const double logLength = triangulation_.logLength(longest, u_);
  const Eigen::RowVector2d head(std::exp(logLength), 0), tail(0, 0);
  place(triangulation_.tail(longest), 0, tail);
  place(triangulation_.head(longest), triangulation_.winding(longest), head);
  queue_.push({logLength, longest, 0, tail, head});
  if (const int across = triangulation_.opposite(longest); across >= 0) {
    queue_.push({logLength, across, triangulation_.winding(longest), head, tail});
  }
}

void Unfolding::layFace(const Front& front) {
  const int h = front.halfEdge, jk = triangulation_.next(h), ki = triangulation_.next(jk), f = triangulation_.face(h);
  if (laid_[static_cast<std::size_t>(f)]) return;
  laid_[static_cast<std::size_t>(f)] = 1;
  const FaceShape shape = triangulation_.shape(f, u_);
  const int first = triangulation_.first(f);
  const double angle = shape.angle[jk == first ? 0 : jk == triangulation_.next(first) ? 1 : 2];  // at the tail
  const Eigen::RowVector2d along = (front.head - front.tail).normalized(), across(-along[1], along[0]);
  const double logJk = triangulation_.logLength(jk, u_), logKi = triangulation_.logLength(ki, u_);
  const Eigen::RowVector2d apex = front.tail + std::exp(logKi) * (std::cos(angle) * along + std::sin(angle) * across);
  const int copyOfHead = front.copy + triangulation_.winding(h), copyOfApex = copyOfHead + triangulation_.winding(jk);
  place(triangulation_.tail(ki), copyOfApex, apex);
  if (const int g = triangulation_.opposite(jk); g >= 0) queue_.push({logJk, g, copyOfApex, apex, front.head});
  if (const int g = triangulation_.opposite(ki); g >= 0) queue_.push({logKi, g, front.copy, front.tail, apex});
}

double Unfolding::holonomy(const Development& development) const {
  double worst = 0, longest = 0;
  for (int h = 0; h < triangulation_.halfEdgeCount(); ++h) {
    if (triangulation_.opposite(h) > h) continue;
    const double length = std::exp(triangulation_.logLength(h, u_));
    const Eigen::RowVector2d edge = development.points.row(triangulation_.head(h)) +
                                    triangulation_.winding(h) * development.period -
                                    development.points.row(triangulation_.tail(h));
    worst = std::max(worst, std::abs(edge.norm() - length));
    longest = std::max(longest, length);
  }
  return worst / longest;
}

Development Unfolding::run() {
  start();
  while (!queue_.empty()) {
    const Front front = queue_.top();
    queue_.pop();
    layFace(front);
  }
  Development development;
  if (weight_ > 0) development.period = shifts_ / weight_;
  development.points.resize(raw_.rows(), 2);
  for (Eigen::Index v = 0; v < raw_.rows(); ++v) {
    development.points.row(v) = raw_.row(v) - copy_[static_cast<std::size_t>(v)] * development.period;
  }
  development.holonomy = holonomy(development);
  return development;
}

}  // namespace

Development develop(const IntrinsicTriangulation& triangulation, const Eigen::VectorXd& u) {
  return Unfolding(triangulation, u).run();
}

}  // namespace authalic
