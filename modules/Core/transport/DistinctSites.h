/// @file
/// The checks that no two sites lie in one place. Private to transport/.
#pragma once

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <numeric>
#include <optional>
#include <string>
#include <vector>

#include "Core/base/Error.h"

namespace authalic {

/// Two rows that are equal, the smallest first; empty when there are none.
template <class Derived>
[[nodiscard]] std::optional<std::array<int, 2>> coincidentRows(const Eigen::MatrixBase<Derived>& rows) {
  std::vector<int> order(static_cast<std::size_t>(rows.rows()));
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](int a, int b) {
    for (Eigen::Index k = 0; k < rows.cols(); ++k) {
      if (rows(a, k) != rows(b, k)) return rows(a, k) < rows(b, k);
    }
    return a < b;
  });
  for (std::size_t k = 0; k + 1 < order.size(); ++k) {
    if (rows.row(order[k]) == rows.row(order[k + 1])) return std::array<int, 2>{order[k], order[k + 1]};
  }
  return std::nullopt;
}

/// @param sites  one row each
/// @throws GeometryError when there is none, one is not finite (it is named), or two coincide (they are named)
template <class Derived>
void requireDistinctSites(const Eigen::MatrixBase<Derived>& sites) {
  if (sites.rows() == 0) throw GeometryError("At least one site is required, but there is none.");
  for (Eigen::Index i = 0; i < sites.rows(); ++i) {
    if (sites.row(i).allFinite()) continue;
    throw GeometryError("Sites with finite coordinates are required, but site " + std::to_string(i) + " has none.");
  }
  if (const auto pair = coincidentRows(sites)) {
    throw GeometryError("Sites in different places are required, but sites " + std::to_string((*pair)[0]) + " and " +
                        std::to_string((*pair)[1]) + " are in one; merge them or move one.");
  }
}

/// @throws GeometryError when two vertices have one image
template <class Derived>
void requireDistinctImages(const Eigen::MatrixBase<Derived>& image) {
  if (const auto pair = coincidentRows(image)) {
    throw GeometryError("An initial map that keeps vertices apart is required, but vertices " +
                        std::to_string((*pair)[0]) + " and " + std::to_string((*pair)[1]) +
                        " have one image; take another initial map.");
  }
}

}  // namespace authalic
