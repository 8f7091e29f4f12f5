#include "Core/transport/SemiDiscreteTransport.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "Core/base/Error.h"
#include "Core/transport/CoarseToFineStart.h"
#include "Core/transport/DampedNewton.h"

namespace authalic {
namespace {

constexpr double kOnBoundary = 1e-12;
constexpr Eigen::Index kManySites = 20000;  // coarse to fine gains from here on
constexpr Eigen::Index kFewSites = 64;      // and makes no sense below
constexpr double kCoarseShare = 0.2;        // of the progress

// What DampedNewton asks of a diagram, for sites in the plane.
class PlanarCells final : public TransportCells {
 public:
  PlanarCells(PowerDiagram& diagram, const Execution& execution) : diagram_(diagram), execution_(execution) {}
  bool compute(const Heights& heights) override { return diagram_.computeUnlessHidden(heights, execution_); }
  const Eigen::VectorXd& areas() const override { return diagram_.cells().masses; }
  void derivatives(std::vector<Eigen::Triplet<double>>& entries) const override {
    const Points2& y = diagram_.sites();
    for (const PowerEdge& edge : diagram_.cells().edges) {
      entries.emplace_back(edge.second, edge.first, edge.mass / (y.row(edge.first) - y.row(edge.second)).norm());
    }
  }

 private:
  PowerDiagram& diagram_;
  const Execution& execution_;
};

bool coarseToFineIsWanted(TransportStart start, Eigen::Index count) {
  if (start == TransportStart::Automatic) return count >= kManySites;
  return start == TransportStart::CoarseToFine && count >= kFewSites;
}

}  // namespace

void SemiDiscreteTransportOptions::validate() const {
  if (!(tolerance > 0)) {
    throw InvalidArgument("A tolerance above 0 is required for transport, but it is " +
                          std::to_string(tolerance) + ".");
  }
  if (maxIterations < 0) {
    throw InvalidArgument("A number of iterations of at least 0 is required for transport, but it is " +
                          std::to_string(maxIterations) + ".");
  }
  if (!SparseSolver::available(solver)) {
    throw InvalidArgument("A solver that is part of this build is required, but " +
                          std::string(solverBackendName(solver)) + " was not built in.");
  }
}

Heights startHeights(const Points2& sites, const PlanarDomain& domain) {
  const Points2& corner = domain.corners();
  Eigen::RowVector2d middle = Eigen::RowVector2d::Zero();
  if (!domain.isDisk()) middle = corner.colwise().mean();
  double room = 1;
  bool inside = domain.isDisk() && sites.rowwise().squaredNorm().maxCoeff() <= 1 + kOnBoundary;
  for (Eigen::Index k = 0; k < corner.rows(); ++k) {
    const Eigen::RowVector2d a = corner.row(k), along = (corner.row((k + 1) % corner.rows()) - a).normalized();
    const Eigen::RowVector2d inwards(-along[1], along[0]);
    const double reach = ((sites.rowwise() - a) * inwards.transpose()).minCoeff();
    inside = (k == 0 || inside) && reach >= -kOnBoundary;
    room = k == 0 ? (middle - a).dot(inwards) : std::min(room, (middle - a).dot(inwards));
  }
  if (inside) return (-0.5 * sites.rowwise().squaredNorm()).cast<long double>();
  const Eigen::RowVector2d centre = sites.colwise().mean();
  const double radius = std::sqrt((sites.rowwise() - centre).rowwise().squaredNorm().maxCoeff());
  const double scale = radius > 0 ? 0.9 * room / radius : 1.0;
  const Points2 moved = (scale * (sites.rowwise() - centre)).rowwise() + middle;
  return (-0.5 / scale * moved.rowwise().squaredNorm()).cast<long double>();
}

TransportSolution semiDiscreteTransport(PowerDiagram& diagram, const Eigen::VectorXd& masses,
                                        const SemiDiscreteTransportOptions& options, const Heights& start,
                                        const Execution& execution) {
  const Eigen::Index count = diagram.sites().rows();
  const bool wanted = start.size() == 0 && coarseToFineIsWanted(options.start, count);
  CoarseToFineStart coarse;
  if (wanted) {
    options.validate();
    coarse = coarseToFineStart(diagram, checkedMasses(masses, count, diagram.total()), options,
                               execution.part(0, kCoarseShare));
  }
  const bool found = coarse.heights.size() > 0;
  Heights first = start;
  if (found) first = std::move(coarse.heights);
  else if (start.size() == 0) first = startHeights(diagram.sites(), diagram.domain());
  const Execution rest = execution.part(wanted ? kCoarseShare : 0, 1);
  PlanarCells cells(diagram, rest);
  TransportSolution solution = dampedNewton(cells, count, masses, diagram.total(), options, std::move(first), rest);
  solution.levels = std::move(coarse.levels);
  if (start.size() == 0) {
    solution.levels.push_back({static_cast<int>(count), solution.iterations, found ? coarse.voronoi : 1});
  }
  return solution;
}

}  // namespace authalic
