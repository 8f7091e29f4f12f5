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

constexpr int kMostSteps = 12;
constexpr int kHalvings = 8;
constexpr double kWorthwhile = 0.99;     // factor of the distortion in one step
constexpr double kDamping = 1e-6;        // of the diagonal
constexpr double kSmallestRatio = 1e-3;  // of face areas, in the weights

Complex at(const Points2& points, int v) { return {points(v, 0), points(v, 1)}; }

// How corners move with one parameter.
struct Response {
  Points2 places;                             // of the vertices
  std::vector<std::pair<int, Complex>> shifts;  // of corners beyond the cut, in increasing order
};

class HolonomyFit {
 public:
  HolonomyFit(const SurfaceTopology& topology, const SeamedAreas& areas, const TargetMeasure& target,
              FlatConeSurface& flat)
      : topology_(topology), areas_(areas), target_(target.faces()), flat_(flat),
        parameters_(flat.translations) {}

  void respond(const HalfEdgeWeights& weights, SolverBackend backend) {
    SeamedBarycentricSystem system(areas_, backend);
    system.factorize(weights);
    for (Eigen::Index j = 0; j < parameters_.size(); ++j) {
      Response response{Points2::Zero(areas_.vertexCount(), 2), {}};
      const Eigen::VectorXcd unit = Eigen::VectorXcd::Unit(parameters_.size(), j);
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

  // Returns whether a step was worthwhile.
  bool step(Points2& image) {
    const double before = distortion(image);
    if (!std::isfinite(before)) return false;
    const Eigen::VectorXcd direction = gaussNewton(image);
    const Points2 base = image;
    const Eigen::VectorXcd from = parameters_;
    for (int halving = 0; halving < kHalvings; ++halving) {
      const double part = std::pow(0.5, halving);
      moveTo(from, base, part * direction, image);
      if (const double now = distortion(image); now < before) return now - 2 < kWorthwhile * (before - 2);
    }
    moveTo(from, base, 0 * direction, image);
    return false;
  }

 private:
  [[nodiscard]] double distortion(const Points2& image) const {
    const Eigen::VectorXd a = areas_.areas(image);
    if (!(a.minCoeff() > 0)) return std::numeric_limits<double>::infinity();
    const Eigen::ArrayXd ratio = a.array() / (a.sum() * target_.array());
    return (target_.array() * (ratio + 1 / ratio)).sum();
  }

  void moveTo(const Eigen::VectorXcd& from, const Points2& base, const Eigen::VectorXcd& change, Points2& image) {
    parameters_ = from + change;
    image = base;
    for (std::size_t j = 0; j < responses_.size(); ++j) {
      const Complex q = change[static_cast<Eigen::Index>(j)];
      const Points2& b = responses_[j].places;
      image.col(0) += q.real() * b.col(0) - q.imag() * b.col(1);
      image.col(1) += q.imag() * b.col(0) + q.real() * b.col(1);
    }
    setMotions(flat_, flat_.holonomy.motions(topology_, flat_.cut, parameters_));
    for (const int v : flat_.cones) image.row(v) = flat_.places.row(v);
  }

  // Derivatives of the areas by the real and the imaginary part of one parameter.
  void derivatives(const Response& response, const std::vector<Complex>& sides, Eigen::MatrixXd& jacobian,
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

  [[nodiscard]] Eigen::VectorXcd gaussNewton(const Coordinates& image) const {
    const Eigen::Index m = areas_.faces().rows(), count = 2 * parameters_.size();
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
    Eigen::VectorXcd direction(parameters_.size());
    for (Eigen::Index j = 0; j < direction.size(); ++j) direction[j] = {step[2 * j], step[2 * j + 1]};
    return direction;
  }

  const SurfaceTopology& topology_;
  const SeamedAreas& areas_;
  const Eigen::VectorXd& target_;
  FlatConeSurface& flat_;
  Eigen::VectorXcd& parameters_;
  std::vector<Response> responses_;
};

}  // namespace

void fitHolonomy(const SurfaceTopology& topology, const SeamedAreas& areas, const TargetMeasure& target,
                 const HalfEdgeWeights& weights, SolverBackend backend, FlatConeSurface& flat, Points2& image,
                 const Execution& execution) {
  HolonomyFit fit(topology, areas, target, flat);
  fit.respond(weights, backend);
  for (int step = 0; step < kMostSteps && !execution.cancelled() && fit.step(image); ++step) {
    execution.report(double(step) / kMostSteps, "Fitting the flat surface");
  }
}

}  // namespace authalic
