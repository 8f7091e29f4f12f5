/// @file
/// The steps of the zipper in the upper half-plane: what ConformalWelding is made of.
#pragma once

#include <Eigen/Core>

#include <complex>
#include <functional>
#include <vector>

#include "Core/base/Execution.h"

namespace authalic {

/// The seam while it is being closed: the upper half-plane with the tip at 0 and v_0 at ∞. The open points of side 1
/// lie on the positive half-axis, those of side 2 on the negative; both are kept as gaps between neighbours, the first
/// gap starting at the tip, because gaps keep their relative accuracy where positions would not.
struct OpenSeam {
  Eigen::VectorXd first, second;  ///< as many gaps > 0 on both sides
};

/// The closed pairs. Step k is
///
///     g(z) = ½ (a + b) p q (p + q) / (b p + a q),   p = √(z − a),  q = √(z + b),   Im p, Im q ≥ 0,
///
/// a conformal map of the half-plane onto the half-plane minus a circular arc orthogonal to the axis, with
/// g(a) = g(−b) = 0, g(∞) = ∞, g'(∞) = 1. Seen from side 2, in coordinates −z̄, it is the same with a and b exchanged.
/// @cite marshall2007
class Zipper {
 public:
  using Complex = std::complex<double>;
  /// A point on its way through the steps, and the step before which it starts.
  struct Traveller {
    Complex at;
    Eigen::Index step = 0;
  };

  Zipper() = default;
  /// Closes the pairs of the seam one after another. O(n²).
  /// @throws GeometryError when a gap underflows or is not finite
  /// @throws CancelledError
  explicit Zipper(OpenSeam seam, const Execution& execution = {});

  [[nodiscard]] Eigen::Index steps() const noexcept { return a_.size(); }

  /// Carries points of the closed upper half-plane through all steps; `mirrored` for coordinates −z̄. O(n) each.
  /// @param travellers  in ascending order of their first step
  [[nodiscard]] std::vector<Complex> close(const std::vector<Traveller>& travellers, bool mirrored,
                                           const Execution& execution) const;
  /// The way back through all steps, in coordinates of side 1. O(n).
  [[nodiscard]] Complex open(Complex point) const;

 private:
  Eigen::VectorXd a_, b_;
};

}  // namespace authalic
