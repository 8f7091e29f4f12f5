#include "Core/authalic/FoldoverFree.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <vector>

#include "Core/base/Error.h"
#include "Core/numerics/ElementAssembly.h"

namespace authalic {
namespace {

using Matrix4 = Eigen::Matrix4d;
using Vector4 = Eigen::Vector4d;

constexpr double kLeastHeight = 0.05;    // of a reference triangle, by its longest side
constexpr double kSlow = 0.99;           // factor of the energy in one step, from where an image without folds is done
constexpr double kLeastProgress = 0.1;   // of the energy, as ε sees it
constexpr double kLeastEpsilon = 1e-10;
constexpr double kRegularisation = 1e-8;
constexpr double kShorter = 0.5;
constexpr int kAttempts = 20;

// Gradients of the three hat functions on a triangle with the angles of a face, but none of its heights very small, of
// the given area: row k belongs to corner k.
Eigen::Matrix<double, 3, 2> hatGradients(const Points3& points, const Faces& faces, Eigen::Index face, double area) {
  Eigen::Vector3d corner[3];
  for (int k = 0; k < 3; ++k) corner[k] = points.row(faces(face, k)).transpose();
  int first = 0;  // of the longest side
  double longest = 0;
  for (int k = 0; k < 3; ++k) {
    const double length = (corner[(k + 1) % 3] - corner[k]).norm();
    if (length > longest) longest = length, first = k;
  }
  const Eigen::Vector3d side = corner[(first + 1) % 3] - corner[first], arm = corner[(first + 2) % 3] - corner[first];
  double along = 0.5, height = std::sqrt(0.75);
  if (longest > 0) {
    along = std::clamp(arm.dot(side) / (longest * longest), 0.0, 1.0);
    height = std::max(arm.cross(side).norm() / (longest * longest), kLeastHeight);
  }
  const double scale = std::sqrt(2 * area / height);
  Eigen::Matrix2d edges;  // columns: side and arm
  edges << scale, along * scale, 0, height * scale;
  const Eigen::Matrix2d inverse = edges.inverse();
  Eigen::Matrix<double, 3, 2> result;
  result.row((first + 1) % 3) = inverse.row(0);
  result.row((first + 2) % 3) = inverse.row(1);
  result.row(first) = -inverse.row(0) - inverse.row(1);
  return result;
}

double determinant(const Vector4& j) { return j[0] * j[3] - j[1] * j[2]; }

// χ_ε, without cancellation.
double positivePart(double d, double epsilon) {
  const double s = std::hypot(d, epsilon);
  return d > 0 ? 0.5 * (d + s) : 0.5 * epsilon * epsilon / (s - d);
}

double faceEnergy(const Vector4& j, double epsilon) {
  const double d = determinant(j);
  return (j.squaredNorm() + 1 + d * d) / positivePart(d, epsilon);
}

// First and second derivative of faceEnergy(), the latter made positive semi-definite.
void derivatives(const Vector4& j, double epsilon, Vector4& gradient, Matrix4& hessian) {
  const double d = determinant(j), s = std::hypot(d, epsilon), chi = positivePart(d, epsilon);
  const double slope = chi / s, bend = 0.5 * epsilon * epsilon / (s * s * s);
  const double b = 1 / chi, b1 = -slope * b * b, b2 = 2 * slope * slope * b * b * b - bend * b * b;
  const double n = j.squaredNorm() + 1 + d * d;
  const Vector4 c(j[3], -j[2], -j[1], j[0]), dn = 2 * j + 2 * d * c;
  Matrix4 k = Matrix4::Zero();
  k(0, 3) = k(3, 0) = 1;
  k(1, 2) = k(2, 1) = -1;
  gradient = b * dn + n * b1 * c;
  hessian = b * (2 * Matrix4::Identity() + 2 * (c * c.transpose() + d * k)) +
            b1 * (dn * c.transpose() + c * dn.transpose()) + n * (b2 * c * c.transpose() + b1 * k);
  const Eigen::SelfAdjointEigenSolver<Matrix4> eigen(hessian);
  hessian = eigen.eigenvectors() * eigen.eigenvalues().cwiseMax(0).asDiagonal() * eigen.eigenvectors().transpose();
}

class FoldoverFreeMap {
 public:
  FoldoverFreeMap(const AreaFunctional& areas, const Eigen::VectorXd& targets, const Points3& points,
                  SolverBackend backend)
      : areas_(areas), targets_(targets), assembly_(areas.unknownCount(), unknowns(areas)),
        solver_(backend, PatternUse::Reused), values_(static_cast<std::size_t>(21 * targets.size())) {
    for (Eigen::Index f = 0; f < targets.size(); ++f) {
      hats_.push_back(hatGradients(points, areas.faces(), f, targets[f]));
    }
    solver_.analyze(assembly_.matrix());
  }

  [[nodiscard]] double smallest(const Coordinates& image) const {
    return (areas_.areas(image).array() / targets_.array()).minCoeff();
  }

  [[nodiscard]] double energy(const Coordinates& image) const {
    double sum = 0;
    for (int f = 0; f < static_cast<int>(targets_.size()); ++f) {
      sum += targets_[f] * faceEnergy(jacobian(image, f), epsilon_);
    }
    return sum;
  }

  // One step of Newton's method.
  void advance(Coordinates& image) {
    const double before = energy(image);
    const AreaFunctional::Frames frames = areas_.frames(image);
    const Eigen::VectorXd right = linearise(image, frames);
    SparseMatrix matrix = assembly_.assemble(values_);
    for (int v = 0; v < matrix.cols(); ++v) matrix.valuePtr()[matrix.outerIndexPtr()[v]] *= 1 + kRegularisation;
    solver_.factorize(matrix);
    const Coordinates wanted = areas_.displacement(frames, solver_.solve(right));
    double after = before, part = 1;
    for (int shorter = 0; shorter < kAttempts && !(after < before); ++shorter, part *= kShorter) {
      Coordinates next = areas_.moved(image, wanted, part);
      after = energy(next);
      if (after < before) image = std::move(next);
    }
    progress_ = 1 - after / before;
  }

  // ε for the next step, as the cited work has it, but not below the depth of the deepest fold: of one step at an ε
  // that fell without the energy, folds would see a wall.
  void sharpen(double smallest) {
    const double d = smallest, sigma = std::max(kLeastProgress, progress_);
    const double mu = (1 - sigma) * positivePart(d, epsilon_);
    const double wanted = d < mu ? 2 * std::sqrt(mu * (mu - d)) : 0;
    epsilon_ = std::max({wanted, -d, kLeastEpsilon});
  }

  [[nodiscard]] double progress() const noexcept { return progress_; }

 private:
  [[nodiscard]] static ElementAssembly::Unknowns unknowns(const AreaFunctional& areas) {
    ElementAssembly::Unknowns elements(areas.faces().rows(), 6);
    for (Eigen::Index f = 0; f < elements.rows(); ++f) {
      for (int k = 0; k < 6; ++k) elements(f, k) = areas.unknown(areas.faces()(f, k / 2), k % 2);
    }
    return elements;
  }

  [[nodiscard]] Vector4 jacobian(const Coordinates& image, int face) const {
    const Eigen::Matrix2d j =
        areas_.corners(image, face).transpose() * hats_[static_cast<std::size_t>(face)];
    return {j(0, 0), j(0, 1), j(1, 0), j(1, 1)};
  }

  // Fills the elements; @return the descent along the unknowns.
  Eigen::VectorXd linearise(const Coordinates& image, const AreaFunctional::Frames& frames) {
    Eigen::VectorXd right = Eigen::VectorXd::Zero(areas_.unknownCount());
    double* value = values_.data();
    for (int f = 0; f < static_cast<int>(targets_.size()); ++f) {
      Vector4 gradient;
      Matrix4 hessian;
      derivatives(jacobian(image, f), epsilon_, gradient, hessian);
      const AreaFunctional::Directions directions = areas_.directions(frames, f);
      Eigen::Matrix<double, 4, 6> change;
      for (int a = 0; a < 6; ++a) {
        const Eigen::RowVector2d hat = hats_[static_cast<std::size_t>(f)].row(a / 2);
        change.col(a) << directions(a, 0) * hat.transpose(), directions(a, 1) * hat.transpose();
      }
      const Eigen::Matrix<double, 6, 6> element = targets_[f] * change.transpose() * hessian * change;
      const Eigen::Matrix<double, 6, 1> slope = targets_[f] * change.transpose() * gradient;
      for (int a = 0; a < 6; ++a) {
        for (int b = a; b < 6; ++b) *value++ = element(a, b);
        const int u = areas_.unknown(areas_.faces()(f, a / 2), a % 2);
        if (u >= 0) right[u] -= slope[a];
      }
    }
    return right;
  }

  const AreaFunctional& areas_;
  const Eigen::VectorXd& targets_;
  ElementAssembly assembly_;
  SparseSolver solver_;
  std::vector<double> values_;
  std::vector<Eigen::Matrix<double, 3, 2>> hats_;
  double epsilon_ = 1, progress_ = 0;
};

}  // namespace

int foldoverFree(const AreaFunctional& areas, const Eigen::VectorXd& targets, const Points3& points, int mostSteps,
                 SolverBackend backend, Coordinates& image) {
  FoldoverFreeMap map(areas, targets, points, backend);
  double smallest = map.smallest(image);
  try {
    for (int step = 0; step < mostSteps && !(smallest > 0 && map.progress() < 1 - kSlow); ++step) {
      map.sharpen(smallest);
      map.advance(image);
      smallest = map.smallest(image);
    }
  } catch (const SolverError&) {  // the image of the last step stays
  }
  return static_cast<int>(areas.faces().rows() - (areas.areas(image).array() > 0).count());
}

}  // namespace authalic
