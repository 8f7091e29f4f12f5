/// @file
/// How far a planar mesh may move along given velocities before its first triangle collapses.
#pragma once

#include "Core/base/Arrays.h"
#include "Core/base/Execution.h"

namespace authalic {

/// Smallest λ > 0 with a λ² + b λ + c = 0, or +infinity when there is none.
///
/// Stable form: q = −½ (b + sgn(b) √D), roots q/a and c/q; no cancellation between b and √D.
/// For c ≤ 0 (a triangle that is already degenerate or flipped) the answer is 0.
[[nodiscard]] double smallestPositiveRoot(double a, double b, double c) noexcept;

/// Smallest λ in (0, farthest] with a λ³ + b λ² + c λ + d = 0, or +infinity when there is none; 0 for d ≤ 0.
/// Bisection between the extrema of the cubic, to 1e-15 of `farthest`.
[[nodiscard]] double smallestPositiveRoot(double a, double b, double c, double d, double farthest) noexcept;

/// First step λ at which the triangle p + λ v has no area, +infinity when it never loses it.
///
/// With edges e and velocity differences d of corners 2 and 3 against corner 1 and × the planar cross product,
/// 2·area(λ) = e₁₂×e₁₃ + λ (e₁₂×d₁₃ + d₁₂×e₁₃) + λ² d₁₂×d₁₃ @cite su2019 (eq. 4, whose printed coefficients
/// are wrong); one equation per triangle is enough.
[[nodiscard]] double firstFlip(const Points2& points, const Points2& velocities, int a, int b, int c) noexcept;

/// The minimum of firstFlip over all faces: every face keeps a positive area for steps in [0, that minimum).
///
/// @param points      n×2, every face counter-clockwise
/// @param velocities  n×2
/// @param faces       m×3
/// Complexity O(m); the minimum does not depend on the thread count.
[[nodiscard]] double flipFreeStep(const Points2& points, const Points2& velocities, const Faces& faces,
                                  const Execution& execution = {});

}  // namespace authalic
