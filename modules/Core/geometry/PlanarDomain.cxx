#include "Core/geometry/PlanarDomain.h"

#include <cmath>
#include <string>
#include <vector>

#include "Core/base/Error.h"
#include "Core/geometry/Areas.h"

namespace authalic {
namespace {

constexpr double kPi = 3.14159265358979323846;

double cross(const Eigen::RowVector2d& u, const Eigen::RowVector2d& v) { return u[0] * v[1] - u[1] * v[0]; }

double turn(const Points2& p, Eigen::Index a, Eigen::Index b, Eigen::Index c) {
  return cross(p.row(b) - p.row(a), p.row(c) - p.row(b));
}

bool within(const Points2& p, Eigen::Index a, Eigen::Index b, Eigen::Index c) {
  return (p.row(c) - p.row(a)).dot(p.row(c) - p.row(b)) <= 0;
}

bool sidesMeet(const Points2& p, Eigen::Index a, Eigen::Index b, Eigen::Index c, Eigen::Index d) {
  const double abc = turn(p, a, b, c), abd = turn(p, a, b, d), cda = turn(p, c, d, a), cdb = turn(p, c, d, b);
  if (((abc > 0) != (abd > 0)) && ((cda > 0) != (cdb > 0)) && abc != 0 && abd != 0 && cda != 0 && cdb != 0) return true;
  return (abc == 0 && within(p, a, b, c)) || (abd == 0 && within(p, a, b, d)) || (cda == 0 && within(p, c, d, a)) ||
         (cdb == 0 && within(p, c, d, b));
}

Points2 withoutStraightCorners(const Points2& p) {
  std::vector<Eigen::Index> kept;
  const Eigen::Index n = p.rows();
  for (Eigen::Index i = 0; i < n; ++i) {
    const Eigen::Index before = (i + n - 1) % n, after = (i + 1) % n;
    const double lengths = (p.row(i) - p.row(before)).norm() * (p.row(after) - p.row(i)).norm();
    if (lengths == 0) {
      throw InvalidArgument("Different polygon corners are required, but corner " + std::to_string(i) +
                            " coincides with a neighbour; remove it.");
    }
    if (std::abs(turn(p, before, i, after)) > 1e-10 * lengths) kept.push_back(i);
  }
  Points2 result(static_cast<Eigen::Index>(kept.size()), 2);
  for (std::size_t k = 0; k < kept.size(); ++k) result.row(static_cast<Eigen::Index>(k)) = p.row(kept[k]);
  return result;
}

void requireSimple(const Points2& p) {
  const Eigen::Index n = p.rows();
  for (Eigen::Index i = 0; i < n; ++i) {
    for (Eigen::Index j = i + 2; j < n; ++j) {
      if (i == 0 && j == n - 1) continue;
      if (!sidesMeet(p, i, (i + 1) % n, j, (j + 1) % n)) continue;
      throw InvalidArgument("A polygon whose sides do not cross is required, but sides " + std::to_string(i) +
                            " and " + std::to_string(j) + " meet; reorder its corners.");
    }
  }
}

}  // namespace

PlanarDomain PlanarDomain::rectangle(double aspect) {
  if (!(aspect >= 0.01 && aspect <= 100)) {
    throw InvalidArgument("A rectangle's aspect (width / height) from 0.01 to 100 is required, but it is " +
                          std::to_string(aspect) + ".");
  }
  Points2 corners(4, 2);
  corners << 0, 0, aspect, 0, aspect, 1, 0, 1;
  return polygon(corners);
}

PlanarDomain PlanarDomain::polygon(const Points2& given) {
  if (given.rows() < 3 || !given.allFinite()) {
    throw InvalidArgument("A polygon of at least 3 finite corners is required, but it has " +
                          std::to_string(given.rows()) + (given.allFinite() ? "." : ", not all of them finite."));
  }
  PlanarDomain domain;
  domain.corners_ = withoutStraightCorners(given);
  if (domain.corners_.rows() < 3) {
    throw InvalidArgument("A polygon with a positive area is required, but its corners lie on one line.");
  }
  requireSimple(domain.corners_);
  if (polygonArea(domain.corners_) < 0) domain.corners_ = domain.corners_.colwise().reverse().eval();
  const Eigen::Index n = domain.corners_.rows();
  for (Eigen::Index i = 0; i < n; ++i) {
    domain.convex_ = domain.convex_ && turn(domain.corners_, i, (i + 1) % n, (i + 2) % n) > 0;
  }
  return domain;
}

double PlanarDomain::area() const { return isDisk() ? kPi : polygonArea(corners_); }

}  // namespace authalic
