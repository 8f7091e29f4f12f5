/// @file
/// Cutting a closed surface of genus 0 along a level set of a function into two disks with one matched boundary.
#pragma once

#include <Eigen/Core>

#include <vector>

#include "Core/base/Execution.h"
#include "Core/mesh/DiskMesh.h"
#include "Core/mesh/SphereMesh.h"

namespace authalic {

struct LevelSetCutOptions {
  double level = 0;
  /// The seam keeps this fraction of an edge from its ends, at most ½, so that a level set through vertices needs no
  /// special case. Small: a smooth seam, and a few tiny faces that a Delaunay flip removes; 0.1 and more: no tiny
  /// faces, but a seam with corners.
  double clearance = 1e-3;

  /// @throws InvalidArgument when clearance is outside (0, 0.5] or the level is not finite
  void validate() const;
};

/// Where the seam crosses an edge of the surface.
struct SeamPoint {
  int above = -1, below = -1;  ///< vertices of the edge on the two sides
  double parameter = 0;        ///< the point is (1 − parameter) above + parameter below
};

/// One of the two disks. Its vertices are those of the surface, in order, then the seam points.
struct CutHalf {
  DiskMesh disk;
  std::vector<int> originalPointIds;  ///< vertex of the surface, or −1 for a seam point
  std::vector<int> originalFaceIds;   ///< face of the surface that the face lies in
  int seamStart = 0;                  ///< vertex of seam point 0; the k-th one is seamStart + k
  double area = 0;                    ///< mm²
};

struct LevelSetCutResult {
  CutHalf above, below;
  std::vector<SeamPoint> seam;  ///< closed; above lies to its left, below to its right
  double seamLength = 0;        ///< mm
  /// Connected pieces of the level sets that went with the surface around them, so that two disks are left.
  int mergedPieces = 0;
};

/// Cuts through the faces where the function, linear on each face, takes the level; no vertex moves.
///
/// Of {u > level} and {u ≤ level} the largest connected piece each (by area) is kept; every other piece goes with its
/// surroundings (`mergedPieces`): eigenfunctions have two nodal domains on a smooth surface, but specks may come
/// with negative cotangent weights, and other functions may have any number. What is left are two connected sets of
/// vertices, and on a surface of genus 0 the edges between them form one closed seam: both halves are disks.
///
/// Faces on the seam become a triangle on one side and, on the other, two with the larger least angle. Guarantees: the
/// areas of the halves sum to that of the surface; both boundaries carry the same points. Does not balance the halves.
/// Complexity O(m).
///
/// @param values  n, any unit
/// @throws InvalidArgument from the options
/// @throws GeometryError when the values do not match the vertices, are not finite, or do not take the level
[[nodiscard]] LevelSetCutResult levelSetCut(const SphereMesh& surface, const Eigen::VectorXd& values,
                                            const LevelSetCutOptions& options = {}, const Execution& execution = {});

}  // namespace authalic
