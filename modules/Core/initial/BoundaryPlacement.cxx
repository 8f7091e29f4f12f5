#include "Core/initial/BoundaryPlacement.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <string>

#include "Core/base/Error.h"
#include "Core/geometry/Areas.h"

namespace authalic {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kOnBoundary = 1e-6;  // relative to the size of the domain

std::size_t at(int i) { return static_cast<std::size_t>(i); }

std::vector<int> rotatedTo(std::vector<int> loop, std::size_t first) {
  std::rotate(loop.begin(), loop.begin() + static_cast<std::ptrdiff_t>(first), loop.end());
  return loop;
}

// Arc length at each vertex of the loop; the last entry is the whole length.
std::vector<double> arcLengths(const TriangleMesh& mesh, const std::vector<int>& loop) {
  std::vector<double> length{0.0};
  for (std::size_t i = 0; i < loop.size(); ++i) {
    length.push_back(length.back() + (mesh.point(loop[(i + 1) % loop.size()]) - mesh.point(loop[i])).norm());
  }
  if (!(length.back() > 0)) {
    throw GeometryError("A boundary loop with a positive length is required, but all its " +
                        std::to_string(loop.size()) + " vertices lie in one point.");
  }
  return length;
}

double sideLength(const PlanarDomain& domain, int k) {
  const auto& c = domain.corners();
  return (c.row((k + 1) % c.rows()) - c.row(k)).norm();
}

// Loop entries that become corners: nearest in arc length, strictly increasing.
std::vector<int> chooseCorners(const std::vector<double>& arc, const PlanarDomain& domain) {
  const int count = static_cast<int>(domain.corners().rows()), n = static_cast<int>(arc.size()) - 1;
  if (n < count) {
    throw TopologyError("At least as many boundary vertices as corners (" + std::to_string(count) +
                        ") are required, but the boundary has " + std::to_string(n) + "; refine it.");
  }
  double perimeter = 0, target = 0;
  for (int k = 0; k < count; ++k) perimeter += sideLength(domain, k);
  std::vector<int> corners{0};
  for (int k = 1; k < count; ++k) {
    target += sideLength(domain, k - 1) / perimeter * arc.back();
    const auto after = std::lower_bound(arc.begin(), arc.end() - 1, target) - arc.begin();
    int nearest = static_cast<int>(after);
    if (nearest > 0 && (nearest >= n || target - arc[at(nearest - 1)] <= arc[at(nearest)] - target)) --nearest;
    corners.push_back(std::clamp(nearest, corners.back() + 1, n - (count - k)));
  }
  return corners;
}

void assignSides(BoundaryPlacement& placement) {
  const int n = static_cast<int>(placement.vertices.size()), count = static_cast<int>(placement.corners.size());
  placement.role.assign(at(n), count == 0 ? BoundaryRole::Circle : BoundaryRole::Side);
  placement.side.assign(at(n), -1);
  for (int k = 0; k < count; ++k) {
    const int end = k + 1 < count ? placement.corners[at(k + 1)] : n;
    for (int i = placement.corners[at(k)]; i < end; ++i) placement.side[at(i)] = k;
    placement.role[at(placement.corners[at(k)])] = BoundaryRole::Corner;
  }
}

// Intervals [low, high] of loop entries on one closed side whose ends an inner edge joins; outermost ones only.
std::vector<std::array<int, 2>> findChords(const DiskMesh& disk, const BoundaryPlacement& placement) {
  const SurfaceTopology& topology = disk.topology();
  const int n = static_cast<int>(placement.vertices.size()), count = static_cast<int>(placement.corners.size());
  std::vector<int> entry(at(disk.mesh().vertexCount()), -1);
  for (int i = 0; i < n; ++i) entry[at(placement.vertices[at(i)])] = i;
  std::vector<std::array<int, 2>> chords;
  for (int h = 0; h < 3 * disk.mesh().faceCount(); ++h) {
    const int a = entry[at(topology.tail(h))], b = entry[at(topology.head(h))];
    if (a < 0 || b < 0 || topology.opposite(h) < h) continue;
    for (int k = 0; k < count; ++k) {
      const int begin = placement.corners[at(k)], end = k + 1 < count ? placement.corners[at(k + 1)] : n;
      const int i = a == 0 && end == n && begin > 0 ? n : a, j = b == 0 && end == n && begin > 0 ? n : b;
      if (std::min(i, j) >= begin && std::max(i, j) <= end) chords.push_back({std::min(i, j), std::max(i, j)});
    }
  }
  std::sort(chords.begin(), chords.end(), [](const auto& x, const auto& y) {
    return x[0] != y[0] ? x[0] < y[0] : x[1] > y[1];
  });
  std::vector<std::array<int, 2>> outermost;
  for (const auto& chord : chords) {
    if (outermost.empty() || chord[1] > outermost.back()[1]) outermost.push_back(chord);
  }
  return outermost;
}

// Marks the faces between a chord and the boundary that it cuts off, and returns their area.
double markPocket(const DiskMesh& disk, const Eigen::VectorXd& areas, int from, int past, int to,
                  BoundaryPlacement& placement) {
  const SurfaceTopology& topology = disk.topology();
  std::vector<int> open;
  for (int h = 0; h < 3 * disk.mesh().faceCount() && open.empty(); ++h) {
    if (topology.opposite(h) < 0 && topology.tail(h) == from && topology.head(h) == past) open.push_back(h / 3);
  }
  double area = 0;
  while (!open.empty()) {
    const int f = open.back();
    open.pop_back();
    if (placement.inPocket[at(f)]) continue;
    placement.inPocket[at(f)] = 1;
    area += areas[f];
    for (int h = 3 * f; h < 3 * f + 3; ++h) {
      const int a = topology.tail(h), b = topology.head(h);
      if (a != from && a != to) placement.pocketOf[at(a)] = static_cast<int>(placement.pockets.size()) - 1;
      const bool chord = (a == from && b == to) || (a == to && b == from);
      if (!chord && topology.opposite(h) >= 0) open.push_back(topology.opposite(h) / 3);
    }
  }
  return area;
}

// Finds the pockets and, when asked, bulges them: a parabola over the chord that holds the pocket's area.
void treatPockets(const DiskMesh& disk, const PlanarDomain& domain, const std::vector<double>* arc,
                  BoundaryPlacement& placement) {
  placement.inPocket.assign(at(disk.mesh().faceCount()), 0);
  placement.pocketOf.assign(at(disk.mesh().vertexCount()), -1);
  if (domain.isDisk()) return;
  const std::vector<std::array<int, 2>> chords = findChords(disk, placement);
  if (chords.empty()) return;
  const Eigen::VectorXd areas = faceAreas(disk.mesh());
  const double scale = domain.area() / areas.sum();
  const auto& v = placement.vertices;
  for (const auto& [low, high] : chords) {
    const int n = static_cast<int>(v.size());
    placement.pockets.push_back({v[at(low)], v[at(high % n)]});
    const double area = markPocket(disk, areas, v[at(low)], v[at(low + 1)], v[at(high % n)], placement);
    const Eigen::RowVector2d a = placement.points.row(low), b = placement.points.row(high % n);
    const double chord = (b - a).norm(), sag = std::clamp(1.5 * area * scale / chord, 1e-9 * chord, 0.25 * chord);
    const Eigen::RowVector2d outwards = Eigen::RowVector2d(b[1] - a[1], a[0] - b[0]) / chord;
    for (int i = low + 1; i < high; ++i) {
      placement.role[at(i)] = BoundaryRole::Pocket;
      if (!arc) continue;
      const double t = ((*arc)[at(i)] - (*arc)[at(low)]) / ((*arc)[at(high)] - (*arc)[at(low)]);
      placement.points.row(i) = a + t * (b - a) + 4 * t * (1 - t) * sag * outwards;
    }
  }
}

void spreadOverCircle(const std::vector<double>& arc, BoundaryPlacement& placement) {
  for (std::size_t i = 0; i < placement.vertices.size(); ++i) {
    const double angle = 2 * kPi * arc[i] / arc.back();
    placement.points.row(static_cast<Eigen::Index>(i)) << std::cos(angle), std::sin(angle);
  }
}

void spreadOverPolygon(const std::vector<double>& arc, const PlanarDomain& domain, BoundaryPlacement& placement) {
  const auto& corner = domain.corners();
  const int n = static_cast<int>(placement.vertices.size()), count = static_cast<int>(corner.rows());
  for (int i = 0; i < n; ++i) {
    const int k = placement.side[at(i)], begin = placement.corners[at(k)],
              end = k + 1 < count ? placement.corners[at(k + 1)] : n;
    const double length = arc[at(end)] - arc[at(begin)];
    const double t = length > 0 ? (arc[at(i)] - arc[at(begin)]) / length : double(i - begin) / (end - begin);
    placement.points.row(i) = corner.row(k) + t * (corner.row((k + 1) % count) - corner.row(k));
  }
}

[[noreturn]] void notOnBoundary(int vertex, const Eigen::RowVector2d& point) {
  throw GeometryError("An initial map whose boundary lies on the boundary of the domain is required, but boundary "
                      "vertex " + std::to_string(vertex) + " is at (" + std::to_string(point[0]) + ", " +
                      std::to_string(point[1]) + "); compute the initial map for the same domain.");
}

std::vector<int> recogniseCorners(const std::vector<int>& loop, const PlanarDomain& domain, const Points2& image,
                                  double tolerance) {
  std::vector<int> corners;
  for (Eigen::Index k = 0; k < domain.corners().rows(); ++k) {
    int nearest = 0;
    const auto distance = [&](int i) { return (image.row(loop[at(i)]) - domain.corners().row(k)).norm(); };
    for (int i = 1; i < static_cast<int>(loop.size()); ++i) nearest = distance(i) < distance(nearest) ? i : nearest;
    if (distance(nearest) > tolerance) notOnBoundary(loop[at(nearest)], image.row(loop[at(nearest)]));
    corners.push_back(nearest);
  }
  return corners;
}

void requireOnSides(const PlanarDomain& domain, double tolerance, BoundaryPlacement& placement) {
  const auto& corner = domain.corners();
  for (std::size_t i = 0; i < placement.vertices.size(); ++i) {
    if (placement.role[i] == BoundaryRole::Pocket) continue;
    const auto row = static_cast<Eigen::Index>(i);
    const Eigen::RowVector2d p = placement.points.row(row), a = corner.row(placement.side[i]);
    const Eigen::RowVector2d along = corner.row((placement.side[i] + 1) % corner.rows()) - a;
    const double t = placement.role[i] == BoundaryRole::Corner ? 0 : (p - a).dot(along) / along.squaredNorm();
    if ((a + t * along - p).norm() > tolerance) notOnBoundary(placement.vertices[i], p);
    placement.points.row(row) = a + t * along;
  }
}

Points2 rowsOf(const Points2& image, const std::vector<int>& vertices) {
  Points2 rows(static_cast<Eigen::Index>(vertices.size()), 2);
  for (std::size_t i = 0; i < vertices.size(); ++i) rows.row(static_cast<Eigen::Index>(i)) = image.row(vertices[i]);
  return rows;
}

}  // namespace

BoundaryPlacement placeBoundary(const DiskMesh& disk, const PlanarDomain& domain, int startVertex) {
  const std::vector<int>& loop = disk.boundary();
  const auto start = startVertex < 0 ? loop.begin() : std::find(loop.begin(), loop.end(), startVertex);
  if (start == loop.end()) {
    throw InvalidArgument("A start vertex on the boundary loop is required, but vertex " +
                          std::to_string(startVertex) + " is not on it; omit it or choose one that is.");
  }
  BoundaryPlacement placement;
  placement.vertices = rotatedTo(loop, static_cast<std::size_t>(start - loop.begin()));
  placement.points.resize(static_cast<Eigen::Index>(loop.size()), 2);
  const std::vector<double> arc = arcLengths(disk.mesh(), placement.vertices);
  if (!domain.isDisk()) placement.corners = chooseCorners(arc, domain);
  assignSides(placement);
  if (domain.isDisk()) {
    spreadOverCircle(arc, placement);
  } else {
    spreadOverPolygon(arc, domain, placement);
  }
  treatPockets(disk, domain, &arc, placement);
  return placement;
}

BoundaryPlacement recogniseBoundary(const DiskMesh& disk, const PlanarDomain& domain, const Points2& image) {
  if (image.rows() != disk.mesh().vertexCount() || !image.allFinite()) {
    throw GeometryError("An initial map with " + std::to_string(disk.mesh().vertexCount()) +
                        " finite points is required, but it has " + std::to_string(image.rows()) +
                        (image.allFinite() ? "." : " and not all are finite."));
  }
  const double tolerance = kOnBoundary * std::sqrt(domain.area());
  BoundaryPlacement placement;
  placement.vertices = disk.boundary();
  if (domain.isDisk()) {
    placement.points = rowsOf(image, placement.vertices);
    for (Eigen::Index i = 0; i < placement.points.rows(); ++i) {
      const double radius = placement.points.row(i).norm();
      if (std::abs(radius - 1) > tolerance) {
        notOnBoundary(placement.vertices[at(static_cast<int>(i))], placement.points.row(i));
      }
      placement.points.row(i) /= radius;
    }
  } else {
    const std::vector<int> corners = recogniseCorners(placement.vertices, domain, image, tolerance);
    const int n = static_cast<int>(placement.vertices.size());
    placement.vertices = rotatedTo(placement.vertices, at(corners.front()));
    placement.points = rowsOf(image, placement.vertices);
    for (const int corner : corners) placement.corners.push_back((corner - corners.front() + n) % n);
    if (!std::is_sorted(placement.corners.begin(), placement.corners.end())) {
      notOnBoundary(placement.vertices.front(), placement.points.row(0));
    }
  }
  assignSides(placement);
  treatPockets(disk, domain, nullptr, placement);
  if (!domain.isDisk()) requireOnSides(domain, tolerance, placement);
  return placement;
}

}  // namespace authalic
