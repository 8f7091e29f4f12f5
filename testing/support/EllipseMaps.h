/// @file
/// The conformal maps of an ellipse on the unit circle, in closed form.
#pragma once

#include <cmath>
#include <complex>

namespace authalic::testing {

/// sn, cn and dn of Jacobi by the arithmetic-geometric mean.
struct JacobiFunctions {
  double sn = 0, cn = 1, dn = 1;
  JacobiFunctions(double u, double k) {
    double a[32], c[32];
    int n = 0;
    a[0] = 1;
    c[0] = k;
    double b = std::sqrt(1 - k * k), power = 1;
    for (; std::abs(c[n]) > 1e-17 && n < 30; ++n, power *= 2) {
      a[n + 1] = 0.5 * (a[n] + b);
      c[n + 1] = 0.5 * (a[n] - b);
      b = std::sqrt(a[n] * b);
    }
    double phi = power * a[n] * u;
    for (; n > 0; --n) phi = 0.5 * (phi + std::asin(c[n] * std::sin(phi) / a[n]));
    sn = std::sin(phi);
    cn = std::cos(phi);
    dn = std::sqrt(1 - k * k * sn * sn);
  }
};

/// sn(x + iy) by the addition theorem.
inline std::complex<double> jacobiSn(std::complex<double> u, double k) {
  const JacobiFunctions f(u.real(), k), g(u.imag(), std::sqrt(1 - k * k));
  const double below = g.cn * g.cn + k * k * f.sn * f.sn * g.sn * g.sn;
  return {f.sn * g.dn / below, f.cn * f.dn * g.sn * g.cn / below};
}

/// The ellipse ((1 + m) cos t, (1 − m) sin t), 0 < m < 1. Its outside is the image of 1/w + m w for |w| < 1, e^{−it}
/// going to t; its inside goes to the disk by √k sn(2K/π arcsin(z / 2√m)), the modulus k having the nome m².
class EllipseMaps {
 public:
  explicit EllipseMaps(double m) : m_(m) {
    double theta2 = 0, theta3 = 1;
    for (int n = 0; n < 40; ++n) theta2 += 2 * std::pow(m, 2 * (n + 0.5) * (n + 0.5));
    for (int n = 1; n < 40; ++n) theta3 += 2 * std::pow(m, 2.0 * n * n);
    k_ = theta2 * theta2 / (theta3 * theta3);
    quarter_ = std::comp_ellint_1(k_);
  }
  /// The angle on the circle of disk 1 that goes to the ellipse point t: arg √k sn(K − 2Kt/π + ½iK').
  [[nodiscard]] double innerAngle(double t) const {
    const JacobiFunctions f(quarter_ * (1 - 2 * t / M_PI), k_);
    return std::atan2(f.cn * f.dn, (1 + k_) * f.sn);
  }

  /// Of a point inside the ellipse, in disk 1.
  [[nodiscard]] std::complex<double> inside(std::complex<double> z) const {
    return std::sqrt(k_) * jacobiSn(2 * quarter_ / M_PI * std::asin(z / (2 * std::sqrt(m_))), k_);
  }
  /// Of a point outside the ellipse, in disk 2.
  [[nodiscard]] std::complex<double> outside(std::complex<double> z) const {
    const std::complex<double> root = std::sqrt(z - 2 * std::sqrt(m_)) * std::sqrt(z + 2 * std::sqrt(m_));
    return 2.0 / (z + root);
  }

 private:
  double m_, k_ = 0, quarter_ = 0;
};

}  // namespace authalic::testing
