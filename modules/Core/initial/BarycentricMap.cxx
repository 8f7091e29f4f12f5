#include "Core/initial/BarycentricMap.h"

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseLU>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <string>

#include "Core/base/Error.h"
#include "Core/geometry/Areas.h"
#include "Core/geometry/Laplacian.h"
#include "Core/numerics/ElementAssembly.h"

namespace authalic {
namespace {

using RowMajorMatrix = Eigen::SparseMatrix<double, Eigen::RowMajor, int>;

// Eigen's iterative solvers accept any object with this shape as a preconditioner.
class FactorisedPreconditioner {
 public:
  using StorageIndex = int;
  enum { ColsAtCompileTime = Eigen::Dynamic, MaxColsAtCompileTime = Eigen::Dynamic };
  template <class Matrix>
  FactorisedPreconditioner& analyzePattern(const Matrix&) { return *this; }
  template <class Matrix>
  FactorisedPreconditioner& factorize(const Matrix&) { return *this; }
  template <class Matrix>
  FactorisedPreconditioner& compute(const Matrix&) { return *this; }
  template <class Vector>
  Eigen::VectorXd solve(const Vector& b) const { return solver_->solve(b); }
  [[nodiscard]] Eigen::ComputationInfo info() const { return Eigen::Success; }
  void use(const SparseSolver& solver) { solver_ = &solver; }

 private:
  const SparseSolver* solver_ = nullptr;
};

// Weight of each half-edge seen from its tail (forward) and from its head (backward).
MeanValueWeights weightsOf(const TriangleMesh& mesh, BarycentricWeights kind) {
  if (kind == BarycentricWeights::MeanValue) return meanValueWeights(mesh);
  HalfEdgeWeights weights = kind == BarycentricWeights::Harmonic
                                ? cotangentWeights(mesh)
                                : HalfEdgeWeights(HalfEdgeWeights::Constant(mesh.faceCount(), 3, 0.5));
  return {weights, weights};
}

struct Unknowns {
  std::vector<int> ofVertex;    // −1 on the boundary
  std::vector<int> vertices;    // of each unknown
  ElementAssembly::Unknowns ofFace;
};

Unknowns numberInnerVertices(const DiskMesh& disk) {
  Unknowns unknowns;
  const auto& onBoundary = disk.topology().onBoundary();
  for (std::size_t v = 0; v < onBoundary.size(); ++v) {
    unknowns.ofVertex.push_back(onBoundary[v] ? -1 : static_cast<int>(unknowns.vertices.size()));
    if (!onBoundary[v]) unknowns.vertices.push_back(static_cast<int>(v));
  }
  const Faces& faces = disk.mesh().faces();
  unknowns.ofFace.resize(faces.rows(), 3);
  for (Eigen::Index f = 0; f < faces.rows(); ++f) {
    for (int k = 0; k < 3; ++k) unknowns.ofFace(f, k) = unknowns.ofVertex[static_cast<std::size_t>(faces(f, k))];
  }
  return unknowns;
}

// The symmetric part of the system: the system itself for symmetric weights.
SparseMatrix symmetricSystem(const MeanValueWeights& weights, const Unknowns& unknowns) {
  ElementAssembly assembly(static_cast<int>(unknowns.vertices.size()), unknowns.ofFace);
  std::vector<double> values(static_cast<std::size_t>(6 * unknowns.ofFace.rows()));
  for (Eigen::Index f = 0; f < unknowns.ofFace.rows(); ++f) {
    const Eigen::RowVector3d w = 0.5 * (weights.forward.row(f) + weights.backward.row(f));
    const std::array<double, 6> element{w[0] + w[2], -w[0], -w[2], w[0] + w[1], -w[1], w[1] + w[2]};
    std::copy(element.begin(), element.end(), values.begin() + 6 * f);
  }
  return assembly.assemble(values);
}

RowMajorMatrix fullSystem(const MeanValueWeights& weights, const Unknowns& unknowns) {
  std::vector<Eigen::Triplet<double, int>> entries;
  entries.reserve(static_cast<std::size_t>(12 * unknowns.ofFace.rows()));
  const auto add = [&entries](int i, int j, double w) {
    if (i < 0) return;
    entries.emplace_back(i, i, w);
    if (j >= 0) entries.emplace_back(i, j, -w);
  };
  for (Eigen::Index f = 0; f < unknowns.ofFace.rows(); ++f) {
    for (int k = 0; k < 3; ++k) {
      const int i = unknowns.ofFace(f, k), j = unknowns.ofFace(f, (k + 1) % 3);
      add(i, j, weights.forward(f, k));
      add(j, i, weights.backward(f, k));
    }
  }
  const auto n = static_cast<Eigen::Index>(unknowns.vertices.size());
  RowMajorMatrix matrix(n, n);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

Eigen::MatrixXd rightHandSide(const DiskMesh& disk, const MeanValueWeights& weights, const Unknowns& unknowns,
                              const Points2& image) {
  const Faces& faces = disk.mesh().faces();
  Eigen::MatrixXd b = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(unknowns.vertices.size()), 2);
  for (Eigen::Index f = 0; f < faces.rows(); ++f) {
    for (int k = 0; k < 3; ++k) {
      const int l = (k + 1) % 3, i = unknowns.ofFace(f, k), j = unknowns.ofFace(f, l);
      if (i >= 0 && j < 0) b.row(i) += weights.forward(f, k) * image.row(faces(f, l));
      if (j >= 0 && i < 0) b.row(j) += weights.backward(f, k) * image.row(faces(f, k));
    }
  }
  return b;
}

// BiCGSTAB with a factorised preconditioner; a sparse LU where it stalls.
Eigen::MatrixXd solveUnsymmetric(const RowMajorMatrix& matrix, const SparseSolver& preconditioner,
                                 const Eigen::MatrixXd& b) {
  Eigen::BiCGSTAB<RowMajorMatrix, FactorisedPreconditioner> iteration;
  iteration.preconditioner().use(preconditioner);
  iteration.setTolerance(1e-14);
  iteration.setMaxIterations(100);
  iteration.compute(matrix);
  Eigen::MatrixXd x(b.rows(), 2);
  const Eigen::MatrixXd guess = preconditioner.solve(b);
  for (int c = 0; c < 2; ++c) {
    x.col(c) = iteration.solveWithGuess(b.col(c), guess.col(c));
    if (iteration.info() == Eigen::Success || iteration.error() < 1e-12) continue;
    Eigen::SparseLU<Eigen::SparseMatrix<double>> direct{Eigen::SparseMatrix<double>(matrix)};
    if (direct.info() != Eigen::Success) {
      throw SolverError("A regular mean-value system is required, but its factorisation failed; "
                        "look for degenerate triangles, or use tutte.");
    }
    return direct.solve(b);
  }
  return x;
}

Eigen::MatrixXd solveInner(const MeanValueWeights& weights, const Unknowns& unknowns, const Eigen::MatrixXd& b,
                           const BarycentricMapOptions& options) {
  SparseSolver solver(options.solver);
  solver.compute(symmetricSystem(weights, unknowns));
  if (options.weights != BarycentricWeights::MeanValue) return solver.solve(b);
  return solveUnsymmetric(fullSystem(weights, unknowns), solver, b);
}

double residualOf(const DiskMesh& disk, const MeanValueWeights& weights, const Points2& image) {
  const Faces& faces = disk.mesh().faces();
  Points2 force = Points2::Zero(image.rows(), 2);
  Eigen::VectorXd total = Eigen::VectorXd::Zero(image.rows());
  for (Eigen::Index f = 0; f < faces.rows(); ++f) {
    for (int k = 0; k < 3; ++k) {
      const int i = faces(f, k), j = faces(f, (k + 1) % 3);
      force.row(i) += weights.forward(f, k) * (image.row(j) - image.row(i));
      force.row(j) += weights.backward(f, k) * (image.row(i) - image.row(j));
      total[i] += std::abs(weights.forward(f, k));
      total[j] += std::abs(weights.backward(f, k));
    }
  }
  double worst = 0;
  for (Eigen::Index i = 0; i < image.rows(); ++i) {
    if (disk.topology().onBoundary()[static_cast<std::size_t>(i)] || !(total[i] > 0)) continue;
    worst = std::max(worst, force.row(i).norm() / total[i]);
  }
  return worst;
}

}  // namespace

const char* barycentricWeightsName(BarycentricWeights weights) noexcept {
  switch (weights) {
    case BarycentricWeights::Uniform: return "tutte";
    case BarycentricWeights::Harmonic: return "harmonic";
    case BarycentricWeights::MeanValue: return "mean-value";
  }
  return "mean-value";
}

void BarycentricMapOptions::validate() const {
  if (startVertex < -1) {
    throw InvalidArgument("A start vertex of at least -1 is required, but it is " + std::to_string(startVertex) + ".");
  }
  if (!SparseSolver::available(solver)) {
    throw InvalidArgument("A solver that is part of this build is required, but " +
                          std::string(solverBackendName(solver)) + " was not built in.");
  }
}

BarycentricMapResult barycentricMap(const DiskMesh& disk, const BarycentricMapOptions& options,
                                    const Execution& execution) {
  options.validate();
  const auto start = std::chrono::steady_clock::now();
  execution.report(0, barycentricWeightsName(options.weights));
  BarycentricMapResult result;
  result.boundary = placeBoundary(disk, options.domain, options.startVertex);
  result.image = Points2::Zero(disk.mesh().vertexCount(), 2);
  for (std::size_t i = 0; i < result.boundary.vertices.size(); ++i) {
    result.image.row(result.boundary.vertices[i]) = result.boundary.points.row(static_cast<Eigen::Index>(i));
  }
  execution.throwIfCancelled();
  const MeanValueWeights weights = weightsOf(disk.mesh(), options.weights);
  const Unknowns unknowns = numberInnerVertices(disk);
  if (!unknowns.vertices.empty()) {
    const Eigen::MatrixXd b = rightHandSide(disk, weights, unknowns, result.image);
    const Eigen::MatrixXd x = solveInner(weights, unknowns, b, options);
    for (std::size_t k = 0; k < unknowns.vertices.size(); ++k) {
      result.image.row(unknowns.vertices[k]) = x.row(static_cast<Eigen::Index>(k));
    }
  }
  result.residual = residualOf(disk, weights, result.image);
  result.flippedFaces = countFlippedFaces(result.image, disk.mesh().faces());
  result.degenerateFaces = static_cast<int>((faceAreas(disk.mesh()).array() <= 0).count());
  result.status = Status::Converged;
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  execution.report(1, barycentricWeightsName(options.weights));
  return result;
}

}  // namespace authalic
