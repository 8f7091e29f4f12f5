#include "Core/authalic/RoomOnCircle.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace authalic {
namespace {

constexpr double kFullCircle = 6.283185307179586;
constexpr double kShortest = 1e-2;  // of the mean arc
constexpr double kMostOfCircle = 0.5;
constexpr double kSmallPiece = 0.1;  // of the area

std::size_t at(Eigen::Index i) { return static_cast<std::size_t>(i); }

// What an inner edge between two boundary vertices, a chord, cuts off.
struct Piece {
  Eigen::Index first, count;  // arcs, around the circle
  double share;
};

// The parts between the chords, a tree.
class Pieces {
 public:
  // @param place  per vertex, −1 inside
  Pieces(const SurfaceTopology& topology, const std::vector<int>& place, const Eigen::VectorXd& shares)
      : topology_(topology), place_(place), part_(at(shares.size()), -1) {
    for (int f = 0; f < static_cast<int>(shares.size()); ++f) {
      if (part_[at(f)] < 0) grow(f, shares);
    }
  }

  // A piece comes after those that lie in it.
  [[nodiscard]] std::vector<Piece> all(Eigen::Index arcCount) {
    const auto largest = std::max_element(shares_.begin(), shares_.end()) - shares_.begin();
    std::vector<std::pair<int, int>> entered;  // half-edges of chords: of the part behind, and of the one before
    std::vector<char> reached(shares_.size(), 0);
    reached[at(largest)] = 1;
    std::vector<std::size_t> waiting{at(largest)};
    for (std::size_t k = 0; k < waiting.size(); ++k) {
      for (const int h : chords_[waiting[k]]) {
        const int behind = topology_.opposite(h);
        const std::size_t part = at(part_[at(behind / 3)]);
        if (std::exchange(reached[part], 1)) continue;
        entered.emplace_back(behind, h);
        waiting.push_back(part);
      }
    }
    std::vector<Piece> result;
    for (auto chord = entered.rbegin(); chord != entered.rend(); ++chord) {
      const auto [behind, before] = *chord;
      const double share = shares_[at(part_[at(behind / 3)])];
      shares_[at(part_[at(before / 3)])] += share;
      const Eigen::Index first = place_[at(topology_.head(behind))], end = place_[at(topology_.tail(behind))];
      result.push_back({first, (end - first + arcCount) % arcCount, share});
    }
    return result;
  }

 private:
  [[nodiscard]] bool isChord(int h) const {
    return place_[at(topology_.tail(h))] >= 0 && place_[at(topology_.head(h))] >= 0;
  }

  void grow(int seed, const Eigen::VectorXd& shares) {
    const int part = static_cast<int>(shares_.size());
    shares_.push_back(0);
    chords_.emplace_back();
    std::vector<int> waiting{seed};
    part_[at(seed)] = part;
    while (!waiting.empty()) {
      const int f = waiting.back();
      waiting.pop_back();
      shares_.back() += shares[f];
      for (int h = 3 * f; h < 3 * f + 3; ++h) {
        const int across = topology_.opposite(h);
        if (across < 0) continue;
        if (isChord(h)) {
          chords_.back().push_back(h);
        } else if (part_[at(across / 3)] < 0) {
          part_[at(across / 3)] = part;
          waiting.push_back(across / 3);
        }
      }
    }
  }

  const SurfaceTopology& topology_;
  const std::vector<int>& place_;
  std::vector<int> part_;  // of faces
  std::vector<double> shares_;
  std::vector<std::vector<int>> chords_;  // half-edges of each part
};

// Arcs from each vertex of the placement to the next.
Eigen::ArrayXd arcsOf(const BoundaryPlacement& placement) {
  const Eigen::Index n = placement.points.rows();
  Eigen::ArrayXd arcs(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const Eigen::RowVector2d p = placement.points.row(i), q = placement.points.row((i + 1) % n);
    const double turn = std::atan2(p[0] * q[1] - p[1] * q[0], p.dot(q));
    arcs[i] = turn < 0 ? turn + kFullCircle : turn;
  }
  return arcs;
}

Eigen::ArrayXd leastArcs(const DiskMesh& disk, const TargetMeasure& target, const BoundaryPlacement& placement,
                         const Eigen::ArrayXd& arcs) {
  const Eigen::Index n = arcs.size();
  std::vector<int> place(at(disk.mesh().vertexCount()), -1), count(place.size(), 0), last(place.size(), -1);
  for (Eigen::Index i = 0; i < n; ++i) place[at(placement.vertices[at(i)])] = static_cast<int>(i);
  const Faces& faces = disk.mesh().faces();
  for (Eigen::Index f = 0; f < faces.rows(); ++f) {
    for (int k = 0; k < 3; ++k) {
      ++count[at(faces(f, k))];
      last[at(faces(f, k))] = static_cast<int>(f);
    }
  }
  Eigen::ArrayXd least = Eigen::ArrayXd::Constant(n, kShortest * kFullCircle / static_cast<double>(n));
  for (std::size_t v = 0; v < place.size(); ++v) {
    if (place[v] < 0 || count[v] != 1) continue;
    const double arc = std::cbrt(kFullCircle * target.faces()[last[v]]);
    for (const Eigen::Index i : {Eigen::Index(place[v]), (place[v] + n - 1) % n}) least[i] = std::max(least[i], arc);
  }
  for (const Piece& piece : Pieces(disk.topology(), place, target.faces()).all(n)) {
    if (piece.share > kSmallPiece) continue;
    double has = 0, room = 0;
    for (Eigen::Index k = 0; k < piece.count; ++k) {
      has += arcs[(piece.first + k) % n];
      room += least[(piece.first + k) % n];
    }
    const double wanted = 2 * std::cbrt(kFullCircle * piece.share);
    for (Eigen::Index k = 0; k < piece.count && room < wanted; ++k) {
      const Eigen::Index i = (piece.first + k) % n;
      least[i] = std::max(least[i], wanted * arcs[i] / has);
    }
  }
  return least * std::min(1.0, kMostOfCircle * kFullCircle / least.sum());
}

// max(s · arc, least) with s such that the sum is the circle.
Eigen::ArrayXd widened(const Eigen::ArrayXd& arcs, const Eigen::ArrayXd& least) {
  double low = 0, high = 1;
  for (int halving = 0; halving < 60; ++halving) {
    const double scale = 0.5 * (low + high);
    ((scale * arcs).max(least).sum() < kFullCircle ? low : high) = scale;
  }
  return (low * arcs).max(least);
}

}  // namespace

void makeRoomOnCircle(const DiskMesh& disk, const TargetMeasure& target, BoundaryPlacement& placement) {
  const Eigen::ArrayXd arcs = arcsOf(placement), least = leastArcs(disk, target, placement, arcs);
  if ((arcs >= least).all()) return;
  const Eigen::ArrayXd wide = widened(arcs, least);
  double angle = std::atan2(placement.points(0, 1), placement.points(0, 0));
  for (Eigen::Index i = 0; i < wide.size(); ++i) {
    placement.points.row(i) << std::cos(angle), std::sin(angle);
    angle += wide[i];
  }
}

}  // namespace authalic
