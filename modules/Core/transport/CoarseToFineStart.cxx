#include "Core/transport/CoarseToFineStart.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "Core/transport/CellMending.h"
#include "Core/transport/DistinctSites.h"
#include "Core/transport/HeightInterpolation.h"
#include "Core/transport/SiteClusters.h"

namespace authalic {
namespace {

constexpr double kClusterSize = 6;
constexpr double kCoarseTolerance = 1e-3;  // the interpolation is off by more
constexpr int kMostMendings = 4;
constexpr double kMostEmpty = 0.05;  // of the cells; the coarse transport does not show what there is then
constexpr double kGoodPart = 0.02, kLeastPart = 1e-3;  // of its mass that a cell shall have, and must have
constexpr std::array<double, 4> kBlends = {1.0 / 64, 1.0 / 16, 1.0 / 4, 1.0 / 2};

double smallestPart(const PowerDiagram& diagram, const Eigen::VectorXd& masses) {
  return (diagram.cells().masses.array() / masses.array()).minCoeff();
}

// Mends cells once, and again as long as the smallest has little of its mass: that part, or none when too many cells
// are empty.
std::optional<double> mend(PowerDiagram& diagram, const Eigen::VectorXd& masses, const SiteClusters& clusters,
                           Heights& heights, const Execution& execution) {
  diagram.compute(heights, execution);
  if (diagram.cells().emptyCells > kMostEmpty * static_cast<double>(masses.size())) return std::nullopt;
  double part = smallestPart(diagram, masses);
  for (int k = 0; k < kMostMendings && (k == 0 || part < kGoodPart) && !execution.cancelled(); ++k) {
    const int count = static_cast<int>(clusters.masses.size());
    if (mendCells(diagram, masses, clusters.clusterOf, count, heights) == 0) break;
    diagram.compute(heights, execution);
    part = smallestPart(diagram, masses);
  }
  return part;
}

// Interpolated heights of the sites, or none.
Heights interpolated(const PowerDiagram& coarse, const TransportSolution& solution, const Points2& sites,
                     const SiteClusters& clusters, const Execution& execution) {
  if (solution.status != Status::Converged) return {};
  const HeightInterpolation interpolation(coarse, solution.heights);
  if (!interpolation.usable()) return {};
  Heights heights = interpolation.heightsAt(sites, clusters.clusterOf, execution);
  return heights.allFinite() ? heights : Heights();
}

}  // namespace

CoarseToFineStart coarseToFineStart(PowerDiagram& diagram, const Eigen::VectorXd& masses,
                                    const SemiDiscreteTransportOptions& options, const Execution& execution) {
  CoarseToFineStart result;
  const SiteClusters clusters = clusterSites(diagram.sites(), masses, kClusterSize);
  if (clusters.masses.size() < 2 || coincidentRows(clusters.places)) return result;
  PowerDiagram coarse = diagram.withSites(clusters.places);
  SemiDiscreteTransportOptions loose;
  loose.tolerance = std::max(kCoarseTolerance, options.tolerance);
  loose.solver = options.solver;
  const TransportSolution solution =
      semiDiscreteTransport(coarse, clusters.masses, loose, {}, execution.part(0, 0.8));
  Heights heights = interpolated(coarse, solution, diagram.sites(), clusters, execution);
  if (heights.size() == 0) return result;
  const std::optional<double> mended = mend(diagram, masses, clusters, heights, execution);
  if (!mended) return result;
  double part = *mended;
  const Heights voronoi = startHeights(diagram.sites(), diagram.domain());
  Heights blend = heights;
  for (std::size_t k = 0; k < kBlends.size() && part < kLeastPart && !execution.cancelled(); ++k) {
    result.voronoi = kBlends[k];
    blend = (1 - static_cast<long double>(kBlends[k])) * heights + static_cast<long double>(kBlends[k]) * voronoi;
    diagram.compute(blend, execution);
    part = smallestPart(diagram, masses);
  }
  if (part < kLeastPart) return result;
  result.heights = std::move(blend);
  result.levels = solution.levels;
  return result;
}

}  // namespace authalic
