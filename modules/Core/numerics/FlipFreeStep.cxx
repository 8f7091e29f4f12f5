#include "Core/numerics/FlipFreeStep.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>

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
