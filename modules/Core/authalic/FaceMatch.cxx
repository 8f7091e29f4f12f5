#include "Core/authalic/FaceMatch.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "Core/base/Error.h"

namespace authalic {
namespace {

constexpr double kSmallestRatio = 1e-3;   // of face areas, in the weights
constexpr double kPinned = 0.5;           // of the step: faces that collapse before are slowed by themselves
constexpr double kSlowed = 0.5;           // to this part of what would collapse them
constexpr double kMarginToFlip = 0.9;
constexpr double kShorter = 0.7;          // than the step before, where that did not lower the objective
constexpr int kAttempts = 24;             // at a step
constexpr double kNearerStars = 0.5;      // by this factor at least, in one step
constexpr double kNoNearer = 0.9;         // of what stars were after less damping: more of it does not help
constexpr double kAstray = 2;             // times what faces are, or may be, after such a step
constexpr double kCollapsesEarly = 1.5;   // of a step: faces that collapse before it get stiffer
constexpr double kEndPull = 1e-3;         // of the usual one
constexpr int kStepsWithoutCurvature = 20;  // before faces that the model wants much of get stiffer
// ε by |p_t|: a tenth of what |½ δᵀ ∂²a δ| ≤ Σ |δ_i − δ_j|² / (4 √3) asks for.
constexpr double kCurvature = 0.1 / 1.7320508075688772;
constexpr double kMostWanted = 10;          // |p_t|: a face that has nearly collapsed must open, not become rigid
constexpr double kStiffer = 10, kStiffest = 1e6, kSofter = 0.7;

// τ of the first step, its factor per step, and where it usually ends, by the square of the goal.
struct Pull {
  double first, falls, usual;
};

constexpr Pull kNoPull{0, 1, 0}, kShortPull{0.01, 0.35, 1}, kLongPull{0.1, 0.5, 8};

// One element per face, then one per star.
std::shared_ptr<AssembledSystem> systemOf(const AreaFunctional& areas, const BoundaryStars& stars,
                                          SolverBackend backend, AnalysedSystems& systems) {
  const Faces& faces = areas.faces();
  std::vector<int> starts{0}, unknowns;
  for (Eigen::Index f = 0; f < faces.rows(); ++f) {
    for (int k = 0; k < 6; ++k) unknowns.push_back(areas.unknown(faces(f, k / 2), k % 2));
    starts.push_back(static_cast<int>(unknowns.size()));
  }
  stars.appendElements(starts, unknowns);
  return systems.of(areas.unknownCount(), std::move(starts), std::move(unknowns), backend, PatternUse::Reused);
}

}  // namespace

FaceMatch::FaceMatch(const AreaFunctional& areas, const Eigen::VectorXd& targets,
                     const HalfEdgeWeights& cotangents, SolverBackend backend, Shapes shapes,
                     AnalysedSystems& systems)
    : areas_(areas),
      targets_(targets),
      workers_({}, {}, systems.threads()),
      importance_(shapes == Shapes::Free ? Eigen::VectorXd::Ones(targets.size()) : faceImportance(targets)),
      shape_(areas, cotangents, importance_),
      stars_(areas, targets, importance_),
      system_(systemOf(areas, stars_, backend, systems)),
      values_(static_cast<std::size_t>(21 * areas.faces().rows()) + stars_.valueCount()) {
  stiffness_ = Eigen::VectorXd::Ones(areas.faces().rows());
  const Pull& pull = shapes == Shapes::Free ? kNoPull : shapes == Shapes::First ? kLongPull : kShortPull;
  pull_ = pull.first;
  pullFalls_ = pull.falls;
  usualPull_ = pull.usual;
}

void FaceMatch::restart(double goal) noexcept {
  failures_ = 0;
  leastPull_ = std::min(leastPull_, usualPull_ * goal * goal);
  endPull_ = kEndPull * leastPull_;
}

void FaceMatch::relax() noexcept {
  leastDamping_ = std::max(0.3 * leastDamping_, kLeastDamping);
  leastPull_ = std::max(0.5 * leastPull_, endPull_);
}

void FaceMatch::freeShapes() noexcept {
  importance_.setOnes();
  pull_ = leastPull_ = endPull_ = usualPull_ = 0;
}

// m_t (r_t + 1/r_t − 2); infinite when a face is folded.
Eigen::ArrayXd FaceMatch::faceErrors(const Eigen::VectorXd& areas) const {
  if (!(areas.minCoeff() > 0)) {
    return Eigen::ArrayXd::Constant(areas.size(), std::numeric_limits<double>::infinity());
  }
  const Eigen::ArrayXd share = areas.array() / areas.sum();
  return (share - targets_.array()).square() / share;
}

double FaceMatch::objective(const Coordinates& image) const {
  const Eigen::VectorXd a = areas_.areas(image);
  const double ofFaces = (importance_.array() * faceErrors(a)).sum();
  if (!std::isfinite(ofFaces)) return ofFaces;
  return 0.5 * a.sum() * (ofFaces + stars_.value(a)) + pull_ * shape_.value(image);
}

double FaceMatch::residual(const Coordinates& image) const {
  return std::sqrt(faceErrors(areas_.areas(image)).sum());
}

double FaceMatch::meanAbsLog(const Coordinates& image) const {
  const Eigen::VectorXd a = areas_.areas(image);
  return (a.array() / (a.sum() * targets_.array())).log().abs().mean();
}

void FaceMatch::linearise(const Coordinates& image) {
  frames_ = areas_.frames(image);
  gradients_ = areas_.gradients(image, frames_);
  const Eigen::VectorXd a = areas_.areas(image);
  const double total = a.sum();
  const Eigen::ArrayXd ratio = (a.array() / (total * targets_.array())).max(kSmallestRatio);
  weights_ = importance_.array() * (1 + ratio) / (2 * ratio.square() * targets_.array() * total);
  pulls_ = weights_.cwiseProduct(total * targets_ - a);
  stars_.linearise(a);
  stars_.addPulls(pulls_);
  right_ = Eigen::VectorXd::Zero(areas_.unknownCount());
  const Faces& faces = areas_.faces();
  for (Eigen::Index f = 0; f < faces.rows(); ++f) {
    for (int k = 0; k < 6; ++k) {
      const int u = areas_.unknown(faces(f, k / 2), k % 2);
      if (u >= 0) right_[u] += pulls_[f] * gradients_(f, k);
    }
  }
  shape_.addDescent(image, frames_, pull_, right_);
}

double FaceMatch::rigidity(Eigen::Index face, double damping) const {
  const double curvature = steps_ < kStepsWithoutCurvature ? 0 : kCurvature;
  return damping * stiffness_[face] + curvature * std::min(std::abs(pulls_[face]), kMostWanted);
}

void FaceMatch::fillElement(Eigen::Index face, double rigidity) {
  const AreaFunctional::Directions directions = areas_.directions(frames_, static_cast<int>(face));
  double* value = &values_[static_cast<std::size_t>(21 * face)];
  for (int a = 0; a < 6; ++a) {
    for (int b = a; b < 6; ++b, ++value) {
      *value = weights_[face] * gradients_(face, a) * gradients_(face, b) +
               edgeStiffness(face, rigidity, a / 2, b / 2) * directions.row(a).dot(directions.row(b));
    }
  }
}

// Whether there is enough damping for a positive definite matrix.
bool FaceMatch::factorise(double damping) {
  parallelFor(static_cast<std::size_t>(stiffness_.size()), workers_, [&](std::size_t begin, std::size_t end) {
    for (auto f = static_cast<Eigen::Index>(begin); f < static_cast<Eigen::Index>(end); ++f) {
      fillElement(f, rigidity(f, damping));
    }
  });
  stars_.appendValues(gradients_, &values_[static_cast<std::size_t>(21 * stiffness_.size())]);
  try {
    system_->factorize(system_->assemble(values_));
  } catch (const SolverError&) {
    return false;
  }
  return true;
}

double FaceMatch::edgeStiffness(Eigen::Index face, double rigidity, int k, int l) const {
  return (k == l ? rigidity : -0.5 * rigidity) + pull_ * shape_.stiffness(face, k, l);
}

Coordinates FaceMatch::step(const Coordinates& image) {
  if (const CornerMoves* parameters = areas_.parameters()) return stepWithParameters(image, *parameters);
  const std::vector<Coordinates> moves = areas_.jointMoves(image);
  if (!moves.empty()) return jointStep(image, moves);
  return areas_.displacement(frames_, system_->solver().solve(right_));
}

// When each face flips on the way, see AreaFunctional::firstFlip().
Eigen::ArrayXd FaceMatch::flips(const Coordinates& image, const Coordinates& displacement) const {
  Eigen::ArrayXd first(areas_.faces().rows());
  parallelFor(static_cast<std::size_t>(first.size()), workers_, [&](std::size_t begin, std::size_t end) {
    for (std::size_t f = begin; f < end; ++f) {
      first[static_cast<Eigen::Index>(f)] = areas_.firstFlip(image, displacement, static_cast<int>(f));
    }
  });
  return first;
}

// A few thin triangles must not stop the whole map: their corners move by a part of what would collapse them.
Coordinates FaceMatch::slowedWhereFacesCollapse(const Coordinates& image, Coordinates displacement,
                                                Eigen::ArrayXd& flips) const {
  const Faces& faces = areas_.faces();
  for (int pass = 0; pass < 20; ++pass) {
    Eigen::VectorXd part = Eigen::VectorXd::Ones(image.rows());
    for (Eigen::Index f = 0; f < flips.size(); ++f) {
      for (int k = 0; k < 3 && flips[f] < kPinned; ++k) {
        part[faces(f, k)] = std::min(part[faces(f, k)], kSlowed * flips[f]);
      }
    }
    if (part.minCoeff() == 1) break;
    displacement = areas_.slowed(image, displacement, part);
    flips = this->flips(image, displacement);
  }
  return displacement;
}

// Faces that would collapse on the way become stiffer in the steps to come, so that they move as a whole.
void FaceMatch::stiffen(const Eigen::ArrayXd& flips) {
  for (Eigen::Index f = 0; f < stiffness_.size(); ++f) {
    const bool collapses = flips[f] < kCollapsesEarly;
    stiffness_[f] = collapses ? std::min(stiffness_[f] * kStiffer, kStiffest) : std::max(1.0, stiffness_[f] * kSofter);
  }
}

void FaceMatch::adapt(double step) {
  ++steps_;
  failures_ = step > 0 ? 0 : failures_ + 1;
  damping_ = std::max(leastDamping_, damping_ * (step == 0 ? 10 : step > 0.7 ? 0.25 : step < 0.2 ? 4 : 0.5));
}

double FaceMatch::advance(Coordinates& image) {
  linearise(image);
  const double before = objective(image);
  if (!factorise(damping_)) {
    adapt(0);
    return 0;
  }
  const Coordinates wanted = step(image);
  Eigen::ArrayXd first = flips(image, wanted);
  stiffen(first);
  const Coordinates slowed = slowedWhereFacesCollapse(image, wanted, first);
  double part = std::min(1.0, kMarginToFlip * first.minCoeff());
  for (int shorter = 0; shorter < kAttempts; ++shorter, part *= kShorter) {
    Coordinates next = areas_.eased(areas_.moved(image, slowed, part));
    if (!(objective(next) < before)) continue;
    image = std::move(next);
    adapt(part);
    pull_ = std::max(leastPull_, pullFalls_ * pull_);
    return part;
  }
  adapt(0);
  return 0;
}

double FaceMatch::advanceOnStars(StarConstraint& stars, double tolerance, Coordinates& image) {
  linearise(image);
  stars.linearise(areas_.areas(image), gradients_, weights_);
  const double before = stars.residual(image), astray = kAstray * std::max(residual(image), tolerance);
  double nearest = std::numeric_limits<double>::infinity();
  for (; dampingOnStars_ <= kMostDampingOnStars; dampingOnStars_ *= 10) {
    if (!factorise(dampingOnStars_)) continue;
    const Coordinates wanted = areas_.displacement(frames_, stars.solve(system_->solver(), right_));
    const double part = std::min(1.0, kMarginToFlip * flips(image, wanted).minCoeff());
    Coordinates next = areas_.eased(areas_.moved(image, wanted, part));
    const double after = stars.residual(next);
    if (after < kNearerStars * before) {
      if (!(residual(next) <= astray)) continue;
      image = std::move(next);
      return part;
    }
    if (after > kNoNearer * nearest) return 0;
    nearest = after;
  }
  dampingOnStars_ = kMostDampingOnStars;
  return 0;
}

}  // namespace authalic
