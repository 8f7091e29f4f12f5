/// @file
/// The exact authalic solve on flat cone surfaces: closed surfaces with two handles or more.
#pragma once

#include <vector>

#include "Core/authalic/AuthalicMap.h"
#include "Core/conformal/ConeSeams.h"
#include "Core/mesh/HighGenusMesh.h"

namespace authalic {

struct FlatConeAuthalicMapResult : AuthalicSolution {
  FlatConeSurface flat;         ///< cones, cut, rigid motions; `places` are those of the map
  Points2 image;                ///< n'×2, of the cut's vertices, area 1; may lie in several layers
  std::vector<ConeSeam> seams;
  double seamError = 0;         ///< largest distance of the two sides of a seam after its rigid motion
  double angleError = 0;        ///< largest |sum of the angles around a vertex − 2π|, less curvature at cones, radians
};

/// Maps a closed surface of genus ≥ 2 to a flat surface with cones so that every vertex star has its target area, as
/// authalicMap().
///
/// A closed surface of genus g ≥ 2 has no flat metric without cones, for the curvature is 2πχ in all: here it sits in
/// 8(g − 1) cones of angle 5π/2, or more with as many of angle 3π/2 (flatConeSurface()). Cut open through them, the
/// surface is a disk in the plane whose seams are paired by rigid motions. There is one pair of unknowns per
/// vertex, in a chart of its own; corners beyond a seam see it through the motions, so that every star is whole and
/// no seam breaks. The turns are those of a conformal flat metric and stay; translations and cones are unknowns of
/// every face step. The start is the conformal layout, freed of folds (foldoverFree() in authalic/) and of faces that
/// are much too small, in patches that may lie across seams and around cones; before the face steps, cones and
/// translations are fitted to the areas (HolonomyFit in authalic/). Faces that do not reach their targets while shapes
/// are kept have a second half of the iterations with areas alone.
///
/// Guarantees: the sides of every seam differ by one rigid motion, to rounding, whatever the status; around every
/// vertex but the cones the unfolded star is that of a plane (no face folded, angles of sum 2π): the map is locally
/// injective. Not guaranteed: that the opened disk is embedded; it is immersed and may overlap itself. The cut and
/// the cones depend on the surface and, among equals, on the numbering of vertices.
/// Where folds of the start cannot be removed, the status is Stalled and flippedFaces says how many.
/// @throws InvalidArgument from options (the domain is not read); GeometryError when the target does not belong to
///         the surface; SolverError when a system cannot be factorised
/// @cite zou2011 @cite springborn2008 @cite garanzha2021
[[nodiscard]] FlatConeAuthalicMapResult flatConeAuthalicMap(const HighGenusMesh& surface, const TargetMeasure& target,
                                                            const AuthalicMapOptions& options = {},
                                                            const Execution& execution = {});

}  // namespace authalic
