#include "Core/initial/SymmetricDirichletMap.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "Core/base/Error.h"
#include "Core/geometry/Areas.h"
#include "Core/initial/BoundaryPair.h"
#include "Core/initial/IsometricElements.h"
#include "Core/numerics/FlipFreeStep.h"

namespace authalic {
namespace {

constexpr double kShortened = 0.9;  // of the way to the first collapse
constexpr double kNear = 1e-2;      // decrement below which the whole Hessian is tried
constexpr double kSufficient = 1e-4;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

// The Newton system: x and y of the vertices that move. With a free boundary one vertex of a distant pair stays,
// and the other moves along x only: translation and rotation, of which E does not depend, would make the matrix
// singular.
class NewtonSystem {
 public:
  NewtonSystem(const DiskMesh& disk, IsometricBoundary boundary, SolverBackend backend)
      : unknown_(at(2 * disk.mesh().vertexCount()), -1),
        elements_(numberUnknowns(disk, boundary)),
        assembly_(count_, elements_),
        solver_(backend, PatternUse::Reused) {
    solver_.analyze(assembly_.matrix());
  }

  // The Newton direction about an image: of the whole Hessian near the minimum, where it is definite, else projected.
  // @return gᵀ direction
  double solve(IsometricElements& elements, const Points2& image, const Execution& execution, Points2& direction) {
    energy_ = elements.linearise(image, !whole_, execution);
    if (whole_ && !factorises(elements, 0)) {
      whole_ = false;
      energy_ = elements.linearise(image, true, execution);
    }
    for (double damping = 0; !whole_ && !factorises(elements, damping);) {
      damping = damping == 0 ? 1e-12 : 100 * damping;
      if (damping > 1) {
        throw SolverError("A definite Hessian is required, but it stays singular; look for degenerate faces.");
      }
    }
    const Points2 gradient = elements.gradient();
    Eigen::VectorXd right(count_);
    for (int i = 0; i < 2 * gradient.rows(); ++i) {
      if (unknown_[at(i)] >= 0) right[unknown_[at(i)]] = -gradient(i / 2, i % 2);
    }
    const Eigen::VectorXd solution = solver_.solve(right);
    direction = Points2::Zero(gradient.rows(), 2);
    for (int i = 0; i < 2 * gradient.rows(); ++i) {
      if (unknown_[at(i)] >= 0) direction(i / 2, i % 2) = solution[unknown_[at(i)]];
    }
    const double slope = -right.dot(solution);
    whole_ = -slope < kNear * kNear * energy_;
    return slope;
  }

  [[nodiscard]] double energy() const { return energy_; }

 private:
  ElementAssembly::Unknowns numberUnknowns(const DiskMesh& disk, IsometricBoundary boundary) {
    const std::array<int, 2> pair = farthestBoundaryPair(disk);
    for (int i = 0; i < 2 * disk.mesh().vertexCount(); ++i) {
      const bool fixed = boundary == IsometricBoundary::Fixed && disk.topology().onBoundary()[at(i / 2)];
      const bool gauge = boundary == IsometricBoundary::Free && (i / 2 == pair[0] || i == 2 * pair[1] + 1);
      if (!fixed && !gauge) unknown_[at(i)] = count_++;
    }
    const Faces& faces = disk.mesh().faces();
    ElementAssembly::Unknowns elements(faces.rows(), 6);
    for (Eigen::Index f = 0; f < faces.rows(); ++f) {
      for (int k = 0; k < 6; ++k) {
        elements(f, k) = unknown_[at(2 * faces(f, k / 2) + k % 2)];
      }
    }
    return elements;
  }

  bool factorises(const IsometricElements& elements, double damping) {
    SparseMatrix hessian = assembly_.assemble(elements.hessians());
    for (int u = 0; u < count_ && damping > 0; ++u) {
      hessian.valuePtr()[hessian.outerIndexPtr()[u]] *= 1 + damping;  // the diagonal comes first in its column
    }
    try {
      solver_.factorize(hessian);
    } catch (const SolverError&) {
      return false;
    }
    return true;
  }

  std::vector<int> unknown_;
  int count_ = 0;
  bool whole_ = false;
  double energy_ = 0;
  ElementAssembly::Unknowns elements_;
  ElementAssembly assembly_;
  SparseSolver solver_;
};

// The longest step along the direction that keeps every face unfolded and lowers the energy enough. 0: none
double searchLine(const IsometricElements& elements, const Faces& faces, const Points2& direction, double energy,
                  double slope, const Execution& execution, Points2& image) {
  double step = std::min(1.0, kShortened * flipFreeStep(image, direction, faces, execution));
  for (int halving = 0; halving < 30; ++halving, step *= 0.5) {
    Points2 next = image + step * direction;
    const double there = elements.energy(next, execution);
    const double enough = std::max(kSufficient * step * slope, -1e-13 * energy);
    if (!(there <= energy + enough) || !(there < energy)) continue;
    image = std::move(next);
    return step;
  }
  return 0;
}

void requireUnfoldedStart(const DiskMesh& disk, const Points2& start) {
  if (start.rows() != disk.mesh().vertexCount()) {
    throw GeometryError("One start point per vertex is required: the surface has " +
                        std::to_string(disk.mesh().vertexCount()) + " vertices, the start " +
                        std::to_string(start.rows()) + " points.");
  }
  const int folded = countFlippedFaces(start, disk.mesh().faces());
  if (folded == 0 && start.allFinite()) return;
  throw GeometryError("A start without folded faces is required, but " + std::to_string(folded) +
                      " of its faces have no positive area; start from a tutte or mean-value map.");
}

// Turns an image so that the second vertex of a pair lies to the right of the first.
void turnPair(const std::array<int, 2>& pair, Points2& image) {
  const Eigen::RowVector2d axis = (image.row(pair[1]) - image.row(pair[0])).normalized();
  Eigen::Matrix2d turn;
  turn << axis[0], -axis[1], axis[1], axis[0];
  if (turn.allFinite()) image *= turn;
}

void centre(const Faces& faces, Points2& image) {
  const Eigen::VectorXd areas = signedFaceAreas(image, faces);
  Eigen::RowVector2d centroid(0, 0);
  for (Eigen::Index f = 0; f < faces.rows(); ++f) {
    for (int k = 0; k < 3; ++k) centroid += areas[f] / 3 * image.row(faces(f, k));
  }
  image.rowwise() -= centroid / areas.sum();
}

}  // namespace

const char* isometricBoundaryName(IsometricBoundary boundary) noexcept {
  return boundary == IsometricBoundary::Free ? "free" : "fixed";
}

void SymmetricDirichletMapOptions::validate() const {
  if (!(tolerance > 0) || maxIterations < 0) {
    throw InvalidArgument("A positive tolerance and at least 0 iterations are required, but they are " +
                          std::to_string(tolerance) + " and " + std::to_string(maxIterations) + ".");
  }
  if (!SparseSolver::available(solver)) {
    throw InvalidArgument("A solver that is part of this build is required, but " +
                          std::string(solverBackendName(solver)) + " was not built in.");
  }
}

SymmetricDirichletMapResult symmetricDirichletMap(const DiskMesh& disk, const Points2& start,
                                                  const SymmetricDirichletMapOptions& options,
                                                  const Execution& execution) {
  options.validate();
  requireUnfoldedStart(disk, start);
  const auto begin = std::chrono::steady_clock::now();
  const TriangleMesh& mesh = disk.mesh();
  const double startArea = signedFaceAreas(start, mesh.faces()).sum(), surfaceArea = faceAreas(mesh).sum();
  if (!(surfaceArea > 0)) throw GeometryError("A surface with positive area is required, but it has none.");
  // Both areas 1 inside.
  IsometricElements elements(mesh, 1 / std::sqrt(surfaceArea));
  NewtonSystem system(disk, options.boundary, options.solver);
  SymmetricDirichletMapResult result;
  result.image = start / std::sqrt(startArea);
  if (options.boundary == IsometricBoundary::Free) {
    turnPair(farthestBoundaryPair(disk), result.image);
    result.image *= elements.bestScale(result.image);
  }
  result.status = Status::NotConverged;
  Points2 direction;
  for (;; ++result.iterations) {
    SymmetricDirichletIteration now;
    const double slope = system.solve(elements, result.image, execution, direction);
    now.energy = system.energy();
    now.decrement = result.residual = std::sqrt(std::max(-slope, 0.0) / now.energy);
    if (now.decrement <= options.tolerance) result.status = Status::Converged;
    if (execution.cancelled()) result.status = Status::Cancelled;
    if (result.status == Status::NotConverged && result.iterations < options.maxIterations) {
      execution.report(double(result.iterations) / options.maxIterations, "Symmetric Dirichlet energy");
      now.step = searchLine(elements, mesh.faces(), direction, now.energy, slope, execution, result.image);
      if (now.step == 0) result.status = Status::Stalled;
    }
    result.history.push_back(now);
    if (now.step == 0) break;
  }
  result.energy = elements.energy(result.image, execution);
  result.image *= std::sqrt(options.boundary == IsometricBoundary::Free ? surfaceArea : startArea);
  if (options.boundary == IsometricBoundary::Free) centre(mesh.faces(), result.image);
  result.flippedFaces = countFlippedFaces(result.image, mesh.faces());
  result.degenerateFaces = static_cast<int>((faceAreas(mesh).array() <= 0).count());
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  execution.report(1, "Symmetric Dirichlet energy");
  return result;
}

}  // namespace authalic
