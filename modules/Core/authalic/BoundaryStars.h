/// @file
/// The stars of the vertices that slide on a boundary, as a part of what face steps look at. Private to authalic/.
#pragma once

#include <vector>

#include "Core/authalic/AreaFunctional.h"

namespace authalic {

/// B(a) = κ Σ_v ω_v n_v (s_v + 1/s_v − 2) over the vertices with one freedom: n_v and s_v n_v are the target and the
/// share of the faces around v, ω_v their importance, and κ = m / 2500 on m faces, but at least 10 and at most 30.
/// From 25,000 faces to 75,000 a star so counts alike against the sum over all faces, however many they are; with less
/// than 10, stars of small meshes are held up by their neighbours.
///
/// A star on a boundary is a few faces, which must have their area exactly when stars are matched afterwards. It gets
/// it by slides of its neighbours along the boundary, far around; faces near their targets hardly ask for them.
class BoundaryStars {
 public:
  /// @param targets     m shares of the faces
  /// @param importance  m values ω
  BoundaryStars(const AreaFunctional& areas, const Eigen::VectorXd& targets, const Eigen::VectorXd& importance);

  /// B. @param faceAreas  m values > 0
  [[nodiscard]] double value(const Eigen::VectorXd& faceAreas) const;

  /// The quadratic model of ½ S B, S = Σ a: ½ Σ_v W_v (a_v + ∂a_v·δ − S n_v)², as FaceMatch has it of faces.
  void linearise(const Eigen::VectorXd& faceAreas);
  /// pulls_t += Σ_{v of t} W_v (S n_v − a_v): how much the model wants of the area of t.
  void addPulls(Eigen::VectorXd& pulls) const;

  /// One element per star, after those that are there, as ElementAssembly takes them.
  void appendElements(std::vector<int>& starts, std::vector<int>& unknowns) const;
  /// The upper triangles of W_v ∂a_v ∂a_vᵀ, one after the other.
  void appendValues(const AreaFunctional::Gradients& gradients, double* values) const;
  [[nodiscard]] std::size_t valueCount() const;

 private:
  struct Star {
    std::vector<int> faces, unknowns;
    std::vector<int> places;      // of the unknowns 6 k + j of face k, −1 for none
    double target, importance;    // n, ω
    double weight = 0, lacks = 0; // W, S n − a
  };
  std::vector<Star> stars_;
  double weight_;  // κ
};

}  // namespace authalic
