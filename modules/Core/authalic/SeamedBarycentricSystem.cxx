#include "Core/authalic/SeamedBarycentricSystem.h"

namespace authalic {
namespace {

using Complex = std::complex<double>;

ElementAssembly::Unknowns elementUnknowns(const SeamedAreas& areas) {
  const Faces& faces = areas.faces();
  ElementAssembly::Unknowns elements(faces.rows(), 6);
  for (Eigen::Index f = 0; f < faces.rows(); ++f) {
    for (int k = 0; k < 6; ++k) elements(f, k) = areas.unknown(faces(f, k / 2), k % 2);
  }
  return elements;
}

}  // namespace

SeamedBarycentricSystem::SeamedBarycentricSystem(const SeamedAreas& areas, SolverBackend backend)
    : areas_(areas), assembly_(areas.unknownCount(), elementUnknowns(areas)), solver_(backend, PatternUse::Reused),
      values_(static_cast<std::size_t>(21 * areas.faces().rows())) {
  solver_.analyze(assembly_.matrix());
}

void SeamedBarycentricSystem::factorize(const HalfEdgeWeights& weights) {
  double* value = values_.data();
  for (int f = 0; f < static_cast<int>(weights.rows()); ++f) {
    Eigen::Matrix<double, 6, 6> element = Eigen::Matrix<double, 6, 6>::Zero();
    for (int k = 0; k < 3; ++k) {
      const int l = (k + 1) % 3;
      const Complex turn = std::conj(areas_.motion(f, k).turn) * areas_.motion(f, l).turn;
      Eigen::Matrix2d block;
      block << turn.real(), -turn.imag(), turn.imag(), turn.real();
      element.block<2, 2>(2 * k, 2 * k).diagonal().array() += weights(f, k);
      element.block<2, 2>(2 * l, 2 * l).diagonal().array() += weights(f, k);
      element.block<2, 2>(2 * k, 2 * l) -= weights(f, k) * block;
      element.block<2, 2>(2 * l, 2 * k) -= weights(f, k) * block.transpose();
    }
    for (int a = 0; a < 6; ++a) {
      for (int b = a; b < 6; ++b) *value++ = element(a, b);
    }
  }
  solver_.factorize(assembly_.assemble(values_));
}

void SeamedBarycentricSystem::solve(const HalfEdgeWeights& weights, const std::vector<RigidMotion>& motions,
                                    Points2& image) const {
  const Faces& faces = areas_.faces();
  Eigen::VectorXd right = Eigen::VectorXd::Zero(areas_.unknownCount());
  const auto known = [&](int f, int k) {  // where a corner is when all unknowns are 0
    const int v = faces(f, k);
    const RigidMotion& motion = motions[static_cast<std::size_t>(3 * f + k)];
    return areas_.freedom(v) > 0 ? motion.shift : motion({image(v, 0), image(v, 1)});
  };
  const auto pull = [&](int f, int k, Complex force) {
    const int u = areas_.unknown(faces(f, k), 0);
    if (u < 0) return;
    const Complex inChart = std::conj(motions[static_cast<std::size_t>(3 * f + k)].turn) * force;
    right[u] += inChart.real();
    right[u + 1] += inChart.imag();
  };
  for (int f = 0; f < static_cast<int>(faces.rows()); ++f) {
    for (int k = 0; k < 3; ++k) {
      const int l = (k + 1) % 3;
      const Complex force = weights(f, k) * (known(f, l) - known(f, k));
      pull(f, k, force);
      pull(f, l, -force);
    }
  }
  const Eigen::VectorXd solution = solver_.solve(right);
  for (int v = 0; v < areas_.vertexCount(); ++v) {
    if (areas_.freedom(v) > 0) image.row(v) = solution.segment<2>(areas_.unknown(v, 0)).transpose();
  }
}

}  // namespace authalic
