/// @file
/// Heights of many sites from a transport to few. Private to transport/.
#pragma once

#include <Eigen/Core>

#include <vector>

#include "Core/transport/PowerDiagram.h"

namespace authalic {

/// The convex conjugate of the potential of a transport, v = u*, as a smooth function of the place of a site.
///
/// Site j of the transport has the value v(y_j) = −h_j and the gradient ∇v(y_j) = x_j, the centroid of its cell. A
/// quadratic q_j is fitted to both at j and at its neighbours in the diagram, by weighted least squares, its Hessian
/// made positive definite; with weights φ_j that fall to 0 at some distance in the metric of that Hessian,
///
///   v(p) = Σ_j φ_j(p) q_j(p) / Σ_j φ_j(p),  over the cluster of p and its neighbours.
///
/// Exact where the heights are those of a quadratic and the centroids its gradients (sites moved, scaled, stretched).
/// Close to convex, not convex for certain.
class HeightInterpolation {
 public:
  /// @param diagram  of the few sites, at their heights
  HeightInterpolation(const PowerDiagram& diagram, const Heights& heights);

  /// −v at each site. @param sites n×2. @param clusterOf n: the one of the few sites that is near.
  [[nodiscard]] Heights heightsAt(const Points2& sites, const std::vector<int>& clusterOf,
                                  const Execution& execution) const;

  /// Whether the fits are usable: false when one of the few sites has no cell or no neighbour.
  [[nodiscard]] bool usable() const { return usable_; }

 private:
  struct Quadratic {
    Eigen::RowVector2d origin, slope;  // y_j and x_j
    double value = 0;                  // v(y_j)
    double scale = 1;                  // mean distance of neighbours
    Eigen::Matrix<double, 6, 1> coefficients;  // of 1, x, y, x²/2, xy, y²/2 by the scale, on top of value and slope
    double reach = 1;  // square of the distance at which the weight is 0, in the metric of the Hessian

    [[nodiscard]] double valueAt(const Eigen::RowVector2d& p) const;
    [[nodiscard]] double weight(const Eigen::RowVector2d& p) const;
  };

  void fit(int j, const PowerCells& cells);
  [[nodiscard]] double conjugateAt(const Eigen::RowVector2d& p, int cluster) const;

  std::vector<Quadratic> fits_;
  std::vector<std::vector<int>> around_;  // neighbours, then theirs
  std::vector<std::size_t> direct_;       // how many of them are neighbours
  bool usable_ = true;
};

}  // namespace authalic
