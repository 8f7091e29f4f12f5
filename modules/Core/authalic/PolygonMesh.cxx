#include "Core/authalic/PolygonMesh.h"

#include <array>
#include <utility>

#include "Core/authalic/FlowingMesh.h"
#include "Core/base/Error.h"
#include "Core/geometry/Areas.h"

namespace authalic {
namespace {

constexpr int kRounds = 16;
using Triangle = std::array<int, 3>;

double turn(const Points2& p, int a, int b, int c) {
  const Eigen::RowVector2d u = p.row(b) - p.row(a), v = p.row(c) - p.row(b);
  return u[0] * v[1] - u[1] * v[0];
}

bool isEar(const Points2& p, const std::vector<int>& ring, std::size_t i) {
  const int a = ring[(i + ring.size() - 1) % ring.size()], b = ring[i], c = ring[(i + 1) % ring.size()];
  if (!(turn(p, a, b, c) > 0)) return false;
  for (const int v : ring) {
    if (v == a || v == b || v == c) continue;
    if (turn(p, a, b, v) >= 0 && turn(p, b, c, v) >= 0 && turn(p, c, a, v) >= 0) return false;
  }
  return true;
}

std::vector<Triangle> clipEars(const Points2& p, std::vector<int> ring) {
  std::vector<Triangle> faces;
  while (ring.size() > 3) {
    std::size_t ear = 0;
    while (ear < ring.size() && !isEar(p, ring, ear)) ++ear;
    if (ear == ring.size()) {
      throw GeometryError("A simple polygon is required, but none of its remaining " + std::to_string(ring.size()) +
                          " corners can be cut off.");
    }
    faces.push_back({ring[(ear + ring.size() - 1) % ring.size()], ring[ear], ring[(ear + 1) % ring.size()]});
    ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(ear));
  }
  faces.push_back({ring[0], ring[1], ring[2]});
  return faces;
}

// Splits the face that runs along the boundary from `from` to `to` at the point `between`.
void splitSide(std::vector<Triangle>& faces, int from, int to, int between) {
  for (Triangle& face : faces) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (face[k] != from || face[(k + 1) % 3] != to) continue;
      const int tip = face[(k + 2) % 3];
      face = {from, between, tip};
      faces.push_back({between, to, tip});
      return;
    }
  }
}

Faces toFaces(const std::vector<Triangle>& triangles) {
  Faces faces(static_cast<Eigen::Index>(triangles.size()), 3);
  for (std::size_t f = 0; f < triangles.size(); ++f) {
    faces.row(static_cast<Eigen::Index>(f)) << triangles[f][0], triangles[f][1], triangles[f][2];
  }
  return faces;
}

Faces delaunay(const Points2& points, const Faces& faces) {
  FlowingMesh mesh(faces, static_cast<int>(points.rows()));
  mesh.makeDelaunay(points);
  return mesh.faces();
}

// Inserts the middle of every face that is too large. @return whether there was one
bool insertMiddles(double largestFace, Points2& points, Faces& faces) {
  const Eigen::VectorXd areas = signedFaceAreas(points, faces);
  const Eigen::Index large = (areas.array() > largestFace).count(), oldFaces = faces.rows();
  if (large == 0) return false;
  Eigen::Index point = points.rows(), face = oldFaces;
  points.conservativeResize(point + large, 2);
  faces.conservativeResize(oldFaces + 2 * large, 3);
  for (Eigen::Index f = 0; f < oldFaces; ++f) {
    if (!(areas[f] > largestFace)) continue;
    const int a = faces(f, 0), b = faces(f, 1), c = faces(f, 2), middle = static_cast<int>(point);
    points.row(point++) = (points.row(a) + points.row(b) + points.row(c)) / 3;
    faces.row(f) << a, b, middle;
    faces.row(face++) << b, c, middle;
    faces.row(face++) << c, a, middle;
  }
  return true;
}

}  // namespace

PolygonMesh polygonMesh(const Points2& boundary, const std::vector<int>& corners, double largestFace) {
  std::vector<Triangle> triangles = clipEars(boundary, corners);
  const int count = static_cast<int>(boundary.rows());
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const int end = corners[(k + 1) % corners.size()];
    for (int from = corners[k]; (from + 1) % count != end; from = (from + 1) % count) {
      splitSide(triangles, from, end, (from + 1) % count);
    }
  }
  PolygonMesh mesh{boundary, delaunay(boundary, toFaces(triangles)), boundary.rows()};
  for (int round = 0; round < kRounds && insertMiddles(largestFace, mesh.points, mesh.faces); ++round) {
    mesh.faces = delaunay(mesh.points, mesh.faces);
  }
  return mesh;
}

}  // namespace authalic
