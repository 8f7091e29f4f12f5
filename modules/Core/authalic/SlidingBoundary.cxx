#include "Core/authalic/SlidingBoundary.h"

namespace authalic {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

}  // namespace

SlidingBoundary::SlidingBoundary(const BoundaryPlacement& placement, const PlanarDomain& domain, const Points2& image)
    : freedom_(static_cast<std::size_t>(image.rows()), 2),
      along_(static_cast<std::size_t>(image.rows()), Eigen::RowVector2d::Zero()),
      circle_(domain.isDisk()) {
  const auto& corner = domain.corners();
  for (std::size_t i = 0; i < placement.vertices.size(); ++i) {
    const int v = placement.vertices[i], k = placement.side[i];
    switch (placement.role[i]) {
      case BoundaryRole::Corner: freedom_[at(v)] = 0; fixed_.push_back(v); break;
      case BoundaryRole::Side:
        along_[at(v)] = (corner.row((k + 1) % corner.rows()) - corner.row(k)).normalized();
        [[fallthrough]];
      case BoundaryRole::Circle: freedom_[at(v)] = 1; sliders_.push_back(v); break;
      case BoundaryRole::Pocket: break;
    }
  }
  attachPockets(placement, image);
}

void SlidingBoundary::attachPockets(const BoundaryPlacement& placement, const Points2& image) {
  for (int v = 0; v < static_cast<int>(placement.pocketOf.size()); ++v) {
    if (placement.pocketOf[at(v)] < 0) continue;
    const auto [from, to] = placement.pockets[at(placement.pocketOf[at(v)])];
    const Eigen::RowVector2d chord = image.row(to) - image.row(from), offset = image.row(v) - image.row(from);
    const double square = chord.squaredNorm();
    riders_.push_back(
        {v, from, to, offset.dot(chord) / square, (chord[0] * offset[1] - chord[1] * offset[0]) / square});
  }
}

Eigen::RowVector2d SlidingBoundary::tangent(const Points2& image, int vertex) const {
  if (!circle_) return along_[at(vertex)];
  return Eigen::RowVector2d(-image(vertex, 1), image(vertex, 0)).normalized();
}

void SlidingBoundary::keepTangential(const Points2& image, Points2& velocities) const {
  for (const int v : sliders_) {
    const Eigen::RowVector2d t = tangent(image, v);
    velocities.row(v) = velocities.row(v).dot(t) * t;
  }
  for (const int v : fixed_) velocities.row(v).setZero();
  for (const Rider& rider : riders_) velocities.row(rider.vertex).setZero();
}

void SlidingBoundary::retract(Points2& image) const {
  if (!circle_) return;
  for (const int v : sliders_) image.row(v).normalize();
}

void SlidingBoundary::carryPockets(Points2& image) const {
  for (const Rider& rider : riders_) {
    const Eigen::RowVector2d chord = image.row(rider.to) - image.row(rider.from);
    image.row(rider.vertex) = image.row(rider.from) + rider.along * chord +
                              rider.across * Eigen::RowVector2d(-chord[1], chord[0]);
  }
}

}  // namespace authalic
