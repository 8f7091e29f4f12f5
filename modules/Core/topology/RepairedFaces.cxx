#include "Core/topology/RepairedFaces.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <numeric>
#include <tuple>

namespace authalic {

RepairedFaces::RepairedFaces(const Points3& inputPoints, const Faces& inputFaces)
    : originalPoint(static_cast<std::size_t>(inputPoints.rows())) {
  for (Eigen::Index i = 0; i < inputPoints.rows(); ++i) points.emplace_back(inputPoints.row(i).transpose());
  std::iota(originalPoint.begin(), originalPoint.end(), 0);
  pointSource = originalPoint;
  for (Eigen::Index f = 0; f < inputFaces.rows(); ++f) {
    const int id = static_cast<int>(f);
    faces.push_back({{inputFaces(f, 0), inputFaces(f, 1), inputFaces(f, 2)}, id, id});
  }
}

double RepairedFaces::area(const RepairedFace& face) const {
  const Eigen::Vector3d &a = point(face.v[0]), &b = point(face.v[1]), &c = point(face.v[2]);
  return 0.5 * (b - a).cross(c - a).norm();
}

Eigen::Vector3d RepairedFaces::centre(const RepairedFace& face) const {
  return (point(face.v[0]) + point(face.v[1]) + point(face.v[2])) / 3.0;
}

Faces RepairedFaces::faceMatrix() const {
  Faces matrix(static_cast<Eigen::Index>(faces.size()), 3);
  for (std::size_t f = 0; f < faces.size(); ++f) {
    for (int k = 0; k < 3; ++k) matrix(static_cast<Eigen::Index>(f), k) = faces[f].v[static_cast<std::size_t>(k)];
  }
  return matrix;
}

Points3 RepairedFaces::pointMatrix() const {
  Points3 matrix(static_cast<Eigen::Index>(points.size()), 3);
  for (std::size_t i = 0; i < points.size(); ++i) matrix.row(static_cast<Eigen::Index>(i)) = points[i].transpose();
  return matrix;
}

int RepairedFaces::copyOf(int vertex) {
  const auto v = static_cast<std::size_t>(vertex);
  const Eigen::Vector3d place = points[v];
  const int original = originalPoint[v], source = pointSource[v];
  points.push_back(place);
  originalPoint.push_back(original);
  pointSource.push_back(source);
  return static_cast<int>(points.size()) - 1;
}

void RepairedFaces::removeFaces(const std::vector<char>& gone) {
  std::size_t kept = 0;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    if (f >= gone.size() || !gone[f]) faces[kept++] = faces[f];
  }
  faces.erase(faces.begin() + static_cast<std::ptrdiff_t>(kept), faces.end());
}

void RepairedFaces::listFace(RepairKind kind, const RepairedFace& face, double size) {
  changes.push_back({kind, {}, centre(face), size});
  if (face.original >= 0) changes.back().ids.push_back(face.original);
}

void RepairedFaces::listVertices(RepairKind kind, const std::vector<int>& vertices, double size) {
  changes.push_back({kind, {}, Eigen::Vector3d::Zero(), size});
  for (const int v : vertices) {
    changes.back().place += point(v) / static_cast<double>(vertices.size());
    const int original = originalPoint[static_cast<std::size_t>(v)];
    if (original >= 0) changes.back().ids.push_back(original);
  }
}

std::vector<EdgeFaces> edgesOf(const std::vector<RepairedFace>& faces) {
  std::vector<std::tuple<int, int, int>> keyed;
  keyed.reserve(3 * faces.size());
  for (std::size_t f = 0; f < faces.size(); ++f) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [a, b] = std::minmax(faces[f].v[k], faces[f].v[(k + 1) % 3]);
      keyed.emplace_back(a, b, static_cast<int>(3 * f + k));
    }
  }
  std::sort(keyed.begin(), keyed.end());
  std::vector<EdgeFaces> edges;
  for (const auto& [a, b, h] : keyed) {
    if (edges.empty() || edges.back().a != a || edges.back().b != b) edges.push_back({a, b, {}});
    edges.back().halfEdges.push_back(h);
  }
  return edges;
}

DisjointSets::DisjointSets(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0); }

int DisjointSets::find(int a) {
  while (parent_[static_cast<std::size_t>(a)] != a) {
    int& up = parent_[static_cast<std::size_t>(a)];
    up = parent_[static_cast<std::size_t>(up)];
    a = up;
  }
  return a;
}

bool DisjointSets::join(int a, int b) {
  const auto [first, second] = std::minmax({find(a), find(b)});
  parent_[static_cast<std::size_t>(second)] = first;
  return first != second;
}

FacesAround facesAround(const RepairedFaces& surface) {
  FacesAround around(surface.pointCount());
  for (std::size_t f = 0; f < surface.faces.size(); ++f) {
    for (const int v : surface.faces[f].v) around[static_cast<std::size_t>(v)].push_back(static_cast<int>(f));
  }
  return around;
}

}  // namespace authalic
