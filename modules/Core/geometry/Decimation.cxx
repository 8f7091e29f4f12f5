#include "Core/geometry/Decimation.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <queue>
#include <string>
#include <utility>
#include <vector>

#include "Core/base/Error.h"
#include "Core/mesh/SurfaceTopology.h"

namespace authalic {

namespace {

// Σ weight (n·x + d)²: xᵀ A x + 2 b·x + c, and the sum of the weights.
struct Quadric {
  Eigen::Matrix3d A = Eigen::Matrix3d::Zero();
  Eigen::Vector3d b = Eigen::Vector3d::Zero();
  double c = 0, weight = 0;

  void addPlane(const Eigen::Vector3d& normal, double d, double w) {
    A += w * normal * normal.transpose();
    b += w * d * normal;
    c += w * d * d;
    weight += w;
  }
  void operator+=(const Quadric& q) {
    A += q.A;
    b += q.b;
    c += q.c;
    weight += q.weight;
  }
  [[nodiscard]] double operator()(const Eigen::Vector3d& x) const { return x.dot(A * x) + 2 * b.dot(x) + c; }
};

struct Candidate {
  double cost;
  int halfEdge;
  unsigned stamp;
  bool operator<(const Candidate& other) const {  // the queue serves the largest: cheapest, then lowest id
    return cost != other.cost ? cost > other.cost : halfEdge > other.halfEdge;
  }
};

// A corner table that collapses edges: half-edge h = 3 f + k runs from corner k of face f to the next.
class Decimation {
 public:
  explicit Decimation(const TriangleMesh& mesh) : faces_(mesh.faces()), faceCount_(mesh.faceCount()) {
    const SurfaceTopology topology(mesh.faces(), mesh.vertexCount());
    requireManifold(topology);
    const auto n = static_cast<std::size_t>(mesh.vertexCount());
    points_.resize(n);
    for (std::size_t v = 0; v < n; ++v) points_[v] = mesh.point(static_cast<int>(v));
    fixed_ = topology.onBoundary();
    opposite_.resize(3 * static_cast<std::size_t>(faceCount_));
    outgoing_.assign(n, -1);
    for (int h = 0; h < 3 * faceCount_; ++h) {
      opposite_[at(h)] = topology.opposite(h);
      outgoing_[at(tail(h))] = h;
    }
    stamp_.assign(opposite_.size(), 0);
    mark_.assign(n, 0);
    gatherQuadrics();
  }

  void run(int targetFaces, const Execution& execution) {
    const int initial = faceCount_;
    fillQueue();
    std::size_t steps = 0;
    while (faceCount_ > targetFaces && !queue_.empty()) {
      const Candidate next = queue_.top();
      queue_.pop();
      if ((++steps & 0xffffu) == 0) {
        execution.throwIfCancelled();
        execution.report(static_cast<double>(initial - faceCount_) / (initial - targetFaces), "decimation");
      }
      if (next.stamp != stamp_[at(next.halfEdge)] || removed(next.halfEdge)) continue;
      const Eigen::Vector3d x = placement(next.halfEdge);
      if (linkAllows(next.halfEdge) && shapeAllows(next.halfEdge, x)) collapse(next.halfEdge, x);
    }
  }

  [[nodiscard]] TriangleMesh result() const {
    std::vector<int> id(points_.size(), -1);
    Points3 points(static_cast<Eigen::Index>(points_.size()), 3);
    Faces faces(faceCount_, 3);
    Eigen::Index vertices = 0, row = 0;
    for (Eigen::Index f = 0; f < faces_.rows(); ++f) {
      if (removed(static_cast<int>(3 * f))) continue;
      for (int k = 0; k < 3; ++k) {
        const std::size_t v = at(faces_(f, k));
        if (id[v] < 0) {
          points.row(vertices) = points_[v].transpose();
          id[v] = static_cast<int>(vertices++);
        }
        faces(row, k) = id[v];
      }
      ++row;
    }
    points.conservativeResize(vertices, 3);
    return TriangleMesh(std::move(points), std::move(faces));
  }

 private:
  static std::size_t at(int index) { return static_cast<std::size_t>(index); }
  static int next(int h) { return SurfaceTopology::next(h); }
  static int previous(int h) { return SurfaceTopology::previous(h); }
  [[nodiscard]] int tail(int h) const { return faces_(h / 3, h % 3); }
  [[nodiscard]] int head(int h) const { return tail(next(h)); }
  [[nodiscard]] bool removed(int h) const { return faces_(h / 3, 0) < 0; }
  [[nodiscard]] int edgeName(int h) const { return std::max(h, opposite_[at(h)]); }

  static void requireManifold(const SurfaceTopology& topology) {
    if (topology.manifold()) return;
    throw TopologyError(
        "A consistently oriented manifold surface is required for decimation, but there are " +
        std::to_string(topology.nonManifoldEdges().size() + topology.inconsistentEdges().size()) +
        " bad edges and " + std::to_string(topology.nonManifoldVertices().size()) +
        " bad vertices; repair the surface first.");
  }

  void gatherQuadrics() {
    quadrics_.resize(points_.size());
    for (Eigen::Index f = 0; f < faces_.rows(); ++f) {
      const Eigen::Vector3d &a = points_[at(faces_(f, 0))], &b = points_[at(faces_(f, 1))],
                            &c = points_[at(faces_(f, 2))];
      const Eigen::Vector3d normal = (b - a).cross(c - a);
      const double twice = normal.norm();
      if (!(twice > 0)) continue;
      const Eigen::Vector3d unit = normal / twice;
      for (int k = 0; k < 3; ++k) quadrics_[at(faces_(f, k))].addPlane(unit, -unit.dot(a), twice / 6);
    }
  }

  // Calls body(half-edge) for the half-edges that leave an interior vertex.
  template <class Body>
  void around(int vertex, const Body& body) const {
    const int first = outgoing_[at(vertex)];
    int h = first;
    do {
      body(h);
      h = opposite_[at(previous(h))];
    } while (h != first);
  }

  [[nodiscard]] Quadric edgeQuadric(int h) const {
    Quadric q = quadrics_[at(tail(h))];
    q += quadrics_[at(head(h))];
    const Eigen::Vector3d middle = 0.5 * (points_[at(tail(h))] + points_[at(head(h))]);
    const double w = 1e-3 * q.weight;
    q.A.diagonal().array() += w;
    q.b -= w * middle;
    q.c += w * middle.squaredNorm();
    return q;
  }

  [[nodiscard]] Eigen::Vector3d placement(int h) const {
    const Quadric q = edgeQuadric(h);
    return q.A.inverse() * -q.b;  // the second term bounds the condition number by 10³
  }

  // The minimum of the edge's quadric plus the spread of the edge itself.
  [[nodiscard]] Candidate candidate(int h) const {
    const Quadric q = edgeQuadric(h);
    const double length2 = (points_[at(tail(h))] - points_[at(head(h))]).squaredNorm();
    const Eigen::Vector3d x = q.A.inverse() * -q.b;
    return {std::max(0.0, q(x)) + 1e-3 * q.weight * length2, h, stamp_[at(h)]};
  }

  void fillQueue() {
    std::vector<Candidate> all;
    for (int h = 0; h < static_cast<int>(opposite_.size()); ++h) {
      if (collapsible(h) && edgeName(h) == h) all.push_back(candidate(h));
    }
    queue_ = std::priority_queue<Candidate>(std::less<Candidate>(), std::move(all));
  }

  [[nodiscard]] bool collapsible(int h) const {
    return opposite_[at(h)] >= 0 && !fixed_[at(tail(h))] && !fixed_[at(head(h))];
  }

  // The ends share exactly the two vertices opposite the edge, and those keep at least three neighbours.
  [[nodiscard]] bool linkAllows(int h) {
    ++marker_;
    around(tail(h), [&](int g) { mark_[at(head(g))] = marker_; });
    int shared = 0;
    around(head(h), [&](int g) { shared += mark_[at(head(g))] == marker_; });
    return shared == 2 && valence(head(next(h))) > 3 && valence(head(next(opposite_[at(h)]))) > 3;
  }

  [[nodiscard]] int valence(int vertex) const {
    if (fixed_[at(vertex)]) return 4;  // a boundary vertex may lose a face: its fan stays a fan
    int count = 0;
    around(vertex, [&](int) { ++count; });
    return count;
  }

  [[nodiscard]] bool shapeAllows(int h, const Eigen::Vector3d& x) const {
    const int f0 = h / 3, f1 = opposite_[at(h)] / 3;
    bool good = x.allFinite();
    const auto check = [&](int g) {
      if (!good || g / 3 == f0 || g / 3 == f1) return;
      const Eigen::Vector3d &p = points_[at(tail(g))], &a = points_[at(head(g))],
                            &b = points_[at(head(next(g)))];
      const Eigen::Vector3d before = (a - p).cross(b - p), after = (a - x).cross(b - x);
      const double twice = after.norm(),
                   sides = (a - x).squaredNorm() + (b - x).squaredNorm() + (a - b).squaredNorm();
      good = after.dot(before) > 0.25 * twice * before.norm() && 2 * std::sqrt(3.0) * twice > 0.15 * sides;
    };
    around(tail(h), check);
    around(head(h), check);
    return good;
  }

  // Glues the two outer edges of the face of h together: a runs from the apex to the head of h, b from its
  // tail to the apex. Both exist, because neither end of h lies on the boundary.
  void closeFace(int h) {
    const int a = opposite_[at(next(h))], b = opposite_[at(previous(h))];
    opposite_[at(a)] = b;
    opposite_[at(b)] = a;
    outgoing_[at(tail(previous(h)))] = a;
    outgoing_[at(tail(h))] = b;
    faces_(h / 3, 0) = -1;
    --faceCount_;
  }

  void collapse(int h, const Eigen::Vector3d& x) {
    const int kept = tail(h), gone = head(h), g = opposite_[at(h)];
    quadrics_[at(kept)] += quadrics_[at(gone)];
    points_[at(kept)] = x;
    std::vector<int>& leaving = scratch_;
    leaving.clear();
    around(gone, [&](int e) { leaving.push_back(e); });
    for (const int e : leaving) faces_(e / 3, e % 3) = kept;
    closeFace(h);
    closeFace(g);
    refresh(kept);
  }

  // New costs for the edges around a vertex that moved.
  void refresh(int vertex) {
    around(vertex, [&](int e) {
      const int name = edgeName(e);
      ++stamp_[at(e)];
      ++stamp_[at(opposite_[at(e)])];
      if (collapsible(name)) queue_.push(candidate(name));
    });
  }

  Faces faces_;
  int faceCount_;
  std::vector<Eigen::Vector3d> points_;
  std::vector<Quadric> quadrics_;
  std::vector<int> opposite_, outgoing_, scratch_;
  std::vector<char> fixed_;
  std::vector<unsigned> stamp_, mark_;
  unsigned marker_ = 0;
  std::priority_queue<Candidate> queue_;
};

}  // namespace

TriangleMesh decimate(const TriangleMesh& mesh, int targetFaces, const Execution& execution) {
  if (targetFaces < 4) {
    throw InvalidArgument("At least 4 faces must be asked of decimation, but the target is " +
                          std::to_string(targetFaces) + ".");
  }
  if (mesh.faceCount() <= targetFaces) return mesh;
  Decimation decimation(mesh);
  decimation.run(targetFaces, execution);
  return decimation.result();
}

}  // namespace authalic
