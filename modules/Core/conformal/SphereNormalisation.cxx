#include "Core/conformal/SphereNormalisation.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/SVD>

#include <string>

#include "Core/base/Error.h"
#include "Core/geometry/Areas.h"

namespace authalic {
namespace {

// The rotation R with det R = 1 that maximises tr(R M): Kabsch.
Eigen::Matrix3d bestRotation(const Eigen::Matrix3d& m) {
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(m, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const Eigen::Matrix3d ut = svd.matrixU().transpose();
  const double sign = (svd.matrixV() * ut).determinant() < 0 ? -1 : 1;
  return svd.matrixV() * Eigen::Vector3d(1, 1, sign).asDiagonal() * ut;
}

Eigen::Matrix3d towardsSurface(const TriangleMesh& surface, const Points3& y, const Eigen::VectorXd& mass) {
  const Eigen::RowVector3d mean = mass.transpose() * surface.points() / mass.sum();
  const Points3 centred = surface.points().rowwise() - mean;
  return bestRotation(y.transpose() * mass.asDiagonal() * centred);
}

// The axis with the sign that makes its third moment positive.
Eigen::Vector3d signedAxis(const Points3& y, const Eigen::VectorXd& mass, const Eigen::Vector3d& axis) {
  const double skewness = mass.dot((y * axis).array().cube().matrix());
  return skewness < 0 ? Eigen::Vector3d(-axis) : axis;
}

Eigen::Matrix3d towardsPrincipalAxes(const Points3& y, const Eigen::VectorXd& mass) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(y.transpose() * mass.asDiagonal() * y);
  const Eigen::Vector3d z = signedAxis(y, mass, eigen.eigenvectors().col(2));
  const Eigen::Vector3d x = signedAxis(y, mass, eigen.eigenvectors().col(1));
  Eigen::Matrix3d rotation;
  rotation << x.transpose(), z.cross(x).transpose(), z.transpose();
  return rotation;
}

Eigen::Matrix3d towardsLandmarks(const Points3& y, int north, int meridian) {
  const Eigen::Vector3d z = y.row(north).transpose(), other = y.row(meridian).transpose();
  const Eigen::Vector3d across = z.cross(other);
  if (!(across.norm() > 1e-12)) {
    throw GeometryError("Two landmarks that are neither equal nor opposite on the sphere are required, but vertices " +
                        std::to_string(north) + " and " + std::to_string(meridian) + " are; choose another vertex.");
  }
  const Eigen::Vector3d v = across.normalized();
  Eigen::Matrix3d rotation;
  rotation << v.cross(z).transpose(), v.transpose(), z.transpose();
  return rotation;
}

Eigen::Matrix3d rotationOf(const TriangleMesh& surface, const Points3& y, const Eigen::VectorXd& mass,
                           const SphereNormalisationOptions& options) {
  switch (options.rotation) {
    case SphereRotation::Surface: return towardsSurface(surface, y, mass);
    case SphereRotation::PrincipalAxes: return towardsPrincipalAxes(y, mass);
    case SphereRotation::Landmarks: return towardsLandmarks(y, options.northVertex, options.meridianVertex);
    case SphereRotation::None: break;
  }
  return Eigen::Matrix3d::Identity();
}

void requireLandmark(const TriangleMesh& surface, int vertex) {
  if (vertex < surface.vertexCount()) return;
  throw InvalidArgument("Landmarks among the " + std::to_string(surface.vertexCount()) +
                        " vertices of the surface are required, but one is " + std::to_string(vertex) + ".");
}

}  // namespace

const char* sphereRotationName(SphereRotation rotation) noexcept {
  switch (rotation) {
    case SphereRotation::Surface: return "surface";
    case SphereRotation::PrincipalAxes: return "principal-axes";
    case SphereRotation::Landmarks: return "landmarks";
    case SphereRotation::None: return "none";
  }
  return "none";
}

void SphereNormalisationOptions::validate() const {
  if (!(tolerance > 0) || maxIterations < 0) {
    throw InvalidArgument("A positive tolerance and at least 0 iterations are required, but they are " +
                          std::to_string(tolerance) + " and " + std::to_string(maxIterations) + ".");
  }
  const bool given = northVertex >= 0 && meridianVertex >= 0 && northVertex != meridianVertex;
  const bool needed = rotation == SphereRotation::Landmarks;
  if (needed ? !given : northVertex != -1 || meridianVertex != -1) {
    throw InvalidArgument(
        "Two different landmark vertices are required with the rotation 'landmarks' and none with any "
        "other, but with '" +
        std::string(sphereRotationName(rotation)) + "' they are " + std::to_string(northVertex) + " and " +
        std::to_string(meridianVertex) + ".");
  }
}

SphereNormalisation normaliseSphere(const TriangleMesh& surface, const Points3& image,
                                    const SphereNormalisationOptions& options) {
  options.validate();
  requireLandmark(surface, options.northVertex);
  requireLandmark(surface, options.meridianVertex);
  const Eigen::VectorXd mass = vertexStars(faceAreas(surface), surface.faces(), surface.vertexCount());
  const SphereCentring centring =
      centreOfSphericalMassToOrigin(image, mass, options.tolerance, options.maxIterations);
  const Eigen::Matrix3d rotation = rotationOf(surface, centring.map(image), mass, options);
  SphereNormalisation result;
  result.map = SphereMobius(centring.map.centre(), rotation);
  result.image = result.map(image);
  result.status = centring.status;
  result.iterations = centring.iterations;
  result.residual = (mass.transpose() * result.image).norm() / mass.sum();
  return result;
}

double centreOfMassDistance(const TriangleMesh& surface, const Points3& image) {
  const Eigen::VectorXd mass = vertexStars(faceAreas(surface), surface.faces(), surface.vertexCount());
  return (mass.transpose() * image).norm() / mass.sum();
}

Points3 rotateSphere(const TriangleMesh& surface, const Points3& image, const SphereNormalisationOptions& options) {
  options.validate();
  requireLandmark(surface, options.northVertex);
  requireLandmark(surface, options.meridianVertex);
  const Eigen::VectorXd mass = vertexStars(faceAreas(surface), surface.faces(), surface.vertexCount());
  return image * rotationOf(surface, image, mass, options).transpose();
}

}  // namespace authalic
