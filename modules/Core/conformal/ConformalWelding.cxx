#include "Core/conformal/ConformalWelding.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "Core/base/Error.h"

namespace authalic {
namespace {

using Complex = std::complex<double>;
using Projective = Eigen::Vector2cd;

Complex onCircle(double angle) { return std::polar(1.0, angle); }

double sineOfHalf(double angle, double complement) { return std::sin(0.5 * std::min(angle, complement)); }

/// Σ of the arcs before each point, and from each point to the end: the small one of both is accurate.
std::pair<Eigen::VectorXd, Eigen::VectorXd> partialSums(const Eigen::VectorXd& arcs) {
  const Eigen::Index n = arcs.size();
  Eigen::VectorXd before(n), after(n);
  before[0] = 0;
  for (Eigen::Index k = 1; k < n; ++k) before[k] = before[k - 1] + arcs[k - 1];
  after[n - 1] = arcs[n - 1];
  for (Eigen::Index k = n - 2; k >= 0; --k) after[k] = after[k + 1] + arcs[k];
  return {before, after};
}

Complex planar(const Projective& p) {
  if (p[1] == Complex(0)) return {std::numeric_limits<double>::infinity(), 0};
  return p[0] / p[1];
}

/// (2x, 2y, 1 − |w|²)/(1 + |w|²) of w = u/v, without dividing by either.
Eigen::RowVector3d spherical(const Projective& p) {
  const double largest = std::max(std::abs(p[0]), std::abs(p[1]));
  const Complex u = p[0] / largest, v = p[1] / largest, product = u * std::conj(v);
  const double uu = std::norm(u), vv = std::norm(v), sum = uu + vv;
  return {2 * product.real() / sum, 2 * product.imag() / sum, (vv - uu) / sum};
}

/// The Möbius transformation that takes three points to 0, 1, ∞ (cross-ratio), points given projectively.
Eigen::Matrix2cd toZeroOneInfinity(const std::array<Projective, 3>& p) {
  const auto bracket = [](const Projective& x, const Projective& y) { return x[0] * y[1] - x[1] * y[0]; };
  const Complex top = bracket(p[1], p[2]), bottom = bracket(p[1], p[0]);
  Eigen::Matrix2cd map;
  map << top * p[0][1], -top * p[0][0], bottom * p[2][1], -bottom * p[2][0];
  return map / map.cwiseAbs().maxCoeff();
}

Eigen::VectorXcd planarPoints(const std::vector<Projective>& points) {
  Eigen::VectorXcd images(static_cast<Eigen::Index>(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i) images[static_cast<Eigen::Index>(i)] = planar(points[i]);
  return images;
}

Points3 sphericalPoints(const std::vector<Projective>& points) {
  Points3 images(static_cast<Eigen::Index>(points.size()), 3);
  for (std::size_t i = 0; i < points.size(); ++i) images.row(static_cast<Eigen::Index>(i)) = spherical(points[i]);
  return images;
}

Points2 circlePoints(const Eigen::VectorXd& angles) {
  Points2 points(angles.size(), 2);
  points.col(0) = angles.array().cos();
  points.col(1) = angles.array().sin();
  return points;
}

Complex diskPointOf(const Points2& points, Eigen::Index i) {
  const Complex z(points(i, 0), points(i, 1));
  const double radius = std::abs(z);
  if (!(radius <= 1 + 1e-9)) {
    throw InvalidArgument("Points of the closed unit disk are required, but point " + std::to_string(i) +
                          " has distance " + std::to_string(radius) + " from its centre.");
  }
  return z;
}

/// Value at `s` of the cubic through four points.
double interpolate(const std::array<double, 4>& x, const std::array<double, 4>& y, double s) {
  double value = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    double weight = 1;
    for (std::size_t j = 0; j < 4; ++j) {
      if (j != i) weight *= (s - x[j]) / (x[i] - x[j]);
    }
    value += weight * y[i];
  }
  return value;
}

/// The angle on disk 2 that the cubic through pairs k − 1 … k + 2 gives to the middle of arc k of disk 1, kept within
/// the arc.
double middlePartner(const WeldingSignature& signature, const Eigen::VectorXd& secondAngles, Eigen::Index k) {
  const Eigen::Index n = signature.firstArcs.size();
  std::array<double, 4> x{}, y{};
  x[0] = -signature.firstArcs[(k + n - 1) % n];
  y[0] = -signature.secondArcs[(k + n - 1) % n];
  x[2] = signature.firstArcs[k];
  y[2] = signature.secondArcs[k];
  x[3] = x[2] + signature.firstArcs[(k + 1) % n];
  y[3] = y[2] + signature.secondArcs[(k + 1) % n];
  return secondAngles[k] - std::clamp(interpolate(x, y, 0.5 * x[2]), 0.0, y[2]);
}

}  // namespace

HalfPlaneChart::HalfPlaneChart(const Eigen::VectorXd& arcs, double start, bool clockwise)
    : origin_(onCircle(start)), clockwise_(clockwise) {
  const auto [before, after] = partialSums(arcs);
  const Eigen::Index n = arcs.size();
  // cot ½θ_k − cot ½θ_{k+1} = sin ½(θ_{k+1} − θ_k) / (sin ½θ_k sin ½θ_{k+1})
  Eigen::VectorXd all(n - 2);
  for (Eigen::Index k = 1; k + 1 < n; ++k) {
    all[k - 1] = std::sin(0.5 * std::min(arcs[k], 2 * M_PI - arcs[k])) /
                 (sineOfHalf(before[k], after[k]) * sineOfHalf(before[k + 1], after[k + 1]));
  }
  scale_ = 1 / all[0];
  gaps_ = scale_ * all.tail(n - 3);
  secondAngle_ = before[2];
}

Complex HalfPlaneChart::toHalfPlane(Complex point) const {
  Complex w = point * std::conj(origin_);
  if (clockwise_) w = std::conj(w);
  const double radius = std::abs(w);
  if (radius >= 1) {  // −cot ½θ + cot ½θ_2, and ∞ at θ = 0
    const double angle = std::arg(w);
    if (angle == 0) return {0, 1e100};
    return scale_ * std::sin(0.5 * (angle - secondAngle_)) / (std::sin(0.5 * angle) * std::sin(0.5 * secondAngle_));
  }
  const Complex rest = 1.0 - w, second = onCircle(secondAngle_);
  const Complex from = Complex(0, 2) * (w - second) / (rest * (1.0 - second));
  return scale_ * Complex(from.real(), (1 - radius) * (1 + radius) / std::norm(rest));
}

Complex HalfPlaneChart::toDisk(Complex point) const {
  const Complex x = point / scale_ - 1 / std::tan(0.5 * secondAngle_);
  Complex w = std::isfinite(std::abs(x)) ? (x - Complex(0, 1)) / (x + Complex(0, 1)) : Complex(1);
  if (clockwise_) w = std::conj(w);
  return w * origin_;
}

WeldingSignature WeldingSignature::fromAngles(const Eigen::VectorXd& first, const Eigen::VectorXd& second) {
  if (first.size() != second.size() || first.size() < 3) {
    throw InvalidArgument("At least 3 pairs of angles are required for a welding, but there are " +
                          std::to_string(first.size()) + " on disk 1 and " + std::to_string(second.size()) +
                          " on disk 2.");
  }
  const Eigen::Index n = first.size();
  WeldingSignature signature{Eigen::VectorXd(n), Eigen::VectorXd(n), first[0], second[0]};
  const auto advance = [](double arc) { return arc < 0 ? arc + 2 * M_PI : arc; };
  for (Eigen::Index k = 0; k < n; ++k) {
    const Eigen::Index next = (k + 1) % n;
    signature.firstArcs[k] = advance(first[next] - first[k]);
    signature.secondArcs[k] = advance(second[k] - second[next]);
  }
  signature.validate();
  return signature;
}

WeldingSignature WeldingSignature::fromPoints(const Points2& first, const Points2& second) {
  if (!first.allFinite() || !second.allFinite() || (first.rowwise().squaredNorm().array() <= 0).any() ||
      (second.rowwise().squaredNorm().array() <= 0).any()) {
    throw InvalidArgument("Boundary points with a direction are required for a welding, but one is 0 or not finite.");
  }
  const auto angles = [](const Points2& points) {
    Eigen::VectorXd values(points.rows());
    for (Eigen::Index k = 0; k < points.rows(); ++k) values[k] = std::atan2(points(k, 1), points(k, 0));
    return values;
  };
  WeldingSignature signature = fromAngles(angles(first), angles(second));
  const auto turn = [](const Points2& points, Eigen::Index k, Eigen::Index l) {  // accurate for close neighbours
    return std::atan2(points(k, 0) * points(l, 1) - points(k, 1) * points(l, 0), points.row(k).dot(points.row(l)));
  };
  const Eigen::Index n = first.rows();
  for (Eigen::Index k = 0; k < n; ++k) {
    const Eigen::Index next = (k + 1) % n;
    if (signature.firstArcs[k] < 3) signature.firstArcs[k] = turn(first, k, next);
    if (signature.secondArcs[k] < 3) signature.secondArcs[k] = -turn(second, k, next);
  }
  signature.validate();
  return signature;
}

Eigen::VectorXd WeldingSignature::firstAngles() const { return firstStart + partialSums(firstArcs).first.array(); }

Eigen::VectorXd WeldingSignature::secondAngles() const { return secondStart - partialSums(secondArcs).first.array(); }

void WeldingSignature::validate() const {
  if (firstArcs.size() < 3 || firstArcs.size() != secondArcs.size()) {
    throw InvalidArgument("At least 3 pairs of arcs are required for a welding, but there are " +
                          std::to_string(firstArcs.size()) + " on disk 1 and " +
                          std::to_string(secondArcs.size()) + " on disk 2.");
  }
  if (!std::isfinite(firstStart) || !std::isfinite(secondStart)) {
    throw InvalidArgument("Finite start angles are required for a welding.");
  }
  for (const auto& [arcs, name] : {std::pair(&firstArcs, "1"), std::pair(&secondArcs, "2")}) {
    for (Eigen::Index k = 0; k < arcs->size(); ++k) {
      if ((*arcs)[k] > 0) continue;
      throw InvalidArgument("Boundary points in order are required for a welding (counter-clockwise on disk 1, "
                            "clockwise on disk 2), but on disk " + std::string(name) + " point " +
                            std::to_string((k + 1) % arcs->size()) + " does not come after point " +
                            std::to_string(k) + ".");
    }
    if (!(std::abs(arcs->sum() - 2 * M_PI) < 1e-6)) {
      throw InvalidArgument("Arcs that sum to 2π are required for a welding, but those of disk " + std::string(name) +
                            " sum to " + std::to_string(arcs->sum()) + "; do the points go round more than once?");
    }
  }
}

ConformalWelding::ConformalWelding(WeldingSignature signature, const Execution& execution)
    : signature_(std::move(signature)), after_(Eigen::Matrix2cd::Identity()) {
  signature_.validate();
  charts_ = {HalfPlaneChart(signature_.firstArcs, signature_.firstStart, false),
             HalfPlaneChart(signature_.secondArcs, signature_.secondStart, true)};
  // The arcs from v_0 over v_1 to v_2 are glued by −x ~ −x; the square root makes the seam the imaginary axis.
  const auto rooted = [](const Eigen::VectorXd& gaps) {
    Eigen::VectorXd roots(gaps.size());
    double at = 0, root = 0;
    for (Eigen::Index k = 0; k < gaps.size(); ++k) {
      at += gaps[k];
      const double next = std::sqrt(at);
      roots[k] = gaps[k] / (root + next);
      root = next;
    }
    return roots;
  };
  zipper_ = Zipper({rooted(charts_[0].gaps()), rooted(charts_[1].gaps())}, execution.part(0, 0.7));
  traceCurve(execution.part(0.7, 1));
  const Points2 centre = Points2::Zero(1, 2);
  after_ = toZeroOneInfinity({evaluate(Side::First, centre, execution)[0], tips_[0],
                              evaluate(Side::Second, centre, execution)[0]});
  execution.report(1, "zipper");
}

void ConformalWelding::traceCurve(const Execution& execution) {
  std::vector<Zipper::Traveller> travellers{{{0, 1}, 0}};
  for (Eigen::Index k = 2; k < signature_.firstArcs.size(); ++k) travellers.push_back({0, k - 2});
  const std::vector<Complex> images = zipper_.close(travellers, false, execution);
  tips_ = {Projective(1, 0)};
  for (const Complex& z : images) tips_.emplace_back(z * z, 1);
}

std::vector<ConformalWelding::Projective> ConformalWelding::evaluate(Side side, const Points2& points,
                                                                     const Execution& execution) const {
  const bool second = side == Side::Second;
  const HalfPlaneChart& chart = charts_[second ? 1 : 0];
  std::vector<Zipper::Traveller> travellers(static_cast<std::size_t>(points.rows()));
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    travellers[static_cast<std::size_t>(i)].at = std::sqrt(chart.toHalfPlane(diskPointOf(points, i)));
  }
  const std::vector<Complex> images = zipper_.close(travellers, second, execution);
  std::vector<Projective> result(images.size());
  for (std::size_t i = 0; i < images.size(); ++i) {
    const Complex square = images[i] * images[i];
    result[i] = after_ * Projective(second ? std::conj(square) : square, 1);
  }
  return result;
}

Eigen::VectorXcd ConformalWelding::curve() const {
  std::vector<Projective> points(tips_);
  for (Projective& point : points) point = after_ * point;
  return planarPoints(points);
}

Points3 ConformalWelding::curveOnSphere() const {
  std::vector<Projective> points(tips_);
  for (Projective& point : points) point = after_ * point;
  return sphericalPoints(points);
}

Eigen::VectorXcd ConformalWelding::mapFirst(const Points2& points, const Execution& execution) const {
  return planarPoints(evaluate(Side::First, points, execution));
}

Eigen::VectorXcd ConformalWelding::mapSecond(const Points2& points, const Execution& execution) const {
  return planarPoints(evaluate(Side::Second, points, execution));
}

Points3 ConformalWelding::mapFirstToSphere(const Points2& points, const Execution& execution) const {
  return sphericalPoints(evaluate(Side::First, points, execution));
}

Points3 ConformalWelding::mapSecondToSphere(const Points2& points, const Execution& execution) const {
  return sphericalPoints(evaluate(Side::Second, points, execution));
}

WeldingPreimages ConformalWelding::inverse(const Eigen::VectorXcd& images) const {
  const Eigen::Matrix2cd before = after_.inverse();
  WeldingPreimages result{Points2(images.size(), 2), std::vector<char>(static_cast<std::size_t>(images.size()))};
  for (Eigen::Index i = 0; i < images.size(); ++i) {
    if (std::isnan(images[i].real()) || std::isnan(images[i].imag())) {
      throw InvalidArgument("Points of the extended plane are required, but point " + std::to_string(i) + " is NaN.");
    }
    const bool infinite = std::isinf(images[i].real()) || std::isinf(images[i].imag());
    const Complex square = planar(before * (infinite ? Projective(1, 0) : Projective(images[i], 1)));
    Complex z = std::isinf(square.real()) ? Complex(0, 1e100) : std::sqrt(square);
    if (z.imag() < 0) z = -z;
    z = zipper_.open(z);
    const bool second = z.real() < 0;
    if (second) z = -std::conj(z);
    const Complex point = charts_[second ? 1 : 0].toDisk(z * z);
    result.points.row(i) << point.real(), point.imag();
    result.second[static_cast<std::size_t>(i)] = second;
  }
  return result;
}

ConformalWelding ConformalWelding::withCurvePointsAt(const std::array<int, 3>& points,
                                                     const std::array<Complex, 3>& places) const {
  std::array<Projective, 3> from, to;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    if (points[i] < 0 || points[i] >= static_cast<int>(tips_.size()) || points[i] == points[j] ||
        !std::isfinite(std::abs(places[i])) || places[i] == places[j]) {
      throw InvalidArgument("Three different curve points of " + std::to_string(tips_.size()) +
                            " and three different finite places are required to normalise a welding.");
    }
    from[i] = tips_[static_cast<std::size_t>(points[i])];
    to[i] = Projective(places[i], 1);
  }
  ConformalWelding result(*this);
  result.after_ = toZeroOneInfinity(to).inverse() * toZeroOneInfinity(from);
  return result;
}

WeldingAccuracy ConformalWelding::accuracy(const Execution& execution) const {
  const Eigen::VectorXd first = signature_.firstAngles(), second = signature_.secondAngles();
  const auto mismatch = [&](const Eigen::VectorXd& alpha, const Eigen::VectorXd& beta) {
    const Points3 inner = mapFirstToSphere(circlePoints(alpha), execution);
    return (inner - mapSecondToSphere(circlePoints(beta), execution)).rowwise().norm().maxCoeff();
  };
  Eigen::VectorXd partners(second.size());
  for (Eigen::Index k = 0; k < second.size(); ++k) partners[k] = middlePartner(signature_, second, k);
  return {mismatch(first, second), mismatch(first + 0.5 * signature_.firstArcs, partners)};
}

}  // namespace authalic
