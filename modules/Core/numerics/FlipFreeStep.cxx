#include "Core/numerics/FlipFreeStep.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>
#include <utility>

namespace authalic {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

double positiveOrInfinite(double root) { return root > 0 ? root : kInfinity; }

}  // namespace

double smallestPositiveRoot(double a, double b, double c) noexcept {
  if (!(c > 0)) return 0;
  const double discriminant = b * b - 4 * a * c;
  if (!(discriminant >= 0)) return kInfinity;
  const double q = -0.5 * (b + std::copysign(std::sqrt(discriminant), b));
  if (q == 0) return kInfinity;  // b = 0 and a = 0: the area is constant
  const double first = positiveOrInfinite(c / q);
  return a == 0 ? first : std::min(first, positiveOrInfinite(q / a));
}

double smallestPositiveRoot(double a, double b, double c, double d, double farthest) noexcept {
  if (!(d > 0)) return 0;
  const double t = farthest;
  if (((std::abs(a) * t + std::abs(b)) * t + std::abs(c)) * t < d) return kInfinity;
  const auto value = [&](double x) { return ((a * x + b) * x + c) * x + d; };
  // The extrema within (0, farthest), in order, divide it into parts where the cubic is monotone.
  double ends[3] = {farthest, farthest, farthest};
  int count = 0;
  const double discriminant = b * b - 3 * a * c;
  if (discriminant >= 0) {
    const double q = -(b + std::copysign(std::sqrt(discriminant), b));
    for (const double extremum : {a != 0 ? q / (3 * a) : -1.0, q != 0 ? c / q : -1.0}) {
      if (extremum > 0 && extremum < farthest) ends[count++] = extremum;
    }
    if (count == 2 && ends[0] > ends[1]) std::swap(ends[0], ends[1]);
  }
  double low = 0;
  for (int part = 0; part <= count; low = ends[part++]) {
    if (value(ends[part]) > 0) continue;
    double high = ends[part];
    for (int halving = 0; halving < 50; ++halving) {
      const double middle = 0.5 * (low + high);
      (value(middle) > 0 ? low : high) = middle;
    }
    return low;
  }
  return kInfinity;
}

double firstFlip(const Points2& p, const Points2& v, int a, int b, int c) noexcept {
  const double ex = p(b, 0) - p(a, 0), ey = p(b, 1) - p(a, 1), fx = p(c, 0) - p(a, 0), fy = p(c, 1) - p(a, 1);
  const double dx = v(b, 0) - v(a, 0), dy = v(b, 1) - v(a, 1), gx = v(c, 0) - v(a, 0), gy = v(c, 1) - v(a, 1);
  return smallestPositiveRoot(dx * gy - dy * gx, ex * gy - ey * gx + dx * fy - dy * fx, ex * fy - ey * fx);
}

double flipFreeStep(const Points2& points, const Points2& velocities, const Faces& faces,
                    const Execution& execution) {
  double smallest = kInfinity;
  std::mutex guard;
  parallelFor(static_cast<std::size_t>(faces.rows()), execution, [&](std::size_t begin, std::size_t end) {
    double mine = kInfinity;
    for (auto f = static_cast<Eigen::Index>(begin); f < static_cast<Eigen::Index>(end); ++f) {
      mine = std::min(mine, firstFlip(points, velocities, faces(f, 0), faces(f, 1), faces(f, 2)));
    }
    const std::lock_guard<std::mutex> lock(guard);
    smallest = std::min(smallest, mine);
  }, 16384);
  return smallest;
}

}  // namespace authalic
