/// @file
/// Energy, gradient and Hessian of the symmetric Dirichlet energy, face by face. Private to initial/.
#pragma once

#include <vector>

#include "Core/base/Execution.h"
#include "Core/mesh/TriangleMesh.h"
#include "Core/numerics/ElementAssembly.h"

namespace authalic {

/// The faces of a surface as elements of Σ_t ρ_t (‖J‖² + ‖J⁻¹‖²).
///
/// The shape of a face is clamped to a height of 1e-6 of its longest side, its share ρ_t to 1e-12, so that a
/// degenerate face keeps its image from folding without weighing on the map.
class IsometricElements {
 public:
  /// @param scale  of the surface: E compares the image with the surface times this
  IsometricElements(const TriangleMesh& surface, double scale);

  /// E of an image; +infinity when a face is not counter-clockwise.
  [[nodiscard]] double energy(const Points2& image, const Execution& execution = {}) const;
  /// The factor of the image that makes E least.
  [[nodiscard]] double bestScale(const Points2& image) const;

  /// Gradient and Hessian of every face about an image; projected: without the negative eigenvalues. @return E
  double linearise(const Points2& image, bool projected, const Execution& execution = {});
  /// Σ of the faces' gradients, n×2.
  [[nodiscard]] Points2 gradient() const;
  /// 21 entries per face (see ElementAssembly): unknowns x, y of corner 0, 1, 2.
  [[nodiscard]] const std::vector<double>& hessians() const noexcept { return hessians_; }

 private:
  [[nodiscard]] Eigen::Matrix2d jacobian(const Points2& image, Eigen::Index face) const;
  void lineariseFace(const Points2& image, bool projected, Eigen::Index face);

  const Faces& faces_;
  Eigen::Index vertexCount_;
  Eigen::VectorXd shares_;
  Eigen::Matrix<double, Eigen::Dynamic, 6, Eigen::RowMajor> hats_;       // gradients of the three hat functions
  Eigen::Matrix<double, Eigen::Dynamic, 6, Eigen::RowMajor> gradients_;  // of E by the corners
  Eigen::VectorXd energies_;
  std::vector<double> hessians_;
};

}  // namespace authalic
