#include "Core/geometry/CommonRefinement.h"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "Core/base/Error.h"
#include "Core/geometry/Areas.h"

namespace authalic {
namespace {

std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

double cross(const Eigen::RowVector2d& a, const Eigen::RowVector2d& b) {
  return a[0] * b[1] - a[1] * b[0];
}

// Parameters in order and apart from each other; evenly spaced ones where they are not.
void settle(std::vector<double>& parameters) {
  const double count = static_cast<double>(parameters.size()), gap = 1e-3 / (count + 1);
  double last = 0;
  bool fine = true;
  for (const double p : parameters) {
    fine = fine && p >= last + gap && p <= 1 - gap;
    last = p;
  }
  for (std::size_t k = 0; !fine && k < parameters.size(); ++k)
    parameters[k] = static_cast<double>(k + 1) / (count + 1);
}

class Refinement {
 public:
  Refinement(const TriangleMesh& surface, const SurfaceTopology& topology,
             const IntrinsicTriangulation& flipped, const Points2& image)
      : surface_(surface),
        topology_(topology),
        flipped_(flipped),
        image_(image),
        first_(at(flipped.halfEdgeCount()), -1) {}

  CommonRefinement run();

 private:
  /// A crossing of a flipped edge, seen from one of its half-edges.
  struct Crossing {
    int halfEdge, index;
  };

  void numberCrossings();
  [[nodiscard]] int id(const Crossing& c) const;
  [[nodiscard]] Crossing across(const Crossing& c) const;
  void traceFrom(int h);
  void trace(int apex, Crossing start);
  void placeOnFlippedEdges();
  [[nodiscard]] int halfEdgeOf(int tail, int head) const;
  void emit(std::vector<int> cell, int face);
  [[nodiscard]] int faceBeside(int one, int other) const;
  void cutFace(int h);
  void cutCorner(int h);
  void cutMiddle(int h);

  const TriangleMesh& surface_;
  const SurfaceTopology& topology_;
  const IntrinsicTriangulation& flipped_;
  const Points2& image_;
  std::vector<int> first_;  // per half-edge: id of the crossing next to its tail (one per edge)
  std::map<std::pair<int, int>, int> halfEdges_;  // of the surface, by its ends
  std::vector<std::array<int, 2>> ends_;          // of the surface's edge, per crossing
  std::vector<double> onSurface_,
      onFlipped_;              // per crossing: parameter along the surface's edge; along the flipped one
  std::vector<int> vertices_;  // of the flipped edge per crossing: its stored half-edge
  std::vector<Eigen::RowVector3i> faces_;
  std::vector<int> faceIds_;
};

void Refinement::numberCrossings() {
  int next = surface_.vertexCount();
  for (int h = 0; h < flipped_.halfEdgeCount(); ++h) {
    if (flipped_.opposite(h) > h || flipped_.crossings(h) <= 0) continue;
    first_[at(h)] = next;
    next += flipped_.crossings(h);
    vertices_.insert(vertices_.end(), at(flipped_.crossings(h)), h);
  }
  ends_.assign(vertices_.size(), {-1, -1});
  onSurface_.assign(vertices_.size(), 0.0);
  onFlipped_.assign(vertices_.size(), 0.0);
}

Refinement::Crossing Refinement::across(const Crossing& c) const {
  return {flipped_.opposite(c.halfEdge), flipped_.crossings(c.halfEdge) - 1 - c.index};
}

int Refinement::id(const Crossing& c) const {
  const Crossing other = first_[at(c.halfEdge)] >= 0 ? c : across(c);
  return first_[at(other.halfEdge)] + other.index;
}

// Follow an edge of the surface from a corner of the flipped triangulation to its other end.
void Refinement::trace(int apex, Crossing start) {
  std::vector<int> passed;
  int end = -1;
  for (Crossing at_ = start; end < 0;) {
    passed.push_back(id(at_));
    const Crossing in = across(at_);
    const FaceCrossings c = flipped_.faceCrossings(in.halfEdge);
    const int count = flipped_.crossings(in.halfEdge), previous = flipped_.previous(in.halfEdge);
    if (in.index < c.aroundTail) {
      at_ = {previous, flipped_.crossings(previous) - 1 - in.index};
    } else if (in.index < c.aroundTail + c.fromApex) {
      end = flipped_.tail(previous);
    } else {
      at_ = {flipped_.next(in.halfEdge), count - 1 - in.index};
    }
  }
  if (apex > end) return;  // it is found from its other end, too
  const Eigen::RowVector2d from = image_.row(apex), along = image_.row(end) - from;
  std::vector<double> parameters;
  for (const int crossing : passed) {
    const int h = vertices_[at(crossing - surface_.vertexCount())];
    const Eigen::RowVector2d p = image_.row(flipped_.tail(h)), edge = image_.row(flipped_.head(h)) - p;
    const double sine = cross(along, edge);
    parameters.push_back(sine != 0 ? cross(p - from, edge) / sine : -1);
    onFlipped_[at(crossing - surface_.vertexCount())] = sine != 0 ? cross(p - from, along) / sine : -1;
  }
  settle(parameters);
  for (std::size_t k = 0; k < passed.size(); ++k) {
    ends_[at(passed[k] - surface_.vertexCount())] = {apex, end};
    onSurface_[at(passed[k] - surface_.vertexCount())] = parameters[k];
  }
}

void Refinement::traceFrom(int h) {
  if (flipped_.opposite(h) < 0 || flipped_.crossings(h) <= 0) return;
  const FaceCrossings c = flipped_.faceCrossings(h);
  for (int k = 0; k < c.fromApex; ++k) trace(flipped_.tail(flipped_.previous(h)), {h, c.aroundTail + k});
}

void Refinement::placeOnFlippedEdges() {
  for (int h = 0; h < flipped_.halfEdgeCount(); ++h) {
    if (first_[at(h)] < 0) continue;
    const auto begin = onFlipped_.begin() + (first_[at(h)] - surface_.vertexCount());
    std::vector<double> parameters(begin, begin + flipped_.crossings(h));
    settle(parameters);
    std::copy(parameters.begin(), parameters.end(), begin);
  }
}

int Refinement::halfEdgeOf(int tail, int head) const {
  const auto found = halfEdges_.find({tail, head});
  return found == halfEdges_.end() ? -1 : found->second;
}

// The face of the surface to the left of the piece of its edge from one point to the other; −1 when it is no
// such piece.
int Refinement::faceBeside(int one, int other) const {
  const int n = surface_.vertexCount();
  const auto edgeOf = [&](int point, int partner) -> std::array<int, 2> {
    return point >= n     ? ends_[at(point - n)]
           : partner >= n ? ends_[at(partner - n)]
                          : std::array<int, 2>{point, partner};
  };
  std::array<int, 2> edge = edgeOf(one, other);
  const auto place = [&](int point) {
    if (point >= n) return ends_[at(point - n)] == edge ? onSurface_[at(point - n)] : -1.0;
    return point == edge[0] ? 0.0 : point == edge[1] ? 1.0 : -1.0;
  };
  const double a = place(one), b = place(other);
  if (a < 0 || b < 0) return -1;
  const int h = a < b ? halfEdgeOf(edge[0], edge[1]) : halfEdgeOf(edge[1], edge[0]);
  return h < 0 ? -1 : h / 3;
}

// A convex cell, counter-clockwise, as a fan. One of its sides is a piece of an edge of the surface and names
// the face.
void Refinement::emit(std::vector<int> cell, int face) {
  cell.erase(std::unique(cell.begin(), cell.end()), cell.end());
  while (cell.size() > 1 && cell.front() == cell.back()) cell.pop_back();
  for (std::size_t k = 0; k < cell.size() && face < 0; ++k)
    face = faceBeside(cell[k], cell[(k + 1) % cell.size()]);
  for (std::size_t k = 2; k < cell.size(); ++k) {
    faces_.push_back({cell[0], cell[k - 1], cell[k]});
    faceIds_.push_back(face);
  }
}

// Slices around the corner at the tail of h.
void Refinement::cutCorner(int h) {
  const int previous = flipped_.previous(h), count = flipped_.faceCrossings(h).aroundTail;
  int below = flipped_.tail(h), above = below;
  for (int k = 0; k < count; ++k) {
    const int on = id({h, k}), off = id({previous, flipped_.crossings(previous) - 1 - k});
    emit({below, on, off, above}, -1);
    below = on;
    above = off;
  }
}

// What is left between the corners; where edges run from the corner opposite to h over h, in slices.
void Refinement::cutMiddle(int h) {
  const auto last = [this](int half,
                           bool towardsHead) {  // the innermost crossing around an end of a half-edge
    const FaceCrossings c = flipped_.faceCrossings(half);
    if (towardsHead)
      return c.aroundHead > 0 ? id({half, flipped_.crossings(half) - c.aroundHead}) : flipped_.head(half);
    return c.aroundTail > 0 ? id({half, c.aroundTail - 1}) : flipped_.tail(half);
  };
  const int next = flipped_.next(h), previous = flipped_.previous(h), apex = flipped_.tail(previous);
  const FaceCrossings c = flipped_.faceCrossings(h);
  if (c.fromApex == 0) {
    emit({last(h, false), last(h, true), last(next, false), last(next, true), last(previous, false),
          last(previous, true)},
         -1);
    return;
  }
  emit({apex, last(previous, true), last(h, false), id({h, c.aroundTail})}, -1);
  for (int k = 1; k < c.fromApex; ++k)
    emit({apex, id({h, c.aroundTail + k - 1}), id({h, c.aroundTail + k})}, -1);
  emit({apex, id({h, c.aroundTail + c.fromApex - 1}), last(h, true), last(next, false)}, -1);
}

void Refinement::cutFace(int h) {
  int middle = h;
  for (const int half : {h, flipped_.next(h), flipped_.previous(h)}) {
    cutCorner(half);
    if (flipped_.faceCrossings(half).fromApex > 0) middle = half;
  }
  cutMiddle(middle);
}

CommonRefinement Refinement::run() {
  for (int h = 0; h < static_cast<int>(3 * surface_.faceCount()); ++h)
    halfEdges_[{topology_.tail(h), topology_.head(h)}] = h;
  numberCrossings();
  for (int h = 0; h < flipped_.halfEdgeCount(); ++h) traceFrom(h);
  placeOnFlippedEdges();
  for (int f = 0; f < flipped_.faceCount(); ++f) cutFace(flipped_.first(f));
  const int n = surface_.vertexCount(), more = static_cast<int>(vertices_.size());
  CommonRefinement result;
  Points3 points(n + more, 3);
  points.topRows(n) = surface_.points();
  result.image.resize(n + more, 2);
  result.image.topRows(n) = image_;
  for (int c = 0; c < more; ++c) {
    const auto [a, b] = ends_[at(c)];
    const int h = vertices_[at(c)];
    const double s = onSurface_[at(c)], t = onFlipped_[at(c)];
    points.row(n + c) = (1 - s) * surface_.points().row(a) + s * surface_.points().row(b);
    result.image.row(n + c) = (1 - t) * image_.row(flipped_.tail(h)) + t * image_.row(flipped_.head(h));
  }
  Faces faces(static_cast<Eigen::Index>(faces_.size()), 3);
  for (std::size_t f = 0; f < faces_.size(); ++f) faces.row(static_cast<Eigen::Index>(f)) = faces_[f];
  result.flippedFaces = countFlippedFaces(result.image, faces);
  result.mesh = TriangleMesh(std::move(points), std::move(faces));
  result.originalPointIds.assign(at(n + more), -1);
  for (int v = 0; v < n; ++v) result.originalPointIds[at(v)] = v;
  result.originalFaceIds = std::move(faceIds_);
  return result;
}

}  // namespace

CommonRefinement commonRefinement(const TriangleMesh& surface, const SurfaceTopology& topology,
                                  const IntrinsicTriangulation& flipped, const Points2& image) {
  bool tracked = flipped.vertexCount() == surface.vertexCount() &&
                 flipped.faceCount() == surface.faceCount() && image.rows() == surface.vertexCount();
  bool any = false;
  for (int h = 0; tracked && h < flipped.halfEdgeCount(); ++h) any = any || flipped.crossings(h) > 0;
  // Without a crossing the triangulation must be the surface's own.
  if (tracked && !any) tracked = flipped.faces() == surface.faces();
  if (!tracked) {
    throw InvalidArgument(
        "A triangulation that tracks its crossings with this surface is required (trackCrossings before the "
        "first flip, no boundary edge split).");
  }
  return Refinement(surface, topology, flipped, image).run();
}

}  // namespace authalic
