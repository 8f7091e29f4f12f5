#include "Core/authalic/AreaFunctional.h"

#include <utility>

#include "Core/authalic/Patches.h"

namespace authalic {

AreaFunctional::AreaFunctional(const Faces& faces, std::vector<char> freedom)
    : faces_(faces), freedom_(std::move(freedom)), first_(freedom_.size(), -1) {
  for (std::size_t v = 0; v < freedom_.size(); ++v) {
    if (freedom_[v] == 0) continue;
    first_[v] = unknownCount_;
    unknownCount_ += freedom_[v];
  }
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

const Points2& AreaFunctional::shifts() const {
  static const Points2 none;
  return none;
}

std::vector<Coordinates> AreaFunctional::jointMoves(const Coordinates&) const { return {}; }

Coordinates AreaFunctional::slowed(const Coordinates&, const Coordinates& displacement,
                                   const Eigen::VectorXd& part) const {
  return part.asDiagonal() * displacement;
}

const std::vector<EarOnCircle>& AreaFunctional::slidingEars() const {
  static const std::vector<EarOnCircle> none;
  return none;
}

AreaFunctional::Corners AreaFunctional::corners(const Coordinates& image, int face) const {
  Corners result(3, image.cols());
  for (int k = 0; k < 3; ++k) result.row(k) = image.row(faces_(face, k));
  return result;
}

AreaFunctional::Directions AreaFunctional::directions(const Frames& frames, int face) const {
  const Eigen::Index dimension = frames.cols() / 2;
  Directions result(6, dimension);
  for (int a = 0; a < 6; ++a) {
    result.row(a) = frames.row(faces_(face, a / 2)).segment((a % 2) * dimension, dimension);
  }
  return result;
}

}  // namespace authalic
