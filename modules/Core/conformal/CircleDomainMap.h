/// @file
/// Conformal maps of surfaces with several boundary loops onto the unit disk without round holes.
#pragma once

#include <optional>
#include <vector>

#include "Core/base/Execution.h"
#include "Core/base/Status.h"
#include "Core/conformal/DiskNormalisation.h"
#include "Core/conformal/YamabeFlow.h"
#include "Core/geometry/CommonRefinement.h"
#include "Core/mesh/PolyAnnulusMesh.h"
#include "Core/numerics/CircleFit.h"

namespace authalic {

/// Which way leads to round holes. Both give the same map up to a Möbius transformation as meshes get finer.
enum class CircleDomainRoad {
  Curvature,  ///< one flow with the curvature of circles on every loop @cite su2016
  Koebe,      ///< holes filled, one loop after the other made round by a Riemann map, over and over
              ///< @cite koebe1910
};

struct CircleDomainOptions {
  CircleDomainRoad road = CircleDomainRoad::Curvature;
  int outerLoop = -1;      ///< loop of PolyAnnulusMesh::loops() that becomes the unit circle; −1 = the longest
                           ///< (mm)
  double roundness = 1e-6; ///< Koebe: stop when every loop is a circle to this, relative to its radius, > 0
  int maxRounds = 100;     ///< Koebe: rounds over all loops, ≥ 0
  DiskNormalisation normalisation;
  bool refine = false;     ///< also return the common refinement, on which nothing folds (road Curvature)
  bool unfold = true;      ///< bulge pockets, re-embed small patches around folded faces (initial/Unfold)
  YamabeFlowOptions flow;

  /// @throws InvalidArgument naming the field that is outside its range.
  void validate(const PolyAnnulusMesh& surface) const;
};

struct CircleDomainResult {
  Points2 image;                      ///< n×2
  Eigen::VectorXd logScale;           ///< n: u of the image's metric. Road Curvature with vertex scaling: image
                                      ///< lengths are l_ij e^{(u_i + u_j)/2} where no edge was flipped; circle
                                      ///< packing: ln of the radii, to second order; empty on the road Koebe
  std::vector<FittedCircle> circles;  ///< of every loop, in the order of loops(); deviation to 1e-14
  int outerLoop = 0;
  Status status = Status::NotRun;     ///< of the flow; Koebe: Converged when every loop is round
  double residual = 0;                ///< max |K − K̄| of the (last) flow
  double holonomy = 0;                ///< of its development
  double roundness = 0;               ///< how far loops were from their circles, relative, before vertices were
                                      ///< put on them
  int flippedBeforeUnfolding = 0;     ///< faces of the input that the conformal map itself folds
  int flippedFaces = 0;               ///< faces of the input that are folded in the image
  int pockets = 0;                    ///< pockets bulged into holes, see FoldedPockets
  std::optional<CommonRefinement> refinement;  ///< when asked for, with the image as it is before unfolding
  int iterations = 0;                 ///< Newton steps, all flows
  int rounds = 0;                     ///< Koebe: rounds over all loops
  int edgeFlips = 0;                  ///< of the intrinsic triangulation, all kinds
  std::vector<YamabeIteration> history;
  double seconds = 0;
};

/// Maps a surface of genus 0 with k ≥ 1 loops conformally onto the unit disk minus k − 1 round disks.
///
/// **Curvature.** K̄ = 0 inside; on the outer loop a turn of +2π, on every other −2π, shared out like the arcs of
/// a polygon inscribed in a circle, which depend on the metric that is sought (BoundaryCircle). Instead of one
/// flow after the other with K̄ in proportion to the edges of the last, the dependence enters Newton's method: one
/// flow, quadratic convergence, loops on circles to rounding. What is left free is a Möbius transformation of the
/// disk.
/// **Koebe.** Loop by loop: turn the domain inside out around it, fill all other holes with fans, take the Riemann
/// map. Linear convergence, many flows: an independent check, not the way to work.
///
/// Guarantees: vertices of loops on their circles to 1e-14, but for those of pockets: an ear of the surface (a
/// triangle with two boundary edges) on an inner circle would lie in the hole and is bulged into it (`pockets`).
/// Not guaranteed: no folded face (→ flippedFaces); that loops of few vertices stay apart (chords, not arcs, bound
/// the mesh).
/// Complexity: that of the flow; Koebe: k flows per round. When cancelled, the image is empty and the status says
/// so.
/// @throws InvalidArgument from options, also when a refinement is asked for on the road Koebe or where a boundary
///         edge had to be split; GeometryError when an edge has no length; SolverError
[[nodiscard]] CircleDomainResult circleDomainMap(const PolyAnnulusMesh& surface,
                                                 const CircleDomainOptions& options = {},
                                                 const Execution& execution = {});

/// "curvature", "koebe".
[[nodiscard]] const char* circleDomainRoadName(CircleDomainRoad road) noexcept;

}  // namespace authalic
