#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "Core/authalic/LieFlowStages.h"
#include "Core/geometry/Areas.h"
#include "Core/geometry/Laplacian.h"
#include "Core/numerics/ElementAssembly.h"

namespace authalic {
namespace {

constexpr int kSlowingPasses = 20;

// Marks the corners of faces that would collapse before the wanted step.
std::vector<char> pinnedVertices(const AreaFunctional& areas, const Coordinates& image, const Coordinates& velocity,
                                 double wanted) {
  std::vector<char> pinned(static_cast<std::size_t>(image.rows()), 0);
  const Faces& faces = areas.faces();
  for (int f = 0; f < static_cast<int>(faces.rows()); ++f) {
    if (areas.firstFlip(image, velocity, f) >= wanted) continue;
    for (int k = 0; k < 3; ++k) pinned[static_cast<std::size_t>(faces(f, k))] = 1;
  }
  return pinned;
}

HalfEdgeWeights weightsOf(const AreaFunctional& areas, const Coordinates& image) {
  if (image.cols() == 2) return cotangentWeights(Points2(image), areas.faces(), areas.shifts());
  return cotangentWeights(Points3(image), areas.faces());
}

Coordinates gradientsOf(const AreaFunctional& areas, const Coordinates& image, const Eigen::VectorXd& h) {
  if (image.cols() == 2) return vertexGradients(Points2(image), areas.faces(), h, areas.shifts());
  return vertexGradients(Points3(image), areas.faces(), h);
}

// h with L h = rightHandSide; h = 0 at the first vertex of face 0 and at those that no face uses.
Eigen::VectorXd solvePoisson(const AreaFunctional& areas, const Coordinates& image,
                             const Eigen::VectorXd& rightHandSide, SolverBackend backend) {
  const Faces& faces = areas.faces();
  std::vector<int> unknown(static_cast<std::size_t>(image.rows()), -1), vertices;
  std::vector<char> used(unknown.size(), 0);
  for (Eigen::Index k = 0; k < faces.size(); ++k) used[static_cast<std::size_t>(faces.data()[k])] = 1;
  used[static_cast<std::size_t>(faces(0, 0))] = 0;
  for (std::size_t v = 0; v < used.size(); ++v) {
    if (!used[v]) continue;
    unknown[v] = static_cast<int>(vertices.size());
    vertices.push_back(static_cast<int>(v));
  }
  const HalfEdgeWeights weights = weightsOf(areas, image);
  ElementAssembly::Unknowns elements(faces.rows(), 3);
  std::vector<double> values(static_cast<std::size_t>(6 * faces.rows()));
  for (Eigen::Index f = 0; f < faces.rows(); ++f) {
    for (int k = 0; k < 3; ++k) elements(f, k) = unknown[static_cast<std::size_t>(faces(f, k))];
    const double w01 = weights(f, 0), w12 = weights(f, 1), w20 = weights(f, 2);
    const double element[6] = {w01 + w20, -w01, -w20, w01 + w12, -w12, w12 + w20};
    std::copy(element, element + 6, values.begin() + 6 * f);
  }
  ElementAssembly assembly(static_cast<int>(vertices.size()), elements);
  SparseSolver solver(backend);
  solver.compute(assembly.assemble(values));
  const Eigen::VectorXd x = solver.solve(rightHandSide(vertices));
  Eigen::VectorXd h = Eigen::VectorXd::Zero(image.rows());
  h(vertices) = x;
  return h;
}

}  // namespace

const Points2& LieFlowDomain::shifts() const {
  static const Points2 none;
  return none;
}

void LieFlowDomain::freeze(std::vector<char> faces) {
  frozen_ = std::move(faces);
  Eigen::VectorXd ofFace = target_.faces();
  for (Eigen::Index f = 0; f < ofFace.size(); ++f) {
    if (frozen_[static_cast<std::size_t>(f)]) ofFace[f] = 0;
  }
  ofFace /= ofFace.sum();
  flowingTargets_ = vertexStars(ofFace, faces_, static_cast<int>(target_.vertices().size()));
}

int countFolded(const AreaFunctional& areas, const Coordinates& image) {
  return static_cast<int>(areas.faces().rows() - (areas.areas(image).array() > 0).count());
}

LieFlowIteration measureStars(const Eigen::VectorXd& areas, const Eigen::VectorXd& targets) {
  LieFlowIteration iteration;
  const double total = areas.sum(), targetTotal = targets.sum();
  double square = 0;
  for (Eigen::Index v = 0; v < areas.size(); ++v) {
    if (!(targets[v] > 0)) continue;
    const double share = targets[v] / targetTotal, ratio = areas[v] / total / share;
    square += share * (ratio - 1) * (ratio - 1);
    iteration.meanAbsLog += share * std::abs(std::log(std::max(ratio, 1e-300)));
  }
  iteration.residual = std::sqrt(square);
  return iteration;
}

Coordinates poissonVelocity(const AreaFunctional& areas, const Coordinates& image,
                            const Eigen::VectorXd& rightHandSide, SolverBackend backend) {
  const Eigen::VectorXd h = solvePoisson(areas, image, rightHandSide, backend);
  Coordinates velocity = gradientsOf(areas, image, h);
  keepTangential(areas, image, velocity);
  return velocity;
}

void keepTangential(const AreaFunctional& areas, const Coordinates& image, Coordinates& velocity) {
  const AreaFunctional::Frames frames = areas.frames(image);
  const Eigen::Index d = image.cols();
  for (int v = 0; v < areas.vertexCount(); ++v) {
    const Eigen::RowVectorXd wanted = velocity.row(v);
    velocity.row(v).setZero();
    for (int j = 0; j < areas.freedom(v); ++j) {
      const auto direction = frames.row(v).segment(j * d, d);
      velocity.row(v) += wanted.dot(direction) * direction;
    }
  }
}

double flipFreeStep(const AreaFunctional& areas, const Coordinates& image, const Coordinates& velocity) {
  double first = std::numeric_limits<double>::infinity();
  for (int f = 0; f < static_cast<int>(areas.faces().rows()); ++f) {
    first = std::min(first, areas.firstFlip(image, velocity, f));
  }
  return first;
}

void relaxPinned(const AreaFunctional& areas, const Coordinates& image, double wanted, Coordinates& velocity) {
  const Faces& faces = areas.faces();
  for (int pass = 0; pass < 8; ++pass) {
    const std::vector<char> pinned = pinnedVertices(areas, image, velocity, wanted);
    Coordinates sum = Coordinates::Zero(image.rows(), image.cols());
    Eigen::VectorXd count = Eigen::VectorXd::Zero(image.rows());
    for (Eigen::Index f = 0; f < faces.rows(); ++f) {
      for (int k = 0; k < 3; ++k) {
        const int i = faces(f, k);
        if (!pinned[static_cast<std::size_t>(i)]) continue;
        sum.row(i) += velocity.row(faces(f, (k + 1) % 3)) + velocity.row(faces(f, (k + 2) % 3));
        count[i] += 2;
      }
    }
    if (count.maxCoeff() == 0) return;
    for (Eigen::Index i = 0; i < image.rows(); ++i) {
      if (count[i] > 0) velocity.row(i) = sum.row(i) / count[i];
    }
    keepTangential(areas, image, velocity);
  }
}

int slowPinned(const AreaFunctional& areas, const Coordinates& image, double wanted, Coordinates& displacement) {
  std::vector<char> slowed(static_cast<std::size_t>(image.rows()), 0);
  const Faces& faces = areas.faces();
  for (int pass = 0; pass < kSlowingPasses; ++pass) {
    Eigen::VectorXd part = Eigen::VectorXd::Ones(image.rows());
    for (int f = 0; f < static_cast<int>(faces.rows()); ++f) {
      const double first = areas.firstFlip(image, displacement, f);
      for (int k = 0; k < 3 && first < wanted; ++k) part[faces(f, k)] = std::min(part[faces(f, k)], 0.5 * first);
    }
    if (part.minCoeff() == 1) break;
    displacement.array().colwise() *= part.array();
    for (Eigen::Index v = 0; v < part.size(); ++v) slowed[static_cast<std::size_t>(v)] |= part[v] < 1;
  }
  return static_cast<int>(std::count(slowed.begin(), slowed.end(), 1));
}

}  // namespace authalic
