#include "Core/mesh/TriangleMesh.h"

#include <string>
#include <utility>

#include "Core/base/Error.h"

namespace authalic {

namespace {

void requireFinite(const Points3& points) {
  if (points.allFinite()) return;
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    if (!points.row(i).allFinite()) {
      throw GeometryError("Finite coordinates are required, but vertex " + std::to_string(i) +
                          " has a NaN or infinite one; remove or repair that vertex.");
    }
  }
}

void requireValidFaces(const Faces& faces, Eigen::Index vertexCount) {
  for (Eigen::Index f = 0; f < faces.rows(); ++f) {
    const int a = faces(f, 0), b = faces(f, 1), c = faces(f, 2);
    if (faces.row(f).minCoeff() < 0 || faces.row(f).maxCoeff() >= vertexCount) {
      throw GeometryError("Vertex indices from 0 to " + std::to_string(vertexCount - 1) +
                          " are required, but face " + std::to_string(f) + " names " + std::to_string(a) +
                          ", " + std::to_string(b) + ", " + std::to_string(c) + "; the file is damaged.");
    }
    if (a == b || b == c || c == a) {
      throw GeometryError("Three different vertices per face are required, but face " + std::to_string(f) +
                          " names " + std::to_string(a) + ", " + std::to_string(b) + ", " + std::to_string(c) +
                          "; remove the degenerate face ('authalic repair').");
    }
  }
}

}  // namespace

TriangleMesh::TriangleMesh(Points3 points, Faces faces) : points_(std::move(points)), faces_(std::move(faces)) {
  if (faces_.rows() == 0) {
    throw GeometryError("A surface with at least one triangle is required, but there are " +
                        std::to_string(points_.rows()) + " points and no triangle.");
  }
  requireFinite(points_);
  requireValidFaces(faces_, points_.rows());
}

}  // namespace authalic
