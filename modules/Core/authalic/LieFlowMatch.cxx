#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "Core/authalic/LieFlowStages.h"
#include "Core/geometry/Areas.h"
#include "Core/numerics/ElementAssembly.h"

namespace authalic {
namespace {

constexpr double kSmallestRatio = 0.02;  // of face areas, in the weights
// The faces nearly determine the map: with less damping the last face-scale errors are bought with long slides along
// the curves of equal area, away from the gradient flow.
constexpr double kSmallestDamping = 0.01;
constexpr double kPinned = 0.5;       // of the step: faces that collapse before this are slowed by themselves
constexpr double kMostFolded = 0.02;  // share of faces above which a whole step is not worth unfolding

ElementAssembly::Unknowns elementUnknowns(const AreaFunctional& areas) {
  const Faces& faces = areas.faces();
  ElementAssembly::Unknowns elements(faces.rows(), 6);
  for (Eigen::Index f = 0; f < faces.rows(); ++f) {
    for (int k = 0; k < 6; ++k) elements(f, k) = areas.unknown(faces(f, k / 2), k % 2);
  }
  return elements;
}

// The linearised least-squares problem about one image.
class AreaSystem {
 public:
  AreaSystem(const AreaFunctional& areas, const TargetMeasure& target, SolverBackend backend)
      : areas_(areas), target_(target.faces()), assembly_(areas.unknownCount(), elementUnknowns(areas)),
        solver_(backend, PatternUse::Reused), values_(static_cast<std::size_t>(21 * areas.faces().rows())) {
    solver_.analyze(assembly_.matrix());
  }

  [[nodiscard]] const AreaFunctional& areas() const noexcept { return areas_; }

  // E = Σ w_t (q_t − m_t)² with q = a / Σ a and the weights of the last linearisation; infinite when a face
  // is folded.
  [[nodiscard]] double energy(const Coordinates& image) const {
    const Eigen::VectorXd areas = areas_.areas(image);
    const double total = areas.sum();
    if (!(areas.minCoeff() > 0)) return std::numeric_limits<double>::infinity();
    return ((areas / total - target_).array().square() * weight_.array()).sum() * total;
  }

  void linearise(const Coordinates& image) {
    frames_ = areas_.frames(image);
    gradients_ = areas_.gradients(image, frames_);
    const Eigen::VectorXd areas = areas_.areas(image);
    const double total = areas.sum();
    weight_ = inverseShares(areas.array() / total) / total;
    right_ = Eigen::VectorXd::Zero(areas_.unknownCount());
    const Faces& faces = areas_.faces();
    for (Eigen::Index f = 0; f < faces.rows(); ++f) {
      const double pull = weight_[f] * (target_[f] * total - areas[f]);
      for (int k = 0; k < 6; ++k) {
        const int u = areas_.unknown(faces(f, k / 2), k % 2);
        if (u >= 0) right_[u] += pull * gradients_(f, k);
      }
    }
  }

  // δ for the damping ε.
  [[nodiscard]] Coordinates step(double damping) {
    for (Eigen::Index f = 0; f < areas_.faces().rows(); ++f) fillElement(f, damping);
    solver_.factorize(assembly_.assemble(values_));
    return areas_.displacement(frames_, solver_.solve(right_));
  }

 private:
  [[nodiscard]] Eigen::ArrayXd inverseShares(const Eigen::ArrayXd& share) const {
    return share.max(kSmallestRatio * target_.array()).min(target_.array()).max(1e-300).inverse();
  }

  // Entry a = 2 k + j belongs to direction j of corner k.
  void fillElement(Eigen::Index f, double damping) {
    const Eigen::Index d = frames_.cols() / 2;
    const auto direction = [&](int a) { return frames_.row(areas_.faces()(f, a / 2)).segment((a % 2) * d, d); };
    double* value = &values_[static_cast<std::size_t>(21 * f)];
    for (int a = 0; a < 6; ++a) {
      for (int b = a; b < 6; ++b, ++value) {
        const bool sameCorner = a / 2 == b / 2;
        const double laplacian = sameCorner ? (a == b ? 1.0 : 0.0) : -0.5 * direction(a).dot(direction(b));
        *value = weight_[f] * gradients_(f, a) * gradients_(f, b) + damping * laplacian;
      }
    }
  }

  const AreaFunctional& areas_;
  const Eigen::VectorXd& target_;
  ElementAssembly assembly_;
  SparseSolver solver_;
  std::vector<double> values_;
  AreaFunctional::Frames frames_;
  AreaFunctional::Gradients gradients_;
  Eigen::VectorXd weight_, right_;
};

// Where a step leads, and its energy; step 0 when no step was found.
struct Move {
  Coordinates image;
  double step = 0, energy = std::numeric_limits<double>::infinity();
};

// The longest step along δ, by halving from `first`, that keeps every face unfolded and lowers the energy.
Move searchLine(const AreaSystem& system, const Coordinates& image, const Coordinates& delta, double first,
                double energy) {
  Move move;
  double step = first;
  for (int halving = 0; halving < 12; ++halving, step *= 0.5) {
    move.image = system.areas().moved(image, delta, step);
    move.energy = system.energy(move.image);
    move.step = step;
    if (move.energy < energy) return move;
  }
  return {};
}

// The whole step, with the few faces that fold on the way unfolded in place.
Move wholeStep(const LieFlowDomain& domain, const AreaSystem& system, const Coordinates& image,
               const Coordinates& delta) {
  Move move;
  move.image = system.areas().moved(image, delta, 1);
  const int folded = countFolded(system.areas(), move.image);
  if (folded > kMostFolded * static_cast<double>(domain.faces().rows())) return {};
  if (folded > 0) move.image = domain.unfolded(move.image, UnfoldReach::Patches);
  move.energy = system.energy(move.image);
  move.step = 1;
  return move;
}

}  // namespace

void matchAreas(const LieFlowDomain& domain, const DiscreteLieFlowOptions& options, const Execution& execution,
                Coordinates& image, LieFlowSolution& solution) {
  const std::unique_ptr<AreaFunctional> areas = domain.heldAreas();
  AreaSystem system(*areas, domain.target(), options.solver);
  double damping = 1;
  solution.status = Status::NotConverged;
  int failures = 0;
  for (solution.finishIterations = 0;; ++solution.finishIterations) {
    LieFlowIteration now = measureStars(
        vertexStars(areas->areas(image), domain.faces(), areas->vertexCount()), domain.target().vertices());
    now.finishing = true;
    if (now.residual <= options.tolerance) solution.status = Status::Converged;
    if (failures > 4) solution.status = Status::Stalled;
    if (execution.cancelled()) solution.status = Status::Cancelled;
    if (solution.status != Status::NotConverged || solution.finishIterations >= options.maxFinishIterations) return;
    execution.report(double(solution.finishIterations) / options.maxFinishIterations, "Matching areas");

    system.linearise(image);
    const double energy = system.energy(image);
    const Coordinates delta = system.step(damping);
    Move move = wholeStep(domain, system, image, delta);
    if (!(move.energy < energy)) {
      Coordinates slowed = delta;
      slowPinned(*areas, image, kPinned, slowed);
      move = searchLine(system, image, slowed, std::min(1.0, 0.9 * flipFreeStep(*areas, image, slowed)), energy);
    }
    now.step = move.step;
    if (now.step > 0) image = std::move(move.image);
    failures = now.step > 0 ? 0 : failures + 1;
    damping *= now.step == 0 ? 10 : now.step > 0.7 ? 0.25 : now.step < 0.2 ? 4 : 1;
    damping = std::max(damping, kSmallestDamping);
    solution.history.push_back(now);
  }
}

}  // namespace authalic
