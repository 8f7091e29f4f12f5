#include "Core/topology/LevelSetCut.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "Core/base/Error.h"
#include "Core/geometry/Areas.h"

namespace authalic {
namespace {

using Flags = std::vector<char>;

void requireUsableValues(const TriangleMesh& surface, const Eigen::VectorXd& values, double level) {
  if (values.size() != surface.vertexCount()) {
    throw GeometryError("One value per vertex is required: the surface has " + std::to_string(surface.vertexCount()) +
                        " vertices, but there are " + std::to_string(values.size()) + " values.");
  }
  if (!values.allFinite()) throw GeometryError("Finite values are required to cut along a level set.");
  if (!(values.maxCoeff() > level) || !(values.minCoeff() <= level)) {
    throw GeometryError("A level that the values take is required, but they run from " +
                        std::to_string(values.minCoeff()) + " to " + std::to_string(values.maxCoeff()) +
                        " and the level is " + std::to_string(level) + ".");
  }
}

/// Which connected piece (over edges whose ends have the same flag) each vertex belongs to, and their areas.
struct Pieces {
  std::vector<int> of;
  std::vector<double> area;
};

Pieces piecesOf(const SurfaceTopology& topology, const Flags& flags, const Eigen::VectorXd& stars) {
  std::vector<int> outgoing(flags.size(), -1);
  for (int h = 0; h < 3 * static_cast<int>(topology.faces().rows()); ++h) {
    outgoing[static_cast<std::size_t>(topology.tail(h))] = h;
  }
  Pieces pieces{std::vector<int>(flags.size(), -1), {}};
  for (std::size_t seed = 0; seed < flags.size(); ++seed) {
    if (pieces.of[seed] >= 0) continue;
    const int id = static_cast<int>(pieces.area.size());
    pieces.area.push_back(0);
    std::vector<int> front{static_cast<int>(seed)};
    pieces.of[seed] = id;
    while (!front.empty()) {
      const int at = front.back();
      front.pop_back();
      pieces.area.back() += stars[at];
      const int first = outgoing[static_cast<std::size_t>(at)];
      int h = first;
      do {
        const auto next = static_cast<std::size_t>(topology.head(h));
        if (flags[next] == flags[seed] && pieces.of[next] < 0) {
          pieces.of[next] = id;
          front.push_back(topology.head(h));
        }
        h = topology.opposite(SurfaceTopology::previous(h));
      } while (h != first);
    }
  }
  return pieces;
}

/// The largest piece whose vertices carry the flag.
int largestPiece(const Pieces& pieces, const Flags& flags, char flag) {
  int largest = -1;
  for (std::size_t i = 0; i < flags.size(); ++i) {
    const int id = pieces.of[i];
    if (flags[i] != flag) continue;
    if (largest < 0 || pieces.area[static_cast<std::size_t>(id)] > pieces.area[static_cast<std::size_t>(largest)]) {
      largest = id;
    }
  }
  return largest;
}

/// Leaves two connected sets: of the complement of the largest piece above, the part that holds the largest piece
/// below, and the rest. Returns how many pieces were merged.
int keepTwoPieces(const SurfaceTopology& topology, const Eigen::VectorXd& stars, Flags& above) {
  const Pieces pieces = piecesOf(topology, above, stars);
  if (pieces.area.size() == 2) return 0;
  const int top = largestPiece(pieces, above, 1), bottom = largestPiece(pieces, above, 0);
  Flags inTop(above.size());
  for (std::size_t i = 0; i < above.size(); ++i) inTop[i] = pieces.of[i] == top;
  const Pieces parts = piecesOf(topology, inTop, stars);
  int kept = -1;
  for (std::size_t i = 0; i < above.size(); ++i) {
    if (pieces.of[i] == bottom) kept = parts.of[i];
  }
  for (std::size_t i = 0; i < above.size(); ++i) above[i] = parts.of[i] != kept;
  return static_cast<int>(pieces.area.size()) - 2;
}

/// The crossed half-edges that lead from above to below, in the order in which the seam visits them.
std::vector<int> traceSeam(const SurfaceTopology& topology, const Flags& above) {
  const auto crosses = [&](int h, char from) {
    return above[static_cast<std::size_t>(topology.tail(h))] == from &&
           above[static_cast<std::size_t>(topology.head(h))] != from;
  };
  int first = 0;
  while (!crosses(first, 1)) ++first;
  std::vector<int> seam;
  int h = first;
  do {
    seam.push_back(h);
    do {
      h = SurfaceTopology::next(h);
    } while (!crosses(h, 0));
    h = topology.opposite(h);
  } while (h != first);
  return seam;
}

double leastAngle(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
  const auto angle = [](const Eigen::Vector3d& p, const Eigen::Vector3d& q) {
    return std::atan2(p.cross(q).norm(), p.dot(q));
  };
  return std::min({angle(b - a, c - a), angle(c - b, a - b), angle(a - c, b - c)});
}

/// Collects one half: original vertices in order, then the seam points.
class HalfBuilder {
 public:
  HalfBuilder(const TriangleMesh& surface, const Flags& above, char flag, const Points3& seamPoints)
      : numbers_(above.size(), -1) {
    for (std::size_t i = 0; i < above.size(); ++i) {
      if (above[i] != flag) continue;
      numbers_[i] = static_cast<int>(ids_.size());
      ids_.push_back(static_cast<int>(i));
    }
    seamStart_ = static_cast<int>(ids_.size());
    points_.resize(seamStart_ + seamPoints.rows(), 3);
    for (int i = 0; i < seamStart_; ++i) points_.row(i) = surface.points().row(ids_[static_cast<std::size_t>(i)]);
    points_.bottomRows(seamPoints.rows()) = seamPoints;
    ids_.resize(static_cast<std::size_t>(points_.rows()), -1);
  }

  [[nodiscard]] int vertex(int original) const { return numbers_[static_cast<std::size_t>(original)]; }
  [[nodiscard]] int seamPoint(int k) const { return seamStart_ + k; }
  void add(int a, int b, int c, int face) {
    faces_.push_back({a, b, c});
    faceIds_.push_back(face);
  }
  /// The quadrangle a, b, c, d split by the diagonal with the larger least angle.
  void add(int a, int b, int c, int d, int face) {
    const Eigen::Vector3d pa = points_.row(a), pb = points_.row(b), pc = points_.row(c), pd = points_.row(d);
    const double first = std::min(leastAngle(pa, pb, pc), leastAngle(pa, pc, pd));
    if (first >= std::min(leastAngle(pb, pc, pd), leastAngle(pb, pd, pa))) {
      add(a, b, c, face);
      add(a, c, d, face);
    } else {
      add(b, c, d, face);
      add(b, d, a, face);
    }
  }
  [[nodiscard]] CutHalf finish() {
    Faces faces(static_cast<Eigen::Index>(faces_.size()), 3);
    for (std::size_t f = 0; f < faces_.size(); ++f) {
      faces.row(static_cast<Eigen::Index>(f)) << faces_[f][0], faces_[f][1], faces_[f][2];
    }
    TriangleMesh mesh(std::move(points_), std::move(faces));
    const double area = faceAreas(mesh).sum();
    return {DiskMesh(std::move(mesh)), std::move(ids_), std::move(faceIds_), seamStart_, area};
  }

 private:
  std::vector<int> numbers_, ids_, faceIds_;
  Points3 points_;
  std::vector<std::array<int, 3>> faces_;
  int seamStart_ = 0;
};

void distributeFaces(const SurfaceTopology& topology, const Flags& above, const std::vector<int>& seam,
                     HalfBuilder& top, HalfBuilder& bottom) {
  std::vector<int> crossing(static_cast<std::size_t>(3 * topology.faces().rows()), -1);
  for (std::size_t k = 0; k < seam.size(); ++k) {
    crossing[static_cast<std::size_t>(seam[k])] = static_cast<int>(k);
    crossing[static_cast<std::size_t>(topology.opposite(seam[k]))] = static_cast<int>(k);
  }
  for (int f = 0; f < static_cast<int>(topology.faces().rows()); ++f) {
    int apex = -1;  // the corner that is alone on its side
    for (int k = 0; k < 3; ++k) {
      const int h = 3 * f + k;
      if (crossing[static_cast<std::size_t>(h)] >= 0 &&
          crossing[static_cast<std::size_t>(SurfaceTopology::previous(h))] >= 0) {
        apex = h;
      }
    }
    if (apex < 0) {
      HalfBuilder& half = above[static_cast<std::size_t>(topology.tail(3 * f))] ? top : bottom;
      half.add(half.vertex(topology.tail(3 * f)), half.vertex(topology.tail(3 * f + 1)),
               half.vertex(topology.tail(3 * f + 2)), f);
      continue;
    }
    const int a = topology.tail(apex), b = topology.head(apex), c = topology.tail(SurfaceTopology::previous(apex));
    const int p = crossing[static_cast<std::size_t>(apex)],
              q = crossing[static_cast<std::size_t>(SurfaceTopology::previous(apex))];
    HalfBuilder &small = above[static_cast<std::size_t>(a)] ? top : bottom,
                &large = above[static_cast<std::size_t>(a)] ? bottom : top;
    small.add(small.vertex(a), small.seamPoint(p), small.seamPoint(q), f);
    large.add(large.seamPoint(p), large.vertex(b), large.vertex(c), large.seamPoint(q), f);
  }
}

}  // namespace

void LevelSetCutOptions::validate() const {
  if (!std::isfinite(level) || !(clearance > 0 && clearance <= 0.5)) {
    throw InvalidArgument("A finite level and a clearance above 0 and at most 0.5 are required, but the level is " +
                          std::to_string(level) + " and the clearance " + std::to_string(clearance) + ".");
  }
}

LevelSetCutResult levelSetCut(const SphereMesh& surface, const Eigen::VectorXd& values,
                              const LevelSetCutOptions& options, const Execution& execution) {
  options.validate();
  const TriangleMesh& mesh = surface.mesh();
  requireUsableValues(mesh, values, options.level);
  execution.report(0, "cut");
  Flags above(static_cast<std::size_t>(values.size()));
  for (Eigen::Index i = 0; i < values.size(); ++i) above[static_cast<std::size_t>(i)] = values[i] > options.level;
  const int merged =
      keepTwoPieces(surface.topology(), vertexStars(faceAreas(mesh), mesh.faces(), mesh.vertexCount()), above);
  const std::vector<int> halfEdges = traceSeam(surface.topology(), above);
  std::vector<SeamPoint> seam(halfEdges.size());
  Points3 points(static_cast<Eigen::Index>(seam.size()), 3);
  for (std::size_t k = 0; k < seam.size(); ++k) {
    SeamPoint& point = seam[k];
    point.above = surface.topology().tail(halfEdges[k]);
    point.below = surface.topology().head(halfEdges[k]);
    point.parameter = std::clamp((values[point.above] - options.level) / (values[point.above] - values[point.below]),
                                 options.clearance, 1 - options.clearance);
    points.row(static_cast<Eigen::Index>(k)) = (1 - point.parameter) * mesh.points().row(point.above) +
                                               point.parameter * mesh.points().row(point.below);
  }
  double length = 0;
  for (Eigen::Index k = 0; k < points.rows(); ++k) {
    length += (points.row((k + 1) % points.rows()) - points.row(k)).norm();
  }
  HalfBuilder top(mesh, above, 1, points), bottom(mesh, above, 0, points);
  distributeFaces(surface.topology(), above, halfEdges, top, bottom);
  execution.throwIfCancelled();
  LevelSetCutResult result{top.finish(), bottom.finish(), std::move(seam), length, merged};
  execution.report(1, "cut");
  return result;
}

}  // namespace authalic
