#include "Core/initial/Unfold.h"

#include <algorithm>

#include "Core/base/Error.h"
#include "Core/geometry/Areas.h"
#include "Core/initial/BarycentricSystem.h"

namespace authalic {
namespace {

constexpr int kMostRings = 32;  // wider patches give way to the whole mesh

std::size_t at(int i) { return static_cast<std::size_t>(i); }

// Marks the vertices within `rings` edges of a marked one.
void grow(const Faces& faces, int rings, std::vector<char>& marked) {
  for (int ring = 0; ring < rings; ++ring) {
    std::vector<char> next = marked;
    for (Eigen::Index f = 0; f < faces.rows(); ++f) {
      if (!marked[at(faces(f, 0))] && !marked[at(faces(f, 1))] && !marked[at(faces(f, 2))]) continue;
      for (int k = 0; k < 3; ++k) next[at(faces(f, k))] = 1;
    }
    marked.swap(next);
  }
}

Eigen::VectorXd areasOf(const Points2& image, const Faces& faces, const Points2& shifts) {
  return shifts.size() == 0 ? signedFaceAreas(image, faces) : periodicFaceAreas(image, shifts, faces);
}

std::vector<char> cornersOfFolds(const Faces& faces, const Eigen::VectorXd& areas, int vertexCount) {
  std::vector<char> marked(at(vertexCount), 0);
  for (Eigen::Index f = 0; f < faces.rows(); ++f) {
    if (areas[f] > 0) continue;
    for (int k = 0; k < 3; ++k) marked[at(faces(f, k))] = 1;
  }
  return marked;
}

// With the image's own mean-value weights; with equal ones where collapsed triangles make those unusable.
void embed(const Faces& faces, const std::vector<char>& held, const Points2& shifts, Points2& image) {
  try {
    solveBarycentric(faces, meanValueWeights(image, faces, shifts), held, SolverBackend::Automatic, image, shifts);
  } catch (const SolverError&) {
    BarycentricSolver(faces, held, SolverBackend::Automatic)
        .solve(HalfEdgeWeights::Constant(faces.rows(), 3, 1.0), image, shifts);
  }
}

}  // namespace

UnfoldResult unfold(const SurfaceTopology& topology, Points2 image, const Execution& execution, UnfoldReach reach,
                    const Points2& shifts) {
  UnfoldResult result{std::move(image), 0, 0, 0};
  const Faces& faces = topology.faces();
  for (int rings = 2;; rings *= 2) {
    const Eigen::VectorXd areas = areasOf(result.image, faces, shifts);
    result.flippedFaces = static_cast<int>(faces.rows() - (areas.array() > 0).count());
    const bool everything = result.movedVertices == topology.vertexCount();
    if (result.flippedFaces == 0 || everything || execution.cancelled()) return result;
    std::vector<char> held = cornersOfFolds(faces, areas, topology.vertexCount());
    grow(faces, rings, held);
    result.movedVertices = static_cast<int>(std::count(held.begin(), held.end(), 1));
    if (rings > kMostRings || 2 * result.movedVertices > topology.vertexCount()) {
      if (reach == UnfoldReach::Patches) return result;
      std::fill(held.begin(), held.end(), 1);
      result.movedVertices = topology.vertexCount();
    }
    for (std::size_t v = 0; v < held.size(); ++v) held[v] = !held[v] || topology.onBoundary()[v];
    embed(faces, held, shifts, result.image);
    ++result.rounds;
  }
}

}  // namespace authalic
