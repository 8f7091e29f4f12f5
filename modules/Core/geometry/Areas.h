/// @file
/// Areas of faces and vertex stars, on surfaces and in the plane.
#pragma once

#include <Eigen/Core>

#include <vector>

#include "Core/mesh/TriangleMesh.h"

namespace authalic {

/// Area of every face of a surface, mm². O(m). Zero for degenerate faces.
[[nodiscard]] Eigen::VectorXd faceAreas(const TriangleMesh& surface);

/// Signed area of every face of a planar mesh: positive when counter-clockwise. O(m).
/// @param points  n×2
/// @param faces   m×3
[[nodiscard]] Eigen::VectorXd signedFaceAreas(const Points2& points, const Faces& faces);

/// The same of a periodic image, whose corner 3 f + k lies at points(v) + shifts(3 f + k).
/// @param shifts  3m×2
[[nodiscard]] Eigen::VectorXd periodicFaceAreas(const Points2& points, const Points2& shifts, const Faces& faces);

/// A third of the areas of the faces around each vertex: the lumped mass. Its sum is the sum of the face areas.
/// @param faceMeasures  m values, any unit
/// @return n values, same unit; 0 at vertices without a face
[[nodiscard]] Eigen::VectorXd vertexStars(const Eigen::VectorXd& faceMeasures, const Faces& faces, int vertexCount);

/// Faces of a planar mesh whose signed area is not positive.
[[nodiscard]] int countFlippedFaces(const Points2& points, const Faces& faces);

/// Area of the cone over a closed loop of vertices, tip in the mean of the loop: what closes a hole, mm².
[[nodiscard]] double loopConeArea(const TriangleMesh& surface, const std::vector<int>& loop);

/// Signed area of the polygon through the rows, positive when counter-clockwise (shoelace formula).
[[nodiscard]] double polygonArea(const Points2& polygon);

}  // namespace authalic
