/// @file
/// Metrics of prescribed curvature in the discrete conformal class of a surface: Yamabe and Ricci flow.
#pragma once

#include <Eigen/Core>

#include <vector>

#include "Core/base/Execution.h"
#include "Core/base/Status.h"
#include "Core/conformal/BoundaryCircle.h"
#include "Core/geometry/IntrinsicTriangulation.h"
#include "Core/numerics/SparseSolver.h"

namespace authalic {

/// How lengths follow the factors u.
enum class ConformalMetric {
  VertexScaling,  ///< Yamabe flow: l_ij e^{(u_i + u_j)/2}; a solution exists and is found for every admissible
                  ///< curvature
  CirclePacking,  ///< Ricci flow: circles of radius e^u at constant inversive distance @cite su2016; a solution
                  ///< need not exist
};

/// First radii of a circle packing, the least over the faces ijk around vertex i.
enum class PackingRadii {
  Tangent,       ///< (l_ij + l_ik − l_jk)/2: circles of neighbours never overlap (I ≥ 1), faces keep together
                 ///< @cite luo2011
  Circumradius,  ///< of the face: circles overlap; degenerates where triangles are poor @cite su2016
};

struct YamabeFlowOptions {
  ConformalMetric metric = ConformalMetric::VertexScaling;
  PackingRadii radii = PackingRadii::Tangent;  ///< circle packing only
  double tolerance = 1e-10;  ///< stop when max |K − K̄| falls below it, radians, > 0
  int maxIterations = 200;   ///< Newton steps, ≥ 0
  SolverBackend solver = SolverBackend::Automatic;

  /// @throws InvalidArgument naming the field that is outside its range.
  void validate() const;
};

/// One Newton step.
struct YamabeIteration {
  double residual = 0;  ///< max |K − K̄| before the step
  double step = 0;      ///< fraction of the Newton step taken
  int flips = 0;        ///< edges flipped while looking for it
};

struct YamabeFlowResult {
  IntrinsicTriangulation triangulation;  ///< Delaunay at logScale; n + addedVertices vertices
  Eigen::VectorXd logScale;              ///< u; edge ij has the length e^{λ_ij + (u_i + u_j)/2}. Vertex scaling:
                                         ///< Σ u = 0; circle packing: ln of the radii
  Eigen::VectorXd curvature;             ///< K reached
  Eigen::VectorXd target;                ///< K̄, with what the circles asked for in the end
  int addedVertices = 0;                 ///< vertices n, n+1, … by which boundary edges were split
  Status status = Status::NotRun;        ///< Converged: max |K − K̄| ≤ tolerance; Stalled: rounding allows no more
  int iterations = 0;
  double residual = 0;                   ///< max |K − K̄|
  int initialFlips = 0;                  ///< Euclidean flips to the Delaunay triangulation of the surface itself
  int flips = 0;                         ///< flips by Ptolemy's rule on the way
  int degenerateFaces = 0;               ///< Stalled: most faces that lost their triangle inequality in one of the
                                         ///< steps tried since the best
  std::vector<YamabeIteration> history;
  double seconds = 0;
};

/// "vertex-scaling", "circle-packing".
[[nodiscard]] const char* conformalMetricName(ConformalMetric metric) noexcept;
/// "tangent", "circumradius".
[[nodiscard]] const char* packingRadiiName(PackingRadii radii) noexcept;

/// Curvature of every vertex at u: K_i = 2π − Σ θ inside, π − Σ θ on the boundary (geodesic curvature); 0 where
/// there is no face. Σ K = 2π χ.
[[nodiscard]] Eigen::VectorXd vertexCurvature(const IntrinsicTriangulation& triangulation, const Eigen::VectorXd& u);

/// Finds the scale factors u with K(u) = K̄: discrete uniformisation by the dynamic Yamabe flow.
///
/// The edge lengths l_ij e^{(u_i + u_j)/2} @cite luo2004 have curvature K with ∂K/∂u = L, the cotangent stiffness;
/// K − K̄ is the gradient of a convex energy @cite springborn2008. Newton's method solves L δ = K̄ − K; before
/// every evaluation edges are flipped by Ptolemy's rule until they are Delaunay, which leaves the discrete
/// conformal class as it is, makes the energy convex on all of ℝⁿ, and gives a unique solution for every
/// admissible K̄ on a closed surface @cite gu2018 @cite springborn2020. A step is taken when it lowers the least
/// ‖K − K̄‖₂ so far by a tenth or when the energy still falls at its end; else it is shortened. Both can happen
/// without progress only finitely often.
///
/// The class is that of the surface as a metric space: before the first step edges are flipped with the Euclidean
/// rule until the surface's own triangulation is Delaunay. Where its triangles are poor this matters for accuracy.
///
/// Boundary edges are not flipped, so that the boundary of the result runs along them. Where a face at the
/// boundary stands in the way, because it would lose its triangle inequality, its boundary edge is split at the
/// foot of the altitude; the new vertex asks for K̄ = 0 (or its part of the circle).
///
/// **Circle packing** replaces lengths and L by those of circles at constant inversive distance; edges are flipped
/// with the Euclidean rule to the power-Delaunay triangulation after every step. Its energy is convex where the
/// faces are triangles; nothing keeps them so: the flow stalls where steps of every length break one
/// (degenerateFaces).
///
/// @param triangulation  connected, n vertices
/// @param target         n: K̄; at vertices of circles it is not read
/// @param circles        boundary loops that shall become circles; see BoundaryCircle
/// Guarantees: Gauss–Bonnet holds for K to rounding; the solution does not depend on scale; its triangulation is
/// Delaunay.
/// Not guaranteed: that faces of the *input* stay unfolded when laid out; a residual below the rounding of u times
/// the largest cotangent (10⁻¹⁰ needs edges longer than some 10⁻⁵ of their neighbours), where the flow ends
/// Stalled.
/// Complexity: a sparse factorisation per step, O(n^1.5); 5 to 12 steps are usual.
/// When cancelled, the last iterate is returned with Status::Cancelled.
/// @throws InvalidArgument when options are out of range, or no metric has such curvature: K̄ ≥ 2π inside, K̄ ≥ π
///         on the boundary, or Σ K̄ ≠ 2π χ; GeometryError when K̄ has the wrong length or is not finite;
///         SolverError
[[nodiscard]] YamabeFlowResult yamabeFlow(IntrinsicTriangulation triangulation, const Eigen::VectorXd& target,
                                          std::vector<BoundaryCircle> circles = {},
                                          const YamabeFlowOptions& options = {}, const Execution& execution = {});

}  // namespace authalic
