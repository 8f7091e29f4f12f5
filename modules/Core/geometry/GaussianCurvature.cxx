#include "Core/geometry/GaussianCurvature.h"

#include <cmath>

#include <Eigen/Geometry>

#include "Core/geometry/Areas.h"

namespace authalic {

Eigen::VectorXd gaussianCurvature(const TriangleMesh& surface, const SurfaceTopology& topology) {
  Eigen::VectorXd curvature = Eigen::VectorXd::Constant(surface.vertexCount(), 2 * M_PI);
  for (int f = 0; f < surface.faceCount(); ++f) {
    for (int k = 0; k < 3; ++k) {
      const Eigen::Vector3d a = surface.corner(f, (k + 1) % 3) - surface.corner(f, k),
                            b = surface.corner(f, (k + 2) % 3) - surface.corner(f, k);
      curvature[surface.faces()(f, k)] -= std::atan2(a.cross(b).norm(), a.dot(b));
    }
  }
  const Eigen::VectorXd stars = vertexStars(faceAreas(surface), surface.faces(), surface.vertexCount());
  for (int v = 0; v < surface.vertexCount(); ++v) {
    const bool counts = stars[v] > 0 && !topology.onBoundary()[static_cast<std::size_t>(v)];
    curvature[v] = counts ? curvature[v] / stars[v] : 0;
  }
  return curvature;
}

}  // namespace authalic
