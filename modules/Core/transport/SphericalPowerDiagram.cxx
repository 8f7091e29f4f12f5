#include "Core/transport/SphericalPowerDiagram.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "Core/base/Error.h"
#include "Core/geometry/SphericalAreas.h"
#include "Core/transport/DistinctSites.h"
#include "Core/transport/RegularTriangulation.h"

namespace authalic {
namespace {

using Vector3l = Eigen::Matrix<long double, 3, 1>;

constexpr int kCandidates = 16;  // for the vertex that goes to infinity
constexpr std::size_t kBlock = 1024;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

// e^{-h_i} (Y_j − Y_i) = e^δ (y_j − y_i) + (e^δ − 1) y_i, δ = h_j − h_i: exact to rounding of itself, however small.
Vector3l between(const Points3& y, const Heights& h, int i, int j) {
  const Vector3l from = y.row(i).transpose().cast<long double>(), to = y.row(j).transpose().cast<long double>();
  const long double growth = std::expm1(h[j] - h[i]);
  return (1 + growth) * (to - from) + growth * from;
}

// A vertex of the hull, a direction in the inside of its cell, and how far the other vertices lie below it.
struct Pole {
  int vertex = -1;
  Eigen::Vector3d direction = Eigen::Vector3d::UnitZ();
  Eigen::VectorXd below;
};

Eigen::VectorXd depths(const Points3& y, const Heights& h, const Eigen::Vector3d& direction, int vertex) {
  Eigen::VectorXd below(y.rows());
  const Vector3l along = direction.cast<long double>();
  for (int j = 0; j < static_cast<int>(y.rows()); ++j) {
    below[j] = static_cast<double>(-between(y, h, vertex, j).dot(along));
  }
  below[vertex] = 0;
  return below;
}

// The one of a few vertices that stands out most: the others are then well placed in the plane.
Pole choosePole(const Points3& y, const Heights& h) {
  const int n = static_cast<int>(y.rows());
  const Eigen::VectorXd radius = (h.array() - h.maxCoeff()).exp().cast<double>();
  Pole best;
  double most = 0;
  for (int k = 0; k < std::min(kCandidates, n); ++k) {
    Pole pole;
    pole.direction = y.row(static_cast<Eigen::Index>(k) * n / std::min(kCandidates, n)).transpose();
    Eigen::VectorXd above = (y * pole.direction).cwiseProduct(radius);
    const double highest = above.maxCoeff(&pole.vertex);
    above[pole.vertex] = -std::numeric_limits<double>::infinity();
    const double least = (highest - above.maxCoeff()) / radius[pole.vertex];
    if (least > most || best.vertex < 0) best = std::move(pole), most = least;
  }
  best.below = depths(y, h, best.direction, best.vertex);
  return best;
}

}  // namespace

SphericalPowerDiagram::SphericalPowerDiagram(Points3 sites) : sites_(std::move(sites)) {
  if (sites_.rows() < 4) {
    throw GeometryError("At least 4 sites are required on the sphere, but there are " + std::to_string(sites_.rows()) +
                        ".");
  }
  requireDistinctSites(sites_);
  requireOnUnitSphere(sites_);
  sites_.rowwise().normalize();
  if (!regularTriangulationAvailable()) (void)makeRegularTriangulation(Points2());  // throws
}

// The hull without its vertex `pole`: below the tangent plane of the pole, p ↦ (p − Y_pole) / depth sends planes to
// planes and the pole to infinity, so that its other faces are those of a lower hull over the plane.
void SphericalPowerDiagram::triangulate() {
  const int n = static_cast<int>(sites_.rows());
  const Pole pole = choosePole(sites_, heights_);
  const Eigen::Vector3d first = pole.direction.unitOrthogonal(), second = first.cross(pole.direction);
  std::vector<int> ids;
  Points2 places(n - 1, 2);
  Eigen::VectorXd lifts(n - 1);
  for (int j = 0; j < n; ++j) {
    if (j == pole.vertex) continue;
    const auto row = static_cast<Eigen::Index>(ids.size());
    const Eigen::Vector3d offset = between(sites_, heights_, pole.vertex, j).cast<double>();
    const double depth = std::max(pole.below[j], 1e-300);
    places.row(row) << first.dot(offset) / depth, second.dot(offset) / depth;
    lifts[row] = -0.5 / depth;
    ids.push_back(j);
  }
  const RegularConnectivity dual = makeRegularTriangulation(places)->triangulate(lifts);
  faceOf_.assign(at(n), -1);
  faces_ = dual.corners;
  neighbours_ = dual.neighbours;
  for (std::size_t f = 0; f < faces_.size(); ++f) {
    for (int& vertex : faces_[f]) {
      vertex = vertex < 0 ? pole.vertex : ids[at(vertex)];
      faceOf_[at(vertex)] = static_cast<int>(f);
    }
  }
}

void SphericalPowerDiagram::placeCorners(const Execution& execution) {
  corners_.resize(faces_.size());
  std::vector<char> away(faces_.size());
  parallelFor(faces_.size(), execution, [&](std::size_t begin, std::size_t end) {
    for (std::size_t f = begin; f < end; ++f) {
      const int i = faces_[f][0];
      const Vector3l a = between(sites_, heights_, i, faces_[f][1]), b = between(sites_, heights_, i, faces_[f][2]);
      const Vector3l normal = a.cross(b);
      const long double length = normal.norm();
      corners_[f] = length > 0 ? Eigen::Vector3d((normal / length).cast<double>()) : Eigen::Vector3d::Zero();
      away[f] = corners_[f].dot(sites_.row(i)) > 0;
    }
  });
  cells_.surrounded = !faces_.empty() && std::all_of(away.begin(), away.end(), [](char yes) { return yes != 0; });
}

// visit(face, next face, the site beyond the side between them), counter-clockwise.
template <class Visit>
void SphericalPowerDiagram::visitCorners(int site, const Visit& visit) const {
  const int begun = faceOf_[at(site)];
  if (begun < 0) return;
  int face = begun;
  do {
    const std::array<int, 3>& corner = faces_[at(face)];
    const int k = corner[0] == site ? 0 : corner[1] == site ? 1 : 2;
    const int next = neighbours_[at(face)][at((k + 1) % 3)];
    visit(face, next, corner[at((k + 2) % 3)]);
    face = next;
  } while (face != begun);
}

void SphericalPowerDiagram::addCell(int site, std::vector<SphericalPowerEdge>& edges) {
  double area = 0;
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();
  const Eigen::Vector3d own = sites_.row(site).transpose();
  const int apex = faceOf_[at(site)];
  visitCorners(site, [&](int face, int next, int other) {
    const Eigen::Vector3d &a = corners_[at(face)], &b = corners_[at(next)];
    if (face != apex && next != apex) area += signedSolidAngle(corners_[at(apex)], a, b);
    const double chord = (b - a).norm(), sum = (b + a).norm();
    if (!(chord > 0 && sum > 0)) return;
    const double length = 2 * std::atan2(chord, sum);
    const Eigen::Vector3d normal = a.cross(b - a);
    if (normal.norm() > 0) moment += 0.5 * length * normal.normalized();
    if (other < site) return;
    const double gap = static_cast<double>(between(sites_, heights_, site, other).norm());  // · e^{-h_site}
    edges.push_back({site, other, length, chord / sum * own.dot(a + b) / gap});
  });
  cells_.areas[site] = area;
  cells_.centroids.row(site) = area > 0 && moment.norm() > 0 ? moment.normalized().transpose() : own.transpose();
}

const SphericalPowerCells& SphericalPowerDiagram::compute(const Heights& heights, const Execution& execution) {
  const Eigen::Index n = sites_.rows();
  if (heights.size() != n || !heights.allFinite()) {
    throw GeometryError("One finite height per site (" + std::to_string(n) + ") is required, but there are " +
                        std::to_string(heights.size()) + (heights.allFinite() ? "." : ", not all of them finite."));
  }
  if (cells_.areas.size() == n && (heights_.array() == heights.array()).all()) return cells_;
  cells_.areas.resize(0);
  heights_ = heights;
  triangulate();
  placeCorners(execution);
  cells_.areas = Eigen::VectorXd::Zero(n);
  cells_.centroids.resize(n, 3);
  std::vector<std::vector<SphericalPowerEdge>> found((static_cast<std::size_t>(n) + kBlock - 1) / kBlock);
  parallelFor(found.size(), execution, [&](std::size_t begin, std::size_t end) {
    for (std::size_t block = begin; block < end; ++block) {
      const std::size_t last = std::min(static_cast<std::size_t>(n), (block + 1) * kBlock);
      for (std::size_t i = block * kBlock; i < last; ++i) addCell(static_cast<int>(i), found[block]);
    }
  }, 1);
  cells_.edges.clear();
  for (const auto& edges : found) cells_.edges.insert(cells_.edges.end(), edges.begin(), edges.end());
  cells_.emptyCells = static_cast<int>((cells_.areas.array() <= 0).count());
  return cells_;
}

double SphericalPowerDiagram::transportCost() const {
  double cost = 0;
  for (int i = 0; i < static_cast<int>(sites_.rows()); ++i) {
    const Eigen::Vector3d site = sites_.row(i).transpose(), middle = cells_.centroids.row(i).transpose();
    const auto at = [&](const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
      return -std::log((a + b).normalized().dot(site));
    };
    visitCorners(i, [&](int face, int next, int) {
      const Eigen::Vector3d &a = corners_[static_cast<std::size_t>(face)],
                            &b = corners_[static_cast<std::size_t>(next)];
      cost += signedSolidAngle(middle, a, b) / 3 * (at(middle, a) + at(a, b) + at(b, middle));
    });
  }
  return cost;
}

SphericalCellPolygons SphericalPowerDiagram::polygons(double arcStep) const {
  SphericalCellPolygons polygons;
  polygons.starts.push_back(0);
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i < static_cast<int>(sites_.rows()); ++i) {
    if (cells_.areas[i] > 0) {
      visitCorners(i, [&](int face, int next, int) {
        const Eigen::Vector3d &a = corners_[at(face)], &b = corners_[at(next)];
        const double length = 2 * std::atan2((b - a).norm(), (b + a).norm());
        const int pieces = std::max(1, static_cast<int>(std::ceil(length / arcStep)));
        for (int piece = 0; piece < pieces; ++piece) {
          const double t = length * piece / pieces;
          const Eigen::Vector3d p = piece == 0 ? a : Eigen::Vector3d(std::sin(length - t) * a + std::sin(t) * b);
          points.push_back(p.normalized());
        }
      });
    }
    polygons.starts.push_back(static_cast<int>(points.size()));
  }
  polygons.corners.resize(static_cast<Eigen::Index>(points.size()), 3);
  for (std::size_t k = 0; k < points.size(); ++k) {
    polygons.corners.row(static_cast<Eigen::Index>(k)) = points[k].transpose();
  }
  return polygons;
}

}  // namespace authalic
