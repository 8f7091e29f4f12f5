/// @file
/// The exact authalic solve on the flat torus.
#pragma once

#include "Core/authalic/AuthalicMap.h"
#include "Core/mesh/TorusMesh.h"
#include "Core/topology/CutGraph.h"

namespace authalic {

struct ToroidalAuthalicMapResult : AuthalicSolution {
  Points2 points;           ///< n×2, one image of every vertex; the others differ by periods
  Eigen::Matrix2d lattice;  ///< columns: the two periods, det = 1, the first along +x
  CutGraph cut;             ///< opens the torus to the disk `image`
  Points2 image;  ///< image of the cut's vertices: points(v) + lattice · winding; sides of the cut differ by
                  ///< periods
  double seamError = 0;  ///< largest distance of the two sides of an edge of the cut after the translation between them
};

/// Maps a torus to a flat torus ℝ²/(ℤa + ℤb) of area 1 so that every vertex star has its target area, as
/// authalicMap().
///
/// There is no seam in the computation: x_j − x_i = d_ij with Σ d_ij = 0 around faces, periods a, b around the two
/// generators of the homology (cutToFundamentalDomain), every star whole. The start is the periodic map by positive
/// weights, which is an embedding @cite gortler2006, reweighted until areas are within sight. The lattice is
/// unknown as well: a linear map of determinant 1 changes no ratio of areas, so that the one that makes the
/// Dirichlet energy Σ A_t |J_t|² least, M^-½ of M = Σ A_t J_t J_tᵀ, is taken before and after the solve.
///
/// Guarantees: no folded face, whatever the status; when not converged, the best iterate with its residuals. The cut
/// depends on the numbering of vertices, the periodic map does not but for a translation and the basis of the
/// lattice.
/// @throws InvalidArgument from options (the domain is not read); GeometryError when the target does not belong to
/// the
///         surface; SolverError when a system cannot be factorised
/// @cite zou2011
[[nodiscard]] ToroidalAuthalicMapResult toroidalAuthalicMap(const TorusMesh& torus, const TargetMeasure& target,
                                                            const AuthalicMapOptions& options = {},
                                                            const Execution& execution = {});

}  // namespace authalic
