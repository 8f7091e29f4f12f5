#include "Core/transport/StereographicPowerDiagram.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "Core/base/Error.h"
#include "Core/geometry/SphericalAreas.h"
#include "Core/transport/DistinctSites.h"
#include "Core/transport/RegularFlips.h"
#include "Core/transport/RegularTriangulation.h"

namespace authalic {
namespace {

using Real = long double;
using Vector2l = Eigen::Matrix<Real, 2, 1>;
using Vector3l = Eigen::Matrix<Real, 3, 1>;

constexpr double kNearPole = 1e-5;
constexpr Real kTurns = 0.25;  // of a circle whose arcs are drawn: four times as coarse as lengths
constexpr std::size_t kBlock = 1024;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

Vector3l onSphere(const Vector2l& x) {
  const Real square = x.squaredNorm();
  return Vector3l(2 * x.x(), 2 * x.y(), square - 1) / (1 + square);
}

// A side of a cell, which lies to the left of it: d n + s t for s from s₁ to s₂, or from or to infinity.
struct Side {
  int neighbour;
  Real gap;            // |z_i − z_j|
  Vector2l normal;     // n, out of the cell
  Real distance, k;    // d, √(1 + d²)
  bool begins, ends;   // at a corner
  Real start, end;     // s₁, s₂
  [[nodiscard]] Vector2l along() const { return {-normal.y(), normal.x()}; }
  [[nodiscard]] Vector3l axis() const { return Vector3l(normal.x(), normal.y(), distance) / k; }
  [[nodiscard]] Vector3l point(Real s) const { return onSphere(distance * normal + s * along()); }
  [[nodiscard]] Vector3l first() const { return begins ? point(start) : Vector3l(Vector3l::UnitZ()); }
  [[nodiscard]] Vector3l last() const { return ends ? point(end) : Vector3l(Vector3l::UnitZ()); }
  // 2 atan(s₂/k) − 2 atan(s₁/k): the same bits from both cells.
  [[nodiscard]] Real angle() const {
    if (begins && ends) return 2 * std::atan2(k * (end - start), k * k + start * end);
    if (begins) return 2 * std::atan2(k, start);
    return ends ? 2 * std::atan2(k, -end) : 2 * std::acos(Real(-1));
  }
  [[nodiscard]] static Real sine(Real s, Real k) { return 2 * k * s / (k * k + s * s); }  // of 2 atan(s/k)
  [[nodiscard]] Real weight() const {  // ∫ 4 / (1 + |x|²)² ds
    return (angle() + (ends ? sine(end, k) : 0) - (begins ? sine(start, k) : 0)) / (k * k * k);
  }
};

Eigen::Matrix3d frameOf(const Eigen::Vector3d& pole) {
  if (!pole.allFinite() || !(pole.norm() > 0)) {
    throw InvalidArgument("A finite pole that is not 0 is required for a stereographic projection, but it is (" +
                          std::to_string(pole.x()) + ", " + std::to_string(pole.y()) + ", " +
                          std::to_string(pole.z()) + ").");
  }
  const Eigen::Vector3d up = pole.stableNormalized(), first = up.unitOrthogonal();
  Eigen::Matrix3d frame;
  frame << first.transpose(), up.cross(first).transpose(), up.transpose();
  return frame;
}

void requireAwayFrom(const Eigen::RowVector3d& pole, const Points3& sites) {
  Eigen::Index nearest = 0;
  if ((sites.rowwise() - pole).rowwise().norm().minCoeff(&nearest) > kNearPole) return;
  throw GeometryError("A pole away from the sites is required, but site " + std::to_string(nearest) +
                      " lies at it; take another pole.");
}

}  // namespace

// Connectivity and corners of the diagram of the plane, and the walk around each cell.
struct StereographicPowerDiagram::Walk {
  explicit Walk(Points2 z) : sites(std::move(z)), triangulation(makeRegularTriangulation(sites)) {}

  Points2 sites;
  std::unique_ptr<RegularTriangulation> triangulation;
  Heights heights;
  RegularConnectivity dual;       // of all sites, to flip from; or empty
  std::vector<Vector2l> corners;  // per finite face

  bool triangulate();
  void placeCorners(const Execution& execution);
  [[nodiscard]] bool finite(int face) const;
  [[nodiscard]] Side side(int i, int j, int before, int after) const;
  [[nodiscard]] Real angleAtInfinity(int site, int before, int after) const;
  template <class Visit, class AtInfinity>
  void visit(int site, const Visit& visitSide, const AtInfinity& atInfinity) const;
};

bool StereographicPowerDiagram::Walk::triangulate() {
  const FlipResult flips = dual.corners.empty() ? FlipResult::GivenUp : flipToRegular(sites, heights, dual);
  if (flips == FlipResult::Regular) return true;
  if (flips == FlipResult::Hidden) return false;
  RegularConnectivity found = triangulation->triangulate(heights.cast<double>());
  if (std::find(found.faceOf.begin(), found.faceOf.end(), -1) != found.faceOf.end()) return false;
  if (found.dimension < 2) {
    throw GeometryError("Sites that do not all lie on one circle through the pole are required, but these do; take "
                        "another pole.");
  }
  dual = std::move(found);
  return true;
}

bool StereographicPowerDiagram::Walk::finite(int face) const {
  const std::array<int, 3>& corner = dual.corners[at(face)];
  return corner[0] >= 0 && corner[1] >= 0 && corner[2] >= 0;
}

void StereographicPowerDiagram::Walk::placeCorners(const Execution& execution) {
  corners.resize(dual.corners.size());
  parallelFor(corners.size(), execution, [this](std::size_t begin, std::size_t end) {
    for (std::size_t f = begin; f < end; ++f) {
      if (!finite(static_cast<int>(f))) continue;
      const auto [i, j, k] = dual.corners[f];
      const Vector2l a = (sites.row(j).cast<Real>() - sites.row(i).cast<Real>()).transpose(),
                     b = (sites.row(k).cast<Real>() - sites.row(i).cast<Real>()).transpose();
      const Real p = heights[i] - heights[j], q = heights[i] - heights[k];
      const Real turn = std::max(a.x() * b.y() - a.y() * b.x(), 1e-280L);  // > 0 in exact arithmetic
      corners[f] = {(p * b.y() - q * a.y()) / turn, (q * a.x() - p * b.x()) / turn};
    }
  });
}

// The side of the cells i and j from face `before` to face `after`, as cell i sees it.
Side StereographicPowerDiagram::Walk::side(int i, int j, int before, int after) const {
  const Vector2l across = (sites.row(j).cast<Real>() - sites.row(i).cast<Real>()).transpose();
  Side side;
  side.neighbour = j;
  side.gap = across.norm();
  side.normal = across / side.gap;
  side.distance = (heights[i] - heights[j]) / side.gap;
  side.k = std::hypot(Real(1), side.distance);
  side.begins = finite(before), side.ends = finite(after);
  side.start = side.begins ? side.along().dot(corners[at(before)]) : 0;
  side.end = side.ends ? side.along().dot(corners[at(after)]) : 0;
  return side;
}

// Between the ray that leaves for infinity along face `before` and the one that comes back along face `after`.
Real StereographicPowerDiagram::Walk::angleAtInfinity(int site, int before, int after) const {
  const auto other = [&](int face) {
    for (const int vertex : dual.corners[at(face)]) {
      if (vertex >= 0 && vertex != site) return vertex;
    }
    return site;
  };
  const Vector2l out = (sites.row(other(before)).cast<Real>() - sites.row(site).cast<Real>()).transpose(),
                 back = (sites.row(site).cast<Real>() - sites.row(other(after)).cast<Real>()).transpose();
  return std::atan2(out.x() * back.y() - out.y() * back.x(), out.dot(back));
}

// Counter-clockwise in the plane.
template <class Visit, class AtInfinity>
void StereographicPowerDiagram::Walk::visit(int site, const Visit& visitSide, const AtInfinity& atInfinity) const {
  const int begun = dual.faceOf[at(site)];
  int face = begun;
  do {
    const std::array<int, 3>& corner = dual.corners[at(face)];
    const int k = corner[0] == site ? 0 : corner[1] == site ? 1 : 2;
    const int next = dual.neighbours[at(face)][at((k + 1) % 3)], other = corner[at((k + 2) % 3)];
    if (other >= 0) {
      visitSide(side(site, other, face, next));
    } else {
      atInfinity(angleAtInfinity(site, face, next));
    }
    face = next;
  } while (face != begun);
}

StereographicPowerDiagram::StereographicPowerDiagram(Points3 sites, const Eigen::Vector3d& pole)
    : sites_(std::move(sites)), frame_(frameOf(pole)) {
  if (sites_.rows() < 3) {
    throw GeometryError("At least 3 sites are required for a stereographic diagram, but there are " +
                        std::to_string(sites_.rows()) + ".");
  }
  requireDistinctSites(sites_);
  requireOnUnitSphere(sites_);
  sites_.rowwise().normalize();
  requireAwayFrom(frame_.row(2), sites_);
  walk_ = std::make_unique<Walk>(project(sites_));
  requireDistinctSites(walk_->sites);
}

StereographicPowerDiagram::~StereographicPowerDiagram() = default;

const Points2& StereographicPowerDiagram::planarSites() const noexcept { return walk_->sites; }

Points2 StereographicPowerDiagram::project(const Points3& points) const {
  Points2 places(points.rows(), 2);
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    const double depth = 0.5 * (points.row(i) - frame_.row(2)).squaredNorm();  // 1 − z, exact near the pole too
    places.row(i) = points.row(i) * frame_.topRows<2>().transpose() / depth;
  }
  return places;
}

Heights StereographicPowerDiagram::voronoiHeights() const {
  return -0.5L * planarSites().cast<Real>().rowwise().squaredNorm();
}

Eigen::VectorXd StereographicPowerDiagram::planesAt(const Points3& points) const {
  return project(points).cwiseProduct(planarSites()).rowwise().sum() + walk_->heights.cast<double>();
}

void StereographicPowerDiagram::addCell(int site, std::vector<StereographicPowerEdge>& edges) {
  Real area = 0;
  Vector3l moment = Vector3l::Zero();  // −2 ∫ x: seen from outside the sphere, the walk is clockwise
  walk_->visit(site, [&](const Side& side) {
    const Real angle = side.angle(), height = side.distance / side.k;
    const Vector3l axis = side.axis();
    area += angle * height;
    moment += height * axis.cross(side.last() - side.first()) + angle / (side.k * side.k) * axis;
    const auto rate = static_cast<double>(side.weight() / side.gap);
    if (site < side.neighbour && rate > 0) edges.push_back({site, side.neighbour, rate});
  }, [&](Real angle) { area += 2 * angle; });
  cells_.areas[site] = static_cast<double>(area);
  const Vector3l direction = -(frame_.transpose().cast<Real>() * moment);
  cells_.centroids.row(site) = sites_.row(site);
  if (direction.norm() > 0) cells_.centroids.row(site) = direction.normalized().cast<double>().transpose();
}

bool StereographicPowerDiagram::compute(const Heights& heights, const Execution& execution) {
  const Eigen::Index n = sites_.rows();
  if (heights.size() != n || !heights.allFinite()) {
    throw GeometryError("One finite height per site (" + std::to_string(n) + ") is required, but there are " +
                        std::to_string(heights.size()) + (heights.allFinite() ? "." : ", not all of them finite."));
  }
  walk_->heights = heights;
  if (!walk_->triangulate()) return false;
  walk_->placeCorners(execution);
  cells_.areas.resize(n), cells_.centroids.resize(n, 3);
  std::vector<std::vector<StereographicPowerEdge>> found((static_cast<std::size_t>(n) + kBlock - 1) / kBlock);
  parallelFor(found.size(), execution, [&](std::size_t begin, std::size_t end) {
    for (std::size_t block = begin; block < end; ++block) {
      const std::size_t last = std::min(static_cast<std::size_t>(n), (block + 1) * kBlock);
      for (std::size_t i = block * kBlock; i < last; ++i) addCell(static_cast<int>(i), found[block]);
    }
  }, 1);
  cells_.edges.clear();
  for (const auto& edges : found) cells_.edges.insert(cells_.edges.end(), edges.begin(), edges.end());
  return true;
}

SphericalCellPolygons StereographicPowerDiagram::polygons(double arcStep) const {
  SphericalCellPolygons polygons;
  polygons.starts.push_back(0);
  std::vector<Vector3l> points;
  for (int i = 0; i < static_cast<int>(sites_.rows()); ++i) {
    walk_->visit(i, [&](const Side& side) {
      const Real angle = side.angle(), from = side.begins ? 2 * std::atan(side.start / side.k) : -std::acos(Real(-1));
      const int pieces = std::max(1, static_cast<int>(std::ceil(angle * std::max(1 / side.k, kTurns) / arcStep)));
      points.push_back(side.first());
      for (int piece = 1; piece < pieces; ++piece) {
        points.push_back(side.point(side.k * std::tan((from + angle * piece / pieces) / 2)));
      }
    }, [](Real) {});
    std::reverse(points.begin() + polygons.starts.back(), points.end());
    polygons.starts.push_back(static_cast<int>(points.size()));
  }
  polygons.corners.resize(static_cast<Eigen::Index>(points.size()), 3);
  for (std::size_t k = 0; k < points.size(); ++k) {
    polygons.corners.row(static_cast<Eigen::Index>(k)) = points[k].cast<double>().transpose() * frame_;
  }
  return polygons;
}

}  // namespace authalic
