#include "Core/authalic/AreaSolve.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "Core/authalic/NarrowFaces.h"
#include "Core/authalic/VertexMatch.h"

namespace authalic {
namespace {

constexpr int kRoundsWithShapes = 3;
constexpr int kMostVertexSteps = 12;    // of one round, and as many more as each halve the residual
constexpr double kPinned = 0.1;         // a vertex step shorter than this leads nowhere
constexpr double kGettingSlow = 0.8;    // factor of the residual over kSlowSteps / 2 face steps
constexpr double kShort = 0.6;          // a face step that asks whether a few faces hold up all others
constexpr int kMostInVain = 3;          // then it is no longer asked
constexpr double kSlow = 0.99;          // factor of the residual over kSlowSteps face steps
constexpr std::size_t kSlowSteps = 8;

// Face steps end at this part of the goal, or at the second where they get slow.
constexpr double kNear = 0.9, kNearEnough = 0.95;

// Wanted of the mean of |ln r| over the faces, which sees small ones, but between half of the tolerance and all of it.
constexpr double kMeanLog = 5e-3, kMeanLogWithShapesFirst = 8e-3;

constexpr int kMostStepsOnStars = 3;      // of one round
// Stars farther than this many tolerances ask for a step on the stars, or, after one, farther than the second.
constexpr double kVerticesDisturb = 2, kVerticesStillDisturb = 5;

double now() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

class AreaSolver {
 public:
  AreaSolver(const AreaFunctional& areas, const TriangleMesh& surface, const TargetMeasure& target,
             const AuthalicMapOptions& options, const Execution& execution, Shapes shapes, AnalysedSystems& systems)
      : areas_(areas), surface_(surface.points()), targets_(target.faces()), options_(options), execution_(execution),
        shapes_(shapes),
        meanLogWanted_(std::clamp(shapes == Shapes::First ? kMeanLogWithShapesFirst : kMeanLog,
                                  0.5 * options.tolerance, options.tolerance)),
        faces_(areas, target.faces(), cotangentWeights(surface), options.solver, shapes, systems),
        stars_(areas, target.vertices(), options.solver, systems),
        vertices_(areas, target.vertices(), options.solver, systems) {}

  AreaSolveResult run(Coordinates start) {
    Coordinates image = std::move(start);
    double goal = options_.tolerance;
    bool reached = vertices_.residual(image) <= options_.vertexTolerance;
    if (reached) keepIfBetter(image);
    for (int round = 0; !ended(); ++round) {
      const bool moved = faceSteps(goal, image);
      Coordinates exact = image;
      stepsOnStars(exact);
      reached = vertexSteps(exact);
      goal *= reached ? std::clamp(kNear / farness(exact, faces_.residual(exact)), 0.4, kNear) : 0.5;
      if (reached) keepIfBetter(image = exact);
      if (converged_ && !reached) break;
      if (round + 1 == kRoundsWithShapes && !converged_) {
        faces_.freeShapes();
        shapes_ = Shapes::Free;
      }
      if (!moved && (!reached || faces_.stalled())) result_.status = Status::Stalled;
    }
    if (result_.image.size() == 0) result_.image = std::move(image);
    result_.faceResidual = faces_.residual(result_.image);
    result_.vertexResidual = vertices_.residual(result_.image);
    result_.iterations = static_cast<int>(result_.history.size());
    if (converged_ && result_.status != Status::Cancelled) result_.status = Status::Converged;
    if (result_.status == Status::NotRun) result_.status = Status::NotConverged;
    return std::move(result_);
  }

 private:
  [[nodiscard]] bool ended() {
    if (execution_.cancelled()) result_.status = Status::Cancelled;
    return result_.status != Status::NotRun || static_cast<int>(result_.history.size()) >= options_.maxIterations;
  }

  void tell(const AuthalicIteration& iteration, const char* stage) {
    result_.history.push_back(iteration);
    execution_.report(double(result_.history.size()) / (result_.history.size() + 10.0), stage);
  }

  // Until the residual and the mean over faces are near the goal, or nearly so and progress slows, or nothing
  // moves. Returns whether any step was taken.
  bool faceSteps(double goal, Coordinates& image) {
    const double begun = now();
    bool moved = false;
    std::vector<double> residuals;
    for (faces_.restart(goal); !ended() && !faces_.stalled();) {
      residuals.push_back(faces_.residual(image));
      const std::size_t count = residuals.size();
      const auto slower = [&](std::size_t steps, double factor) {
        return count > steps && residuals.back() > factor * residuals[count - 1 - steps];
      };
      const double far = farness(image, residuals.back()) * options_.tolerance / goal;
      if (far <= kNear) break;
      if (slower(kSlowSteps / 2, kGettingSlow)) {
        if (far <= kNearEnough) break;
        faces_.relax();
      }
      if (slower(kSlowSteps, residuals.back() <= kNearEnough * goal ? kGettingSlow : kSlow)) break;
      const double step = faces_.advance(image);
      moved = moved || step > 0;
      tell({residuals.back(), step, false}, "Matching faces");
      if (step < kShort && inVain_ < kMostInVain) moved = waitForFarFaces(image) || moved;
    }
    result_.faceSeconds += now() - begun;
    return moved;
  }

  // What few faces hold up is done in patches around them. Returns whether that helped.
  bool waitForFarFaces(Coordinates& image) {
    const FaceFlags far = farFaces(areas_, targets_, image);
    if (!far.any()) return false;
    const bool helped = matchFarFaces(far, areas_, targets_, surface_, options_.solver, shapes_, image);
    inVain_ = helped ? 0 : inVain_ + 1;
    return helped;
  }

  // How far the faces are from what is wanted of them: 1 is just enough.
  [[nodiscard]] double farness(const Coordinates& image, double residual) const {
    return std::max(residual / options_.tolerance, faces_.meanAbsLog(image) / meanLogWanted_);
  }

  // Face steps that keep to the stars, until vertex steps have so little left to do that faces do not notice.
  void stepsOnStars(Coordinates& image) {
    const double begun = now();
    for (int k = 0; k < kMostStepsOnStars && !ended(); ++k) {
      const double enough = (k == 0 ? kVerticesDisturb : kVerticesStillDisturb) * options_.tolerance;
      if (stars_.residual(image) <= std::max(enough, options_.vertexTolerance)) break;
      const double residual = faces_.residual(image), step = faces_.advanceOnStars(stars_, options_.tolerance, image);
      if (step == 0) break;
      tell({residual, step, false}, "Matching faces and vertices");
    }
    result_.faceSeconds += now() - begun;
  }

  // Returns whether the tolerance was reached.
  bool vertexSteps(Coordinates& image) {
    const double begun = now();
    vertices_.restart(image);
    double residual = vertices_.residual(image);
    bool halved = true;
    for (int k = 0; (k < kMostVertexSteps || halved) && residual > options_.vertexTolerance && !ended(); ++k) {
      const double step = vertices_.advance(image), before = residual;
      tell({residual, step, true}, "Matching vertices");
      if (step < kPinned) break;
      residual = vertices_.residual(image);
      halved = residual < 0.5 * before;
    }
    result_.vertexSeconds += now() - begun;
    return residual <= options_.vertexTolerance;
  }

  // Of the images with exact stars, the one whose faces are nearest to their targets.
  void keepIfBetter(const Coordinates& exact) {
    const double residual = faces_.residual(exact);
    if (result_.image.size() > 0 && residual >= result_.faceResidual) return;
    result_.image = exact;
    result_.faceResidual = residual;
    if (residual > options_.tolerance) return;
    if (converged_ || faces_.meanAbsLog(exact) <= meanLogWanted_) result_.status = Status::Converged;
    converged_ = true;
  }

  const AreaFunctional& areas_;
  const Points3& surface_;
  const Eigen::VectorXd& targets_;
  const AuthalicMapOptions& options_;
  const Execution& execution_;
  Shapes shapes_;
  int inVain_ = 0;  // patches that did not help, in a row
  double meanLogWanted_;
  FaceMatch faces_;
  StarConstraint stars_;
  VertexMatch vertices_;
  AreaSolveResult result_;
  bool converged_ = false;  // `result_.image` is within both tolerances; small faces have one more round
};

}  // namespace

AreaSolveResult solveAreas(const AreaFunctional& areas, const TriangleMesh& surface, const TargetMeasure& target,
                           Coordinates start, const AuthalicMapOptions& options, const Execution& execution,
                           Shapes shapes, AnalysedSystems* systems) {
  AnalysedSystems own(execution.threads());
  return AreaSolver(areas, surface, target, options, execution, shapes, systems != nullptr ? *systems : own)
      .run(std::move(start));
}

bool giveBetterTheEffortOfBoth(AuthalicSolution& first, AuthalicSolution& second) {
  const bool secondIsBetter = second.status == Status::Converged || second.faceResidual < first.faceResidual;
  AuthalicSolution &best = secondIsBetter ? second : first, &other = secondIsBetter ? first : second;
  best.iterations += other.iterations;
  best.history.insert(secondIsBetter ? best.history.begin() : best.history.end(), other.history.begin(),
                      other.history.end());
  best.startSeconds += other.startSeconds;
  best.faceSeconds += other.faceSeconds;
  best.vertexSeconds += other.vertexSeconds;
  return secondIsBetter;
}

}  // namespace authalic
