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

void SeamedBarycentricSystem::solve(const HalfEdgeWeights& weights, Points2& image) {
  const Faces& faces = areas_.faces();
  Points2 known = image;  // where corners are when all unknowns are 0
  for (int v = 0; v < areas_.vertexCount(); ++v) {
    if (areas_.freedom(v) > 0) known.row(v).setZero();
  }
  const Coordinates start = known;
  Eigen::VectorXd right = Eigen::VectorXd::Zero(areas_.unknownCount());
  double* value = values_.data();
  for (int f = 0; f < static_cast<int>(faces.rows()); ++f) {
    Eigen::Matrix<double, 6, 6> element = Eigen::Matrix<double, 6, 6>::Zero();
    for (int k = 0; k < 3; ++k) {
      const int l = (k + 1) % 3;
      const Complex turn = std::conj(areas_.motion(f, k).turn) * areas_.motion(f, l).turn;
      const Eigen::Matrix2d block = weights(f, k) * (Eigen::Matrix2d() << turn.real(), -turn.imag(), turn.imag(),
                                                     turn.real()).finished();
      element.block<2, 2>(2 * k, 2 * k).diagonal().array() += weights(f, k);
      element.block<2, 2>(2 * l, 2 * l).diagonal().array() += weights(f, k);
      element.block<2, 2>(2 * k, 2 * l) -= block;
      element.block<2, 2>(2 * l, 2 * k) -= block.transpose();
      const Complex pull = weights(f, k) * (areas_.corner(start, f, l) - areas_.corner(start, f, k));
      const Complex atTail = std::conj(areas_.motion(f, k).turn) * pull,
                    atHead = -std::conj(areas_.motion(f, l).turn) * pull;
      if (const int u = areas_.unknown(faces(f, k), 0); u >= 0) right.segment<2>(u) += Eigen::Vector2d(atTail.real(), atTail.imag());
      if (const int u = areas_.unknown(faces(f, l), 0); u >= 0) right.segment<2>(u) += Eigen::Vector2d(atHead.real(), atHead.imag());
    }
    for (int a = 0; a < 6; ++a) {
      for (int b = a; b < 6; ++b) *value++ = element(a, b);
    }
  }
  solver_.factorize(assembly_.assemble(values_));
  const Eigen::VectorXd solution = solver_.solve(right);
  for (int v = 0; v < areas_.vertexCount(); ++v) {
    if (areas_.freedom(v) > 0) image.row(v) = solution.segment<2>(areas_.unknown(v, 0)).transpose();
  }
}

}  // namespace authalic
