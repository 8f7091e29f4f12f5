/// @file
/// A triangle mesh as plain arrays, checked once at construction.
#pragma once

#include "Core/base/Arrays.h"

namespace authalic {

/// Points and triangles. Guarantees: every coordinate is finite, every index lies in [0, n), and no
/// face names a vertex twice. Says nothing about manifoldness: see SurfaceTopology and MeshReport.
class TriangleMesh {
 public:
  TriangleMesh() = default;

  /// @param points  n×3, mm
  /// @param faces   m×3, indices into points
  /// @throws GeometryError when a coordinate is not finite, an index is out of range or repeated in a face,
  ///         or there is no face at all; the first offending vertex or face is named.
  TriangleMesh(Points3 points, Faces faces);

  [[nodiscard]] const Points3& points() const noexcept { return points_; }
  [[nodiscard]] const Faces& faces() const noexcept { return faces_; }
  [[nodiscard]] int vertexCount() const noexcept { return static_cast<int>(points_.rows()); }
  [[nodiscard]] int faceCount() const noexcept { return static_cast<int>(faces_.rows()); }

  [[nodiscard]] Eigen::Vector3d point(int vertex) const { return points_.row(vertex).transpose(); }
  /// The k-th corner (k = 0, 1, 2) of a face.
  [[nodiscard]] Eigen::Vector3d corner(int face, int k) const { return point(faces_(face, k)); }

 private:
  Points3 points_;
  Faces faces_;
};

}  // namespace authalic
