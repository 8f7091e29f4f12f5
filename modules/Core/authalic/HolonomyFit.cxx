#include "Core/authalic/HolonomyFit.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace authalic {
namespace {

using Complex = std::complex<double>;

constexpr int kHalvings = 8;
constexpr double kWorthwhile = 0.99;     // factor of the distortion in one step
constexpr double kDamping = 1e-6;        // of the diagonal
constexpr double kSmallestRatio = 1e-3;  // of face areas, in the weights

Complex at(const Points2& points, int v) { return {points(v, 0), points(v, 1)}; }

}  // namespace

HolonomyFit::HolonomyFit(const SurfaceTopology& topology, const SeamedAreas& areas, const TargetMeasure& target,
                         FlatConeSurface& flat, const HalfEdgeWeights& weights, SolverBackend backend)
    : topology_(topology), areas_(areas), target_(target.faces()), flat_(flat) {
  SeamedBarycentricSystem system(areas_, backend);
  system.factorize(weights);
  for (Eigen::Index j = 0; j < flat_.translations.size(); ++j) {
    Response response{Points2::Zero(areas_.vertexCount(), 2), {}};
    const Eigen::VectorXcd unit = Eigen::VectorXcd::Unit(flat_.translations.size(), j);
    const ConeMotions motions = flat_.holonomy.motions(topology_, flat_.cut, unit);
    for (std::size_t i = 0; i < flat_.cones.size(); ++i) {
      response.places.row(flat_.cones[i]) << motions.places[i].real(), motions.places[i].imag();
    }
    system.solve(weights, motions.corners, response.places);
    for (int c = 0; c < static_cast<int>(motions.corners.size()); ++c) {
      const Complex shift = motions.corners[static_cast<std::size_t>(c)].shift;
      if (shift != Complex(0)) response.shifts.push_back({c, shift});
    }
    responses_.push_back(std::move(response));
  }
}

bool HolonomyFit::relax(Coordinates& image) {
  const double before = distortion(image);
  if (!std::isfinite(before)) return false;
  const Eigen::VectorXcd direction = gaussNewton(image), from = flat_.translations;
  const Coordinates base = image;
  for (int halving = 0; halving < kHalvings; ++halving) {
    moveTo(from, base, std::pow(0.5, halving) * direction, image);
    if (const double now = distortion(image); now < before) return now - 2 < kWorthwhile * (before - 2);
  }
  moveTo(from, base, 0 * direction, image);
  return false;
}

void HolonomyFit::setTranslations(const Eigen::VectorXcd& translations) {
  flat_.translations = translations;
  setMotions(flat_, flat_.holonomy.motions(topology_, flat_.cut, translations));
}

double HolonomyFit::distortion(const Coordinates& image) const {
  const Eigen::VectorXd a = areas_.areas(image);
  if (!(a.minCoeff() > 0)) return std::numeric_limits<double>::infinity();
  const Eigen::ArrayXd ratio = a.array() / (a.sum() * target_.array());
  return (target_.array() * (ratio + 1 / ratio)).sum();
}

void HolonomyFit::moveTo(const Eigen::VectorXcd& from, const Coordinates& base, const Eigen::VectorXcd& change,
                         Coordinates& image) {
  image = base;
  for (std::size_t j = 0; j < responses_.size(); ++j) {
    const Complex q = change[static_cast<Eigen::Index>(j)];
    const Points2& b = responses_[j].places;
    image.col(0) += q.real() * b.col(0) - q.imag() * b.col(1);
    image.col(1) += q.imag() * b.col(0) + q.real() * b.col(1);
  }
  setTranslations(from + change);
  for (const int v : flat_.cones) image.row(v) = flat_.places.row(v);
}

// Derivatives of the areas by the real and the imaginary part of one parameter.
void HolonomyFit::derivatives(const Response& response, const std::vector<Complex>& sides, Eigen::MatrixXd& jacobian,
                              Eigen::Index column) const {
  auto shift = response.shifts.begin();
  for (int f = 0; f < static_cast<int>(jacobian.rows()); ++f) {
    Complex d[3];
    for (int k = 0; k < 3; ++k) {
      d[k] = areas_.motion(f, k).turn * at(response.places, areas_.faces()(f, k));
      if (shift != response.shifts.end() && shift->first == 3 * f + k) d[k] += (shift++)->second;
    }
    // da = ½ Σ_k d_k × s_k, s_k from corner k + 2 to corner k + 1; u × v = Im(conj(u) v)
    Complex sum = 0;
    for (int k = 0; k < 3; ++k) sum += std::conj(d[k]) * sides[static_cast<std::size_t>(3 * f + k)];
    jacobian(f, column) = 0.5 * sum.imag();
    jacobian(f, column + 1) = -0.5 * sum.real();
  }
}

Eigen::VectorXcd HolonomyFit::gaussNewton(const Coordinates& image) const {
  const Eigen::Index m = areas_.faces().rows(), count = 2 * flat_.translations.size();
  std::vector<Complex> sides(static_cast<std::size_t>(3 * m));
  for (int f = 0; f < static_cast<int>(m); ++f) {
    for (int k = 0; k < 3; ++k) {
      sides[static_cast<std::size_t>(3 * f + k)] =
          areas_.corner(image, f, (k + 1) % 3) - areas_.corner(image, f, (k + 2) % 3);
    }
  }
  Eigen::MatrixXd jacobian(m, count);
  for (std::size_t j = 0; j < responses_.size(); ++j) {
    derivatives(responses_[j], sides, jacobian, 2 * static_cast<Eigen::Index>(j));
  }
  const Eigen::VectorXd a = areas_.areas(image);
  const double total = a.sum();
  const Eigen::ArrayXd ratio = (a.array() / (total * target_.array())).max(kSmallestRatio);
  const Eigen::VectorXd weights = (1 + ratio) / (2 * ratio.square() * target_.array() * total);
  const Eigen::VectorXd right = jacobian.transpose() * (weights.array() * (total * target_ - a).array()).matrix();
  jacobian.array().colwise() *= weights.array().sqrt();
  Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(count, count);
  normal.selfadjointView<Eigen::Lower>().rankUpdate(jacobian.transpose());
  normal.diagonal().array() += kDamping * normal.diagonal().maxCoeff();
  const Eigen::VectorXd step = normal.ldlt().solve(right);
  Eigen::VectorXcd direction(flat_.translations.size());
  for (Eigen::Index j = 0; j < direction.size(); ++j) direction[j] = {step[2 * j], step[2 * j + 1]};
  return direction;
}

}  // namespace authalic
