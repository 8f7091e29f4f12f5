#include "Core/initial/IsometricElements.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "Core/geometry/Areas.h"

namespace authalic {
namespace {

constexpr double kSmallestHeight = 1e-6;  // of the longest side
constexpr double kSmallestShare = 1e-12;  // of the surface
constexpr double kLargestEigenvalue = 1e10;  // beyond, factorising would drown the rest in rounding
constexpr std::size_t kChunk = 4096;

using Row6 = Eigen::Matrix<double, 1, 6>;

// F = U diag(s1, s2) Vᵀ with rotations U, V and s1 ≥ |s2|, in closed form.
struct Svd {
  Eigen::Matrix2d u, v;
  double s1, s2;
};

Svd decompose(const Eigen::Matrix2d& f) {
  const double e = 0.5 * (f(0, 0) + f(1, 1)), g = 0.5 * (f(0, 0) - f(1, 1));
  const double h = 0.5 * (f(1, 0) - f(0, 1)), k = 0.5 * (f(1, 0) + f(0, 1));
  const double turning = std::hypot(e, h), stretching = std::hypot(g, k);
  const double sum = std::atan2(k, g), difference = std::atan2(h, e);  // angle of u plus, minus that of v
  const double alpha = 0.5 * (sum + difference), beta = 0.5 * (sum - difference);
  Svd svd;
  svd.u << std::cos(alpha), -std::sin(alpha), std::sin(alpha), std::cos(alpha);
  svd.v << std::cos(beta), -std::sin(beta), std::sin(beta), std::cos(beta);
  svd.s1 = turning + stretching;
  svd.s2 = f.determinant() / svd.s1;  // turning − stretching would cancel
  return svd;
}

double sumOf(const Eigen::VectorXd& values) {
  double sum = 0;
  for (Eigen::Index i = 0; i < values.size(); ++i) sum += values[i];
  return sum;
}

}  // namespace

IsometricElements::IsometricElements(const TriangleMesh& surface, double scale)
    : faces_(surface.faces()), vertexCount_(surface.vertexCount()),
      shares_((faceAreas(surface) / faceAreas(surface).sum()).cwiseMax(kSmallestShare)),
      hats_(surface.faceCount(), 6), gradients_(surface.faceCount(), 6), energies_(surface.faceCount()),
      hessians_(static_cast<std::size_t>(21 * surface.faceCount())) {
  for (int f = 0; f < surface.faceCount(); ++f) {
    int base = 0;
    const auto side = [&](int k) -> Eigen::Vector3d {
      return scale * (surface.corner(f, (k + 1) % 3) - surface.corner(f, k));
    };
    for (int k = 1; k < 3; ++k) {
      if (side(k).norm() > side(base).norm()) base = k;
    }
    // Laid flat along the longest side: (0, 0), (x1, 0), (x2, y2).
    const double x1 = std::max(side(base).norm(), 1e-9), x2 = -side((base + 2) % 3).dot(side(base)) / x1;
    const double y2 = std::max(side(base).cross(side((base + 2) % 3)).norm() / x1, kSmallestHeight * x1);
    const std::array<Eigen::RowVector2d, 3> hats{Eigen::RowVector2d(-1 / x1, (x2 - x1) / (x1 * y2)),
                                                 Eigen::RowVector2d(1 / x1, -x2 / (x1 * y2)),
                                                 Eigen::RowVector2d(0, 1 / y2)};
    for (int k = 0; k < 3; ++k) hats_.block<1, 2>(f, 2 * ((base + k) % 3)) = hats[static_cast<std::size_t>(k)];
  }
}

Eigen::Matrix2d IsometricElements::jacobian(const Points2& image, Eigen::Index f) const {
  const Eigen::RowVector2d origin = image.row(faces_(f, 0));
  const Eigen::Vector2d to1 = (image.row(faces_(f, 1)) - origin).transpose();
  const Eigen::Vector2d to2 = (image.row(faces_(f, 2)) - origin).transpose();
  return to1 * hats_.block<1, 2>(f, 2) + to2 * hats_.block<1, 2>(f, 4);
}

double IsometricElements::energy(const Points2& image, const Execution& execution) const {
  Eigen::VectorXd energies(faces_.rows());
  parallelFor(static_cast<std::size_t>(faces_.rows()), execution, [&](std::size_t begin, std::size_t end) {
    for (auto f = static_cast<Eigen::Index>(begin); f < static_cast<Eigen::Index>(end); ++f) {
      const Eigen::Matrix2d j = jacobian(image, f);
      const double squares = j.squaredNorm(), determinant = j.determinant();
      energies[f] = determinant > 0 ? shares_[f] * squares * (1 + 1 / (determinant * determinant))
                                    : std::numeric_limits<double>::infinity();
    }
  }, kChunk);
  return sumOf(energies);
}

double IsometricElements::bestScale(const Points2& image) const {
  double stretch = 0, inverse = 0;
  for (Eigen::Index f = 0; f < faces_.rows(); ++f) {
    const Eigen::Matrix2d j = jacobian(image, f);
    stretch += shares_[f] * j.squaredNorm();
    inverse += shares_[f] * j.squaredNorm() / std::pow(j.determinant(), 2);
  }
  return std::pow(inverse / stretch, 0.25);
}

double IsometricElements::linearise(const Points2& image, bool projected, const Execution& execution) {
  parallelFor(static_cast<std::size_t>(faces_.rows()), execution, [&](std::size_t begin, std::size_t end) {
    for (std::size_t f = begin; f < end; ++f) lineariseFace(image, projected, static_cast<Eigen::Index>(f));
  }, kChunk);
  return sumOf(energies_);
}

void IsometricElements::lineariseFace(const Points2& image, bool projected, Eigen::Index f) {
  const Svd svd = decompose(jacobian(image, f));
  const double s1 = svd.s1, s2 = svd.s2, product = s1 * s2, cubed = product * product * product;
  energies_[f] = shares_[f] * (s1 * s1 + s2 * s2) * (1 + 1 / (product * product));
  const double by1 = 2 * (s1 - 1 / (s1 * s1 * s1)), by2 = 2 * (s2 - 1 / (s2 * s2 * s2));
  // A change dF of the Jacobian in the frames of the singular vectors has entries uᵢᵀ dF vⱼ = Σ_k (uᵢ·dx_k)(g_k·vⱼ).
  const auto entry = [&](int i, int j) {
    Row6 row;
    for (int k = 0; k < 3; ++k) {
      row.segment<2>(2 * k) = (hats_.block<1, 2>(f, 2 * k) * svd.v.col(j)).value() * svd.u.col(i).transpose();
    }
    return row;
  };
  const Row6 stretch1 = entry(0, 0), stretch2 = entry(1, 1), lower = entry(1, 0), upper = entry(0, 1);
  gradients_.row(f) = shares_[f] * (by1 * stretch1 + by2 * stretch2);
  const double flip = 2 + 2 * (s1 * s1 + product + s2 * s2) / cubed;
  const double twist = 2 - 2 * (s1 * s1 - product + s2 * s2) / cubed;
  const std::array<std::pair<double, Row6>, 4> modes{
      {{2 + 6 / (s1 * s1 * s1 * s1), stretch1},
       {2 + 6 / (s2 * s2 * s2 * s2), stretch2},
       {0.5 * flip, lower + upper},
       {0.5 * (projected ? std::max(0.0, twist) : twist), lower - upper}}};
  double* value = &hessians_[static_cast<std::size_t>(21 * f)];
  for (int a = 0; a < 6; ++a) {
    for (int b = a; b < 6; ++b, ++value) {
      *value = 0;
      for (const auto& [eigenvalue, mode] : modes) {
        *value += shares_[f] * std::min(eigenvalue, kLargestEigenvalue) * mode[a] * mode[b];
      }
    }
  }
}

Points2 IsometricElements::gradient() const {
  Points2 sum = Points2::Zero(vertexCount_, 2);
  for (Eigen::Index f = 0; f < faces_.rows(); ++f) {
    for (int k = 0; k < 3; ++k) sum.row(faces_(f, k)) += gradients_.block<1, 2>(f, 2 * k);
  }
  return sum;
}

}  // namespace authalic
