#include "Core/authalic/ShapeEnergy.h"

#include <algorithm>
#include <utility>

namespace authalic {
namespace {

constexpr double kLargestImportance = 100;  // squared, before normalisation
constexpr double kStiffest = 20;            // sum of the weights of a face

}  // namespace

Eigen::VectorXd faceImportance(const Eigen::VectorXd& targets) {
  const Eigen::ArrayXd raw = (targets.mean() / targets.array()).min(kLargestImportance).sqrt();
  return raw / (raw * targets.array()).sum();
}

ShapeEnergy::ShapeEnergy(const AreaFunctional& areas, HalfEdgeWeights cotangents, const Eigen::VectorXd& importance)
    : areas_(areas), weights_(std::move(cotangents)) {
  for (Eigen::Index f = 0; f < weights_.rows(); ++f) {
    weights_.row(f) *= importance[f] / std::max(1.0, weights_.row(f).sum() / kStiffest);
  }
}

double ShapeEnergy::value(const Coordinates& image) const {
  double sum = 0;
  for (int f = 0; f < static_cast<int>(weights_.rows()); ++f) {
    const AreaFunctional::Corners corners = areas_.corners(image, f);
    for (int k = 0; k < 3; ++k) sum += weights_(f, k) * (corners.row((k + 1) % 3) - corners.row(k)).squaredNorm();
  }
  return 0.5 * sum;
}

void ShapeEnergy::addDescent(const Coordinates& image, const AreaFunctional::Frames& frames, double factor,
                             Eigen::VectorXd& right) const {
  const Faces& faces = areas_.faces();
  for (int f = 0; f < static_cast<int>(weights_.rows()); ++f) {
    const AreaFunctional::Corners corners = areas_.corners(image, f);
    const AreaFunctional::Directions directions = areas_.directions(frames, f);
    for (int k = 0; k < 3; ++k) {
      const int next = (k + 1) % 3, last = (k + 2) % 3;
      const auto force = factor * (weights_(f, k) * (corners.row(next) - corners.row(k)) +
                                   weights_(f, last) * (corners.row(last) - corners.row(k)));
      for (int j = 0; j < 2; ++j) {
        const int u = areas_.unknown(faces(f, k), j);
        if (u >= 0) right[u] += force.dot(directions.row(2 * k + j));
      }
    }
  }
}

}  // namespace authalic
