/// @file
/// The damped Newton method behind transport in the plane and on the sphere. Private to transport/.
#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <vector>

#include "Core/transport/SemiDiscreteTransport.h"

namespace authalic {

/// Cells whose areas depend on one height per site.
class TransportCells {
 public:
  virtual ~TransportCells() = default;
  /// @return false when a cell is empty; nothing else may then be asked for
  [[nodiscard]] virtual bool compute(const Heights& heights) = 0;
  [[nodiscard]] virtual const Eigen::VectorXd& areas() const = 0;
  /// Adds −∂w_i/∂h_j > 0 at (i, j), i > j, for every two cells with a common side.
  virtual void derivatives(std::vector<Eigen::Triplet<double>>& entries) const = 0;
  /// The constant that is taken from all heights of a step, which moves no cell.
  [[nodiscard]] virtual double constantOf(const Eigen::VectorXd& step) const { return step.mean(); }
};

/// The masses, scaled to the sum `area` exactly.
/// @throws GeometryError when there are not `count` of them, one is not positive, or their sum is another
[[nodiscard]] Eigen::VectorXd checkedMasses(const Eigen::VectorXd& masses, Eigen::Index count, double area);

/// See semiDiscreteTransport. `cells` are those of the returned heights afterwards.
[[nodiscard]] TransportSolution dampedNewton(TransportCells& cells, Eigen::Index count, const Eigen::VectorXd& masses,
                                             double area, const SemiDiscreteTransportOptions& options,
                                             Heights start, const Execution& execution);

}  // namespace authalic
