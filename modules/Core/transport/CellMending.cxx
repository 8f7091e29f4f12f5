#include "Core/transport/CellMending.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>

namespace authalic {
namespace {

constexpr double kTooLarge = 5, kLowered = 2, kTooSmall = 0.1, kRaised = 0.5;  // mass / ν
constexpr double kNear = 1.2;       // factor within which a mass is what it shall be
constexpr double kArcSides = 8;     // of the disk as a polygon, times the 4th root of n: 5 % of a cell are lost at most
constexpr int kMostCuts = 200;      // of one cell, beyond its neighbours
constexpr int kMostDoublings = 40, kMostHalvings = 12;
constexpr double kFirstStep = 0.02;
constexpr std::size_t kMostVisits = 5;  // per cell that was too large or too small
constexpr double kRounding = 1e-13;
constexpr double kFar = std::numeric_limits<double>::infinity();

std::size_t at(int i) { return static_cast<std::size_t>(i); }

std::vector<Eigen::Vector2d> outlineOf(const PlanarDomain& domain, Eigen::Index cells) {
  std::vector<Eigen::Vector2d> outline;
  const int sides = static_cast<int>(std::ceil(kArcSides * std::pow(static_cast<double>(cells), 0.25)));
  for (int k = 0; domain.isDisk() && k < sides; ++k) {
    const double angle = 2 * 3.14159265358979323846 * k / sides;
    outline.emplace_back(std::cos(angle), std::sin(angle));
  }
  for (Eigen::Index k = 0; k < domain.corners().rows(); ++k) outline.emplace_back(domain.corners().row(k));
  return outline;
}

// Which cells touch: in the diagram, and what changes have added.
class Neighbours {
 public:
  Neighbours(const std::vector<PowerEdge>& edges, Eigen::Index count) : start_(static_cast<std::size_t>(count) + 1, 0) {
    for (const PowerEdge& edge : edges) ++start_[at(edge.first) + 1], ++start_[at(edge.second) + 1];
    for (std::size_t i = 1; i < start_.size(); ++i) start_[i] += start_[i - 1];
    others_.resize(2 * edges.size());
    std::vector<std::size_t> next(start_.begin(), start_.end() - 1);
    for (const PowerEdge& edge : edges) {
      others_[next[at(edge.first)]++] = edge.second;
      others_[next[at(edge.second)]++] = edge.first;
    }
  }
  [[nodiscard]] bool any(int i) const { return start_[at(i)] < start_[at(i) + 1] || added_.count(i) > 0; }
  void join(int i, int j) { added_[i].push_back(j), added_[j].push_back(i); }

  template <class Visit>
  void each(int i, const Visit& visit) const {
    for (std::size_t k = start_[at(i)]; k < start_[at(i) + 1]; ++k) visit(others_[k]);
    const auto added = added_.find(i);
    if (added == added_.end()) return;
    for (const int j : added->second) visit(j);
  }

 private:
  std::vector<std::size_t> start_;
  std::vector<int> others_;
  std::unordered_map<int, std::vector<int>> added_;
};

class Mending {
 public:
  Mending(const PowerDiagram& diagram, const Eigen::VectorXd& masses, const std::vector<int>& clusterOf, int clusters,
          Heights& heights)
      : diagram_(diagram), y_(diagram.sites()), masses_(masses), clusterOf_(clusterOf), h_(heights),
        neighbours_(diagram.cells().edges, heights.size()), outline_(outlineOf(diagram.domain(), heights.size())),
        beginOf_(at(clusters), -1), queued_(static_cast<std::size_t>(heights.size()), 0) {
    for (int i = static_cast<int>(heights.size()) - 1; i >= 0; --i) {
      if (neighbours_.any(i)) beginOf_[at(clusterOf[at(i)])] = anywhere_ = i;
    }
  }

  int run() {
    const Eigen::ArrayXd part = diagram_.cells().masses.array() / masses_.array();
    for (int i = 0; i < static_cast<int>(part.size()); ++i) {
      if (part[i] > kTooLarge) enqueue(i);
    }
    for (int i = 0; i < static_cast<int>(part.size()); ++i) {
      if (part[i] < kTooSmall) enqueue(i);
    }
    const std::size_t most = kMostVisits * queue_.size();
    int changed = 0;
    for (std::size_t next = 0; anywhere_ >= 0 && next < queue_.size() && next < most; ++next) {
      queued_[at(queue_[next])] = 0;
      if (mend(queue_[next])) ++changed;
    }
    return changed;
  }

 private:
  void enqueue(int i) {
    if (queued_[at(i)]) return;
    queued_[at(i)] = 1;
    queue_.push_back(i);
  }

  [[nodiscard]] int beginOf(int i) const {
    const int begin = beginOf_[at(clusterOf_[at(i)])];
    return begin < 0 ? anywhere_ : begin;
  }

  // Whether the height of site i was changed. What its cell takes from others they must be seen to have lost.
  bool mend(int i) {
    const double mass = massAt(i, h_[i]);
    const bool raise = mass < kTooSmall * masses_[i], lower = mass > kTooLarge * masses_[i];
    const bool appeared = mass > 0 && !neighbours_.any(i);
    if (!raise && !lower && !appeared) return false;
    if (raise || lower) {
      h_[i] = heightFor(i, raise, (raise ? kRaised : kLowered) * masses_[i]);
      (void)massAt(i, h_[i]);
    }
    const std::vector<int> sides = cutters_;
    for (const int k : sides) {
      if (k < 0) continue;
      neighbours_.join(i, k);
      if (!lower) enqueue(k);
    }
    if (lower) enqueue(i);  // hidden sites will show
    return raise || lower;
  }

  // A height with about that mass, between one beyond it and the one that there is.
  [[nodiscard]] long double heightFor(int i, bool raise, double target) {
    const double size = std::sqrt(masses_[i]) * (y_.row(nearestTo(i)) - y_.row(i)).norm();
    long double before = h_[i], step = (raise ? kFirstStep : -kFirstStep) * size, beyond = before + step;
    double mass = massAt(i, beyond);
    for (int k = 0; k < kMostDoublings && (mass < target) == raise; ++k) {
      before = beyond, step *= 2, beyond += step;
      mass = massAt(i, beyond);
    }
    for (int k = 0; k < kMostHalvings && std::abs(std::log(mass / target)) > std::log(kNear); ++k) {
      const long double middle = (before + beyond) / 2;
      const double there = massAt(i, middle);
      const bool good = std::abs(std::log(there / target)) <= std::log(kNear);
      if ((there < target) == raise && !good) before = middle;
      else beyond = middle, mass = there;
    }
    return beyond;
  }

  // The mass of the cell of site i were its height h; its sides and what cut them off stay in polygon_ and cutters_.
  double massAt(int i, long double h) {
    polygon_ = outline_;
    cutters_.assign(polygon_.size(), -1);
    neighbours_.each(i, [&](int k) { cut(i, h, k); });
    int owner = nearestTo(i);
    cut(i, h, owner);
    neighbours_.each(owner, [&](int k) { cut(i, h, k); });
    for (int cuts = 0; cuts < kMostCuts && cutOneCorner(i, h, owner); ++cuts) continue;
    if (polygon_.size() < 3) return 0;
    double area = 0;
    Eigen::Vector2d middle = Eigen::Vector2d::Zero();
    for (std::size_t k = 0; k < polygon_.size(); ++k) {
      const Eigen::Vector2d a = polygon_[k] - polygon_[0], b = polygon_[(k + 1) % polygon_.size()] - polygon_[0];
      area += 0.5 * (a.x() * b.y() - a.y() * b.x());
      middle += polygon_[k] / static_cast<double>(polygon_.size());
    }
    return area * diagram_.densityAt(middle);
  }

  // A site with a cell near site i: by a walk from one of its group.
  [[nodiscard]] int nearestTo(int i) const {
    const auto distance = [&](int k) { return k == i ? kFar : (y_.row(k) - y_.row(i)).squaredNorm(); };
    int nearest = beginOf(i);
    double least = distance(nearest);
    for (int from = -1; from != nearest;) {
      from = nearest;
      neighbours_.each(from, [&](int k) {
        if (distance(k) < least) least = distance(k), nearest = k;
      });
    }
    return nearest;
  }

  // Cuts off a corner that belongs to another site. False when there is none.
  bool cutOneCorner(int i, long double h, int& owner) {
    for (const Eigen::Vector2d& corner : polygon_) {
      owner = ownerOf(corner, owner);
      if (owner == i) continue;
      const double lead = static_cast<double>(h_[owner] - h) + (y_.row(owner) - y_.row(i)).dot(corner.transpose());
      if (!(lead > kRounding)) continue;
      cut(i, h, owner);
      return true;
    }
    return false;
  }

  // From cell to cell upwards; u is convex.
  [[nodiscard]] int ownerOf(const Eigen::Vector2d& x, int begin) const {
    const auto height = [&](int k) { return static_cast<double>(h_[k]) + y_(k, 0) * x.x() + y_(k, 1) * x.y(); };
    int owner = begin;
    double highest = height(begin);
    for (int from = -1; from != owner;) {
      from = owner;
      neighbours_.each(from, [&](int k) {
        const double other = height(k);
        if (other > highest) highest = other, owner = k;
      });
    }
    return owner;
  }

  // What of the polygon is above site k.
  void cut(int i, long double h, int k) {
    if (k == i) return;
    const Eigen::Vector2d normal = (y_.row(i) - y_.row(k)).transpose();
    const double offset = static_cast<double>(h_[k] - h);
    kept_.clear(), keptCutters_.clear();
    for (std::size_t a = 0; a < polygon_.size(); ++a) {
      const Eigen::Vector2d &p = polygon_[a], &q = polygon_[(a + 1) % polygon_.size()];
      const double first = normal.dot(p) - offset, second = normal.dot(q) - offset;
      if (first >= 0) kept_.push_back(p), keptCutters_.push_back(cutters_[a]);
      if ((first >= 0) == (second >= 0)) continue;
      kept_.push_back(p + first / (first - second) * (q - p));
      keptCutters_.push_back(first >= 0 ? k : cutters_[a]);
    }
    polygon_.swap(kept_), cutters_.swap(keptCutters_);
  }

  const PowerDiagram& diagram_;
  const Points2& y_;
  const Eigen::VectorXd& masses_;
  const std::vector<int>& clusterOf_;
  Heights& h_;
  Neighbours neighbours_;
  std::vector<Eigen::Vector2d> outline_, polygon_, kept_;
  std::vector<int> cutters_, keptCutters_;  // per side of the polygon; −1 on the boundary of the domain
  std::vector<int> beginOf_;                // per group, a site with a cell; −1 when there is none
  int anywhere_ = -1;
  std::vector<int> queue_;
  std::vector<char> queued_;
};

}  // namespace

int mendCells(const PowerDiagram& diagram, const Eigen::VectorXd& masses, const std::vector<int>& clusterOf,
              int clusters, Heights& heights) {
  return Mending(diagram, masses, clusterOf, clusters, heights).run();
}

}  // namespace authalic
