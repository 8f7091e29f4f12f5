/// @file
/// Point sets in the plane.
#pragma once

#include <cmath>
#include <random>

#include "Core/base/Arrays.h"

namespace authalic::testing {

/// Uniform in [low, high]².
inline Points2 randomPoints(int count, unsigned seed, double low, double high) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(low, high);
  Points2 points(count, 2);
  for (Eigen::Index i = 0; i < points.size(); ++i) points.data()[i] = uniform(random);
  return points;
}

/// A centre and rings k = 1 … rings of 6 k points at radius k / (rings + ½): the middles of rings of equal width.
inline Points2 ringPoints(int rings) {
  Points2 points(1 + 3 * rings * (rings + 1), 2);
  points.row(0).setZero();
  for (int r = 1, row = 1; r <= rings; ++r) {
    for (int k = 0; k < 6 * r; ++k, ++row) {
      const double angle = 2 * M_PI * (k + 0.5 * (r % 2)) / (6 * r), radius = r / (rings + 0.5);
      points.row(row) << radius * std::cos(angle), radius * std::sin(angle);
    }
  }
  return points;
}

}  // namespace authalic::testing
