#include "Core/authalic/Unfold.h"

#include "Core/geometry/Areas.h"
#include "Core/numerics/ElementAssembly.h"
#include "Core/numerics/SparseSolver.h"

namespace authalic {
namespace {

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

std::vector<char> cornersOfFolds(const Faces& faces, const Points2& image) {
  const Eigen::VectorXd areas = signedFaceAreas(image, faces);
  std::vector<char> marked(static_cast<std::size_t>(image.rows()), 0);
  for (Eigen::Index f = 0; f < faces.rows(); ++f) {
    if (areas[f] > 0) continue;
    for (int k = 0; k < 3; ++k) marked[at(faces(f, k))] = 1;
  }
  return marked;
}

// Puts every marked inner vertex at the mean of its neighbours; returns how many there are.
int embedPatches(const SurfaceTopology& topology, const std::vector<char>& marked, Points2& image) {
  const Faces& faces = topology.faces();
  std::vector<int> unknown(marked.size(), -1), vertices;
  for (std::size_t v = 0; v < marked.size(); ++v) {
    if (!marked[v] || topology.onBoundary()[v]) continue;
    unknown[v] = static_cast<int>(vertices.size());
    vertices.push_back(static_cast<int>(v));
  }
  ElementAssembly::Unknowns elements(faces.rows(), 3);
  Eigen::Index count = 0;
  Eigen::MatrixXd b = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(vertices.size()), 2);
  for (Eigen::Index f = 0; f < faces.rows(); ++f) {
    const Eigen::Vector3i u(unknown[at(faces(f, 0))], unknown[at(faces(f, 1))], unknown[at(faces(f, 2))]);
    if (u.maxCoeff() < 0) continue;
    elements.row(count++) = u.transpose();
    for (int k = 0; k < 3; ++k) {
      for (const int l : {(k + 1) % 3, (k + 2) % 3}) {
        if (u[k] >= 0 && u[l] < 0) b.row(u[k]) += 0.5 * image.row(faces(f, l));
      }
    }
  }
  ElementAssembly assembly(static_cast<int>(vertices.size()), elements.topRows(count));
  std::vector<double> values;
  for (Eigen::Index e = 0; e < count; ++e) values.insert(values.end(), {1, -0.5, -0.5, 1, -0.5, 1});
  SparseSolver solver;
  solver.compute(assembly.assemble(values));
  const Eigen::MatrixXd x = solver.solve(b);
  for (std::size_t k = 0; k < vertices.size(); ++k) image.row(vertices[k]) = x.row(static_cast<Eigen::Index>(k));
  return static_cast<int>(vertices.size());
}

}  // namespace

UnfoldResult unfold(const SurfaceTopology& topology, Points2 image, const Execution& execution) {
  UnfoldResult result{std::move(image), 0, 0, 0};
  std::vector<char> patch(static_cast<std::size_t>(result.image.rows()), 0);
  std::size_t covered = 0;
  for (int rings = 1;; rings *= 2) {
    std::vector<char> folds = cornersOfFolds(topology.faces(), result.image);
    result.flippedFaces = countFlippedFaces(result.image, topology.faces());
    if (result.flippedFaces == 0 || covered == patch.size() || execution.cancelled()) return result;
    grow(topology.faces(), rings, folds);
    covered = 0;
    for (std::size_t v = 0; v < patch.size(); ++v) {
      patch[v] = folds[v];
      covered += patch[v] ? 1 : 0;
    }
    result.movedVertices += embedPatches(topology, patch, result.image);
    ++result.rounds;
  }
}

}  // namespace authalic
