#include "Core/transport/OutlineClipping.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace authalic {
namespace {

constexpr double kPi = 3.14159265358979323846;

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

Eigen::Vector2d turned(const Eigen::Vector2d& p, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {c * p.x() - s * p.y(), s * p.x() + c * p.y()};
}

// Puts what is kept of the sides together, with a side along the cut wherever there is a gap.
class Assembly {
 public:
  Assembly(int sides, int tag, ClippedOutline& part) : sides_(sides), tag_(tag), part_(part) { part.clear(); }

  // From corner `begins` to corner `ends` of the whole; −1 for a point within the side.
  void keep(int origin, double sweep, const Eigen::Vector2d& from, int begins, const Eigen::Vector2d& to, int ends) {
    if (part_.corners.empty()) first_ = begins;
    else close(begins);
    part_.add(from, sweep, origin);
    end_ = to, last_ = ends == sides_ ? 0 : ends;
  }

  void close() {
    if (!part_.corners.empty()) close(first_);
  }

 private:
  void close(int next) {
    if (last_ < 0 || last_ != next) part_.add(end_, 0, -1 - tag_);
  }

  int sides_, tag_, first_ = -1, last_ = -1;
  ClippedOutline& part_;
  Eigen::Vector2d end_ = Eigen::Vector2d::Zero();
};

// Angles from the start of an arc at which it may cross the line, its ends included.
struct ArcParts {
  std::array<double, 4> angles;
  int count = 0;
  void add(double angle) { angles[static_cast<std::size_t>(count++)] = angle; }
};

ArcParts partsOf(const Eigen::Vector2d& start, double sweep, const HalfPlane& half) {
  const double along = half.normal.dot(start), across = cross(start, half.normal);
  const double cosine = half.normal.dot(half.point) / std::hypot(along, across);
  ArcParts parts;
  parts.add(0);
  if (std::abs(cosine) < 1) {
    const double phase = std::atan2(across, along), opening = std::acos(cosine);
    for (const double angle : {phase - opening, phase + opening}) {
      const double ahead = angle - 2 * kPi * std::floor(angle / (2 * kPi));
      if (ahead > 0 && ahead < sweep) parts.add(ahead);
    }
    if (parts.count == 3 && parts.angles[1] > parts.angles[2]) std::swap(parts.angles[1], parts.angles[2]);
  }
  parts.add(sweep);
  return parts;
}

// Keeps the parts of an arc that are inside, judged by their middles; whether there are any.
bool keepArc(const ClippedOutline& whole, int side, const HalfPlane& half, Assembly& assembly) {
  const std::size_t k = static_cast<std::size_t>(side), next = (k + 1) % whole.corners.size();
  const Eigen::Vector2d& start = whole.corners[k];
  const ArcParts parts = partsOf(start, whole.sweeps[k], half);
  bool any = false;
  for (int p = 0; p + 1 < parts.count; ++p) {
    const double from = parts.angles[static_cast<std::size_t>(p)], to = parts.angles[static_cast<std::size_t>(p) + 1];
    if (!(half.depth(turned(start, 0.5 * (from + to))) > 0)) continue;
    const bool atStart = p == 0, atEnd = p + 2 == parts.count;
    assembly.keep(whole.origins[k], to - from, atStart ? start : turned(start, from), atStart ? side : -1,
                  atEnd ? whole.corners[next] : turned(start, to), atEnd ? side + 1 : -1);
    any = true;
  }
  return any;
}

// Area, ∫ ρ x and ∫ ρ |x|² of the triangle 0, a, b in which ρ is q0, q1, q2 at the corners.
void addTriangle(const Eigen::Vector2d& a, const Eigen::Vector2d& b, double q0, double q1, double q2,
                 CellMoments& sum) {
  const double area = 0.5 * cross(a, b);
  sum.area += area / 3 * (q0 + q1 + q2);
  sum.first += area / 12 * ((q0 + 2 * q1 + q2) * a + (q0 + q1 + 2 * q2) * b);
  sum.cost += area / 30 * ((q0 + 3 * q1 + q2) * a.squaredNorm() + (q0 + 2 * q1 + 2 * q2) * a.dot(b) +
                           (q0 + q1 + 3 * q2) * b.squaredNorm());
}

// The same about c of what lies between the chord of an arc of the unit circle and the arc: ∫ x^p y^q over it in the
// frame whose first axis points to the middle of the arc, half an angle h from its ends.
void addSegment(const Eigen::Vector2d& a, double sweep, const Eigen::Vector2d& c, const LinearFunction& density,
                CellMoments& sum) {
  const double h = 0.5 * sweep, s = std::sin(h), cube = s * s * s, fifth = cube * s * s;
  const double m00 = h - 0.5 * std::sin(2 * h), m10 = 2.0 / 3.0 * cube;
  const double m20 = h / 4 - std::sin(4 * h) / 16, m02 = h / 4 - std::sin(2 * h) / 6 + std::sin(4 * h) / 48;
  const double m30 = 2 * (cube / 3 - fifth / 5), m12 = 2.0 / 15.0 * fifth;
  const Eigen::Vector2d u = turned(a, h), v(-u.y(), u.x());
  const double value = density.at(Eigen::Vector2d::Zero()), gu = density.gradient.dot(u), gv = density.gradient.dot(v);
  const double mass = value * m00 + gu * m10;
  const Eigen::Vector2d first = (value * m10 + gu * m20) * u + gv * m02 * v;
  sum.area += mass;
  sum.first += first - mass * c;
  sum.cost += value * (m20 + m02) + gu * (m30 + m12) - 2 * c.dot(first) + c.squaredNorm() * mass;
}

}  // namespace

void uncut(const CellOutline& outline, ClippedOutline& result) {
  result.clear();
  for (std::size_t k = 0; k < outline.corners.size(); ++k) {
    const int parts = std::max(1, static_cast<int>(std::ceil(2 * outline.sweeps[k] / kPi)));
    const double sweep = outline.sweeps[k] / parts;
    for (int p = 0; p < parts; ++p) {
      result.add(p == 0 ? outline.corners[k] : turned(outline.corners[k], p * sweep), sweep, static_cast<int>(k));
    }
  }
}

bool clip(const ClippedOutline& whole, const HalfPlane& half, int tag, ClippedOutline& part) {
  const int n = static_cast<int>(whole.corners.size());
  Assembly assembly(n, tag, part);
  bool inside = false;
  for (int k = 0; k < n; ++k) {
    const std::size_t here = static_cast<std::size_t>(k);
    if (whole.sweeps[here] != 0) {
      inside = keepArc(whole, k, half, assembly) || inside;
      continue;
    }
    const Eigen::Vector2d &a = whole.corners[here], &b = whole.corners[(here + 1) % whole.corners.size()];
    const double da = half.depth(a), db = half.depth(b);
    inside = inside || da > 0 || db > 0;
    if (da >= 0 && db >= 0) {
      assembly.keep(whole.origins[here], 0, a, k, b, k + 1);
    } else if (da > 0 || db > 0) {
      const Eigen::Vector2d crossing = a + da / (da - db) * (b - a);
      if (da > 0) assembly.keep(whole.origins[here], 0, a, k, crossing, -1);
      else assembly.keep(whole.origins[here], 0, crossing, -1, b, k + 1);
    }
  }
  if (inside) assembly.close();
  else part.clear();
  return inside;
}

CellMoments momentsOf(const CellOutline& outline, const LinearFunction& density, const Eigen::Vector2d& site) {
  CellMoments sum;
  if (outline.corners.empty()) return sum;
  const Eigen::Vector2d c = outline.corners.front();
  const std::size_t n = outline.corners.size();
  const double atFirst = density.at(c);
  for (std::size_t k = 1; k + 1 < n; ++k) {
    const Eigen::Vector2d &a = outline.corners[k], &b = outline.corners[k + 1];
    addTriangle(a - c, b - c, atFirst, density.at(a), density.at(b), sum);
  }
  for (std::size_t k = 0; k < n; ++k) {
    if (outline.sweeps[k] != 0) addSegment(outline.corners[k], outline.sweeps[k], c, density, sum);
  }
  const Eigen::Vector2d shift = c - site;
  sum.cost += 2 * shift.dot(sum.first) + shift.squaredNorm() * sum.area;
  sum.first += sum.area * c;
  return sum;
}

Least leastOf(const LinearFunction& function, const CellOutline& outline) {
  Least least{std::numeric_limits<double>::infinity(), Eigen::Vector2d::Zero()};
  const auto look = [&](const Eigen::Vector2d& place) {
    if (function.at(place) < least.value) least = {function.at(place), place};
  };
  const double steepness = function.gradient.norm();
  for (std::size_t k = 0; k < outline.corners.size(); ++k) {
    look(outline.corners[k]);
    if (outline.sweeps[k] == 0 || !(steepness > 0)) continue;
    const Eigen::Vector2d down = -function.gradient / steepness, start = outline.corners[k];
    const double angle = std::atan2(cross(start, down), start.dot(down));
    if ((angle < 0 ? angle + 2 * kPi : angle) < outline.sweeps[k]) look(down);
  }
  return least;
}

}  // namespace authalic
