/// @file
/// Barycentric maps to a flat cone surface. Private to authalic/.
#pragma once

#include <vector>

#include "Core/authalic/SeamedAreas.h"
#include "Core/geometry/Laplacian.h"
#include "Core/numerics/ElementAssembly.h"

namespace authalic {

/// Solves Σ_j w_ij (x_j − x_i) = 0 around every vertex but the cones, x_j seen from i across the seams: the least
/// Σ w_ij |x_i − x_j|² for the rigid motions of the surface. With positive weights the edges of the solution are
/// geodesics of least energy where the surface is not positively curved, and no face folds @cite colindeverdiere1991,
/// as long as no edge would bend around a cone.
class SeamedBarycentricSystem {
 public:
  SeamedBarycentricSystem(const SeamedAreas& areas, SolverBackend backend);

  /// @param weights  per half-edge, the same both ways, > 0
  /// @throws SolverError when the system is not definite
  void factorize(const HalfEdgeWeights& weights);
  /// With the weights of the last factorisation.
  /// @param motions  of the corners, with the turns of the surface
  /// @param image    n×2, in the charts; holds the cones, takes the others
  void solve(const HalfEdgeWeights& weights, const std::vector<RigidMotion>& motions, Points2& image) const;

 private:
  const SeamedAreas& areas_;
  ElementAssembly assembly_;
  SparseSolver solver_;
  std::vector<double> values_;
};

}  // namespace authalic
