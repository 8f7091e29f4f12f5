/// @file
/// The check that no two sites lie in one place. Private to transport/.
#pragma once

#include <Eigen/Core>

#include <algorithm>
#include <numeric>
#include <string>
#include <vector>

#include "Core/base/Error.h"

namespace authalic {

/// @param sites  one row each
/// @throws GeometryError when there is none, one is not finite (it is named), or two coincide (they are named)
template <class Derived>
void requireDistinctSites(const Eigen::MatrixBase<Derived>& sites) {
  if (sites.rows() == 0) throw GeometryError("At least one site is required, but there is none.");
  std::vector<int> order(static_cast<std::size_t>(sites.rows()));
  std::iota(order.begin(), order.end(), 0);
  for (const int i : order) {
    if (sites.row(i).allFinite()) continue;
    throw GeometryError("Sites with finite coordinates are required, but site " + std::to_string(i) + " has none.");
  }
  std::sort(order.begin(), order.end(), [&](int a, int b) {
    for (Eigen::Index k = 0; k < sites.cols(); ++k) {
      if (sites(a, k) != sites(b, k)) return sites(a, k) < sites(b, k);
    }
    return a < b;
  });
  for (std::size_t k = 0; k + 1 < order.size(); ++k) {
    if (sites.row(order[k]) != sites.row(order[k + 1])) continue;
    throw GeometryError("Sites in different places are required, but sites " + std::to_string(order[k]) + " and " +
                        std::to_string(order[k + 1]) + " are both at (" + std::to_string(sites(order[k], 0)) + ", " +
                        std::to_string(sites(order[k], 1)) + (sites.cols() > 2 ? ", …" : "") +
                        "); merge them or move one.");
  }
}

}  // namespace authalic
