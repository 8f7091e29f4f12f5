#include "Core/conformal/Zipper.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "Core/base/Error.h"

namespace authalic {
namespace {

using Complex = Zipper::Complex;

/// The gaps of one side after the pair a > 0 > −b was closed: g at every open point, as differences. With t = q/p,
/// g = ½ (a + b) q (p + q) / (b + a t); t falls and q, p + q grow along the side, so every term below is positive.
void closeGaps(double a, double b, Eigen::Index from, Eigen::VectorXd& gaps) {
  const double half = 0.5 * (a + b);
  double beyond = gaps[from + 1];  // distance from a
  double p = std::sqrt(beyond), q = std::sqrt(beyond + a + b), t = q / p, e = b + a * t;
  gaps[from + 1] = half * q * (p + q) / e;
  for (Eigen::Index k = from + 2; k < gaps.size(); ++k) {
    const double gap = gaps[k];
    beyond += gap;
    const double pn = std::sqrt(beyond), qn = std::sqrt(beyond + a + b), tn = qn / pn, en = b + a * tn;
    const double dp = gap / (p + pn), dq = gap / (q + qn);
    const double dt = (a + b) * gap / (p * p * pn * pn * (t + tn));
    gaps[k] = half * ((dq * (pn + qn) + q * (dp + dq)) + q * (p + q) * (a * dt) / e) / en;
    p = pn;
    q = qn;
    t = tn;
    e = en;
  }
}

/// Points side by side, so that the compiler vectorises the loops over them.
template <int N>
struct Block {
  std::array<double, N> x, y;
};
constexpr int kBlock = 64;

/// √(x + shift + iy) for y ≥ 0, in the closed first quadrant.
template <int N>
void shiftedRoot(const Block<N>& z, double shift, Block<N>& root) {
  for (int i = 0; i < N; ++i) {
    const double x = z.x[i] + shift, y = z.y[i];
    const double large = std::sqrt(0.5 * (std::sqrt(x * x + y * y) + std::fabs(x)));
    const double small = y / (2 * (large > 1e-200 ? large : 1e-200));
    root.x[i] = x >= 0 ? large : small;
    root.y[i] = x >= 0 ? small : large;
  }
}

template <int N>
void closeBlock(double a, double b, Block<N>& z) {
  Block<N> p, q;
  shiftedRoot(z, -a, p);
  shiftedRoot(z, b, q);
  const double half = 0.5 * (a + b);
  for (int i = 0; i < N; ++i) {
    const double sx = p.x[i] + q.x[i], sy = p.y[i] + q.y[i];
    const double mx = p.x[i] * q.x[i] - p.y[i] * q.y[i], my = p.x[i] * q.y[i] + p.y[i] * q.x[i];
    const double nx = mx * sx - my * sy, ny = mx * sy + my * sx;
    const double dx = b * p.x[i] + a * q.x[i], dy = b * p.y[i] + a * q.y[i];
    const double over = half / (dx * dx + dy * dy);
    z.x[i] = (nx * dx + ny * dy) * over;
    const double y = (ny * dx - nx * dy) * over;
    z.y[i] = y > 0 ? y : 0;  // rounding may leave the half-plane, the map does not
  }
}

Complex closePoint(double a, double b, Complex z) {
  Block<1> point{{z.real()}, {z.imag()}};
  closeBlock(a, b, point);
  return {point.x[0], point.y[0]};
}

/// The inverse of one step. With W = 2w/(a + b), κ = (a − b)/(a + b), μ = √(1 + 2κW + W²) = (1 + κW) m:
/// z = ½ (a + b) μ (1 + κW + κμ) / (1 + 2κW) = ½ (a + b) (1 − κ²) μ / (1 + κW − κμ).
Complex openPoint(double a, double b, Complex w) {
  const double sum = a + b, kappa = (a - b) / sum, rest = 4 * (a / sum) * (b / sum);
  const Complex W = 2.0 * w / sum, A = 1.0 + kappa * W;
  const Complex shifted = W + kappa, c(0, std::sqrt(rest));
  Complex mu = std::sqrt(shifted + c) * std::sqrt(shifted - c);
  // m and s = √(m² − 1) ~ W/(1 + κW) lie on the same side of the slit.
  if (std::real(mu * std::conj(A)) * (W.real() + kappa * std::norm(W)) < 0) mu = -mu;
  const Complex B = kappa * mu;
  const Complex z = std::real(A * std::conj(B)) < 0 ? 0.5 * sum * rest * mu / (A - B)
                                                    : 0.5 * sum * mu * (A + B) / (1.0 + 2 * kappa * W);
  return {z.real(), std::max(z.imag(), 0.0)};
}

}  // namespace

Zipper::Zipper(OpenSeam seam, const Execution& execution) {
  const Eigen::Index n = seam.first.size();
  a_.resize(n);
  b_.resize(n);
  for (Eigen::Index k = 0; k < n; ++k) {
    a_[k] = seam.first[k];
    b_[k] = seam.second[k];
    if (!(a_[k] > 1e-140 && b_[k] > 1e-140 && a_[k] < 1e140 && b_[k] < 1e140)) {
      throw GeometryError("Arcs that double precision can tell apart are required, but pair " + std::to_string(k + 3) +
                          " of the welding has no length left; use fewer or more evenly spaced boundary points.");
    }
    if (k + 1 == n) break;
    closeGaps(a_[k], b_[k], k, seam.first);
    closeGaps(b_[k], a_[k], k, seam.second);
    if (k % 256 == 0) {
      execution.throwIfCancelled();
      execution.report(1 - std::pow(1 - double(k) / double(n), 2), "zipper");
    }
  }
}

std::vector<Complex> Zipper::close(const std::vector<Traveller>& travellers, bool mirrored,
                                   const Execution& execution) const {
  const Eigen::VectorXd &a = mirrored ? b_ : a_, &b = mirrored ? a_ : b_;
  std::vector<Complex> images(travellers.size());
  const std::size_t blocks = (travellers.size() + kBlock - 1) / kBlock;
  const auto run = [&](std::size_t begin, std::size_t end) {
    for (std::size_t block = begin; block < end; ++block) {
      const std::size_t first = block * kBlock, count = std::min<std::size_t>(kBlock, travellers.size() - first);
      const Eigen::Index start = travellers[first + count - 1].step;
      Block<kBlock> z{};
      for (std::size_t i = 0; i < kBlock; ++i) {
        Traveller traveller = travellers[first + std::min(i, count - 1)];
        for (; traveller.step < start; ++traveller.step) {
          traveller.at = closePoint(a[traveller.step], b[traveller.step], traveller.at);
        }
        z.x[i] = traveller.at.real();
        z.y[i] = traveller.at.imag();
      }
      for (Eigen::Index k = start; k < steps(); ++k) closeBlock(a[k], b[k], z);
      for (std::size_t i = 0; i < count; ++i) images[first + i] = {z.x[i], z.y[i]};
    }
  };
  parallelFor(blocks, execution, run, 1);
  return images;
}

Complex Zipper::open(Complex point) const {
  for (Eigen::Index k = steps() - 1; k >= 0; --k) point = openPoint(a_[k], b_[k], point);
  return point;
}

}  // namespace authalic
