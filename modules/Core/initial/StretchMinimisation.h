/// @file
/// Maps of a disk with little stretch: barycentric maps whose weights are divided by the stretch, again and again.
#pragma once

#include <vector>

#include "Core/initial/BarycentricMap.h"

namespace authalic {

/// Weights (mean value), domain and start vertex of the first map, as for barycentricMap().
struct StretchMinimisationOptions : BarycentricMapOptions {
  int maxIterations = 50;  ///< rounds, ≥ 0

  /// @throws InvalidArgument when a field is outside its range.
  void validate() const;
};

struct StretchMinimisationResult {
  Points2 image;                   ///< n×2, counter-clockwise
  Status status = Status::NotRun;  ///< Converged: a round did not lower the stretch any more, and no fold; Stalled:
                                   ///< negative weights (Harmonic) made a system that cannot be solved
  int iterations = 0;              ///< rounds, the one that did not lower the stretch included
  double stretch = 0;              ///< of `image`; 1 for an isometry
  int flippedFaces = 0;            ///< faces without a positive signed area
  int degenerateFaces = 0;         ///< faces without area on the surface, whose weights were clamped
  BoundaryPlacement boundary;      ///< as for barycentricMap()
  std::vector<double> history;     ///< stretch before each round
  double seconds = 0;
};

/// Lowers the L² stretch of a barycentric map by reweighting it @cite yoshizawa2004.
///
/// Γ_t ≥ γ_t the singular values of face t from the *plane* to the surface, both total areas made equal: its stretch is
/// σ_t = ((Γ_t² + γ_t²)/2)^½, that of a vertex σ_j = (Σ_{t∋j} A_t σ_t² / Σ_{t∋j} A_t)^½, that of the map
/// (Σ_t A_t σ_t² / Σ_t A_t)^½ @cite sander2001. From the barycentric map with weights w_ij, each round sets
///
///     w_ij ← w_ij / σ_j,      Σ_j w_ij (x_j − x_i) = 0 at every inner vertex i,
///
/// the boundary held; the first round that does not lower the stretch ends it, and the map before is the result. Row
/// i may be divided by σ_i without effect, which keeps symmetric weights symmetric.
///
/// Guarantees: stretch not above that of the barycentric map; with Uniform or MeanValue weights on a convex domain no
/// fold, up to rounding. Harmonic weights may fold → `flippedFaces`. Not guaranteed: a minimum of the stretch (the rule
/// is a heuristic that usually ends after a few rounds), or areas: for those see authalicMap().
/// Complexity: one sparse factorisation per round, O(n^1.5).
/// @throws what barycentricMap() throws
[[nodiscard]] StretchMinimisationResult stretchMinimisation(const DiskMesh& disk,
                                                            const StretchMinimisationOptions& options = {},
                                                            const Execution& execution = {});

}  // namespace authalic
