#include "Core/geometry/Areas.h"

#include <Eigen/Geometry>

namespace authalic {

Eigen::VectorXd faceAreas(const TriangleMesh& surface) {
  Eigen::VectorXd areas(surface.faceCount());
  for (int f = 0; f < surface.faceCount(); ++f) {
    const Eigen::Vector3d a = surface.corner(f, 0);
    areas[f] = 0.5 * (surface.corner(f, 1) - a).cross(surface.corner(f, 2) - a).norm();
  }
  return areas;
}

Eigen::VectorXd signedFaceAreas(const Points2& points, const Faces& faces) {
  Eigen::VectorXd areas(faces.rows());
  for (Eigen::Index f = 0; f < faces.rows(); ++f) {
    const int a = faces(f, 0), b = faces(f, 1), c = faces(f, 2);
    areas[f] = 0.5 * ((points(b, 0) - points(a, 0)) * (points(c, 1) - points(a, 1)) -
                      (points(b, 1) - points(a, 1)) * (points(c, 0) - points(a, 0)));
  }
  return areas;
}

Eigen::VectorXd periodicFaceAreas(const Points2& points, const Points2& shifts, const Faces& faces) {
  Eigen::VectorXd areas(faces.rows());
  for (Eigen::Index f = 0; f < faces.rows(); ++f) {
    const Eigen::RowVector2d a = points.row(faces(f, 0)) + shifts.row(3 * f);
    const Eigen::RowVector2d b = points.row(faces(f, 1)) + shifts.row(3 * f + 1) - a;
    const Eigen::RowVector2d c = points.row(faces(f, 2)) + shifts.row(3 * f + 2) - a;
    areas[f] = 0.5 * (b[0] * c[1] - b[1] * c[0]);
  }
  return areas;
}

Eigen::VectorXd vertexStars(const Eigen::VectorXd& faceMeasures, const Faces& faces, int vertexCount) {
  Eigen::VectorXd stars = Eigen::VectorXd::Zero(vertexCount);
  for (Eigen::Index f = 0; f < faces.rows(); ++f) {
    for (int k = 0; k < 3; ++k) stars[faces(f, k)] += faceMeasures[f] / 3;
  }
  return stars;
}

int countFlippedFaces(const Points2& points, const Faces& faces) {
  return static_cast<int>(
      (signedFaceAreas(points, faces).array() > 0).select(0, Eigen::ArrayXi::Ones(faces.rows())).sum());
}

double polygonArea(const Points2& polygon) {
  double twice = 0;
  for (Eigen::Index i = 0, n = polygon.rows(); i < n; ++i) {
    const Eigen::Index j = (i + 1) % n;
    twice += polygon(i, 0) * polygon(j, 1) - polygon(i, 1) * polygon(j, 0);
  }
  return 0.5 * twice;
}

double loopConeArea(const TriangleMesh& surface, const std::vector<int>& loop) {
  Eigen::Vector3d tip = Eigen::Vector3d::Zero();
  for (const int v : loop) tip += surface.point(v) / static_cast<double>(loop.size());
  double area = 0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Eigen::Vector3d a = surface.point(loop[i]) - tip, b = surface.point(loop[(i + 1) % loop.size()]) - tip;
    area += 0.5 * a.cross(b).norm();
  }
  return area;
}

}  // namespace authalic
