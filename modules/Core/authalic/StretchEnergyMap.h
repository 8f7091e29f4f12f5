/// @file
/// Area-preserving maps of a disk as the fixed point of a stretch-weighted Laplacian.
#pragma once

#include <vector>

#include "Core/authalic/TargetMeasure.h"
#include "Core/base/Execution.h"
#include "Core/base/Status.h"
#include "Core/geometry/PlanarDomain.h"
#include "Core/mesh/DiskMesh.h"
#include "Core/numerics/SparseSolver.h"

namespace authalic {

/// Where the boundary goes in every round.
enum class StretchEnergyBoundary {
  Inverted,  ///< on the circle, from the inversion of the inner vertices; on other domains it stays where it is
  Held,      ///< where the initial map has it
};

/// "inverted", "held".
[[nodiscard]] const char* stretchEnergyBoundaryName(StretchEnergyBoundary boundary) noexcept;

struct StretchEnergyMapOptions {
  PlanarDomain domain;  ///< unit disk; must be the domain of the initial map
  StretchEnergyBoundary boundary = StretchEnergyBoundary::Inverted;
  double tolerance = 5e-3;  ///< of the part by which one round lowers the residual, > 0
  int maxIterations = 200;  ///< rounds, ≥ 0
  SolverBackend solver = SolverBackend::Automatic;

  /// @throws InvalidArgument naming the field that is outside its range.
  void validate() const;
};

struct StretchEnergyMapResult {
  Points2 image;                   ///< n×2, on the domain; vertices in the order of the input
  Status status = Status::NotRun;  ///< Converged: a round lowered the residual by less than `tolerance`, and no fold;
                                   ///< Stalled: a round raised it, the image is the one before
  int iterations = 0;              ///< rounds
  double residual = 0;             ///< (E − 1)^½ of `image`
  int flippedFaces = 0;            ///< faces folded in `image`
  std::vector<double> history;     ///< (E − 1)^½ before each round
  double seconds = 0;
};

/// Fixed-point iteration of the stretch energy E = Σ_t m_t r_t² @cite yueh2019, r_t = image share / target share m_t.
///
/// E ≥ 1, with equality for an area-preserving map only; E − 1 = Σ_t m_t (r_t − 1)². It is a quadratic form with
/// weights that depend on the image,
///
///     w_ij = ½ Σ_{t∋ij} r_t cot θ_t,ij,      θ the angle opposite to ij in the *image* (1/r_t is the stretch factor),
///
/// so that r_t cot θ needs no division by an area. Each round takes the weights of the last image and solves
/// Σ_j w_ij (x_j − x_i) = 0 for the inner vertices. On the circle the boundary comes before: inner vertices are
/// inverted, x/|x|², L_BB x_B = −L_BI x_I is solved outside of the circle, and the solution is centred and normalised.
///
/// @param initial  n×2, a map to the same domain with the boundary on its boundary; the paper's is harmonic
/// @param target   shares per face, from TargetMeasure for this surface
///
/// Guarantees: the image with the least E on the way; the boundary on that of the domain (pockets excepted). Not
/// guaranteed: exact areas; a map without folds (weights may be negative) → `flippedFaces`. For those see
/// authalicMap(), of which this is the peer in the literature. Complexity: one sparse factorisation of size n per
/// round, O(n^1.5), on a pattern ordered once.
/// @throws InvalidArgument from options; GeometryError when initial or target do not belong to the disk or the domain;
///         SolverError when a system cannot be factorised
[[nodiscard]] StretchEnergyMapResult stretchEnergyMap(const DiskMesh& disk, const Points2& initial,
                                                      const TargetMeasure& target,
                                                      const StretchEnergyMapOptions& options = {},
                                                      const Execution& execution = {});

}  // namespace authalic
