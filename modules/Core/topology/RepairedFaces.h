/// @file
/// The triangles under repair, with where each comes from and what was done. Private to topology/.
#pragma once

#include <array>
#include <utility>
#include <vector>

#include "Core/topology/SurfaceRepair.h"

namespace authalic {

struct RepairedFace {
  std::array<int, 3> v;
  int original;  ///< face of the input, −1 = new
  int source;    ///< face of the input whose data it takes
};

/// Points and faces of any kind; every step lists its changes.
struct RepairedFaces {
  std::vector<Eigen::Vector3d> points;
  std::vector<int> originalPoint, pointSource;
  std::vector<RepairedFace> faces;
  std::vector<RepairChange> changes;

  RepairedFaces(const Points3& points, const Faces& faces);

  [[nodiscard]] const Eigen::Vector3d& point(int v) const { return points[static_cast<std::size_t>(v)]; }
  [[nodiscard]] std::size_t pointCount() const noexcept { return points.size(); }
  [[nodiscard]] double area(const RepairedFace& face) const;
  [[nodiscard]] Eigen::Vector3d centre(const RepairedFace& face) const;
  [[nodiscard]] Faces faceMatrix() const;
  [[nodiscard]] Points3 pointMatrix() const;

  int copyOf(int vertex);
  void removeFaces(const std::vector<char>& gone);
  void listFace(RepairKind kind, const RepairedFace& face, double size = 0);
  void listVertices(RepairKind kind, const std::vector<int>& vertices, double size = 0);
};

/// Half-edges 3 f + k of one undirected edge.
struct EdgeFaces {
  int a, b;  ///< a < b
  std::vector<int> halfEdges;
};
/// Every edge with its half-edges, sorted by ends.
[[nodiscard]] std::vector<EdgeFaces> edgesOf(const std::vector<RepairedFace>& faces);

/// Disjoint sets 0 … n − 1; the representative is the smallest member.
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t count);
  int find(int a);
  /// Whether the two were apart.
  bool join(int a, int b);

 private:
  std::vector<int> parent_;
};

// The steps, in order.
void removeRepeatedVertices(RepairedFaces& surface);
void removeDuplicates(RepairedFaces& surface);
void sewSeams(RepairedFaces& surface);
/// `byPlace`: edges whose ends have the same coordinates count as one.
void splitAtJunctions(RepairedFaces& surface, double tolerance, bool byPlace);
/// @throws TopologyError when triangles that share no edge with another have more than half of the area
void requireSheets(const RepairedFaces& surface);
void separateSheets(RepairedFaces& surface);
void removeStrays(RepairedFaces& surface, double share);
/// @throws TopologyError when a component is one-sided
void orient(RepairedFaces& surface);
void removeDegenerate(RepairedFaces& surface);
void fillHoles(RepairedFaces& surface, double largest);
void cutHandles(RepairedFaces& surface, double largest, const Execution& execution);

/// Faces around vertices; kept up by whoever adds faces.
using FacesAround = std::vector<std::vector<int>>;
[[nodiscard]] FacesAround facesAround(const RepairedFaces& surface);
/// Adds faces whose half-edges run along the loop in its order. Says whether it could: a triangle that is there already
/// is not filled.
bool fillLoop(RepairedFaces& surface, FacesAround& around, const std::vector<int>& loop);

}  // namespace authalic
