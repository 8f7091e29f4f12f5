#include "Core/geometry/SurfaceDistance.h"

#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <string>
#include <utility>

#include <Eigen/Dense>

#include "Core/base/Error.h"

namespace authalic {
namespace {

constexpr double kFar = std::numeric_limits<double>::infinity();

/// The distance at a corner of a triangle over whose far side, from a to b, the front comes; infinite when it does not.
/// @param a, b  from the corner to the other two; da, db their distances
double throughFace(const Eigen::Vector3d& a, const Eigen::Vector3d& b, double da, double db) {
  Eigen::Matrix2d gram;
  gram << a.dot(a), a.dot(b), a.dot(b), b.dot(b);
  if (!(gram.determinant() > 1e-12 * gram(0, 0) * gram(1, 1))) return kFar;
  const Eigen::Matrix2d inverse = gram.inverse();
  const Eigen::Vector2d known(da, db), ones(1, 1);
  const double p = ones.dot(inverse * ones), q = ones.dot(inverse * known), r = known.dot(inverse * known) - 1;
  const double discriminant = q * q - p * r;
  if (discriminant < 0) return kFar;
  const double distance = (q + std::sqrt(discriminant)) / p;
  const Eigen::Vector2d backwards = inverse * (known - distance * ones);
  return backwards.maxCoeff() <= 0 ? distance : kFar;
}

class FastMarching {
 public:
  explicit FastMarching(const TriangleMesh& surface)
      : surface_(surface), around_(surface.faces(), surface.vertexCount()),
        distance_(Eigen::VectorXd::Constant(surface.vertexCount(), kFar)),
        done_(static_cast<std::size_t>(surface.vertexCount()), 0) {}

  Eigen::VectorXd from(const std::vector<int>& sources) {
    for (const int source : sources) reach(source, 0);
    while (!front_.empty()) {
      const auto [distance, vertex] = front_.top();
      front_.pop();
      if (done_[static_cast<std::size_t>(vertex)]) continue;
      done_[static_cast<std::size_t>(vertex)] = 1;
      for (int k = around_.first[static_cast<std::size_t>(vertex)];
           k < around_.first[static_cast<std::size_t>(vertex) + 1]; ++k) {
        spread(around_.faces[static_cast<std::size_t>(k)], vertex, distance);
      }
    }
    return std::move(distance_);
  }

 private:
  void reach(int vertex, double distance) {
    if (!(distance < distance_[vertex])) return;
    distance_[vertex] = distance;
    front_.emplace(distance, vertex);
  }

  void spread(int face, int vertex, double distance) {
    const auto corners = surface_.faces().row(face);
    for (int k = 0; k < 3; ++k) {
      const int here = corners[k];
      if (here == vertex || done_[static_cast<std::size_t>(here)]) continue;
      const int third = corners[0] + corners[1] + corners[2] - vertex - here;
      const Eigen::Vector3d place = surface_.point(here), a = surface_.point(vertex) - place;
      reach(here, distance + a.norm());
      if (!done_[static_cast<std::size_t>(third)]) continue;
      reach(here, throughFace(a, surface_.point(third) - place, distance, distance_[third]));
    }
  }

  using Arrival = std::pair<double, int>;
  const TriangleMesh& surface_;
  FacesAroundVertices around_;
  Eigen::VectorXd distance_;
  std::vector<char> done_;
  std::priority_queue<Arrival, std::vector<Arrival>, std::greater<>> front_;
};

}  // namespace

FacesAroundVertices::FacesAroundVertices(const Faces& ofMesh, int vertexCount)
    : first(static_cast<std::size_t>(vertexCount) + 1, 0), faces(static_cast<std::size_t>(ofMesh.size())) {
  for (Eigen::Index k = 0; k < ofMesh.size(); ++k) ++first[static_cast<std::size_t>(ofMesh(k / 3, k % 3)) + 1];
  for (std::size_t v = 1; v < first.size(); ++v) first[v] += first[v - 1];
  std::vector<int> next = first;
  for (Eigen::Index k = 0; k < ofMesh.size(); ++k) {
    faces[static_cast<std::size_t>(next[static_cast<std::size_t>(ofMesh(k / 3, k % 3))]++)] = static_cast<int>(k / 3);
  }
}

Eigen::VectorXd surfaceDistance(const TriangleMesh& surface, const std::vector<int>& sources) {
  for (const int source : sources) {
    if (source >= 0 && source < surface.vertexCount()) continue;
    throw InvalidArgument("Vertices from 0 to " + std::to_string(surface.vertexCount() - 1) +
                          " are required to measure distances from, but one is " + std::to_string(source) + ".");
  }
  return FastMarching(surface).from(sources);
}

}  // namespace authalic
