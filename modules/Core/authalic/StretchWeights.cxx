#include "Core/authalic/StretchWeights.h"

#include "Core/geometry/Areas.h"

namespace authalic {

HalfEdgeWeights stretchWeights(const Points2& image, const Faces& faces, const Eigen::VectorXd& target) {
  const double total = signedFaceAreas(image, faces).sum();
  HalfEdgeWeights weights(faces.rows(), 3);
  for (Eigen::Index f = 0; f < faces.rows(); ++f) {
    for (int k = 0; k < 3; ++k) {
      const Eigen::RowVector2d apex = image.row(faces(f, (k + 2) % 3));
      weights(f, k) = 0.25 * (image.row(faces(f, k)) - apex).dot(image.row(faces(f, (k + 1) % 3)) - apex) /
                      (total * target[f]);
    }
  }
  return weights;
}

}  // namespace authalic
