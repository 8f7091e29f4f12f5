#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "Core/authalic/LieFlowStages.h"
#include "Core/geometry/Areas.h"
#include "Core/initial/Unfold.h"
#include "Core/numerics/ElementAssembly.h"
#include "Core/numerics/FlipFreeStep.h"

namespace authalic {
namespace {

constexpr double kSmallestRatio = 0.02;  // of face areas, in the weights
// The faces nearly determine the map: with less damping the last face-scale errors are bought with long slides along
// the curves of equal area, away from the gradient flow.
constexpr double kSmallestDamping = 0.01;
constexpr double kPinned = 0.25;      // of the step: faces that collapse before twice this are slowed by themselves
constexpr double kMostFolded = 0.02;  // share of faces above which a whole step is not worth unfolding

std::size_t at(int i) { return static_cast<std::size_t>(i); }

// Unknowns of the vertices: two along x and y, one along the boundary, or none.
class Displacements {
 public:
  Displacements(const SlidingBoundary& sliding, int vertexCount) : sliding_(sliding), first_(at(vertexCount), -1) {
    for (int v = 0; v < vertexCount; ++v) {
      if (sliding.freedom(v) == 0) continue;
      first_[at(v)] = count_;
      count_ += sliding.freedom(v);
    }
  }

  [[nodiscard]] int count() const { return count_; }

  // The unknown of vertex v in direction d = 0, 1; −1 where there is none.
  [[nodiscard]] int unknown(int v, int d) const { return d < sliding_.freedom(v) ? first_[at(v)] + d : -1; }

  [[nodiscard]] Points2 directions(const Points2& image) const {
    Points2 result = Points2::Zero(image.rows(), 2);
    for (int v = 0; v < static_cast<int>(image.rows()); ++v) {
      if (sliding_.freedom(v) == 1) result.row(v) = sliding_.tangent(image, v);
    }
    return result;
  }

  [[nodiscard]] Points2 expand(const Eigen::VectorXd& x, const Points2& directions) const {
    Points2 result = Points2::Zero(directions.rows(), 2);
    for (int v = 0; v < static_cast<int>(directions.rows()); ++v) {
      const int u = first_[at(v)];
      if (sliding_.freedom(v) == 2) result.row(v) << x[u], x[u + 1];
      if (sliding_.freedom(v) == 1) result.row(v) = x[u] * directions.row(v);
    }
    return result;
  }

  [[nodiscard]] int freedom(int v) const { return sliding_.freedom(v); }

 private:
  const SlidingBoundary& sliding_;
  std::vector<int> first_;
  int count_ = 0;
};

ElementAssembly::Unknowns elementUnknowns(const Faces& faces, const Displacements& displacements) {
  ElementAssembly::Unknowns elements(faces.rows(), 6);
  for (Eigen::Index f = 0; f < faces.rows(); ++f) {
    for (int k = 0; k < 6; ++k) elements(f, k) = displacements.unknown(faces(f, k / 2), k % 2);
  }
  return elements;
}

// The linearised least-squares problem about one image.
class AreaSystem {
 public:
  AreaSystem(const DiskMesh& disk, const SlidingBoundary& sliding, const TargetMeasure& target, SolverBackend backend)
      : faces_(disk.mesh().faces()), target_(target.faces()),
        displacements_(sliding, disk.mesh().vertexCount()),
        assembly_(displacements_.count(), elementUnknowns(faces_, displacements_)),
        solver_(backend, PatternUse::Reused),
        values_(static_cast<std::size_t>(21 * faces_.rows())) {
    solver_.analyze(assembly_.matrix());
  }

  // E = Σ w_t (q_t − m_t)² with q = a / Σ a and the weights of the last linearisation; infinite when a face is folded.
  [[nodiscard]] double energy(const Points2& image) const {
    const Eigen::VectorXd areas = signedFaceAreas(image, faces_);
    const double total = areas.sum();
    if (!(areas.minCoeff() > 0)) return std::numeric_limits<double>::infinity();
    return ((areas / total - target_).array().square() * weight_.array()).sum() * total;
  }

  void linearise(const Points2& image) {
    directions_ = displacements_.directions(image);
    gradients_.resize(faces_.rows(), 6);
    const Eigen::VectorXd areas = signedFaceAreas(image, faces_);
    const double total = areas.sum();
    weight_ = inverseShares(areas.array() / total) / total;
    right_ = Eigen::VectorXd::Zero(displacements_.count());
    for (Eigen::Index f = 0; f < faces_.rows(); ++f) {
      for (int k = 0; k < 3; ++k) {
        const int i = faces_(f, k), j = faces_(f, (k + 1) % 3), l = faces_(f, (k + 2) % 3);
        const Eigen::RowVector2d g(0.5 * (image(j, 1) - image(l, 1)), 0.5 * (image(l, 0) - image(j, 0)));
        const bool slides = displacements_.freedom(i) == 1;
        gradients_(f, 2 * k) = slides ? g.dot(directions_.row(i)) : g[0];
        gradients_(f, 2 * k + 1) = slides ? 0 : g[1];
        for (int d = 0; d < displacements_.freedom(i); ++d) {
          right_[displacements_.unknown(i, d)] +=
              weight_[f] * (target_[f] * total - areas[f]) * gradients_(f, 2 * k + d);
        }
      }
    }
  }

  // δ for the damping ε.
  [[nodiscard]] Points2 step(double damping) {
    for (Eigen::Index f = 0; f < faces_.rows(); ++f) fillElement(f, damping);
    solver_.factorize(assembly_.assemble(values_));
    return displacements_.expand(solver_.solve(right_), directions_);
  }

 private:
  [[nodiscard]] Eigen::ArrayXd inverseShares(const Eigen::ArrayXd& share) const {
    return share.max(kSmallestRatio * target_.array()).min(target_.array()).max(1e-300).inverse();
  }

  // Inner product of the directions (v, d) and (w, e) of two corners.
  [[nodiscard]] double product(int v, int d, int w, int e) const {
    const auto direction = [this](int u, int c) {
      if (displacements_.freedom(u) == 1) return Eigen::RowVector2d(directions_.row(u));
      return Eigen::RowVector2d(c == 0 ? 1 : 0, c == 0 ? 0 : 1);
    };
    if (displacements_.freedom(v) == 2 && displacements_.freedom(w) == 2) return d == e ? 1 : 0;
    return direction(v, d).dot(direction(w, e));
  }

  void fillElement(Eigen::Index f, double damping) {
    double* value = &values_[static_cast<std::size_t>(21 * f)];
    for (int a = 0; a < 6; ++a) {
      for (int b = a; b < 6; ++b, ++value) {
        const int v = faces_(f, a / 2), w = faces_(f, b / 2);
        const double laplacian = (v == w ? (a == b ? 1.0 : 0.0) : -0.5 * product(v, a % 2, w, b % 2));
        *value = weight_[f] * gradients_(f, a) * gradients_(f, b) + damping * laplacian;
      }
    }
  }

  const Faces& faces_;
  const Eigen::VectorXd& target_;
  Displacements displacements_;
  ElementAssembly assembly_;
  SparseSolver solver_;
  std::vector<double> values_;
  Points2 directions_;
  Eigen::Matrix<double, Eigen::Dynamic, 6, Eigen::RowMajor> gradients_;
  Eigen::VectorXd weight_, right_;
};

// A few thin triangles must not stop the whole map: their corners move by at most half of what would collapse them.
Points2 slowedWhereFacesCollapse(const Points2& image, const Faces& faces, Points2 delta) {
  for (int pass = 0; pass < 20; ++pass) {
    Eigen::VectorXd part = Eigen::VectorXd::Ones(image.rows());
    for (Eigen::Index f = 0; f < faces.rows(); ++f) {
      const double half = 0.5 * firstFlip(image, delta, faces(f, 0), faces(f, 1), faces(f, 2));
      for (int k = 0; k < 3 && half < kPinned; ++k) part[faces(f, k)] = std::min(part[faces(f, k)], half);
    }
    if (part.minCoeff() == 1) break;
    delta.array().colwise() *= part.array();
  }
  return delta;
}

// Where a step leads, and its energy; step 0 when no step was found.
struct Move {
  Points2 image;
  double step = 0, energy = std::numeric_limits<double>::infinity();
};

// The longest step along δ, by halving from `first`, that keeps every face unfolded and lowers the energy.
Move searchLine(const AreaSystem& system, const SlidingBoundary& sliding, const Points2& image, const Points2& delta,
                double first, double energy) {
  Move move;
  double step = first;
  for (int halving = 0; halving < 12; ++halving, step *= 0.5) {
    move.image = image + step * delta;
    sliding.retract(move.image);
    move.energy = system.energy(move.image);
    move.step = step;
    if (move.energy < energy) return move;
  }
  return {};
}

// The whole step, with the few faces that fold on the way unfolded in place.
Move wholeStep(const DiskMesh& disk, const AreaSystem& system, const SlidingBoundary& sliding, const Points2& image,
               const Points2& delta) {
  Move move;
  move.image = image + delta;
  sliding.retract(move.image);
  const int folded = countFlippedFaces(move.image, disk.mesh().faces());
  if (folded > kMostFolded * disk.mesh().faceCount()) return {};
  if (folded > 0) move.image = unfold(disk.topology(), move.image, {}, UnfoldReach::Patches).image;
  move.energy = system.energy(move.image);
  move.step = 1;
  return move;
}

}  // namespace

void matchAreas(const DiskMesh& disk, const SlidingBoundary& sliding, const TargetMeasure& target,
                const DiscreteLieFlowOptions& options, const Execution& execution, DiscreteLieFlowResult& result) {
  AreaSystem system(disk, sliding, target, options.solver);
  double damping = 1;
  result.status = Status::NotConverged;
  int failures = 0;
  for (result.finishIterations = 0;; ++result.finishIterations) {
    const Faces& faces = disk.mesh().faces();
    LieFlowIteration now = measureStars(
        vertexStars(signedFaceAreas(result.image, faces), faces, disk.mesh().vertexCount()), target.vertices());
    now.finishing = true;
    if (now.residual <= options.tolerance) result.status = Status::Converged;
    if (failures > 4) result.status = Status::Stalled;
    if (execution.cancelled()) result.status = Status::Cancelled;
    if (result.status != Status::NotConverged || result.finishIterations >= options.maxFinishIterations) return;
    execution.report(double(result.finishIterations) / options.maxFinishIterations, "Matching areas");

    system.linearise(result.image);
    const double energy = system.energy(result.image);
    const Points2 delta = system.step(damping);
    Move move = wholeStep(disk, system, sliding, result.image, delta);
    if (!(move.energy < energy)) {
      const Points2 slowed = slowedWhereFacesCollapse(result.image, faces, delta);
      const double limit = flipFreeStep(result.image, slowed, faces, execution);
      move = searchLine(system, sliding, result.image, slowed, std::min(1.0, 0.9 * limit), energy);
    }
    now.step = move.step;
    if (now.step > 0) result.image = std::move(move.image);
    failures = now.step > 0 ? 0 : failures + 1;
    damping *= now.step == 0 ? 10 : now.step > 0.7 ? 0.25 : now.step < 0.2 ? 4 : 1;
    damping = std::max(damping, kSmallestDamping);
    result.history.push_back(now);
  }
}

}  // namespace authalic
