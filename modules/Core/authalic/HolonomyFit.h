/// @file
/// The flat cone surface that suits areas best. Private to authalic/.
#pragma once

#include <complex>
#include <utility>
#include <vector>

#include "Core/authalic/SeamedBarycentricSystem.h"
#include "Core/authalic/TargetMeasure.h"

namespace authalic {

/// Moves cones and translations so that the areas of an image come nearer to their targets, as relaxing the lattice
/// does for a torus.
///
/// The parameters q of the holonomy (see ConeHolonomy) move the image by B q, the barycentric map with the given
/// weights of the change of motions and cones; B is linear. A damped Gauss–Newton step lowers Σ m_t (r_t + 1/r_t) over
/// q; it is shortened until that falls and no face folds. Afterwards the flat surface has the new motions and the image
/// belongs to them, with the cones in their new places. An image with a folded face is left as it is.
/// One sparse factorisation and a solve per parameter; O(m q²) per step, q = 2 (number of cones + 2g − 1).
class HolonomyFit {
 public:
  /// @param areas    of `flat`; kept by reference, like the other surfaces and the targets
  /// @param weights  per half-edge, the same both ways, > 0
  /// @throws SolverError when their system is not definite
  HolonomyFit(const SurfaceTopology& topology, const SeamedAreas& areas, const TargetMeasure& target,
              FlatConeSurface& flat, const HalfEdgeWeights& weights, SolverBackend backend);

  /// @return whether the step took a hundredth off the distortion
  bool relax(Coordinates& image);

 private:
  // How corners move with one parameter.
  struct Response {
    Points2 places;                                            // of the vertices
    std::vector<std::pair<int, std::complex<double>>> shifts;  // of corners beyond the cut, in increasing order
  };

  [[nodiscard]] double distortion(const Coordinates& image) const;
  void setTranslations(const Eigen::VectorXcd& translations);
  void moveTo(const Eigen::VectorXcd& from, const Coordinates& base, const Eigen::VectorXcd& change,
              Coordinates& image);
  void derivatives(const Response& response, const std::vector<std::complex<double>>& sides,
                   Eigen::MatrixXd& jacobian, Eigen::Index column) const;
  [[nodiscard]] Eigen::VectorXcd gaussNewton(const Coordinates& image) const;

  const SurfaceTopology& topology_;
  const SeamedAreas& areas_;
  const Eigen::VectorXd& target_;
  FlatConeSurface& flat_;
  std::vector<Response> responses_;
};

}  // namespace authalic
