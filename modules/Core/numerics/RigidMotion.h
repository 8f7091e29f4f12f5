/// @file
/// Rigid motions of the plane.
#pragma once

#include <complex>

namespace authalic {

/// x ↦ turn · x + shift of the plane of complex numbers, |turn| = 1.
struct RigidMotion {
  std::complex<double> turn{1, 0}, shift{0, 0};

  [[nodiscard]] std::complex<double> operator()(std::complex<double> x) const { return turn * x + shift; }
  /// This motion after the other one.
  [[nodiscard]] RigidMotion after(const RigidMotion& first) const {
    return {turn * first.turn, turn * first.shift + shift};
  }
  [[nodiscard]] RigidMotion inverse() const { return {std::conj(turn), -std::conj(turn) * shift}; }
  /// The turn by an angle (radians, counter-clockwise) about a point.
  [[nodiscard]] static RigidMotion about(std::complex<double> centre, double angle) {
    const std::complex<double> turn = std::polar(1.0, angle);
    return {turn, centre - turn * centre};
  }
};

}  // namespace authalic
