/// @file
/// Optimal transport of a measure of a planar domain, uniform or of a piecewise linear density, to point masses.
#pragma once

#include <Eigen/Core>

#include <vector>

#include "Core/base/Execution.h"
#include "Core/base/Status.h"
#include "Core/numerics/SparseSolver.h"
#include "Core/transport/PowerDiagram.h"

namespace authalic {

/// Where Newton's method begins in the plane, when no heights are given.
enum class TransportStart {
  Automatic,     ///< CoarseToFine from 20 000 sites on, where it gains
  Voronoi,       ///< the Voronoi cells of the sites
  CoarseToFine,  ///< heights of a transport to fewer sites @cite merigot2011, interpolated
};

struct SemiDiscreteTransportOptions {
  double tolerance = 1e-9;  ///< of max |w_i − ν_i| / mean ν, > 0
  int maxIterations = 100;  ///< Newton steps, ≥ 0; those of coarser transports do not count
  TransportStart start = TransportStart::Automatic;
  SolverBackend solver = SolverBackend::Automatic;

  /// @throws InvalidArgument naming the field that is outside its range.
  void validate() const;
};

/// One Newton step.
struct TransportIteration {
  double residual = 0;      ///< max |w_i − ν_i| / mean ν before the step
  double step = 0;          ///< part α of the Newton step that was taken
  double smallestCell = 0;  ///< smallest cell after the step / mean ν
};

/// A transport to so many sites: to the given ones, or to clusters of them.
struct TransportLevel {
  int sites = 0;
  int iterations = 0;  ///< Newton steps
  double voronoi = 1;  ///< t: part of Voronoi's heights in its start; 1 at the coarsest
};

/// How a transport was found, whatever the domain.
struct TransportSolution {
  Status status = Status::NotRun;  ///< Converged: residual within the tolerance; Stalled: no step was possible
  int iterations = 0;
  double residual = 0;       ///< max |w_i − ν_i| / mean ν
  Heights heights;           ///< n
  std::vector<TransportIteration> history;
  std::vector<TransportLevel> levels;  ///< in the plane, the coarsest first; none when a start was given
};

/// Heights h such that the cell of site i has the mass ν_i = ∫_{W_i} ρ, its area when the source is uniform: the map
/// x ↦ y_i on W_i then has the least transport cost Σ_i ∫_{W_i} |x − y_i|² ρ of all maps of that measure @cite gu2016.
///
/// Minimises the convex E(h) = ∫ max_i (⟨x, y_i⟩ + h_i) ρ dx − Σ ν_i h_i by Newton's method: ∇E = w − ν,
/// ∂w_i/∂h_j = −∫_{e_ij} ρ ds / |y_i − y_j|, H δ = ν − w with the mean of δ fixed; damped as in @cite kitagawa2019: a
/// step α is taken when every cell keeps ε₀ = ½ min(smallest cell at the start, smallest ν), |w − ν|₂ falls to
/// (1 − α/2) of itself and |w − ν|∞ does not grow, else halved; the next one tried is four times longer, 1 at most.
/// The error after a step α is (1 − α)(w − ν) + O(α²) in any norm, so that short steps always pass: converges from
/// every start without empty cells, at the end quadratically.
///
/// @param diagram  its sites, domain and source; holds the cells of the result afterwards
/// @param masses   ν, n, > 0, with the sum diagram.total() (to 1e-6; scaled to it exactly)
/// From coarse to fine (options.start): clusters of about six sites, themselves from coarse to fine while there are
/// many, are given their masses to 1e-3; their heights, interpolated by smooth fits to values and gradients, are those
/// of the sites, but for a few that are raised or lowered so that no cell is empty. Where that fails the start is
/// Voronoi's.
///
/// @param start    n heights without empty cells, or empty for options.start
/// Guarantees: no cell of any iterate is empty; the 2-norm of the error falls and its largest entry, the residual
/// of the history, does not grow at any step; when not converged, the best iterate with its residual.
/// Complexity: a power diagram and a sparse factorisation of size n per step, O(n^1.5).
/// @throws InvalidArgument from options; GeometryError when a mass is not positive or their sum differs from the
///         total, or the start has empty cells; SolverError when a system cannot be factorised
[[nodiscard]] TransportSolution semiDiscreteTransport(PowerDiagram& diagram, const Eigen::VectorXd& masses,
                                                      const SemiDiscreteTransportOptions& options = {},
                                                      const Heights& start = {},
                                                      const Execution& execution = {});

/// Heights without empty cells: Voronoi's, −|y_i|² / 2, when all sites lie in the domain; else those of the sites
/// moved and scaled into it, which have the same cells.
[[nodiscard]] Heights startHeights(const Points2& sites, const PlanarDomain& domain);

}  // namespace authalic
