#include "Core/transport/DensityIntegrals.h"

#include <utility>

namespace authalic {

DensityIntegrals::DensityIntegrals(const PiecewiseLinearDensity& density)
    : density_(density), seen_(density.pieces().size(), 0) {}

// The part of the cell in a piece, as part_.
bool DensityIntegrals::cut(const DensityPiece& piece) {
  if (!clip(whole_, piece.sides[0], 0, other_) || !clip(other_, piece.sides[1], 1, part_)) return false;
  std::swap(part_, other_);
  return clip(other_, piece.sides[2], 2, part_);
}

void DensityIntegrals::visit(int piece) {
  if (piece < 0 || seen_[static_cast<std::size_t>(piece)] == cells_) return;
  seen_[static_cast<std::size_t>(piece)] = cells_;
  queue_.push_back(piece);
}

void DensityIntegrals::addSides(const LinearFunction& density) {
  for (std::size_t k = 0; k < part_.corners.size(); ++k) {
    if (part_.origins[k] < 0 || part_.sweeps[k] != 0) continue;
    const Eigen::Vector2d &a = part_.corners[k], &b = part_.corners[(k + 1) % part_.corners.size()];
    sides_[static_cast<std::size_t>(part_.origins[k])] += 0.5 * (density.at(a) + density.at(b)) * (b - a).norm();
  }
}

CellMoments DensityIntegrals::over(const CellOutline& cell, const Eigen::Vector2d& inside,
                                   const Eigen::Vector2d& site) {
  ++cells_;
  queue_.clear();
  sides_.assign(cell.corners.size(), 0);
  uncut(cell, whole_);
  visit(density_.pieceAt(inside));
  CellMoments sum;
  for (std::size_t next = 0; next < queue_.size(); ++next) {
    const DensityPiece& piece = density_.pieces()[static_cast<std::size_t>(queue_[next])];
    if (!cut(piece)) {
      if (next > 0) continue;
      for (const int beyond : piece.beyond) visit(beyond);  // a cell so thin that rounding puts it beside its point
      continue;
    }
    const CellMoments moments = momentsOf(part_, piece.density, site);
    sum.area += moments.area;
    sum.first += moments.first;
    sum.cost += moments.cost;
    addSides(piece.density);
    for (const int origin : part_.origins) {
      if (origin < 0) visit(piece.beyond[static_cast<std::size_t>(-1 - origin)]);
    }
  }
  return sum;
}

}  // namespace authalic
