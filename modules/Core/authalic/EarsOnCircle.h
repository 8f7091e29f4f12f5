/// @file
/// Faces inscribed in the unit circle. Private to authalic/.
#pragma once

#include <vector>

#include "Core/base/Arrays.h"

namespace authalic {

/// An ear: a face with two edges on the unit circle, which meet at its tip.
struct EarOnCircle {
  int tip, from, to;  ///< counter-clockwise: from → tip → to along the circle
};

/// The ears of a disk, and where their tips belong.
///
/// An ear whose base cuts the arc α off the circle and whose tip parts it into s and α − s has the area
/// 2 sin(s/2) sin((α − s)/2) sin(α/2), largest, for its base, with the tip in the middle. There the area does not
/// depend on the tip to first order: a solve that moves tips by derivatives alone never finds out that a tip could
/// leave the middle, and lets tips run that come near it.
class EarsOnCircle {
 public:
  /// @param onCircle  n flags
  EarsOnCircle(const Faces& faces, const std::vector<char>& onCircle);

  [[nodiscard]] const std::vector<EarOnCircle>& all() const noexcept { return ears_; }

  /// Every tip to the middle of its arc.
  void centreTips(Points2& image) const;

  /// Every tip to where its ear has the share of the whole area that it should have, on the side of the middle where
  /// it is; to the middle where the base is too short for that.
  /// @param vertexShares  n; the star of a tip is a third of its ear
  void easeTips(Points2& image, const Faces& faces, const Eigen::VectorXd& vertexShares) const;

 private:
  std::vector<EarOnCircle> ears_;
};

}  // namespace authalic
