/// @file
/// The measure that a map shall carry to the plane: surface area, or surface area times a density.
#pragma once

#include <vector>

#include <Eigen/Core>

#include "Core/mesh/TriangleMesh.h"

namespace authalic {

/// Shares of the domain that the faces and vertex stars of a surface shall get; each sums to 1.
///
/// The target of face t is ρ_t A_t / Σ ρ A @cite su2019 (eq. 6): the density multiplies the *surface* area form,
/// so that ρ = 4 on a region gives it four times the share per mm². A region's share is exact in this measure.
/// Faces without surface area (below 1e-6 of the mean target) get 1e-2 of the mean, or less in small stars
/// (`clampedFaces`): nothing can be mapped to a point. The stars of vertices do without that, so that they stay exact;
/// a star without any area is the sum of its raised faces.
class TargetMeasure {
 public:
  /// ρ = 1: area-preserving.
  /// @throws GeometryError when the surface has no area
  explicit TargetMeasure(const TriangleMesh& surface);

  /// @param density  n values > 0, one per vertex (unitless); a face takes the mean of its corners
  /// @throws GeometryError   when the length is not n
  /// @throws InvalidArgument when a density is zero, negative or not finite; the vertex is named
  [[nodiscard]] static TargetMeasure fromVertexDensity(const TriangleMesh& surface, const Eigen::VectorXd& density);

  /// @param density  m values > 0, one per face
  /// @throws as fromVertexDensity
  [[nodiscard]] static TargetMeasure fromFaceDensity(const TriangleMesh& surface, const Eigen::VectorXd& density);

  /// Between the areas of an image and this measure, (1 − t) a + t m @cite nadeem2017: for t = 0 the image itself has
  /// its target areas, for t = 1 the target is this one. From a conformal image this balances angles against areas.
  /// @param imageAreas  m areas of the faces of an image without folds, > 0, any unit
  /// @throws GeometryError when there are not m, or one is not positive; InvalidArgument when t is outside [0, 1]
  [[nodiscard]] TargetMeasure blended(const TriangleMesh& surface, const Eigen::VectorXd& imageAreas, double t) const;

  /// The same with a weight per vertex: face t has the mean t̄ of its corners, and the measure (1 − t̄) a + t̄ m, a
  /// and m as shares, is normalised at the end.
  /// @param t  n weights in [0, 1]
  /// @throws as above; GeometryError when there are not n weights
  [[nodiscard]] TargetMeasure blended(const TriangleMesh& surface, const Eigen::VectorXd& imageAreas,
                                      const Eigen::VectorXd& t) const;

  /// m shares, > 0, sum 1.
  [[nodiscard]] const Eigen::VectorXd& faces() const noexcept { return faces_; }
  /// m shares ≥ 0 before any was raised, sum 1: what a map is measured against.
  [[nodiscard]] const Eigen::VectorXd& shares() const noexcept { return shares_; }
  /// n shares: a third of the faces around each vertex, before any was raised; sum 1.
  [[nodiscard]] const Eigen::VectorXd& vertices() const noexcept { return vertices_; }
  /// Faces whose target was raised because they have no area.
  [[nodiscard]] int clampedFaces() const noexcept { return clampedFaces_; }

 private:
  TargetMeasure(const TriangleMesh& surface, const Eigen::VectorXd& faceDensity);
  void raiseSmallTargets(const TriangleMesh& surface, double ofMean);

  Eigen::VectorXd shares_, faces_, vertices_;
  int clampedFaces_ = 0;
};

/// The mean of the three corners of every face, as a face takes a density or a balance of its vertices.
/// @param ofVertices  n values
/// @return m values
[[nodiscard]] Eigen::VectorXd meanOfCorners(const TriangleMesh& surface, const Eigen::VectorXd& ofVertices);

/// @throws GeometryError when the target was made for a surface with other numbers of faces and vertices
void requireTargetOf(const TriangleMesh& surface, const TargetMeasure& target);

/// Towards the curvature: the density of the measure (1 − α) A / ΣA + α A |k| / Σ A |k| relative to the area
/// @cite su2019remeshing, so that places where the surface bends get more of the map.
/// @param curvature  n numbers of any sign and unit, one per vertex (mean or Gaussian curvature per area)
/// @param weight     α in [0, 1); below 1, so that flat places keep some share
/// @return n densities > 0, mean 1 over the area
/// @throws InvalidArgument when the weight is outside, a curvature is not finite or all are 0; GeometryError when
/// there
///         are not n
[[nodiscard]] Eigen::VectorXd curvatureDensity(const TriangleMesh& surface, const Eigen::VectorXd& curvature,
                                               double weight);

/// A density of 1 everywhere and `factor` on the listed vertices (or faces): a region of interest.
/// @throws InvalidArgument when the factor is not positive and finite, or an index is outside [0, count)
[[nodiscard]] Eigen::VectorXd regionDensity(int count, const std::vector<int>& region, double factor);

}  // namespace authalic
