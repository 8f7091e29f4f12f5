/// @file
/// Integrals of a piecewise linear density over cells of a power diagram. Private to transport/.
#pragma once

#include <vector>

#include "Core/transport/OutlineClipping.h"

namespace authalic {

/// Goes from piece to piece of the density as far as a cell reaches. One for each thread.
class DensityIntegrals {
 public:
  explicit DensityIntegrals(const PiecewiseLinearDensity& density);

  /// ∫ ρ (as `area`), ∫ ρ x and ∫ ρ |x − y|² over a cell. O(pieces that it meets, times its corners).
  /// @param inside  a point of the cell
  [[nodiscard]] CellMoments over(const CellOutline& cell, const Eigen::Vector2d& inside, const Eigen::Vector2d& site);

  /// ∫ ρ ds along each straight side of that cell; 0 for arcs.
  [[nodiscard]] const std::vector<double>& sides() const noexcept { return sides_; }

 private:
  bool cut(const DensityPiece& piece);
  void addSides(const LinearFunction& density);
  void visit(int piece);

  const PiecewiseLinearDensity& density_;
  std::vector<int> seen_;  // number of the last cell that met each piece
  int cells_ = 0;
  std::vector<int> queue_;
  std::vector<double> sides_;
  ClippedOutline whole_, part_, other_;
};

}  // namespace authalic
