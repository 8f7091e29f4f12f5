#include "Core/geometry/Laplacian.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>

#include "Core/numerics/ElementAssembly.h"

namespace authalic {
namespace {

constexpr double kSmallestRelativeArea = 1e-10;

// Half cotangents of the angles opposite to edges 01, 12, 20 from the edge vectors.
template <class Vector>
Eigen::RowVector3d halfCotangents(const Vector& e01, const Vector& e12, const Vector& e20, double doubleArea) {
  const double squares = e01.squaredNorm() + e12.squaredNorm() + e20.squaredNorm();
  const double area = std::max(std::abs(doubleArea), kSmallestRelativeArea * squares);
  if (!(area > 0)) return Eigen::RowVector3d::Zero();
  return Eigen::RowVector3d(-e12.dot(e20), -e20.dot(e01), -e01.dot(e12)) * (0.5 / area);
}

SparseMatrix stiffnessOf(const HalfEdgeWeights& weights, const Faces& faces, int vertexCount) {
  ElementAssembly assembly(vertexCount, faces);
  std::vector<double> values(static_cast<std::size_t>(6 * faces.rows()));
  for (Eigen::Index f = 0; f < faces.rows(); ++f) {
    const double w01 = weights(f, 0), w12 = weights(f, 1), w20 = weights(f, 2);
    const std::array<double, 6> element{w01 + w20, -w01, -w20, w01 + w12, -w12, w12 + w20};
    std::copy(element.begin(), element.end(), values.begin() + 6 * f);
  }
  return assembly.assemble(values);
}

// tan(α/2) at the corner between two edge vectors, without inverse functions.
double tangentOfHalfAngle(const Eigen::Vector3d& u, const Eigen::Vector3d& v) {
  const double denominator = u.norm() * v.norm() + u.dot(v);
  const double cross = u.cross(v).norm();
  return denominator > 1e-6 * cross ? cross / denominator : 1e6;
}

// @param place  of corner k of face f
template <class Place>
MeanValueWeights meanValueWeightsOf(const Faces& faces, const Place& place) {
  MeanValueWeights weights{HalfEdgeWeights(faces.rows(), 3), HalfEdgeWeights(faces.rows(), 3)};
  for (Eigen::Index f = 0; f < faces.rows(); ++f) {
    const std::array<Eigen::Vector3d, 3> p{place(f, 0), place(f, 1), place(f, 2)};
    const std::array<Eigen::Vector3d, 3> edge{p[1] - p[0], p[2] - p[1], p[0] - p[2]};
    std::array<double, 3> tangent{};
    for (std::size_t k = 0; k < 3; ++k) tangent[k] = tangentOfHalfAngle(edge[k], -edge[(k + 2) % 3]);
    const double perimeter = edge[0].norm() + edge[1].norm() + edge[2].norm();
    for (std::size_t k = 0; k < 3; ++k) {
      const double length = std::max({edge[k].norm(), 1e-8 * perimeter, 1e-300});
      weights.forward(f, static_cast<Eigen::Index>(k)) = tangent[k] / length;
      weights.backward(f, static_cast<Eigen::Index>(k)) = tangent[(k + 1) % 3] / length;
    }
  }
  return weights;
}

// Where corner k of a face lies, in an image that is periodic when there are shifts.
Eigen::RowVector2d cornerOf(const Points2& points, const Faces& faces, const Points2& shifts, Eigen::Index f,
                            Eigen::Index k) {
  const Eigen::RowVector2d place = points.row(faces(f, k));
  return shifts.size() == 0 ? place : place + shifts.row(3 * f + k);
}

double angleBetween(double ux, double uy, double vx, double vy) {
  return std::atan2(std::abs(ux * vy - uy * vx), ux * vx + uy * vy);
}

}  // namespace

HalfEdgeWeights cotangentWeights(const TriangleMesh& surface) {
  return cotangentWeights(surface.points(), surface.faces());
}

HalfEdgeWeights cotangentWeights(const Points3& points, const Faces& faces) {
  HalfEdgeWeights weights(faces.rows(), 3);
  for (Eigen::Index f = 0; f < faces.rows(); ++f) {
    const Eigen::Vector3d a = points.row(faces(f, 0)), b = points.row(faces(f, 1)), c = points.row(faces(f, 2));
    weights.row(f) = halfCotangents<Eigen::Vector3d>(b - a, c - b, a - c, (b - a).cross(c - a).norm());
  }
  return weights;
}

HalfEdgeWeights cotangentWeights(const Points2& points, const Faces& faces, const Points2& shifts) {
  HalfEdgeWeights weights(faces.rows(), 3);
  for (Eigen::Index f = 0; f < faces.rows(); ++f) {
    const Eigen::RowVector2d a = cornerOf(points, faces, shifts, f, 0), b = cornerOf(points, faces, shifts, f, 1),
                             c = cornerOf(points, faces, shifts, f, 2);
    const double doubleArea = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    weights.row(f) = halfCotangents<Eigen::RowVector2d>(b - a, c - b, a - c, doubleArea);
  }
  return weights;
}

MeanValueWeights meanValueWeights(const TriangleMesh& surface) {
  return meanValueWeightsOf(surface.faces(), [&surface](Eigen::Index f, int k) {
    return surface.corner(static_cast<int>(f), k);
  });
}

MeanValueWeights meanValueWeights(const Points2& points, const Faces& faces, const Points2& shifts) {
  return meanValueWeightsOf(faces, [&](Eigen::Index f, int k) {
    const Eigen::RowVector2d place = cornerOf(points, faces, shifts, f, k);
    return Eigen::Vector3d(place[0], place[1], 0);
  });
}

SparseMatrix cotangentStiffness(const TriangleMesh& surface) {
  return stiffnessOf(cotangentWeights(surface), surface.faces(), surface.vertexCount());
}

SparseMatrix cotangentStiffness(const Points2& points, const Faces& faces) {
  return stiffnessOf(cotangentWeights(points, faces), faces, static_cast<int>(points.rows()));
}

Points2 faceGradients(const Points2& points, const Faces& faces, const Eigen::VectorXd& u, const Points2& shifts) {
  Points2 gradients(faces.rows(), 2);
  for (Eigen::Index f = 0; f < faces.rows(); ++f) {
    const int a = faces(f, 0), b = faces(f, 1), c = faces(f, 2);
    const Eigen::RowVector2d origin = cornerOf(points, faces, shifts, f, 0),
                             e = cornerOf(points, faces, shifts, f, 1) - origin,
                             g = cornerOf(points, faces, shifts, f, 2) - origin;
    const double doubleArea = e[0] * g[1] - e[1] * g[0], du = u[b] - u[a], dv = u[c] - u[a];
    if (doubleArea == 0) {
      gradients.row(f).setZero();
    } else {
      gradients.row(f) << (du * g[1] - dv * e[1]) / doubleArea, (dv * e[0] - du * g[0]) / doubleArea;
    }
  }
  return gradients;
}

Points2 vertexGradients(const Points2& points, const Faces& faces, const Eigen::VectorXd& u, const Points2& shifts) {
  const Points2 ofFace = faceGradients(points, faces, u, shifts);
  Points2 gradients = Points2::Zero(points.rows(), 2);
  Eigen::VectorXd angles = Eigen::VectorXd::Zero(points.rows());
  for (Eigen::Index f = 0; f < faces.rows(); ++f) {
    for (int k = 0; k < 3; ++k) {
      const int i = faces(f, k);
      const Eigen::RowVector2d origin = cornerOf(points, faces, shifts, f, k),
                               e = cornerOf(points, faces, shifts, f, (k + 1) % 3) - origin,
                               g = cornerOf(points, faces, shifts, f, (k + 2) % 3) - origin;
      const double angle = angleBetween(e[0], e[1], g[0], g[1]);
      gradients.row(i) += angle * ofFace.row(f);
      angles[i] += angle;
    }
  }
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    if (angles[i] > 0) gradients.row(i) /= angles[i];
  }
  return gradients;
}

Points3 vertexGradients(const Points3& points, const Faces& faces, const Eigen::VectorXd& u) {
  Points3 gradients = Points3::Zero(points.rows(), 3);
  Eigen::VectorXd angles = Eigen::VectorXd::Zero(points.rows());
  for (Eigen::Index f = 0; f < faces.rows(); ++f) {
    const std::array<Eigen::Vector3d, 3> p{points.row(faces(f, 0)), points.row(faces(f, 1)), points.row(faces(f, 2))};
    const Eigen::Vector3d normal = (p[1] - p[0]).cross(p[2] - p[0]);
    if (!(normal.squaredNorm() > 0)) continue;
    Eigen::Vector3d gradient = Eigen::Vector3d::Zero();
    for (std::size_t k = 0; k < 3; ++k) {
      gradient += u[faces(f, static_cast<Eigen::Index>(k))] * normal.cross(p[(k + 2) % 3] - p[(k + 1) % 3]);
    }
    gradient /= normal.squaredNorm();
    for (std::size_t k = 0; k < 3; ++k) {
      const Eigen::Vector3d e = p[(k + 1) % 3] - p[k], g = p[(k + 2) % 3] - p[k];
      const double angle = std::atan2(e.cross(g).norm(), e.dot(g));
      gradients.row(faces(f, static_cast<Eigen::Index>(k))) += angle * gradient.transpose();
      angles[faces(f, static_cast<Eigen::Index>(k))] += angle;
    }
  }
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    if (angles[i] > 0) gradients.row(i) /= angles[i];
  }
  return gradients;
}

}  // namespace authalic
