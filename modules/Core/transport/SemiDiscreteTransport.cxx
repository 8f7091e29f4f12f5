#include "Core/transport/SemiDiscreteTransport.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "Core/base/Error.h"
#include "Core/transport/DampedNewton.h"

namespace authalic {
namespace {

// What DampedNewton asks of a diagram, for sites in the plane.
class PlanarCells final : public TransportCells {
 public:
  PlanarCells(PowerDiagram& diagram, const Execution& execution) : diagram_(diagram), execution_(execution) {}
  void compute(const Eigen::VectorXd& heights) override { diagram_.compute(heights, execution_); }
  const Eigen::VectorXd& areas() const override { return diagram_.cells().areas; }
  void derivatives(std::vector<Eigen::Triplet<double>>& entries) const override {
    const Points2& y = diagram_.sites();
    for (const PowerEdge& edge : diagram_.cells().edges) {
      entries.emplace_back(edge.second, edge.first, edge.length / (y.row(edge.first) - y.row(edge.second)).norm());
    }
  }

 private:
  PowerDiagram& diagram_;
  const Execution& execution_;
};

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

Eigen::VectorXd voronoiHeights(const Points2& sites) { return -0.5 * sites.rowwise().squaredNorm(); }

TransportSolution semiDiscreteTransport(PowerDiagram& diagram, const Eigen::VectorXd& masses,
                                        const SemiDiscreteTransportOptions& options, const Eigen::VectorXd& start,
                                        const Execution& execution) {
  PlanarCells cells(diagram, execution);
  return dampedNewton(cells, diagram.sites().rows(), masses, diagram.domainArea(), options,
                      start.size() > 0 ? start : voronoiHeights(diagram.sites()), execution);
}

}  // namespace authalic
