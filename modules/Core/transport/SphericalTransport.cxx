#include "Core/transport/SphericalTransport.h"

#include "Core/base/Error.h"
#include "Core/transport/DampedNewton.h"

namespace authalic {
namespace {

constexpr double kSphere = 4 * 3.14159265358979323846;

// What DampedNewton asks of a diagram, for sites on the sphere.
class SphericalCells final : public TransportCells {
 public:
  SphericalCells(SphericalPowerDiagram& diagram, const Execution& execution)
      : diagram_(diagram), execution_(execution) {}
  bool compute(const Heights& heights) override {
    return diagram_.compute(heights, execution_).surrounded;  // a step too far has no cells
  }
  const Eigen::VectorXd& areas() const override { return diagram_.cells().areas; }
  void derivatives(std::vector<Eigen::Triplet<double>>& entries) const override {
    for (const SphericalPowerEdge& edge : diagram_.cells().edges) {
      entries.emplace_back(edge.second, edge.first, edge.rate);
    }
  }

 private:
  SphericalPowerDiagram& diagram_;
  const Execution& execution_;
};

}  // namespace

TransportSolution sphericalTransport(SphericalPowerDiagram& diagram, const Eigen::VectorXd& masses,
                                     const SemiDiscreteTransportOptions& options, const Heights& start,
                                     const Execution& execution) {
  const Heights first = start.size() > 0 ? start : Heights(Heights::Zero(diagram.sites().rows()));
  SphericalCells cells(diagram, execution);
  if (!cells.compute(first)) {
    throw GeometryError(
        "Sites all around the sphere are required, but there is a hemisphere without any; normalise the "
        "initial map so that its centre of mass is 0.");
  }
  return dampedNewton(cells, diagram.sites().rows(), masses, kSphere, options, first, execution);
}

}  // namespace authalic
