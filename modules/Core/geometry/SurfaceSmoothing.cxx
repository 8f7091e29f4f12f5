#include "Core/geometry/SurfaceSmoothing.h"

#include <Eigen/Geometry>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "Core/base/Error.h"
#include "Core/mesh/SurfaceTopology.h"

namespace authalic {

namespace {

// Neighbours of every vertex in compressed rows; on a closed mesh each is the head of one half-edge of the
// vertex.
struct Neighbours {
  std::vector<int> first, list;
};

Neighbours neighboursOf(const Faces& faces, int vertexCount) {
  Neighbours out;
  out.first.assign(static_cast<std::size_t>(vertexCount) + 1, 0);
  for (Eigen::Index f = 0; f < faces.rows(); ++f) {
    for (int k = 0; k < 3; ++k) ++out.first[static_cast<std::size_t>(faces(f, k)) + 1];
  }
  for (std::size_t v = 1; v < out.first.size(); ++v) out.first[v] += out.first[v - 1];
  out.list.resize(static_cast<std::size_t>(out.first.back()));
  std::vector<int> next(out.first.begin(), out.first.end() - 1);
  for (Eigen::Index f = 0; f < faces.rows(); ++f) {
    for (int k = 0; k < 3; ++k) {
      out.list[static_cast<std::size_t>(next[static_cast<std::size_t>(faces(f, k))]++)] =
          faces(f, (k + 1) % 3);
    }
  }
  return out;
}

void umbrellaStep(const Points3& from, Points3& to, const Neighbours& graph, double factor,
                  const Execution& execution) {
  parallelFor(static_cast<std::size_t>(from.rows()), execution, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      const auto row = static_cast<Eigen::Index>(v);
      const int first = graph.first[v], last = graph.first[v + 1];
      if (first == last) {
        to.row(row) = from.row(row);
        continue;
      }
      Eigen::RowVector3d sum = Eigen::RowVector3d::Zero();
      for (int n = first; n < last; ++n) sum += from.row(graph.list[static_cast<std::size_t>(n)]);
      to.row(row) = (1 - factor) * from.row(row) + factor / (last - first) * sum;
    }
  });
}

Eigen::RowVector3d areaVector(const Points3& x, const Faces& faces, Eigen::Index f) {
  const Eigen::RowVector3d a = x.row(faces(f, 0)), b = x.row(faces(f, 1)), c = x.row(faces(f, 2));
  return 0.5 * (b - a).cross(c - a);
}

double volumeOf(const Points3& x, const Faces& faces) {
  const Eigen::RowVector3d origin = x.colwise().mean();
  double sum = 0;
  for (Eigen::Index f = 0; f < faces.rows(); ++f) {
    sum += areaVector(x, faces, f).dot(x.row(faces(f, 0)) - origin);
  }
  return sum / 3;
}

double areaOf(const Points3& x, const Faces& faces) {
  double sum = 0;
  for (Eigen::Index f = 0; f < faces.rows(); ++f) sum += areaVector(x, faces, f).norm();
  return sum;
}

// Newton on a uniform offset along the vertex normals: dV/dδ = Σ n_v · ∇_v V.
void offsetToVolume(Points3& x, const Faces& faces, double wanted) {
  for (int round = 0; round < 8; ++round) {
    const double error = wanted - volumeOf(x, faces);
    if (std::abs(error) <= 1e-10 * std::abs(wanted)) return;
    Points3 normal = Points3::Zero(x.rows(), 3);
    for (Eigen::Index f = 0; f < faces.rows(); ++f) {
      const Eigen::RowVector3d n = areaVector(x, faces, f) / 3;
      for (int k = 0; k < 3; ++k) normal.row(faces(f, k)) += n;
    }
    double slope = 0;
    for (Eigen::Index v = 0; v < x.rows(); ++v) {
      const double length = normal.row(v).norm();
      slope += length;
      if (length > 0) normal.row(v) /= length;
    }
    if (!(slope > 0)) return;
    x += (error / slope) * normal;
  }
}

void requireClosed(const TriangleMesh& mesh) {
  const SurfaceTopology topology(mesh.faces(), mesh.vertexCount());
  if (topology.manifold() && topology.boundaryLoops().empty()) return;
  throw TopologyError(
      "A closed manifold surface is required for smoothing, but there are " +
      std::to_string(topology.boundaryLoops().size()) + " boundary loops, " +
      std::to_string(topology.nonManifoldEdges().size() + topology.inconsistentEdges().size()) +
      " bad edges and " + std::to_string(topology.nonManifoldVertices().size()) +
      " bad vertices; repair the surface first.");
}

}  // namespace

void SmoothingOptions::validate() const {
  if (iterations < 0 || iterations > 1000) {
    throw InvalidArgument("Smoothing iterations must lie in [0, 1000], but there are " +
                          std::to_string(iterations) + ".");
  }
  if (!(passBand > 0 && passBand < 1)) {
    throw InvalidArgument("The pass band of smoothing must lie in (0, 1), but it is " +
                          std::to_string(passBand) + ".");
  }
}

double enclosedVolume(const TriangleMesh& mesh) {
  return volumeOf(mesh.points(), mesh.faces());
}

SmoothedSurface smoothSurface(const TriangleMesh& mesh, const SmoothingOptions& options,
                              const Execution& execution) {
  options.validate();
  requireClosed(mesh);
  const Faces& faces = mesh.faces();
  SmoothedSurface out;
  out.volumeBefore = volumeOf(mesh.points(), faces);
  out.areaBefore = areaOf(mesh.points(), faces);
  constexpr double lambda = 0.6307;
  const double mu = 1.0 / (options.passBand - 1.0 / lambda);
  const Neighbours graph = neighboursOf(faces, mesh.vertexCount());
  Points3 x = mesh.points(), y(x.rows(), 3);
  for (int i = 0; i < options.iterations; ++i) {
    execution.throwIfCancelled();
    execution.report(static_cast<double>(i) / options.iterations, "smoothing");
    umbrellaStep(x, y, graph, lambda, execution);
    umbrellaStep(y, x, graph, mu, execution);
  }
  if (options.restoreVolume) offsetToVolume(x, faces, out.volumeBefore);
  for (Eigen::Index f = 0; f < faces.rows(); ++f) {
    out.turnedFaces += areaVector(x, faces, f).dot(areaVector(mesh.points(), faces, f)) < 0;
  }
  out.volumeAfter = volumeOf(x, faces);
  out.areaAfter = areaOf(x, faces);
  out.mesh = TriangleMesh(std::move(x), faces);
  return out;
}

}  // namespace authalic
