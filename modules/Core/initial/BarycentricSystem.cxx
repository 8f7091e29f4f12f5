#include "Core/initial/BarycentricSystem.h"

#include <Eigen/QR>
#include <Eigen/SparseLU>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "Core/base/Error.h"
#include "Core/initial/DirectedSystem.h"
#include "Core/numerics/ElementAssembly.h"

namespace authalic {
namespace {

struct Unknowns {
  std::vector<int> ofVertex;    // −1 where held
  std::vector<int> vertices;    // of each unknown
  ElementAssembly::Unknowns ofFace;
};

Unknowns numberFreeVertices(const Faces& faces, const std::vector<char>& held) {
  Unknowns unknowns;
  for (std::size_t v = 0; v < held.size(); ++v) {
    unknowns.ofVertex.push_back(held[v] ? -1 : static_cast<int>(unknowns.vertices.size()));
    if (!held[v]) unknowns.vertices.push_back(static_cast<int>(v));
  }
  unknowns.ofFace.resize(faces.rows(), 3);
  for (Eigen::Index f = 0; f < faces.rows(); ++f) {
    for (int k = 0; k < 3; ++k) unknowns.ofFace(f, k) = unknowns.ofVertex[static_cast<std::size_t>(faces(f, k))];
  }
  return unknowns;
}

// The entries of each face's element matrix, for ElementAssembly.
std::vector<double> elementValues(const HalfEdgeWeights& weights) {
  std::vector<double> values(static_cast<std::size_t>(6 * weights.rows()));
  for (Eigen::Index f = 0; f < weights.rows(); ++f) {
    const Eigen::RowVector3d w = weights.row(f);
    const std::array<double, 6> element{w[0] + w[2], -w[0], -w[2], w[0] + w[1], -w[1], w[1] + w[2]};
    std::copy(element.begin(), element.end(), values.begin() + 6 * f);
  }
  return values;
}

// What the held neighbours contribute. @param forward, backward  weights seen from tail and head of each half-edge
Eigen::MatrixXd rightHandSide(const Faces& faces, const HalfEdgeWeights& forward, const HalfEdgeWeights& backward,
                              const ElementAssembly::Unknowns& unknowns, std::size_t unknownCount,
                              const Points2& image) {
  Eigen::MatrixXd b = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(unknownCount), 2);
  for (Eigen::Index f = 0; f < faces.rows(); ++f) {
    for (int k = 0; k < 3; ++k) {
      const int l = (k + 1) % 3, i = unknowns(f, k), j = unknowns(f, l);
      if (i >= 0 && j < 0) b.row(i) += forward(f, k) * image.row(faces(f, l));
      if (j >= 0 && i < 0) b.row(j) += backward(f, k) * image.row(faces(f, k));
    }
  }
  return b;
}

// What the shifts of corners contribute. @param forward, backward  as above
void addShifts(const HalfEdgeWeights& forward, const HalfEdgeWeights& backward,
               const ElementAssembly::Unknowns& unknowns, const Points2& shifts, Eigen::MatrixXd& b) {
  for (Eigen::Index f = 0; f < forward.rows() && shifts.size() > 0; ++f) {
    for (int k = 0; k < 3; ++k) {
      const int l = (k + 1) % 3, i = unknowns(f, k), j = unknowns(f, l);
      const Eigen::RowVector2d between = shifts.row(3 * f + l) - shifts.row(3 * f + k);
      if (i >= 0) b.row(i) += forward(f, k) * between;
      if (j >= 0) b.row(j) -= backward(f, k) * between;
    }
  }
}

// One restart of right-hand-side-blocked GMRES: two independent Krylov spaces that share every preconditioner call.
class PairedGmres {
 public:
  static constexpr int kDimension = 30;

  PairedGmres(const DirectedSystem& matrix, const SparseSolver& preconditioner)
      : matrix_(matrix), preconditioner_(preconditioner) {}

  // Improves x; returns the largest relative preconditioned residual reached.
  double cycle(const Eigen::MatrixXd& b, const Eigen::Vector2d& scale, double tolerance, Eigen::MatrixXd& x) {
    std::vector<Eigen::MatrixXd> basis{preconditioner_.solve(b - matrix_.multiply(x))};
    Eigen::Vector2d worst(0, 0);
    for (int c = 0; c < 2; ++c) {
      start_[c] = basis[0].col(c).norm();
      if (start_[c] > 0) basis[0].col(c) /= start_[c];
      hessenberg_[c].setZero(kDimension + 1, kDimension);
    }
    int used = 0;
    while (used < kDimension) {
      basis.push_back(preconditioner_.solve(matrix_.multiply(basis.back())));
      orthogonalise(basis, used++);
      for (int c = 0; c < 2; ++c) worst[c] = leastSquares(c, used) / std::max(scale[c], 1e-300);
      if (worst.maxCoeff() <= tolerance) break;
    }
    for (int c = 0; c < 2; ++c) {
      for (int k = 0; k < used; ++k) x.col(c) += coefficients_[c][k] * basis[static_cast<std::size_t>(k)].col(c);
    }
    return worst.maxCoeff();
  }

 private:
  void orthogonalise(std::vector<Eigen::MatrixXd>& basis, int step) {
    for (int c = 0; c < 2; ++c) {
      auto last = basis.back().col(c);
      for (int k = 0; k <= step; ++k) {
        const double overlap = last.dot(basis[static_cast<std::size_t>(k)].col(c));
        hessenberg_[c](k, step) = overlap;
        last -= overlap * basis[static_cast<std::size_t>(k)].col(c);
      }
      const double norm = last.norm();
      hessenberg_[c](step + 1, step) = norm;
      if (norm > 0) last /= norm;
    }
  }

  double leastSquares(int c, int used) {
    const Eigen::MatrixXd h = hessenberg_[c].topLeftCorner(used + 1, used);
    Eigen::VectorXd right = Eigen::VectorXd::Zero(used + 1);
    right[0] = start_[c];
    coefficients_[c] = h.colPivHouseholderQr().solve(right);
    return (right - h * coefficients_[c]).norm();
  }

  const DirectedSystem& matrix_;
  const SparseSolver& preconditioner_;
  std::array<Eigen::MatrixXd, 2> hessenberg_;
  std::array<Eigen::VectorXd, 2> coefficients_;
  std::array<double, 2> start_{};
};

// The whole matrix, where only a factorisation with pivoting helps.
Eigen::MatrixXd solveDirectly(const DirectedSystem& system, const Eigen::MatrixXd& b) {
  const Eigen::SparseLU<Eigen::SparseMatrix<double>> direct{system.matrix()};
  if (direct.info() != Eigen::Success) {
    throw SolverError("A regular mean-value system is required, but its factorisation failed; "
                      "look for degenerate triangles, or use tutte.");
  }
  return direct.solve(b);
}

Eigen::MatrixXd solveUnsymmetric(const DirectedSystem& system, const SparseSolver& preconditioner,
                                 const Eigen::MatrixXd& b) {
  Eigen::MatrixXd x = preconditioner.solve(b);
  const Eigen::Vector2d scale(x.col(0).norm(), x.col(1).norm());
  PairedGmres gmres(system, preconditioner);
  for (int restart = 0; restart < 4; ++restart) {
    if (gmres.cycle(b, scale, 1e-13, x) <= 1e-13) return x;
  }
  return solveDirectly(system, b);
}

void store(const std::vector<int>& vertices, const Eigen::MatrixXd& x, Points2& image) {
  for (std::size_t k = 0; k < vertices.size(); ++k) image.row(vertices[k]) = x.row(static_cast<Eigen::Index>(k));
}

ElementAssembly::Unknowns takeUnknowns(Unknowns&& unknowns, std::vector<int>& vertices) {
  vertices = std::move(unknowns.vertices);
  return std::move(unknowns.ofFace);
}

}  // namespace

void solveBarycentric(const Faces& faces, const HalfEdgeWeights& weights, const std::vector<char>& held,
                      SolverBackend backend, Points2& image) {
  const Unknowns unknowns = numberFreeVertices(faces, held);
  if (unknowns.vertices.empty()) return;
  ElementAssembly assembly(static_cast<int>(unknowns.vertices.size()), unknowns.ofFace);
  SparseSolver solver(backend);
  solver.compute(assembly.assemble(elementValues(weights)));
  const Eigen::MatrixXd b = rightHandSide(faces, weights, weights, unknowns.ofFace, unknowns.vertices.size(), image);
  store(unknowns.vertices, solver.solve(b), image);
}

BarycentricSolver::BarycentricSolver(const Faces& faces, const std::vector<char>& held, SolverBackend backend,
                                     int threads)
    : faces_(faces),
      unknowns_(takeUnknowns(numberFreeVertices(faces, held), vertices_)),
      assembly_(static_cast<int>(vertices_.size()), unknowns_),
      solver_(backend, PatternUse::Reused, threads) {
  if (!vertices_.empty()) solver_.analyze(assembly_.matrix());
}

void BarycentricSolver::solve(const HalfEdgeWeights& weights, Points2& image, const Points2& shifts) {
  if (vertices_.empty()) return;
  solver_.factorize(assembly_.assemble(elementValues(weights)));
  Eigen::MatrixXd b = rightHandSide(faces_, weights, weights, unknowns_, vertices_.size(), image);
  addShifts(weights, weights, unknowns_, shifts, b);
  store(vertices_, solver_.solve(b), image);
}

void solveBarycentric(const Faces& faces, const MeanValueWeights& weights, const std::vector<char>& held,
                      SolverBackend backend, Points2& image, const Points2& shifts) {
  const Unknowns unknowns = numberFreeVertices(faces, held);
  if (unknowns.vertices.empty()) return;
  const int count = static_cast<int>(unknowns.vertices.size());
  const DirectedSystem system(weights, unknowns.ofFace, count);
  SparseSolver solver(backend);
  solver.compute(system.symmetricPart());
  Eigen::MatrixXd b =
      rightHandSide(faces, weights.forward, weights.backward, unknowns.ofFace, unknowns.vertices.size(), image);
  addShifts(weights.forward, weights.backward, unknowns.ofFace, shifts, b);
  store(unknowns.vertices, solveUnsymmetric(system, solver, system.scale().asDiagonal() * b), image);
}

}  // namespace authalic
