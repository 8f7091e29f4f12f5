/// @file
/// A triangulation of the plane or the sphere whose edges flip while its vertices flow. Private to authalic/.
#pragma once

#include <vector>

#include "Core/authalic/AreaFunctional.h"
#include "Core/mesh/TriangleMesh.h"

namespace authalic {

/// Faces that may be re-triangulated by edge flips; the vertices and the outline stay.
///
/// Keeping the flowing mesh Delaunay gives cotangent weights that are not negative, and lets a vertex pass an edge
/// that is in its way @cite su2019. The price: faces of the original mesh may fold meanwhile; count them there.
class FlowingMesh {
 public:
  /// @param faces   m×3, manifold and oriented
  /// @param frozen  m flags: faces left out of the flowing mesh (their inner edges become outline); empty = none
  /// @param shifts  3m×2 or empty: those of a periodic image, see periodicFaceAreas()
  FlowingMesh(const Faces& faces, int vertexCount, const std::vector<char>& frozen = {}, const Points2& shifts = {});

  /// Flip edges until every inner edge is Delaunay: in the plane, opposite angles sum to at most π (up to 1e-12 in
  /// the cotangents); on the sphere, no vertex lies above the plane of the face beside it, so that the flat faces
  /// are the convex hull.
  /// @param points  n×2 or n×3, every face counter-clockwise; stays so: an edge flips only inside a strictly
  ///                convex quad
  /// @return the number of flips
  int makeDelaunay(const Coordinates& points);

  [[nodiscard]] const Faces& faces() const noexcept { return faces_; }
  /// Of the corners of faces(); no rows when there were none.
  [[nodiscard]] const Points2& shifts() const noexcept { return shifts_; }

 private:
  [[nodiscard]] bool shouldFlip(const Coordinates& points, int halfEdge) const;
  [[nodiscard]] Eigen::RowVector2d shift(int halfEdge) const;
  void flip(int halfEdge);
  void join(int halfEdge, int opposite);

  Faces faces_;
  Points2 shifts_;
  std::vector<int> opposite_, stack_;
};

}  // namespace authalic
