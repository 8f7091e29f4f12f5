/// @file
/// The rigid motions that close a flat cone surface, as functions of its translations.
#pragma once

#include <Eigen/Core>

#include <complex>
#include <vector>

#include "Core/mesh/SurfaceTopology.h"
#include "Core/numerics/RigidMotion.h"
#include "Core/topology/CutGraph.h"

namespace authalic {

/// Motions of a flat cone surface that was cut open, and the places of its cones.
struct ConeMotions {
  std::vector<RigidMotion> across;           ///< 3m, on half-edges of the cut: from the side of its face to the other
  std::vector<RigidMotion> corners;          ///< 3m: corner 3 f + k of the opened image is at corners[3 f + k](place)
  std::vector<std::complex<double>> places;  ///< per cone, in the chart of its vertex
};

/// Holonomy of a flat surface with cones whose turns are given.
///
/// The motions across the edges of a spanning tree of the cut follow, leaf by leaf, from those across the 2g edges that
/// it leaves out: around a vertex they compose to the identity, around a cone to the turn by its curvature about its
/// place. With the turns fixed, the translations across these 2g edges and the places of all cones but the first are
/// free, and everything else is a linear function of them: N − 1 + 2g complex parameters, of which one translation of
/// the whole is without effect. Closes to rounding.
class ConeHolonomy {
 public:
  ConeHolonomy() = default;
  /// @param cut         reaches every cone
  /// @param cones       at least one; Σ curvature = 2πχ
  /// @param curvature   per cone, not 0
  /// @param image       per corner, where it lies in the opened image: decides turns and parameters()
  ConeHolonomy(const SurfaceTopology& topology, const CutGraph& cut, const std::vector<int>& cones,
               const std::vector<double>& curvature, const std::vector<std::complex<double>>& image);

  /// Of the image: places of the cones but the first, then translations.
  [[nodiscard]] const Eigen::VectorXcd& parameters() const noexcept { return parameters_; }
  /// Linear in the parameters but for the turns, which do not depend on them. O(m)
  [[nodiscard]] ConeMotions motions(const SurfaceTopology& topology, const CutGraph& cut,
                                    const Eigen::VectorXcd& parameters) const;
  /// The corner whose chart a vertex has.
  [[nodiscard]] int chart(int vertex) const { return chart_[static_cast<std::size_t>(vertex)]; }

 private:
  friend class ConeClosing;

  std::vector<int> cones_, coneOf_, branches_, generators_, chart_;
  std::vector<double> curvature_;
  std::vector<std::complex<double>> turns_;  // across the generators
  Eigen::VectorXcd parameters_;
};

}  // namespace authalic
