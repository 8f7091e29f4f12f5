#include "Core/authalic/SolidAngles.h"

#include <Eigen/Geometry>

#include "Core/authalic/Patches.h"
#include "Core/geometry/SphericalAreas.h"
#include "Core/numerics/FlipFreeStep.h"

namespace authalic {
namespace {

Eigen::Vector3d row(const Coordinates& x, int v) { return x.row(v).transpose(); }

double determinant(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
  return a.dot(b.cross(c));
}

// Derivative of the solid angle of a b c by a: tan(Ω/2) = N / D, with b × c from the edge at b.
Eigen::Vector3d angleGradient(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
  const Eigen::Vector3d cross = b.cross(c - b);
  const double n = a.dot(cross), d = 1 + a.dot(b) + b.dot(c) + c.dot(a);
  return 2 * (d * cross - n * (b + c)) / (n * n + d * d);
}

}  // namespace

SolidAngles::SolidAngles(const Faces& faces, int vertexCount)
    : AreaFunctional(faces, std::vector<char>(static_cast<std::size_t>(vertexCount), 2)) {}

Eigen::VectorXd SolidAngles::areas(const Coordinates& image) const {
  return signedSolidAngles(Points3(image), faces());
}

// Two tangents at every vertex; the axis that is farthest from the vertex decides the first.
AreaFunctional::Frames SolidAngles::frames(const Coordinates& image) const {
  Frames result(image.rows(), 6);
  for (int v = 0; v < vertexCount(); ++v) {
    const Eigen::Vector3d normal = row(image, v);
    Eigen::Index axis = 0;
    normal.cwiseAbs().minCoeff(&axis);
    const Eigen::Vector3d first = normal.cross(Eigen::Vector3d::Unit(axis)).normalized();
    result.row(v) << first.transpose(), normal.cross(first).transpose();
  }
  return result;
}

AreaFunctional::Gradients SolidAngles::gradients(const Coordinates& image, const Frames& frames) const {
  Gradients result(faces().rows(), 6);
  for (Eigen::Index f = 0; f < faces().rows(); ++f) {
    for (int k = 0; k < 3; ++k) {
      const int i = faces()(f, k), j = faces()(f, (k + 1) % 3), l = faces()(f, (k + 2) % 3);
      const Eigen::Vector3d g = angleGradient(row(image, i), row(image, j), row(image, l));
      result(f, 2 * k) = frames.row(i).head<3>().dot(g);
      result(f, 2 * k + 1) = frames.row(i).tail<3>().dot(g);
    }
  }
  return result;
}

Coordinates SolidAngles::moved(const Coordinates& image, const Coordinates& displacement, double t) const {
  Coordinates result = image + t * displacement;
  result.rowwise().normalize();
  return result;
}

double SolidAngles::firstFlip(const Coordinates& image, const Coordinates& displacement, int face) const {
  const int i = faces()(face, 0), j = faces()(face, 1), l = faces()(face, 2);
  const Eigen::Vector3d a = row(image, i), b = row(image, j) - a, c = row(image, l) - a;
  const Eigen::Vector3d u = row(displacement, i), v = row(displacement, j) - u, w = row(displacement, l) - u;
  return smallestPositiveRoot(determinant(u, v, w), determinant(u, v, c) + determinant(u, b, w) + determinant(a, v, w),
                              determinant(u, b, c) + determinant(a, v, c) + determinant(a, b, w), determinant(a, b, c),
                              kFarthest);
}

std::unique_ptr<AreaFunctional> SolidAngles::inPatch(const Patch& patch, const Coordinates&) const {
  return std::make_unique<SolidAngles>(patch.corners, patch.freedom);
}

}  // namespace authalic
