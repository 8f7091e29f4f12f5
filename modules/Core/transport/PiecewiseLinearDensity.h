/// @file
/// Densities of a planar domain that are linear in every triangle of a mesh: the source measure of a transport.
#pragma once

#include <Eigen/Core>

#include <array>
#include <vector>

#include "Core/geometry/PlanarDomain.h"
#include "Core/mesh/DiskMesh.h"

namespace authalic {

/// value + ⟨gradient, x − anchor⟩.
struct LinearFunction {
  Eigen::Vector2d anchor, gradient;
  double value;

  [[nodiscard]] double at(const Eigen::Vector2d& x) const { return value + gradient.dot(x - anchor); }
};

/// What lies on one side of a line: ⟨normal, x − point⟩ ≥ 0, with a normal of length 1.
struct HalfPlane {
  Eigen::Vector2d point, normal;

  [[nodiscard]] double depth(const Eigen::Vector2d& x) const { return normal.dot(x - point); }
};

/// A triangle, or what lies beyond a side of the boundary of the mesh.
struct DensityPiece {
  LinearFunction density;
  std::array<HalfPlane, 3> sides;  ///< the piece is their intersection
  std::array<int, 3> beyond;       ///< piece on the other side of each; −1 when there is none
};

/// A density ρ > 0 of the unit disk or a convex polygon Ω, linear in every triangle of a planar mesh that covers Ω.
///
/// Where Ω reaches beyond the mesh, between a chord of the boundary and the circle, the linear function of the
/// triangle at the chord is continued, up to the rays from the middle of Ω through the ends of the chord: Ω is divided
/// into triangles and such slivers, without a gap. The mesh may be larger than Ω.
class PiecewiseLinearDensity {
 public:
  /// @param domain  Ω
  /// @param mesh    in a plane z = constant, all triangles turned the same way; vertices of its boundary lie on that
  ///                of Ω or outside, to 1e-6 of the size of Ω, and its sides run outside or are chords of the circle
  /// @param values  n, ρ at its vertices, > 0; of any scale
  /// @throws InvalidArgument when the domain is not convex, or a value is not positive and finite
  /// @throws GeometryError when there is not one value per vertex, the mesh is not planar, a triangle is folded or has
  ///         no area (it is named), the mesh does not cover Ω (a place is named), or ρ is not positive in a sliver
  /// Complexity O(m).
  PiecewiseLinearDensity(const PlanarDomain& domain, const DiskMesh& mesh, const Eigen::VectorXd& values);

  [[nodiscard]] const PlanarDomain& domain() const noexcept { return domain_; }
  /// ∫ ρ over Ω.
  [[nodiscard]] double total() const noexcept { return total_; }

  [[nodiscard]] const std::vector<DensityPiece>& pieces() const noexcept { return pieces_; }
  /// A piece that holds a point of Ω: a walk from a piece near it, O(1) in meshes of even resolution.
  [[nodiscard]] int pieceAt(const Eigen::Vector2d& point) const;

 private:
  void requireVertices(const SurfaceTopology& topology, const Points2& points) const;
  void requireCorners() const;
  [[noreturn]] void refuseGapAt(const Eigen::Vector2d& place) const;
  void addTriangles(const SurfaceTopology& topology, const Points2& points, const Eigen::VectorXd& values);
  void addSlivers(const SurfaceTopology& topology, const Points2& points);
  void integrate();
  void placeHints();
  bool walk(const Eigen::Vector2d& point, int& piece) const;
  [[nodiscard]] std::size_t hintOf(const Eigen::Vector2d& point) const;

  PlanarDomain domain_;
  std::vector<DensityPiece> pieces_;  // triangles, then slivers in the order of the boundary
  int triangles_ = 0;
  double total_ = 0;
  Eigen::Vector2d low_, step_;  // of the grid of hints
  int resolution_ = 1;
  std::vector<int> hints_;      // a piece near the middle of each cell
};

}  // namespace authalic
