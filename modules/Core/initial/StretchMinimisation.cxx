#include "Core/initial/StretchMinimisation.h"

#include <chrono>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <utility>

#include "Core/base/Error.h"
#include "Core/geometry/Areas.h"
#include "Core/initial/BarycentricSystem.h"

namespace authalic {
namespace {

// A_t σ_t² of every face, with A_t the surface shares and the image scaled to area 1:
// A (Γ² + γ²)/2 = A/(4 a) Σ cot θ_k |e_k|², θ the angles in the image and e the edges on the surface.
Eigen::VectorXd faceStretches(const TriangleMesh& surface, const Eigen::VectorXd& areas, const Points2& image) {
  const Faces& faces = surface.faces();
  const double total = areas.sum(), whole = signedFaceAreas(image, faces).sum();
  Eigen::VectorXd stretches(faces.rows());
  for (Eigen::Index f = 0; f < faces.rows(); ++f) {
    double sum = 0;
    for (int k = 0; k < 3; ++k) {
      const int i = faces(f, k), j = faces(f, (k + 1) % 3), l = faces(f, (k + 2) % 3);
      sum += (image.row(i) - image.row(l)).dot(image.row(j) - image.row(l)) *
             (surface.point(j) - surface.point(i)).squaredNorm();
    }
    const Eigen::RowVector2d u = image.row(faces(f, 1)) - image.row(faces(f, 0)),
                             v = image.row(faces(f, 2)) - image.row(faces(f, 0));
    const double twice = std::abs(u[0] * v[1] - u[1] * v[0]);  // cot θ_k = (dot product) / twice
    const double least = std::numeric_limits<double>::min();
    stretches[f] = areas[f] / total * sum / (2 * twice * twice + least) * whole / total;
  }
  return stretches;
}

Eigen::VectorXd vertexStretches(const TriangleMesh& surface, const Eigen::VectorXd& areas,
                                const Eigen::VectorXd& stretches) {
  const int n = surface.vertexCount();
  const Eigen::VectorXd sums = vertexStars(stretches, surface.faces(), n),
                        stars = vertexStars(areas / areas.sum(), surface.faces(), n);
  Eigen::VectorXd result = Eigen::VectorXd::Ones(n);
  for (int v = 0; v < n; ++v) {
    if (stars[v] > 0 && sums[v] > 0) result[v] = std::sqrt(sums[v] / stars[v]);
  }
  return result;
}

void divide(const Faces& faces, const Eigen::VectorXd& stretches, MeanValueWeights& weights) {
  for (Eigen::Index f = 0; f < faces.rows(); ++f) {
    for (int k = 0; k < 3; ++k) {
      const double both = stretches[faces(f, k)] * stretches[faces(f, (k + 1) % 3)];
      weights.forward(f, k) /= both;
      weights.backward(f, k) /= both;
    }
  }
  const double scale = 1 / weights.forward.cwiseAbs().mean();
  weights.forward *= scale;
  weights.backward *= scale;
}

class StretchRounds {
 public:
  StretchRounds(const DiskMesh& disk, const StretchMinimisationOptions& options)
      : disk_(disk), options_(options), areas_(faceAreas(disk.mesh())),
        weights_(barycentricWeights(disk.mesh(), options.weights)),
        symmetric_(disk.mesh().faces(), disk.topology().onBoundary(), options.solver) {}

  // Also keeps what the next round needs.
  [[nodiscard]] double stretch(const Points2& image) {
    stretches_ = faceStretches(disk_.mesh(), areas_, image);
    return std::sqrt(stretches_.sum());
  }

  // Empty when the system is not definite, which negative weights may make of it.
  [[nodiscard]] std::optional<Points2> next(Points2 image) {
    divide(disk_.mesh().faces(), vertexStretches(disk_.mesh(), areas_, stretches_), weights_);
    if (options_.weights == BarycentricWeights::MeanValue) {
      solveBarycentric(disk_.mesh().faces(), weights_, disk_.topology().onBoundary(), options_.solver, image);
      return image;
    }
    try {
      symmetric_.solve(weights_.forward, image);
    } catch (const SolverError&) {
      return {};
    }
    return image;
  }

 private:
  const DiskMesh& disk_;
  const StretchMinimisationOptions& options_;
  Eigen::VectorXd areas_, stretches_;
  MeanValueWeights weights_;
  BarycentricSolver symmetric_;
};

void iterate(const DiskMesh& disk, const StretchMinimisationOptions& options, const Execution& execution,
             StretchMinimisationResult& result) {
  StretchRounds rounds(disk, options);
  result.stretch = rounds.stretch(result.image);
  while (result.status == Status::NotRun) {
    if (execution.cancelled()) {
      result.status = Status::Cancelled;
    } else if (result.iterations >= options.maxIterations) {
      result.status = Status::NotConverged;
    } else {
      execution.report(result.iterations / (result.iterations + 5.0), "Lowering the stretch");
      result.history.push_back(result.stretch);
      std::optional<Points2> next = rounds.next(result.image);
      const double stretch = next ? rounds.stretch(*next) : 0;
      ++result.iterations;
      if (!next) {
        result.status = Status::Stalled;
      } else if (!(stretch < result.stretch)) {
        result.status = Status::Converged;
      } else {
        result.image = std::move(*next);
        result.stretch = stretch;
      }
    }
  }
}

}  // namespace

void StretchMinimisationOptions::validate() const {
  BarycentricMapOptions::validate();
  if (maxIterations < 0) {
    throw InvalidArgument("A number of iterations of at least 0 is required, but it is " +
                          std::to_string(maxIterations) + ".");
  }
}

StretchMinimisationResult stretchMinimisation(const DiskMesh& disk, const StretchMinimisationOptions& options,
                                              const Execution& execution) {
  options.validate();
  const auto start = std::chrono::steady_clock::now();
  BarycentricMapResult first = barycentricMap(disk, options, execution.part(0, 0.1));
  StretchMinimisationResult result;
  result.image = std::move(first.image);
  result.boundary = std::move(first.boundary);
  result.degenerateFaces = first.degenerateFaces;
  iterate(disk, options, execution.part(0.1, 1), result);
  result.flippedFaces = countFlippedFaces(result.image, disk.mesh().faces());
  if (result.status == Status::Converged && result.flippedFaces > 0) result.status = Status::NotConverged;
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  execution.report(1, "Stretch minimisation");
  return result;
}

}  // namespace authalic
