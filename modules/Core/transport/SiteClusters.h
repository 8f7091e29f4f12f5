/// @file
/// Neighbouring sites taken together: the sites of the next coarser transport. Private to transport/.
#pragma once

#include <Eigen/Core>

#include <vector>

#include "Core/base/Arrays.h"

namespace authalic {

/// Sites in groups, each with one place and one mass.
struct SiteClusters {
  std::vector<int> clusterOf;  ///< n: the group of each site
  Points2 places;              ///< m×2: centres of mass, no two in one place
  Eigen::VectorXd masses;      ///< m: sums
};

/// Halves the sites at the median of their longer extent until groups have about `size` sites; a site with more than
/// half of the mass of its group, such as that of a hole, becomes a group of its own. The same for the same sites,
/// ties by number. O(n log n).
/// @param sites   n×2, no two in one place
/// @param masses  n, > 0
[[nodiscard]] SiteClusters clusterSites(const Points2& sites, const Eigen::VectorXd& masses, double size);

}  // namespace authalic
