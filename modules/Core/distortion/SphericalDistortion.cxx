#include "Core/distortion/SphericalDistortion.h"

#include <Eigen/Geometry>

#include <cmath>
#include <utility>

#include "Core/base/Error.h"
#include "Core/distortion/MeasuredImage.h"
#include "Core/geometry/SphericalAreas.h"

namespace authalic {
namespace {

// Angle at a between the directions to b and c.
double flatAngle(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
  return std::atan2((b - a).cross(c - a).norm(), (b - a).dot(c - a));
}

// Angle at a between the great circles to b and c.
double sphericalAngle(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
  const Eigen::Vector3d toB = a.cross(b - a), toC = a.cross(c - a);
  return std::atan2(toB.cross(toC).norm(), toB.dot(toC));
}

double meanSphericalAngleError(const TriangleMesh& surface, const Points3& image) {
  double sum = 0;
  for (int f = 0; f < surface.faceCount(); ++f) {
    for (int k = 0; k < 3; ++k) {
      const int a = surface.faces()(f, k), b = surface.faces()(f, (k + 1) % 3), c = surface.faces()(f, (k + 2) % 3);
      const Eigen::Vector3d p = image.row(a), q = image.row(b), r = image.row(c);
      sum += std::abs(sphericalAngle(p, q, r) - flatAngle(surface.point(a), surface.point(b), surface.point(c)));
    }
  }
  return sum * 180 / (M_PI * 3.0 * surface.faceCount());
}

int countNotPositive(const Eigen::VectorXd& values) {
  int count = 0;
  for (Eigen::Index f = 0; f < values.size(); ++f) count += !(values[f] > 0);
  return count;
}

Eigen::VectorXd signedDeterminants(const Points3& image, const Faces& faces) {
  Eigen::VectorXd values(faces.rows());
  for (Eigen::Index f = 0; f < faces.rows(); ++f) {
    values[f] = signedDeterminant(image.row(faces(f, 0)), image.row(faces(f, 1)), image.row(faces(f, 2)));
  }
  return values;
}

MeasuredImage onTheSphere(const TriangleMesh& surface, const Points3& image) {
  requireImagePerVertex(surface, image.rows());
  requireOnUnitSphere(image);
  MeasuredImage measured;
  measured.points = image.rowwise().normalized();
  measured.areas = signedSolidAngles(measured.points, surface.faces());
  measured.flatAreas = signedChordAreas(measured.points, surface.faces());
  return measured;
}

}  // namespace

Points3 ontoUnitSphere(const Points3& image) {
  const Eigen::VectorXd radii = image.rowwise().norm();
  const double mean = radii.size() > 0 ? radii.mean() : 0;
  for (Eigen::Index i = 0; i < radii.size(); ++i) {
    if (std::abs(radii[i] - mean) <= 1e-3 * mean && mean > 0) continue;
    throw GeometryError(
        "An image in the plane z = 0, or on a sphere around 0 (to 1 in 1,000), is required, but point " +
        std::to_string(i) + " lies at distance " + std::to_string(radii[i]) + " from 0 and all points at " +
        std::to_string(mean) + " on average; move the sphere's centre " +
        "to 0, or take an image in the plane.");
  }
  return image.rowwise().normalized();
}

SphericalDistortion measureSphericalDistortion(const TriangleMesh& surface, const Points3& image,
                                               const Eigen::VectorXd& target) {
  const MeasuredImage measured = onTheSphere(surface, image);
  const Points3& onSphere = measured.points;
  const Eigen::VectorXd &solidAngles = measured.areas, &flatAreas = measured.flatAreas;
  Distortion distortion = measureImage(surface, measured, target);
  measureSpreads(distortion);
  SphericalDistortion result;
  result.arrays = std::move(distortion.arrays);
  result.summary = distortion.summary;
  result.flatSummary = measureImage(surface, {onSphere, flatAreas, flatAreas}, target).summary;
  result.flatSummary.angleError = result.summary.angleError;  // of flat triangles in both
  result.flatSummary.quasiConformal = result.summary.quasiConformal;
  result.flatSummary.beltrami = result.summary.beltrami;
  result.sphericalAngleError = meanSphericalAngleError(surface, onSphere);
  const double sign = majoritySign(solidAngles);
  result.coverage = sign * solidAngles.sum() / (4 * M_PI);
  result.flippedBySolidAngle = countNotPositive(sign * solidAngles);
  result.flippedByVolume = countNotPositive(sign * signedDeterminants(onSphere, surface.faces()));
  return result;
}

DistortionSummary summariseSphericalDistortion(const TriangleMesh& surface, const Points3& image,
                                               const Eigen::VectorXd& target) {
  Distortion distortion = measureImage(surface, onTheSphere(surface, image), target);
  measureSpreads(distortion);
  return distortion.summary;
}

}  // namespace authalic
