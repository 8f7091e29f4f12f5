/// @file
/// Making a clean oriented manifold of a broken set of triangles, with a list of everything that was changed.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "Core/base/Execution.h"
#include "Core/base/Status.h"
#include "Core/mesh/MeshReport.h"
#include "Core/mesh/TriangleMesh.h"

namespace authalic {

/// Kinds of change, in the order in which they are made.
enum class RepairKind {
  IsolatedVertex,      ///< removed; ids: the vertex
  DegenerateFace,      ///< removed, collapsed or flipped away; ids: the face
  DuplicateFace,       ///< removed; ids: the face
  Seam,                ///< two boundary edges with the same end points became one edge; ids: the ends of one
  TJunction,           ///< a face was split at a vertex on its boundary edge; ids: the vertex
  NonManifoldEdge,     ///< the faces beyond the two that go on most smoothly were taken apart; ids: its ends
  NonManifoldVertex,   ///< fans of faces that met there got vertices of their own; ids: the vertex
  StrayComponent,      ///< removed; ids: one of its faces; size: mm²
  FlippedFace,         ///< turned to agree with its component; ids: the face
  InsideOutComponent,  ///< closed, all faces turned to face outwards; ids: one of its faces; size: mm²
  Hole,                ///< filled; ids: one of its vertices; size: mm, its length
  Handle,              ///< cut along a loop and capped on both sides; ids: the loop; size: mm, its length
};
inline constexpr int kRepairKinds = 12;

/// "isolated_vertices", "degenerate_faces" …: the name of a kind in reports.
[[nodiscard]] const char* repairKindName(RepairKind kind) noexcept;
/// "3 handles cut and capped": a kind in words.
[[nodiscard]] std::string repairKindWords(RepairKind kind, int count);
/// "(110.3, 167.1, 503.01) mm": a place in words, to five digits.
[[nodiscard]] std::string placeWords(const Eigen::Vector3d& place);

/// One change.
struct RepairChange {
  RepairKind kind = RepairKind::IsolatedVertex;
  std::vector<int> ids;            ///< of the input, as its kind says; without those that the repair made itself
  Eigen::Vector3d place{0, 0, 0};  ///< mm: the vertex, middle of the edge, mean of the vertices of face or loop
  double size = 0;                 ///< mm or mm², as its kind says; else 0
};

/// What counts as a defect.
struct SurfaceRepairOptions {
  /// Whether boundary edges with the same end points (bit for bit) are joined. Off: a surface that was cut open stays
  /// open.
  bool sewSeams = true;
  /// A boundary vertex is a T-junction when it is closer to a boundary edge than this fraction of the edge's length
  /// and a boundary edge leads from it along that edge; in [0, 0.1]. 0 = only exactly on it.
  double junctionTolerance = 1e-4;
  /// Components with less than this fraction of the largest component's area are strays; in [0, 1]. 0 = keep all.
  double strayShare = 0.1;
  /// mm: boundary loops up to this length are holes and are filled; 0 = none, negative = a tenth of √area.
  double largestHole = -1;
  /// mm: handles whose shortest loop is at most this long are cut; 0 = none, negative = all.
  double largestHandle = -1;

  /// @throws InvalidArgument when a number is out of its range or not finite
  void validate() const;
};

/// A repaired surface and what was done to it.
struct SurfaceRepair {
  Status status = Status::NotRun;     ///< Converged: repairing the result changes nothing
  TriangleMesh mesh;
  std::vector<int> originalPointIds;  ///< n': vertex of the input (copies name the same one); −1 = new
  std::vector<int> originalFaceIds;   ///< m': face of the input that it is, or is a part of; −1 = new
  std::vector<int> pointSources;      ///< n': the same, for a new vertex one beside it: where data come from
  std::vector<int> faceSources;       ///< m': the same, for a new face one beside it
  std::vector<RepairChange> changes;  ///< in the order made
  int passes = 0;                     ///< rounds over all kinds, the last of which changed nothing
  MeshReport after;                   ///< of the result: an oriented manifold

  [[nodiscard]] int count(RepairKind kind) const;
  [[nodiscard]] bool changed() const { return !changes.empty(); }
  /// What the result still has that some maps refuse: several components, handles, degenerate faces. Empty = nothing.
  [[nodiscard]] std::string remaining() const;
};

/// Repairs a surface, kind by kind in the order of RepairKind, in rounds until a round changes nothing.
///
/// Handles are found by the shortest loop of edges that does not separate the surface (boundary loops capped), see
/// shortestHandleLoop(); the surface is cut along it, and both sides get a cap, so each cut lowers the genus by one.
/// Which of the two ways round a handle that is (through it or around it) is a matter of length, not of anatomy.
/// Holes and cuts are closed by the triangulation of least weight @cite barequet1995 with the weight
/// (a² + b² + c²)/(4√3) ≥ area of a triangle, without edges that the surface has already; where there is none, by a
/// fan around the mean of the loop.
///
/// Guarantees: the result is an oriented manifold without isolated vertices, duplicate faces and, within the options,
/// strays, holes and handles; every change is listed; points are those of the input, bit for bit, but for centres of
/// fans; vertices and faces that stay keep their order; a clean surface comes back unchanged; when `status` is
/// Converged, repairing the result with the same options changes nothing.
/// Not guaranteed: absence of self-intersections (the two caps of a handle lie on each other), good shapes, and that
/// what is left is one component (see remaining()).
///
/// Single-threaded, deterministic. O(m log m) per round, plus O(k³) per loop of k edges filled, plus a search of the
/// neighbourhood of the homology generators per handle.
///
/// @param points  n×3, mm; may be NaN where no face uses them
/// @param faces   m×3; may repeat a vertex
/// @throws InvalidArgument for bad options; GeometryError for indices out of range, coordinates that are not finite
/// and
///    when no face is left; TopologyError when most triangles meet no other, when the surface is one-sided or could
///         not be made a manifold; CancelledError
[[nodiscard]] SurfaceRepair repairSurface(const Points3& points, const Faces& faces,
                                          const SurfaceRepairOptions& options = {}, const Execution& execution = {});

}  // namespace authalic
