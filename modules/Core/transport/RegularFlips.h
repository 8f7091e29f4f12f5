/// @file
/// A regular triangulation kept while heights change a little. Private to transport/.
#pragma once

#include "Core/transport/PowerDiagram.h"
#include "Core/transport/RegularTriangulation.h"

namespace authalic {

/// How the flips ended.
enum class FlipResult {
  Regular,  ///< regular for the new heights
  Hidden,   ///< certainly not of all sites: one lies above the plane of its only three neighbours
  GivenUp,  ///< stuck, or there would be too many
};

/// Flips edges until the triangulation is regular for new heights: the lower hull of (y_i, −h_i)
/// @cite edelsbrunner1996.
///
/// An edge is flipped when its quadrilateral is convex and the opposite vertex lies below the plane of the face by
/// more than rounding in extended precision. Edges left within rounding of regular move no side of a cell by more
/// than rounding.
/// @param triangulation  dimension 2, of all sites; afterwards still a triangulation of all of them
/// Complexity: O(n + flips).
[[nodiscard]] FlipResult flipToRegular(const Points2& sites, const Heights& heights,
                                       RegularConnectivity& triangulation);

}  // namespace authalic
