#include "Core/authalic/PeriodicStretch.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

namespace authalic {

Eigen::Matrix2d periodicStretch(const TriangleMesh& surface, const Points2& points, const Points2& shifts) {
  Eigen::Matrix2d sum = Eigen::Matrix2d::Zero();
  for (int f = 0; f < surface.faceCount(); ++f) {
    const Eigen::Vector3d e = surface.corner(f, 1) - surface.corner(f, 0),
                          g = surface.corner(f, 2) - surface.corner(f, 0);
    const double base = e.norm(), twice = e.cross(g).norm();
    if (!(twice > 1e-12 * base * g.norm())) continue;
    Eigen::Matrix2d flat, mapped;
    flat << base, e.dot(g) / base, 0, twice / base;
    for (int k = 1; k < 3; ++k) {
      mapped.col(k - 1) = (points.row(surface.faces()(f, k)) + shifts.row(3 * f + k) -
                           points.row(surface.faces()(f, 0)) - shifts.row(3 * f)).transpose();
    }
    const Eigen::Matrix2d jacobian = mapped * flat.inverse();
    sum += 0.5 * twice * jacobian * jacobian.transpose();
  }
  return sum;
}

}  // namespace authalic
