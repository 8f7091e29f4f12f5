/// @file
/// What angles cost areas, and areas angles, on one surface: the curve by which a balance is chosen.
#pragma once

#include <vector>

#include "Core/authalic/AuthalicMap.h"
#include "Core/distortion/Distortion.h"
#include "Core/mesh/SphereMesh.h"

namespace authalic {

struct BalanceCurveOptions {
  std::vector<double> balances = {0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1};  ///< t, each in [0, 1]
  double tolerance = 2e-2;        ///< of the face residual of the finished maps, as AuthalicMapOptions, > 0
  double vertexTolerance = 0.1;   ///< of max |ln r_v| of the finished maps, > 0
  double cellTolerance = 1e-2;    ///< of the transport: max |w_i − ν_i| / mean ν, > 0
  SolverBackend solver = SolverBackend::Automatic;

  /// @throws InvalidArgument naming the field that is outside its range.
  void validate() const;
};

/// The map of one balance. Distortions are relative to the surface, that of areas to the target of balance 1; ideal
/// 2.
struct BalancePoint {
  double balance = 0;
  DistortionSummary metrics;    ///< of the finished map
  DistortionSummary transport;  ///< of the map by transport alone, before the finish
  Status status = Status::NotRun;  ///< Converged: transport and finish within their tolerances, no fold
  double seconds = 0;              ///< by the clock; all conformal work is in BalanceCurve::startSeconds
};

struct BalanceCurve {
  std::vector<BalancePoint> points;  ///< one per balance, in the order of the options; fewer when cancelled
  Status status = Status::NotRun;    ///< Converged when every point is
  double startSeconds = 0;           ///< the conformal map
};

/// D_angle and D_area of the maps between conformal and area-preserving @cite nadeem2017: for every t the optimal
/// transport from the Riemann map to the masses (1 − t) A_conf + t A_M (TargetMeasure::blended), finished by the
/// exact area solve.
///
/// One conformal map serves all, and one analysis of the systems; the transport of a t starts from the line through
/// the heights of the two before it, its finish from that transport alone: a value on a curve is the value alone,
/// but for the tolerance of the cells.
/// Tolerances are those of a curve to choose by: the map itself is then made to its own (vtkOptimalTransportMap with
/// that balance).
/// Guarantees: as optimalTransportMap and authalicMap for every point. Not guaranteed: that the curve is monotone.
/// Complexity: one conformal map, then per point a transport and an area solve.
/// @throws InvalidArgument from options; GeometryError when the conformal map has folds, or as optimalTransportMap
/// and
///         authalicMap; SolverError
[[nodiscard]] BalanceCurve balanceCurve(const DiskMesh& disk, const TargetMeasure& target,
                                        const BalanceCurveOptions& options = {}, const Execution& execution = {});

/// The same on the sphere, from the conformal map to it (sphericalTransportMap, sphericalAuthalicMap).
[[nodiscard]] BalanceCurve balanceCurve(const SphereMesh& sphere, const TargetMeasure& target,
                                        const BalanceCurveOptions& options = {}, const Execution& execution = {});

}  // namespace authalic
