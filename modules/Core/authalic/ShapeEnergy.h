/// @file
/// What an area-preserving map is free to choose: the shape of its faces. Private to authalic/.
#pragma once

#include "Core/authalic/AreaFunctional.h"
#include "Core/geometry/Laplacian.h"

namespace authalic {

/// Importance of each face beside its area: ω_t ~ min(m̄ / m_t, 100)^½, with Σ_t ω_t m_t = 1.
///
/// Energies that weigh a face by its area hardly see small ones, means over faces see nothing else; this is halfway.
/// @param targets  m shares > 0
[[nodiscard]] Eigen::VectorXd faceImportance(const Eigen::VectorXd& targets);

/// The Dirichlet energy of a map from the surface, E(x) = ½ Σ_t ω_t Σ_{edges ij of t} w_t,ij |x_j − x_i|², w_t,ij =
/// ½ cot of the opposite angle on the surface @cite pinkall1993.
///
/// Of faces with given areas it is least where angles are preserved: an image at its target areas has
/// E = ½ Σ_t ω_t a_t (σ₁/σ₂ + σ₂/σ₁). The weights of needles are scaled down, so that none is stiffer than a triangle
/// with an angle of 1.4°.
class ShapeEnergy {
 public:
  /// @param areas       of the domain; kept by reference
  /// @param importance  m values ω
  ShapeEnergy(const AreaFunctional& areas, HalfEdgeWeights cotangents, const Eigen::VectorXd& importance);

  [[nodiscard]] double value(const Coordinates& image) const;
  /// right −= factor ∂E along the frames.
  void addDescent(const Coordinates& image, const AreaFunctional::Frames& frames, double factor,
                  Eigen::VectorXd& right) const;
  /// Entry of corners k and l of the stiffness of a face.
  [[nodiscard]] double stiffness(Eigen::Index face, int k, int l) const {
    if (k == l) return weights_(face, k) + weights_(face, (k + 2) % 3);
    return -weights_(face, l == (k + 1) % 3 ? k : l);
  }

 private:
  const AreaFunctional& areas_;
  HalfEdgeWeights weights_;
};

}  // namespace authalic
