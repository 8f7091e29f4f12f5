#include "Core/transport/RegularFlips.h"

#include <cmath>
#include <limits>

namespace authalic {
namespace {

using Real = long double;

constexpr Real kRounding = 8 * std::numeric_limits<Real>::epsilon();
constexpr std::size_t kMostFlips = 3;  // per site; a new triangulation is faster then

std::size_t at(int i) { return static_cast<std::size_t>(i); }

class Flipping {
 public:
  Flipping(const Points2& sites, const Heights& heights, RegularConnectivity& triangulation)
      : y_(sites), h_(heights), t_(triangulation) {}

  FlipResult run() {
    const int faces = static_cast<int>(t_.corners.size());
    for (int f = 0; f < faces; ++f) {
      for (int k = 0; k < 3; ++k) {
        if (f < t_.neighbours[at(f)][at(k)]) open_.push_back(3 * f + k);
      }
    }
    std::size_t left = kMostFlips * static_cast<std::size_t>(y_.rows());
    while (!open_.empty()) {
      const int edge = open_.back();
      open_.pop_back();
      if (regular(edge / 3, edge % 3)) continue;
      if (!convex_) {
        if (hidden(edge / 3, edge % 3)) return FlipResult::Hidden;
        stuck_ = true;
        continue;
      }
      if (left-- == 0) return FlipResult::GivenUp;
      flip(edge / 3, edge % 3);
    }
    if (stuck_ && !allRegular()) return FlipResult::GivenUp;
    return hullRegular() ? FlipResult::Regular : FlipResult::Hidden;
  }

 private:
  struct Vector {
    Real x, y;
  };
  static Real cross(const Vector& a, const Vector& b) { return a.x * b.y - a.y * b.x; }
  static Real size(const Vector& a, const Vector& b) { return std::abs(a.x * b.y) + std::abs(a.y * b.x); }
  Vector between(int i, int j) const { return {Real(y_(j, 0)) - y_(i, 0), Real(y_(j, 1)) - y_(i, 1)}; }

  // Whether the edge opposite corner k of face f may stay; convex_ says, when not, whether it can be flipped.
  bool regular(int f, int k) {
    const std::array<int, 3>& corner = t_.corners[at(f)];
    const int g = t_.neighbours[at(f)][at(k)], i = corner[at(k)], a = corner[at((k + 1) % 3)],
              b = corner[at((k + 2) % 3)];
    const int d = t_.corners[at(g)][at(mirror(f, g))];
    if (i < 0 || a < 0 || b < 0 || d < 0) return true;
    const Vector toA = between(i, a), toB = between(i, b), toD = between(i, d);
    const Real zA = h_[i] - h_[a], zB = h_[i] - h_[b], zD = h_[i] - h_[d];
    const Real ab = cross(toA, toB), db = cross(toD, toB), ad = cross(toA, toD);
    const Real depth = zD * ab - zA * db - zB * ad;
    const Real error = kRounding * (std::abs(zD) * size(toA, toB) + std::abs(zA) * size(toD, toB) +
                                    std::abs(zB) * size(toA, toD));
    if (depth >= -error) return true;
    convex_ = ad > 0 && db > 0;
    return false;
  }

  // The corner of g whose opposite edge leads to f.
  [[nodiscard]] int mirror(int f, int g) const {
    const std::array<int, 3>& neighbour = t_.neighbours[at(g)];
    return neighbour[0] == f ? 0 : neighbour[1] == f ? 1 : 2;
  }

  // Whether an end of that edge, which is not regular, has three neighbours only: i, d and the other end.
  [[nodiscard]] bool hidden(int f, int k) const {
    const int g = t_.neighbours[at(f)][at(k)], m = mirror(f, g);
    const std::array<int, 3>&around = t_.neighbours[at(f)], &beyond = t_.neighbours[at(g)];
    return around[at((k + 2) % 3)] == beyond[at((m + 1) % 3)] || around[at((k + 1) % 3)] == beyond[at((m + 2) % 3)];
  }

  // (i, a, b) and (d, b, a) become (i, a, d) and (d, b, i).
  void flip(int f, int k) {
    const int g = t_.neighbours[at(f)][at(k)], m = mirror(f, g);
    std::array<int, 3>&first = t_.corners[at(f)], &second = t_.corners[at(g)];
    std::array<int, 3>&around = t_.neighbours[at(f)], &beyond = t_.neighbours[at(g)];
    const int k1 = (k + 1) % 3, k2 = (k + 2) % 3, m1 = (m + 1) % 3, m2 = (m + 2) % 3;
    const int i = first[at(k)], a = first[at(k1)], b = first[at(k2)], d = second[at(m)];
    const int overIB = around[at(k1)], overAD = beyond[at(m1)];
    first[at(k2)] = d, second[at(m2)] = i;
    t_.neighbours[at(overAD)][at(mirror(g, overAD))] = f;
    t_.neighbours[at(overIB)][at(mirror(f, overIB))] = g;
    around[at(k)] = overAD, around[at(k1)] = g;
    beyond[at(m)] = overIB, beyond[at(m1)] = f;
    t_.faceOf[at(a)] = t_.faceOf[at(i)] = f, t_.faceOf[at(b)] = t_.faceOf[at(d)] = g;
    for (const int corner : {k, k2}) open_.push_back(3 * f + corner);
    for (const int corner : {m, m2}) open_.push_back(3 * g + corner);
  }

  bool allRegular() {
    for (int f = 0; f < static_cast<int>(t_.corners.size()); ++f) {
      for (int k = 0; k < 3; ++k) {
        if (f < t_.neighbours[at(f)][at(k)] && !regular(f, k)) return false;
      }
    }
    return true;
  }

  // Sites of the hull on a straight line: none above the segment of its neighbours.
  [[nodiscard]] bool hullRegular() const {
    for (int f = 0; f < static_cast<int>(t_.corners.size()); ++f) {
      const std::array<int, 3>& corner = t_.corners[at(f)];
      const int k = corner[0] < 0 ? 0 : corner[1] < 0 ? 1 : corner[2] < 0 ? 2 : -1;
      if (k < 0) continue;
      const int before = corner[at((k + 1) % 3)], middle = corner[at((k + 2) % 3)];
      const int g = t_.neighbours[at(f)][at((k + 1) % 3)], after = t_.corners[at(g)][at(mirror(f, g))];
      const Vector one = between(middle, before), other = between(middle, after);
      if (cross(one, other) > kRounding * size(one, other)) continue;  // a true corner; the hull runs clockwise here
      const Real p = std::hypot(one.x, one.y), q = std::hypot(other.x, other.y);
      if (q * (h_[middle] - h_[before]) + p * (h_[middle] - h_[after]) < 0) return false;
    }
    return true;
  }

  const Points2& y_;
  const Heights& h_;
  RegularConnectivity& t_;
  std::vector<int> open_;
  bool convex_ = false, stuck_ = false;
};

}  // namespace

FlipResult flipToRegular(const Points2& sites, const Heights& heights, RegularConnectivity& triangulation) {
  return Flipping(sites, heights, triangulation).run();
}

}  // namespace authalic
