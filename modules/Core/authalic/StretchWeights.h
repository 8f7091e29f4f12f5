/// @file
/// Weights of the stretch energy. Private to authalic/.
#pragma once

#include "Core/geometry/Laplacian.h"

namespace authalic {

/// w_ij = ½ r cot θ of each half-edge @cite yueh2019, θ the opposite angle in the *image*, r = image share / target
/// share of the face: ¼ (x_i − x_k)·(x_j − x_k) / (S m), S = Σ a, finite where r and cot are not.
/// @param target  m shares > 0
[[nodiscard]] HalfEdgeWeights stretchWeights(const Points2& image, const Faces& faces, const Eigen::VectorXd& target);

}  // namespace authalic
