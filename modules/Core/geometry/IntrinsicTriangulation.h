/// @file
/// A triangulation that knows edge lengths instead of points, and whose edges can be flipped.
#pragma once

#include <Eigen/Core>

#include <vector>

#include "Core/base/Execution.h"
#include "Core/mesh/SurfaceTopology.h"
#include "Core/mesh/TriangleMesh.h"

namespace authalic {

/// Three numbers per face; entry k belongs to the edge from corner k to corner k+1.
using FaceLengths = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;

/// Corner angles of a face with one more thing a solver needs.
struct FaceShape {
  double angle[3];      ///< at the corner *opposite* to each of its half-edges, radians; π, 0, 0 where no triangle
                        ///< has
                        ///< such sides
  double cotangent[3];  ///< of these angles; 0 where no triangle has such sides
  bool triangle;        ///< whether the three lengths are the sides of a triangle
};

/// Which rule gives the length of a flipped edge.
enum class FlipRule {
  Ptolemy,   ///< l_kl = (l_ik l_jl + l_il l_jk) / l_ij: keeps the discrete conformal class, needs no triangle
             ///< inequality @cite springborn2020
  Euclidean  ///< the distance in the unfolded pair of triangles: keeps the metric
};

/// How the tracked edges run through a face, seen from one of its half-edges h = ij with the corner k opposite:
/// first along h from i come those around corner i, then those from k, then those around j.
struct FaceCrossings {
  int aroundTail = 0, fromApex = 0, aroundHead = 0;
};

/// Half-edges with the natural logarithms λ of their lengths. Edges may join a vertex to itself and several edges
/// may join the same two vertices (a Δ-complex): no face list can say that, half-edges can.
///
/// Half-edge h runs from tail(h) to head(h) on the boundary of one face; next(next(next(h))) = h. Ids of
/// half-edges and faces survive flips; at the start half-edge 3 f + k runs from corner k to corner k+1 of face f,
/// as in SurfaceTopology.
///
/// **Scaling.** A vertex function u scales to λ_ij + (u_i + u_j)/2: the discrete conformal change of
/// @cite luo2004. The stored λ are those of u = 0; every question about shape takes u. Ptolemy's rule commutes
/// with scaling, so a triangulation that was flipped at one u is as good at any other, and the discrete conformal
/// class never changes.
class IntrinsicTriangulation {
 public:
  IntrinsicTriangulation() = default;
  /// Edge lengths of a surface in space.
  /// @throws GeometryError naming the first edge without length
  IntrinsicTriangulation(const TriangleMesh& surface, const SurfaceTopology& topology);
  /// Given edge lengths; the two entries of an inner edge must be equal. No triangle inequality is asked for.
  /// @throws GeometryError naming the first edge whose length is not positive, not finite, or differs between its
  ///         faces
  IntrinsicTriangulation(const SurfaceTopology& topology, const FaceLengths& lengths);

  [[nodiscard]] int vertexCount() const noexcept { return vertexCount_; }
  [[nodiscard]] int faceCount() const noexcept { return static_cast<int>(first_.size()); }
  [[nodiscard]] int halfEdgeCount() const noexcept { return static_cast<int>(next_.size()); }
  [[nodiscard]] int tail(int h) const { return tail_[static_cast<std::size_t>(h)]; }
  [[nodiscard]] int head(int h) const { return tail(next(h)); }
  [[nodiscard]] int next(int h) const { return next_[static_cast<std::size_t>(h)]; }
  [[nodiscard]] int previous(int h) const { return next(next(h)); }
  /// The half-edge that runs the other way, −1 on the boundary.
  [[nodiscard]] int opposite(int h) const { return opposite_[static_cast<std::size_t>(h)]; }
  [[nodiscard]] int face(int h) const { return face_[static_cast<std::size_t>(h)]; }
  /// One half-edge of a face.
  [[nodiscard]] int first(int face) const { return first_[static_cast<std::size_t>(face)]; }
  /// Vertices of a face, from tail(first(face)).
  [[nodiscard]] Faces faces() const;
  [[nodiscard]] const std::vector<char>& onBoundary() const noexcept { return onBoundary_; }

  /// λ at u = 0.
  [[nodiscard]] double logLength(int h) const { return logLength_[static_cast<std::size_t>(h)]; }
  /// λ_ij + (u_i + u_j)/2.
  [[nodiscard]] double logLength(int h, const Eigen::VectorXd& u) const {
    return logLength(h) + 0.5 * (u[tail(h)] + u[head(h)]);
  }

  /// Replace the λ of u = 0 of an edge, on both of its sides.
  void setLogLength(int h, double logLength);

  /// Angles and cotangents of face f, in the order first, next, previous.
  [[nodiscard]] FaceShape shape(int face, const Eigen::VectorXd& u) const;
  /// The cosine opposite to h as a rational function of the lengths, also where no triangle has such sides.
  [[nodiscard]] double oppositeCosine(int h, const Eigen::VectorXd& u) const;
  /// Whether the edge is on the boundary or cot α + cot β ≥ 0, but for rounding, for the angles opposite to it;
  /// where a face is no triangle, cos α + cos β ≥ 0 for the rational cosines.
  [[nodiscard]] bool isDelaunay(int h, const Eigen::VectorXd& u) const;
  /// Whether flip(h) makes sense: an inner edge with two different faces.
  [[nodiscard]] bool flippable(int h) const;

  /// Replace the diagonal ij of a pair of triangles by the other, kl. With the Euclidean rule the length is
  /// measured at u and brought back to u = 0. Afterwards h runs from l to k. Needs flippable(h).
  void flip(int h, const Eigen::VectorXd& u, FlipRule rule = FlipRule::Ptolemy);

  /// Flip inner edges until all are Delaunay at u. Without boundary every face then is a triangle, whatever λ and
  /// u @cite springborn2020. Edges are taken first in, first out: same input, same flips.
  /// @return number of flips
  /// @throws SolverError when flips do not end (lengths beyond the range of double)
  int makeDelaunay(const Eigen::VectorXd& u, FlipRule rule = FlipRule::Ptolemy, const Execution& execution = {});

  /// Split the boundary edge of h at the foot of its face's altitude at u, so that both parts see acute angles.
  /// The metric at u does not change; the new vertex is the last one, its u is to be (u_i + u_j)/2. Afterwards h
  /// ends at it. Needs a boundary edge whose face is a triangle at u with acute angles at both ends of the edge.
  /// @return the new vertex
  int splitBoundaryEdge(int h, const Eigen::VectorXd& u);

  /// From now on remember every flip, so that they can be undone on something else; boundary edges must not be split.
  void recordFlips() {
    recording_ = true;
    flips_.clear();
  }
  /// Half-edges that were flipped, in order.
  [[nodiscard]] const std::vector<int>& recordedFlips() const noexcept { return flips_; }

  /// From now on count how often each edge crosses the edges of the triangulation as it is now: normal coordinates
  /// @cite gillespie2021. Integers, carried through flips of either kind without rounding.
  void trackCrossings();
  /// Crossings of the edge with tracked edges; −1 when it *is* one of them, or when nothing is tracked.
  [[nodiscard]] int crossings(int h) const {
    return crossings_.empty() ? -1 : crossings_[static_cast<std::size_t>(h)];
  }

  /// How tracked edges cross h inside its face.
  [[nodiscard]] FaceCrossings faceCrossings(int h) const;

  /// Attach an integer to every half-edge with w_(opposite) = −w and Σ w = 0 around each face (a closed 1-form:
  /// how often a path along the edge winds around a hole). Flips carry it along.
  /// @throws InvalidArgument when the numbers are not such a form
  void attachWinding(std::vector<int> winding);
  /// The attached integer, 0 when there is none.
  [[nodiscard]] int winding(int h) const { return winding_.empty() ? 0 : winding_[static_cast<std::size_t>(h)]; }

 private:
  void connect(const SurfaceTopology& topology);
  [[nodiscard]] int flippedCrossings(int h) const;
  [[nodiscard]] double flippedLogLength(int h, const Eigen::VectorXd& u, FlipRule rule) const;

  int vertexCount_ = 0;
  std::vector<int> tail_, next_, opposite_, face_, first_;
  std::vector<double> logLength_;
  std::vector<int> winding_, crossings_, flips_;
  bool recording_ = false;
  std::vector<char> onBoundary_;
};

}  // namespace authalic
