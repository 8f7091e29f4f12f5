#include "Core/geometry/SphericalAreas.h"

#include <Eigen/Geometry>

#include <cmath>
#include <string>

#include "Core/base/Error.h"

namespace authalic {
namespace {

constexpr double kOnSphere = 1e-6;  // coordinates in single precision still count as on the sphere

Eigen::Vector3d at(const Points3& points, int v) { return points.row(v).transpose(); }

}  // namespace

double signedDeterminant(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
  return a.dot((b - a).cross(c - a));
}

double signedSolidAngle(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
  return 2 * std::atan2(signedDeterminant(a, b, c), 1 + a.dot(b) + b.dot(c) + c.dot(a));
}

Eigen::VectorXd signedSolidAngles(const Points3& points, const Faces& faces) {
  Eigen::VectorXd angles(faces.rows());
  for (Eigen::Index f = 0; f < faces.rows(); ++f) {
    angles[f] = signedSolidAngle(at(points, faces(f, 0)), at(points, faces(f, 1)), at(points, faces(f, 2)));
  }
  return angles;
}

Eigen::VectorXd signedChordAreas(const Points3& points, const Faces& faces) {
  Eigen::VectorXd areas(faces.rows());
  for (Eigen::Index f = 0; f < faces.rows(); ++f) {
    const Eigen::Vector3d a = at(points, faces(f, 0));
    const Eigen::Vector3d normal = (at(points, faces(f, 1)) - a).cross(at(points, faces(f, 2)) - a);
    areas[f] = a.dot(normal) > 0 ? 0.5 * normal.norm() : -0.5 * normal.norm();
  }
  return areas;
}

int countFlippedOnSphere(const Points3& points, const Faces& faces) {
  int flipped = 0;
  for (Eigen::Index f = 0; f < faces.rows(); ++f) {
    flipped += !(signedDeterminant(at(points, faces(f, 0)), at(points, faces(f, 1)), at(points, faces(f, 2))) > 0);
  }
  return flipped;
}

void requireOnUnitSphere(const Points3& points) {
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    const double radius = points.row(i).norm();
    if (std::abs(radius - 1) <= kOnSphere) continue;
    throw GeometryError("Points on the unit sphere (to 1e-6) are required, but point " + std::to_string(i) +
                        " lies at distance " + std::to_string(radius) +
                        " from the origin; divide by the radius first.");
  }
}

}  // namespace authalic
