/// @file
/// Heights changed at single sites, so that no cell is far from its mass. Private to transport/.
#pragma once

#include <Eigen/Core>

#include <vector>

#include "Core/transport/PowerDiagram.h"

namespace authalic {

/// Lowers sites whose cells have more than 5 ν_i, to 2 ν_i, then raises those with less than ν_i / 10, to ν_i / 2, and
/// their neighbours as far as these then have too little: one after another, each against the others as they are.
/// Sites that others hid, and that show when these are lowered, are seen by the others from then on.
///
/// The cell of a site is cut out of the domain (the disk as a polygon) by its neighbours, which are found from corner
/// to corner by walks over the last diagram and what has been changed since; no diagram is made. Its mass is taken as
/// area times density in its middle. O(number of such sites), each some hundred cuts. Not guaranteed: that every cell
/// is mended in one call, which visits five times as many sites as it finds at most.
/// @param diagram    at those heights; cells without any mass are allowed
/// @param masses     ν, n
/// @param clusterOf  n: the group of each site, in which walks begin
/// @param clusters   number of groups
/// @return how many heights were changed
int mendCells(const PowerDiagram& diagram, const Eigen::VectorXd& masses, const std::vector<int>& clusterOf,
              int clusters, Heights& heights);

}  // namespace authalic
