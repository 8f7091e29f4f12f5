/// @file
/// The exact authalic solve on the periodic rectangle, for tubes.
#pragma once

#include "Core/authalic/AuthalicMap.h"
#include "Core/authalic/PeriodicRectangle.h"
#include "Core/mesh/AnnulusMesh.h"

namespace authalic {

struct PeriodicRectangleAuthalicMapOptions {
  AuthalicMapOptions solve;  ///< its domain is not read
  int outerLoop = -1;        ///< loop of AnnulusMesh::loops() at y = 0; −1 = the longer one (mm)

  /// @throws InvalidArgument naming the field that is outside its range
  void validate() const;
};

struct PeriodicRectangleAuthalicMapResult : AuthalicSolution, PeriodicRectangleImage {};

/// Maps an annulus to the rectangle [0, 1] × [0, h], periodic in x, so that every vertex star has its target area, as
/// authalicMap().
///
/// A flat cylinder: corners lie at x_v + (w, 0) with windings w, so that the cut has no part in the computation and
/// every star is whole; the vertices of both loops slide along y = 0 and y = h. The start is the conformal map
/// (annulusMap), every row at the height below which its share of the target lies; where that is far from the target,
/// the periodic map by positive weights with its boundary. The height is unknown as well: like a shear along x it
/// changes no ratio of areas, so that the two that make the Dirichlet energy of the map least at the area of the
/// surface, h ← h ((M_xx − M_xy²/M_yy) / M_yy)^½ with M = Σ A_t J_t J_tᵀ, are taken before and after the solve. The
/// cylinder as large as a surface of area A has the circumference (A/h)^½ and the height (A h)^½.
///
/// Prefer it to the annulus of circleDomainAuthalicMap() for long tubes: there the triangles near the hole are few,
/// around the hole, and sheared; here all rows are alike.
///
/// Guarantees: no folded face, whatever the status; loops on their lines to rounding, but for the vertices of pockets
/// (ears of the surface have no area on a straight line), which lie outside and are counted; sides alike but for the
/// shift by 1, to rounding. When not converged, the best iterate with its residuals. When cancelled in the start, the
/// image is empty.
/// Complexity: that of annulusMap and authalicMap.
/// @throws InvalidArgument from options; GeometryError when the target does not belong to the surface or faces of the
///         start stay folded; SolverError
/// @cite zou2011 @cite nadeem2017
[[nodiscard]] PeriodicRectangleAuthalicMapResult periodicRectangleAuthalicMap(
    const AnnulusMesh& annulus, const TargetMeasure& target, const PeriodicRectangleAuthalicMapOptions& options = {},
    const Execution& execution = {});

}  // namespace authalic
