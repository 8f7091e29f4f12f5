#include "Core/transport/PiecewiseLinearDensity.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <string>

#include "Core/base/Error.h"
#include "Core/geometry/Areas.h"
#include "Core/transport/OutlineClipping.h"

namespace authalic {
namespace {

constexpr double kOnBoundary = 1e-6;  // of the size of the domain
constexpr double kCovered = 1e-9;     // of its area

std::size_t at(int i) { return static_cast<std::size_t>(i); }

std::string shown(const Eigen::Vector2d& p) {
  std::ostringstream words;
  words << '(' << p.x() << ", " << p.y() << ')';
  return words.str();
}

std::string nameOf(const PlanarDomain& domain) {
  return domain.isDisk() ? "the unit disk" : "the polygon of " + std::to_string(domain.corners().rows()) + " corners";
}

double sizeOf(const PlanarDomain& domain) {
  if (domain.isDisk()) return 1;
  return 0.5 * (domain.corners().colwise().maxCoeff() - domain.corners().colwise().minCoeff()).norm();
}

Eigen::Vector2d middleOf(const PlanarDomain& domain) {
  return domain.isDisk() ? Eigen::Vector2d(0, 0) : Eigen::Vector2d(domain.corners().colwise().mean());
}

// What lies left of the line from a to b.
HalfPlane leftOf(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  const Eigen::Vector2d along = (b - a).normalized();
  return {a, {-along.y(), along.x()}};
}

// How far inside the domain a point lies; < 0 outside.
double depthIn(const PlanarDomain& domain, const Eigen::Vector2d& p) {
  if (domain.isDisk()) return 1 - p.norm();
  const Points2& corners = domain.corners();
  double depth = std::numeric_limits<double>::infinity();
  for (Eigen::Index k = 0; k < corners.rows(); ++k) {
    const Eigen::Vector2d a = corners.row(k), b = corners.row((k + 1) % corners.rows());
    depth = std::min(depth, leftOf(a, b).depth(p));
  }
  return depth;
}

HalfPlane otherSide(const HalfPlane& half) { return {half.point, -half.normal}; }

// What lies left of the line from vertex i to vertex j: from both sides the same bits, up to the sign.
HalfPlane leftOf(const Points2& points, int i, int j) {
  if (i > j) return otherSide(leftOf(points, j, i));
  return leftOf(points.row(i).transpose(), points.row(j).transpose());
}

LinearFunction functionOf(const Points2& points, const Eigen::RowVector3i& face, const Eigen::VectorXd& values) {
  const Eigen::Vector2d a = points.row(face[0]), u = points.row(face[1]).transpose() - a,
                        v = points.row(face[2]).transpose() - a;
  const double rise = values[face[1]] - values[face[0]], other = values[face[2]] - values[face[0]];
  const Eigen::Vector2d gradient = rise * Eigen::Vector2d(v.y(), -v.x()) + other * Eigen::Vector2d(-u.y(), u.x());
  return {a, gradient / (u.x() * v.y() - u.y() * v.x()), values[face[0]]};
}

void requireValues(const Eigen::VectorXd& values, int count) {
  if (values.size() != count) {
    throw GeometryError("A source density of one value per vertex of its mesh (" + std::to_string(count) +
                        ") is required, but it has " + std::to_string(values.size()) +
                        " values; take it from the same mesh.");
  }
  for (Eigen::Index i = 0; i < values.size(); ++i) {
    if (values[i] > 0 && std::isfinite(values[i])) continue;
    throw InvalidArgument("A positive, finite source density is required, but vertex " + std::to_string(i) + " has " +
                          std::to_string(values[i]) + "; give empty regions a small density, not zero.");
  }
}

Points2 planarPoints(const Points3& points) {
  const Eigen::RowVector3d extent = points.colwise().maxCoeff() - points.colwise().minCoeff();
  if (extent[2] > kOnBoundary * extent.head<2>().norm()) {
    throw GeometryError("A source mesh in a plane z = constant is required, but z varies by " +
                        std::to_string(extent[2]) + "; take a map, or flatten it.");
  }
  return points.leftCols<2>();
}

// The faces, counter-clockwise.
Faces upright(const Points2& points, const Faces& faces) {
  const Eigen::VectorXd areas = signedFaceAreas(points, faces);
  const double turn = areas.sum() < 0 ? -1 : 1;
  for (Eigen::Index f = 0; f < faces.rows(); ++f) {
    if (turn * areas[f] > 0) continue;
    throw GeometryError("A source mesh without folds is required, but triangle " + std::to_string(f) + " at " +
                        shown(points.row(faces(f, 0)).transpose()) +
                        (areas[f] == 0 ? " has no area" : " is turned the other way") +
                        "; take a map without folds (--finish authalic), or mesh the domain anew.");
  }
  Faces result = faces;
  if (turn < 0) result.col(1).swap(result.col(2));
  return result;
}

}  // namespace

PiecewiseLinearDensity::PiecewiseLinearDensity(const PlanarDomain& domain, const DiskMesh& mesh,
                                               const Eigen::VectorXd& values)
    : domain_(domain) {
  (void)ConvexRegion(domain);  // convex, or refused
  requireValues(values, mesh.mesh().vertexCount());
  const Points2 points = planarPoints(mesh.mesh().points());
  const Faces faces = upright(points, mesh.mesh().faces());
  const SurfaceTopology topology(faces, mesh.mesh().vertexCount());
  requireVertices(topology, points);
  addTriangles(topology, points, values);
  addSlivers(topology, points);
  placeHints();
  requireCorners();
  integrate();
}

// Vertices of the boundary may not lie in the domain, nor sides run through it that are no chords.
void PiecewiseLinearDensity::requireVertices(const SurfaceTopology& topology, const Points2& points) const {
  const double tolerance = kOnBoundary * sizeOf(domain_);
  const std::vector<int>& loop = topology.boundaryLoops().front();
  for (std::size_t k = 0; k < loop.size(); ++k) {
    const Eigen::Vector2d a = points.row(loop[k]), b = points.row(loop[(k + 1) % loop.size()]);
    Eigen::Vector2d inside = a;
    if (domain_.isDisk() && std::max(a.norm(), b.norm()) > 1 + tolerance) {
      inside = a + std::clamp(-a.dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0) * (b - a);
    }
    if (depthIn(domain_, inside) > tolerance) refuseGapAt(inside);
  }
}

void PiecewiseLinearDensity::refuseGapAt(const Eigen::Vector2d& place) const {
  throw GeometryError("A source mesh that covers " + nameOf(domain_) + " is required, but its boundary passes " +
                      shown(place) + ", inside it; extend the mesh to the boundary of the domain, or scale it.");
}

void PiecewiseLinearDensity::addTriangles(const SurfaceTopology& topology, const Points2& points,
                                          const Eigen::VectorXd& values) {
  const Faces& faces = topology.faces();
  for (int f = 0; f < static_cast<int>(faces.rows()); ++f) {
    DensityPiece piece{functionOf(points, faces.row(f), values), {}, {}};
    for (int k = 0; k < 3; ++k) {
      const int opposite = topology.opposite(3 * f + k);
      piece.sides[at(k)] = leftOf(points, faces(f, k), faces(f, (k + 1) % 3));
      piece.beyond[at(k)] = opposite < 0 ? -1 : opposite / 3;
    }
    pieces_.push_back(piece);
  }
  triangles_ = static_cast<int>(faces.rows());
}

// One for each side of the boundary that has the middle of the domain to its left.
void PiecewiseLinearDensity::addSlivers(const SurfaceTopology& topology, const Points2& points) {
  const Eigen::Vector2d middle = middleOf(domain_);
  std::vector<int> begins(at(static_cast<int>(points.rows())), -1), ends(begins), halfEdges;
  for (int h = 0; h < 3 * triangles_; ++h) {
    const HalfPlane& inside = pieces_[at(h / 3)].sides[at(h % 3)];
    if (topology.opposite(h) >= 0 || !(inside.depth(middle) > 0)) continue;
    const int sliver = triangles_ + static_cast<int>(halfEdges.size());
    halfEdges.push_back(h);
    begins[at(topology.tail(h))] = ends[at(topology.head(h))] = sliver;
    pieces_[at(h / 3)].beyond[at(h % 3)] = sliver;
  }
  for (const int h : halfEdges) {
    const int a = topology.tail(h), b = topology.head(h);
    const DensityPiece& triangle = pieces_[at(h / 3)];
    const HalfPlane first = leftOf(middle, points.row(a).transpose());
    const HalfPlane second = otherSide(leftOf(middle, points.row(b).transpose()));
    pieces_.push_back({triangle.density,
                       {otherSide(triangle.sides[at(h % 3)]), first, second},
                       {h / 3, ends[at(a)], begins[at(b)]}});
  }
}

// No corner of a polygon may lie beyond the mesh.
void PiecewiseLinearDensity::requireCorners() const {
  const double tolerance = kOnBoundary * sizeOf(domain_);
  for (Eigen::Index k = 0; k < domain_.corners().rows(); ++k) {
    const Eigen::Vector2d corner = domain_.corners().row(k);
    const int piece = pieceAt(corner);
    if (piece < triangles_ || pieces_[at(piece)].sides[0].depth(corner) <= tolerance) continue;
    refuseGapAt(corner - pieces_[at(piece)].sides[0].depth(corner) * pieces_[at(piece)].sides[0].normal);
  }
}

void PiecewiseLinearDensity::integrate() {
  ClippedOutline whole, part, other;
  uncut(ConvexRegion(domain_).outline(), whole);
  double area = 0;
  for (int k = 0; k < static_cast<int>(pieces_.size()); ++k) {
    const DensityPiece& piece = pieces_[at(k)];
    if (!clip(whole, piece.sides[0], 0, part) || !clip(part, piece.sides[1], 1, other) ||
        !clip(other, piece.sides[2], 2, part)) {
      continue;
    }
    const Eigen::Vector2d corner = part.corners.front();
    area += momentsOf(part, corner).area;
    total_ += momentsOf(part, piece.density, corner).area;
    const Least least = leastOf(piece.density, part);
    if (least.value > 0) continue;
    throw GeometryError("A source density that stays positive up to the boundary of the domain is required, but "
                        "continued beyond the mesh it is " + std::to_string(least.value) + " at " +
                        shown(least.place) + "; refine the mesh at its boundary, or raise the density there.");
  }
  if (std::abs(area - domain_.area()) <= kCovered * domain_.area()) return;
  throw GeometryError("A source mesh that covers " + nameOf(domain_) + " once is required, but it covers an area of " +
                      std::to_string(area) + " of " + std::to_string(domain_.area()) +
                      "; it must lie about the middle of the domain, and not overlap itself.");
}

std::size_t PiecewiseLinearDensity::hintOf(const Eigen::Vector2d& point) const {
  const Eigen::Array2d place = ((point - low_).array() / step_.array()).max(0).min(resolution_ - 1);
  return at(static_cast<int>(place.y()) * resolution_ + static_cast<int>(place.x()));
}

// Fills a grid of about two triangles a cell row by row, back and forth: each walk is short.
void PiecewiseLinearDensity::placeHints() {
  const Points2& corners = domain_.corners();
  low_ = domain_.isDisk() ? Eigen::Vector2d(-1, -1) : Eigen::Vector2d(corners.colwise().minCoeff());
  const Eigen::Vector2d high = domain_.isDisk() ? Eigen::Vector2d(1, 1) : Eigen::Vector2d(corners.colwise().maxCoeff());
  resolution_ = std::max(1, static_cast<int>(std::sqrt(triangles_ / 2.0)));
  step_ = (high - low_) / resolution_;
  hints_.assign(at(resolution_ * resolution_), 0);
  int piece = 0;
  for (int row = 0; row < resolution_; ++row) {
    for (int k = 0; k < resolution_; ++k) {
      const int column = row % 2 == 0 ? k : resolution_ - 1 - k;
      const Eigen::Vector2d middle = low_ + step_.cwiseProduct(Eigen::Vector2d(column + 0.5, row + 0.5));
      if (depthIn(domain_, middle) > 0) (void)walk(middle, piece);
      hints_[at(row * resolution_ + column)] = piece;
    }
  }
}

// From `piece` across sides that have the point beyond them; false when that leads nowhere.
bool PiecewiseLinearDensity::walk(const Eigen::Vector2d& point, int& piece) const {
  const int most = static_cast<int>(pieces_.size());
  for (int steps = 0; steps <= most; ++steps) {
    const DensityPiece& here = pieces_[at(piece)];
    int next = piece;
    for (int k = 0; k < 3 && next == piece; ++k) {  // not the same side first each time: it could go round
      const std::size_t side = at((k + steps) % 3);
      if (here.sides[side].depth(point) < 0) next = here.beyond[side];
    }
    if (next == piece) return true;
    if (next < 0) return false;
    piece = next;
  }
  return false;
}

int PiecewiseLinearDensity::pieceAt(const Eigen::Vector2d& point) const {
  int piece = hints_[hintOf(point)];
  if (walk(point, piece)) return piece;
  double best = -std::numeric_limits<double>::infinity();
  for (int k = 0; k < static_cast<int>(pieces_.size()); ++k) {
    double depth = std::numeric_limits<double>::infinity();
    for (const HalfPlane& side : pieces_[at(k)].sides) depth = std::min(depth, side.depth(point));
    if (depth > best) best = depth, piece = k;
  }
  return piece;
}

}  // namespace authalic
