#include "Core/authalic/AreaFunctional.h"

#include <utility>

namespace authalic {

AreaFunctional::AreaFunctional(const Faces& faces, std::vector<char> freedom)
    : faces_(faces), freedom_(std::move(freedom)), first_(freedom_.size(), -1) {
  for (std::size_t v = 0; v < freedom_.size(); ++v) {
    if (freedom_[v] == 0) continue;
    first_[v] = unknownCount_;
    unknownCount_ += freedom_[v];
  }
}

AreaFunctional::FrameProducts AreaFunctional::frameProducts(const Frames& frames, int face) const {
  const Eigen::Index dimension = frames.cols() / 2;
  FrameProducts result;
  for (int a = 0; a < 6; ++a) {
    const double* u = frames.row(faces_(face, a / 2)).data() + (a % 2) * dimension;
    for (int b = a; b < 6; ++b) {
      const double* v = frames.row(faces_(face, b / 2)).data() + (b % 2) * dimension;
      double product = 0;
      for (Eigen::Index d = 0; d < dimension; ++d) product += u[d] * v[d];
      result(a, b) = result(b, a) = product;
    }
  }
  return result;
}

Coordinates AreaFunctional::displacement(const Frames& frames, const Eigen::VectorXd& step) const {
  const Eigen::Index dimension = frames.cols() / 2;
  Coordinates result = Coordinates::Zero(frames.rows(), dimension);
  for (int v = 0; v < vertexCount(); ++v) {
    for (int j = 0; j < freedom(v); ++j) {
      result.row(v) += step[unknown(v, j)] * frames.row(v).segment(j * dimension, dimension);
    }
  }
  return result;
}

}  // namespace authalic
