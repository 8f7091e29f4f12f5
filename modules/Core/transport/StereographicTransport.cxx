#include "Core/transport/StereographicTransport.h"

#include "Core/transport/DampedNewton.h"

namespace authalic {
namespace {

constexpr double kSphere = 4 * 3.14159265358979323846;

// What DampedNewton asks of a diagram, for sites in a stereographic plane.
class StereographicCells final : public TransportCells {
 public:
  StereographicCells(StereographicPowerDiagram& diagram, const Execution& execution)
      : diagram_(diagram), execution_(execution) {
    (void)diagram.planarSites().rowwise().squaredNorm().minCoeff(&innermost_);
  }
  bool compute(const Heights& heights) override { return diagram_.compute(heights, execution_); }
  const Eigen::VectorXd& areas() const override { return diagram_.cells().areas; }
  void derivatives(std::vector<Eigen::Triplet<double>>& entries) const override {
    for (const StereographicPowerEdge& edge : diagram_.cells().edges) {
      entries.emplace_back(edge.second, edge.first, edge.rate);
    }
  }
  // Heights grow with |z|², a mean of them would leave no digits to those of the small cells around the origin.
  double constantOf(const Eigen::VectorXd& step) const override { return step[innermost_]; }

 private:
  StereographicPowerDiagram& diagram_;
  const Execution& execution_;
  Eigen::Index innermost_ = 0;
};

}  // namespace

TransportSolution stereographicTransport(StereographicPowerDiagram& diagram, const Eigen::VectorXd& masses,
                                         const SemiDiscreteTransportOptions& options, const Heights& start,
                                         const Execution& execution) {
  StereographicCells cells(diagram, execution);
  return dampedNewton(cells, diagram.sites().rows(), masses, kSphere, options,
                      start.size() > 0 ? start : diagram.voronoiHeights(), execution);
}

}  // namespace authalic
