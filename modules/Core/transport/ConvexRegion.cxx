#include "Core/transport/ConvexRegion.h"

#include <cmath>
#include <limits>

#include "Core/base/Error.h"

namespace authalic {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kSliver = 1e-9;  // of the boundary: a step back by less is rounding, not a whole turn

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

// Area, ∫ x − c and ∫ |x − c|² of the triangle c, c + a, c + b.
void addTriangle(const Eigen::Vector2d& a, const Eigen::Vector2d& b, CellMoments& sum) {
  const double area = 0.5 * cross(a, b);
  sum.area += area;
  sum.first += area / 3 * (a + b);
  sum.cost += area / 6 * (a.squaredNorm() + b.squaredNorm() + a.dot(b));
}

// The same about c of what lies between the chord of an arc of the unit circle and the arc.
void addSegment(const Eigen::Vector2d& a, double sweep, const Eigen::Vector2d& c, CellMoments& sum) {
  const double half = 0.5 * sweep, sine = std::sin(half), area = 0.5 * (sweep - std::sin(sweep));
  const Eigen::Vector2d middle(a.x() * std::cos(half) - a.y() * sine, a.x() * sine + a.y() * std::cos(half));
  const Eigen::Vector2d first = 2.0 / 3.0 * sine * sine * sine * middle;
  const double polar = sweep / 4 - std::sin(sweep) * (2 + std::cos(sweep)) / 12;
  sum.area += area;
  sum.first += first - area * c;
  sum.cost += polar - 2 * c.dot(first) + c.squaredNorm() * area;
}

double angle(const Eigen::Vector2d& p) {
  const double a = std::atan2(p.y(), p.x());
  return a < 0 ? a + 2 * kPi : a;
}

}  // namespace

CellMoments momentsOf(const CellOutline& outline, const Eigen::Vector2d& site) {
  CellMoments sum;
  if (outline.corners.empty()) return sum;
  const Eigen::Vector2d c = outline.corners.front();
  const std::size_t n = outline.corners.size();
  for (std::size_t k = 1; k + 1 < n; ++k) addTriangle(outline.corners[k] - c, outline.corners[k + 1] - c, sum);
  for (std::size_t k = 0; k < n; ++k) {
    if (outline.sweeps[k] != 0) addSegment(outline.corners[k], outline.sweeps[k], c, sum);
  }
  const Eigen::Vector2d shift = c - site;
  sum.cost += 2 * shift.dot(sum.first) + shift.squaredNorm() * sum.area;
  sum.first += sum.area * c;
  return sum;
}

ConvexRegion::ConvexRegion(const PlanarDomain& domain) : corners_(domain.corners()), arc_{0.0} {
  if (!domain.convex()) {
    throw InvalidArgument("A convex domain is required for transport, but the polygon of " +
                          std::to_string(corners_.rows()) +
                          " corners is not convex; take its convex hull or the disk.");
  }
  for (Eigen::Index k = 0; k < corners_.rows(); ++k) {
    arc_.push_back(arc_.back() + (corners_.row((k + 1) % corners_.rows()) - corners_.row(k)).norm());
  }
  if (domain.isDisk()) arc_.push_back(2 * kPi);
}

bool ConvexRegion::contains(const Eigen::Vector2d& p) const {
  if (corners_.rows() == 0) return p.squaredNorm() < 1;
  for (Eigen::Index k = 0, n = corners_.rows(); k < n; ++k) {
    const Eigen::Vector2d a = corners_.row(k), b = corners_.row((k + 1) % n);
    if (!(cross(b - a, p - a) > 0)) return false;
  }
  return true;
}

ConvexRegion::Interval ConvexRegion::along(const Eigen::Vector2d& foot, const Eigen::Vector2d& direction) const {
  if (corners_.rows() == 0) {
    const double b = foot.dot(direction), square = 1 - foot.squaredNorm() + b * b;
    return square > 0 ? Interval{-b - std::sqrt(square), -b + std::sqrt(square)} : Interval{1, -1};
  }
  Interval inside{-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  for (Eigen::Index k = 0, n = corners_.rows(); k < n; ++k) {
    const Eigen::Vector2d a = corners_.row(k), side = corners_.row((k + 1) % n).transpose() - a;
    const double speed = cross(side, direction), height = cross(side, foot - a);
    if (speed > 0) inside.low = std::max(inside.low, -height / speed);
    if (speed < 0) inside.high = std::min(inside.high, -height / speed);
    if (speed == 0 && !(height > 0)) return {1, -1};
  }
  return inside;
}

double ConvexRegion::parameter(const Eigen::Vector2d& p) const {
  if (corners_.rows() == 0) return angle(p);
  double best = 0, nearest = std::numeric_limits<double>::infinity();
  for (Eigen::Index k = 0, n = corners_.rows(); k < n; ++k) {
    const Eigen::Vector2d a = corners_.row(k), side = corners_.row((k + 1) % n).transpose() - a;
    const double length = side.norm(), t = std::min(std::max((p - a).dot(side) / length, 0.0), length);
    const double distance = (a + t / length * side - p).norm();
    if (distance < nearest) nearest = distance, best = arc_[static_cast<std::size_t>(k)] + t;
  }
  return best;
}

void ConvexRegion::addBoundary(const Eigen::Vector2d& a, const Eigen::Vector2d& b, bool whole,
                               CellOutline& outline) const {
  const double period = arc_.back(), from = parameter(a);
  double length = parameter(b) - from;
  if (corners_.rows() == 0) length = std::atan2(cross(a, b), a.dot(b));
  if (length < 0) length += period;
  if (!whole && length > (1 - kSliver) * period) length -= period;
  if (corners_.rows() == 0) return outline.add(a, length);
  outline.add(a);
  const std::size_t n = static_cast<std::size_t>(corners_.rows());
  for (std::size_t turn = 0; turn < 2 * n; ++turn) {
    const double ahead = arc_[turn % n] + (turn < n ? 0 : period) - from;
    if (ahead > 0 && ahead < length) outline.add(corners_.row(static_cast<Eigen::Index>(turn % n)));
  }
}

CellOutline ConvexRegion::outline() const {
  CellOutline all;
  if (corners_.rows() == 0) all.add({1, 0}, 2 * kPi);
  for (Eigen::Index k = 0; k < corners_.rows(); ++k) all.add(corners_.row(k));
  return all;
}

}  // namespace authalic
