/// @file
/// The discrete Lie flow on the periodic rectangle, for tubes.
#pragma once

#include "Core/authalic/DiscreteLieFlow.h"
#include "Core/authalic/PeriodicRectangle.h"
#include "Core/mesh/AnnulusMesh.h"

namespace authalic {

struct PeriodicRectangleLieFlowOptions {
  DiscreteLieFlowOptions flow;  ///< its domain is not read
  int outerLoop = -1;           ///< loop of AnnulusMesh::loops() at y = 0; −1 = the longer one (mm)

  /// @throws InvalidArgument naming the field that is outside its range
  void validate() const;
};

struct PeriodicRectangleLieFlowResult : LieFlowSolution, PeriodicRectangleImage {};

/// Flows an annulus onto the rectangle [0, 1] × [0, h], periodic in x, until every vertex star has its target area.
///
/// As discreteLieFlow() @cite su2019 on a flat cylinder: the flowing mesh flips edges across the cut like any other
/// (its corners carry their windings along), the vertices of both loops slide along their lines. Start and height are
/// those of periodicRectangleAuthalicMap().
///
/// Guarantees: with finish ≠ None no folded face, whatever the status; loops on their lines to rounding, but for the
/// vertices of pockets; sides alike but for the shift by 1. Not guaranteed: that the tolerance is reached (→ status,
/// residual). When cancelled in the start, the image is empty.
/// Complexity: that of annulusMap and discreteLieFlow.
/// @throws InvalidArgument from options; GeometryError when the target does not belong to the surface or faces of the
///         start stay folded; SolverError
[[nodiscard]] PeriodicRectangleLieFlowResult periodicRectangleLieFlow(
    const AnnulusMesh& annulus, const TargetMeasure& target, const PeriodicRectangleLieFlowOptions& options = {},
    const Execution& execution = {});

}  // namespace authalic
