#include "Core/authalic/RoomOnCircle.h"

#include <algorithm>
#include <cmath>

namespace authalic {
namespace {

constexpr double kFullCircle = 6.283185307179586;
constexpr double kShortest = 1e-2;  // of the mean arc
constexpr double kMostOfCircle = 0.5;

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

Eigen::ArrayXd leastArcs(const DiskMesh& disk, const TargetMeasure& target, const BoundaryPlacement& placement) {
  const auto n = static_cast<Eigen::Index>(placement.vertices.size());
  std::vector<int> place(static_cast<std::size_t>(disk.mesh().vertexCount()), -1), count(place.size(), 0),
      last(place.size(), -1);
  for (Eigen::Index i = 0; i < n; ++i)
    place[static_cast<std::size_t>(placement.vertices[static_cast<std::size_t>(i)])] = static_cast<int>(i);
  const Faces& faces = disk.mesh().faces();
  for (Eigen::Index f = 0; f < faces.rows(); ++f) {
    for (int k = 0; k < 3; ++k) {
      ++count[static_cast<std::size_t>(faces(f, k))];
      last[static_cast<std::size_t>(faces(f, k))] = static_cast<int>(f);
    }
  }
  Eigen::ArrayXd least = Eigen::ArrayXd::Constant(n, kShortest * kFullCircle / static_cast<double>(n));
  for (std::size_t v = 0; v < place.size(); ++v) {
    if (place[v] < 0 || count[v] != 1) continue;
    const double arc = std::cbrt(kFullCircle * target.faces()[last[v]]);
    for (const Eigen::Index i : {Eigen::Index(place[v]), (place[v] + n - 1) % n}) least[i] = std::max(least[i], arc);
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
  const Eigen::ArrayXd arcs = arcsOf(placement), least = leastArcs(disk, target, placement);
  if ((arcs >= least).all()) return;
  const Eigen::ArrayXd wide = widened(arcs, least);
  double angle = std::atan2(placement.points(0, 1), placement.points(0, 0));
  for (Eigen::Index i = 0; i < wide.size(); ++i) {
    placement.points.row(i) << std::cos(angle), std::sin(angle);
    angle += wide[i];
  }
}

}  // namespace authalic
