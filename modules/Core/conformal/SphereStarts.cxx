#include "Core/conformal/SphereStarts.h"

#include <Eigen/Geometry>

#include <cmath>
#include <utility>
#include <vector>

#include "Core/conformal/StereographicSphereMap.h"
#include "Core/initial/BarycentricSystem.h"

namespace authalic {

Points3 tutteSphereMap(const SphereMesh& sphere, int outerFace, SolverBackend solver) {
  const Faces& faces = sphere.mesh().faces();
  std::vector<char> held(static_cast<std::size_t>(sphere.mesh().vertexCount()), 0);
  Points2 plane = Points2::Zero(sphere.mesh().vertexCount(), 2);
  for (int k = 0; k < 3; ++k) {
    held[static_cast<std::size_t>(faces(outerFace, k))] = 1;
    plane.row(faces(outerFace, k)) << std::cos(2 * M_PI * k / 3), std::sin(2 * M_PI * k / 3);
  }
  solveBarycentric(faces, HalfEdgeWeights::Constant(faces.rows(), 3, 0.5), held, solver, plane);
  return liftCentred(sphere.mesh(), std::move(plane));
}

Points3 gaussSphereMap(const SphereMesh& sphere) {
  const TriangleMesh& mesh = sphere.mesh();
  Points3 normals = Points3::Zero(mesh.vertexCount(), 3);
  for (int f = 0; f < mesh.faceCount(); ++f) {
    const Eigen::Vector3d a = mesh.corner(f, 0);
    const Eigen::RowVector3d normal = (mesh.corner(f, 1) - a).cross(mesh.corner(f, 2) - a).transpose();
    for (int k = 0; k < 3; ++k) normals.row(mesh.faces()(f, k)) += normal;
  }
  const Eigen::RowVector3d centroid = mesh.points().colwise().mean();
  for (Eigen::Index v = 0; v < normals.rows(); ++v) {
    if (!(normals.row(v).norm() > 0)) normals.row(v) = mesh.points().row(v) - centroid;
    if (!(normals.row(v).norm() > 0)) normals.row(v) << 0, 0, 1;
    normals.row(v).normalize();
  }
  return normals;
}

}  // namespace authalic
