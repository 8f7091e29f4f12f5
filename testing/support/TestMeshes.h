/// @file
/// Small meshes with known geometry.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <random>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "Core/mesh/TriangleMesh.h"

namespace authalic::testing {

/// [0, width] × [0, height] in the plane z = 0, (columns+1)·(rows+1) vertices, diagonals alternating.
inline TriangleMesh gridMesh(int columns, int rows, double width = 1.0, double height = 1.0) {
  Points3 points((columns + 1) * (rows + 1), 3);
  for (int j = 0; j <= rows; ++j) {
    for (int i = 0; i <= columns; ++i) points.row(j * (columns + 1) + i) << width * i / columns, height * j / rows, 0.0;
  }
  Faces faces(2 * columns * rows, 3);
  for (int j = 0, f = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i, f += 2) {
      const int a = j * (columns + 1) + i, b = a + 1, c = a + columns + 2, d = a + columns + 1;
      if ((i + j) % 2 == 0) {
        faces.row(f) << a, b, c;
        faces.row(f + 1) << a, c, d;
      } else {
        faces.row(f) << a, b, d;
        faces.row(f + 1) << b, c, d;
      }
    }
  }
  return TriangleMesh(points, faces);
}

/// Rings of a triangulated flat disk of radius 1: one centre, then ring r has 6 r vertices.
inline TriangleMesh diskMesh(int rings) {
  std::vector<std::array<double, 3>> p{{0, 0, 0}};
  std::vector<int> first{0};
  for (int r = 1; r <= rings; ++r) {
    first.push_back(static_cast<int>(p.size()));
    for (int k = 0; k < 6 * r; ++k) {
      const double t = 2 * M_PI * k / (6 * r);
      p.push_back({std::cos(t) * r / rings, std::sin(t) * r / rings, 0.0});
    }
  }
  std::vector<std::array<int, 3>> f;
  for (int r = 1; r <= rings; ++r) {
    const int outer = 6 * r, inner = r == 1 ? 1 : 6 * (r - 1), o = first[static_cast<std::size_t>(r)],
              n = first[static_cast<std::size_t>(r - 1)];
    for (int side = 0; side < 6; ++side) {
      for (int k = 0; k < r; ++k) {
        const int a = side * r + k, b = r == 1 ? 0 : side * (r - 1) + k;
        f.push_back({o + a, o + (a + 1) % outer, n + b % inner});
        if (k + 1 < r) f.push_back({n + b % inner, o + (a + 1) % outer, n + (b + 1) % inner});
      }
    }
  }
  Points3 points(static_cast<Eigen::Index>(p.size()), 3);
  for (std::size_t i = 0; i < p.size(); ++i) points.row(static_cast<Eigen::Index>(i)) << p[i][0], p[i][1], p[i][2];
  Faces faces(static_cast<Eigen::Index>(f.size()), 3);
  for (std::size_t i = 0; i < f.size(); ++i) faces.row(static_cast<Eigen::Index>(i)) << f[i][0], f[i][1], f[i][2];
  return TriangleMesh(points, faces);
}

/// The flat disk bent onto the spherical cap of the unit sphere down to polar angle `opening` (radians).
inline TriangleMesh capMesh(int rings, double opening) {
  const TriangleMesh flat = diskMesh(rings);
  Points3 points = flat.points();
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    const double radius = points.row(i).norm(), theta = radius * opening,
                 scale = radius > 0 ? std::sin(theta) / radius : 0;
    points.row(i) << points(i, 0) * scale, points(i, 1) * scale, std::cos(theta);
  }
  return TriangleMesh(points, flat.faces());
}

/// A bumpy height field over the unit disk; no symmetry.
inline TriangleMesh bumpyDisk(int rings, double height = 0.5) {
  const TriangleMesh flat = diskMesh(rings);
  Points3 points = flat.points();
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    const double x = points(i, 0), y = points(i, 1);
    points(i, 2) =
        height * (std::sin(3 * x + 1) * std::cos(4 * y) + 0.5 * std::exp(-8 * ((x - 0.3) * (x - 0.3) + y * y)));
  }
  return TriangleMesh(points, flat.faces());
}

/// Vertices at random places over the disk: bad angles, no symmetry.
inline TriangleMesh roughDisk(int rings, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  const TriangleMesh flat = diskMesh(rings);
  Points3 points = flat.points();
  for (Eigen::Index i = 0; i < points.size(); ++i) points.data()[i] += 0.45 / rings * uniform(random);
  return TriangleMesh(points, flat.faces());
}

/// The octahedron subdivided `levels` times onto the unit sphere.
inline TriangleMesh sphereMesh(int levels) {
  std::vector<Eigen::Vector3d> p{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  std::vector<std::array<int, 3>> f{{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                                    {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  for (int level = 0; level < levels; ++level) {
    std::map<std::pair<int, int>, int> middle;
    const auto mid = [&](int a, int b) {
      const auto key = std::minmax(a, b);
      const auto found = middle.find(key);
      if (found != middle.end()) return found->second;
      p.push_back((p[static_cast<std::size_t>(a)] + p[static_cast<std::size_t>(b)]).normalized());
      return middle[key] = static_cast<int>(p.size()) - 1;
    };
    std::vector<std::array<int, 3>> finer;
    for (const auto& t : f) {
      const int x = mid(t[0], t[1]), y = mid(t[1], t[2]), z = mid(t[2], t[0]);
      finer.insert(finer.end(), {{t[0], x, z}, {x, t[1], y}, {z, y, t[2]}, {x, y, z}});
    }
    f = std::move(finer);
  }
  Points3 points(static_cast<Eigen::Index>(p.size()), 3);
  for (std::size_t i = 0; i < p.size(); ++i) points.row(static_cast<Eigen::Index>(i)) = p[i].transpose();
  Faces faces(static_cast<Eigen::Index>(f.size()), 3);
  for (std::size_t i = 0; i < f.size(); ++i) faces.row(static_cast<Eigen::Index>(i)) << f[i][0], f[i][1], f[i][2];
  return TriangleMesh(points, faces);
}

/// Closed, no symmetry: the vertices of the sphere at a distance of 1 plus waves.
inline TriangleMesh wavySphere(int levels) {
  const TriangleMesh mesh = sphereMesh(levels);
  Points3 points = mesh.points();
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    const double x = points(i, 0), y = points(i, 1), z = points(i, 2);
    points.row(i) *= 1 + 0.25 * std::sin(3 * x + 1) * std::cos(2 * y) + 0.2 * x * z + 0.3 * z;
  }
  return TriangleMesh(points, mesh.faces());
}

/// A cylinder of radius 1 and 2 `length` circumferences along z with a hemisphere at each end; rings of `around`
/// vertices an edge apart (fewer towards the poles), each turned by itself, and vertices up to a sixth of an edge off.
inline TriangleMesh capsuleMesh(int around, double length, unsigned seed = 1) {
  std::mt19937 random(seed);
  const auto uniform = [&random](double most) { return most * (2.0 * random() / 4294967296.0 - 1); };
  const double half = 2 * M_PI * length, edge = 2 * M_PI / around, rise = edge * std::sqrt(0.75);
  std::vector<std::array<double, 2>> profile;  // z, radius
  const int along = std::max(1, static_cast<int>(std::lround(2 * half / rise))),
            over = std::max(2, static_cast<int>(std::lround(M_PI / 2 / rise)));
  const auto cap = [over](int k) { return M_PI / 2 * k / over; };
  for (int k = over - 1; k > 0; --k) profile.push_back({-half - std::sin(cap(k)), std::cos(cap(k))});
  for (int k = 0; k <= along; ++k) profile.push_back({half * (2.0 * k / along - 1), 1});
  for (int k = 1; k < over; ++k) profile.push_back({half + std::sin(cap(k)), std::cos(cap(k))});
  std::vector<Eigen::RowVector3d> points{{0, 0, -half - 1}};
  std::vector<std::vector<int>> rings{{0}};
  for (const auto& [z, radius] : profile) {
    const int count = std::max(5, static_cast<int>(std::lround(around * radius)));
    const double start = uniform(M_PI), shake = radius == 1 ? edge / 6 : 0;
    rings.emplace_back();
    for (int k = 0; k < count; ++k) {
      const double angle = start + 2 * M_PI * (k + uniform(1.0 / 6)) / count;
      rings.back().push_back(static_cast<int>(points.size()));
      points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), z + uniform(shake));
    }
  }
  rings.push_back({static_cast<int>(points.size())});
  points.emplace_back(0, 0, half + 1);
  std::vector<Eigen::RowVector3i> faces;
  for (std::size_t r = 0; r + 1 < rings.size(); ++r) {
    const std::vector<int>&lower = rings[r], &upper = rings[r + 1];
    const std::size_t below = lower.size() == 1 ? 0 : lower.size(), above = upper.size() == 1 ? 0 : upper.size();
    const auto distance = [&](int a, int b) {
      return (points[static_cast<std::size_t>(a)] - points[static_cast<std::size_t>(b)]).norm();
    };
    std::size_t first = 0;  // of the upper ring, nearest to the first of the lower one
    for (std::size_t j = 1; j < upper.size(); ++j) {
      if (distance(upper[j], lower[0]) < distance(upper[first], lower[0])) first = j;
    }
    for (std::size_t i = 0, j = 0; i < below || j < above;) {
      const int a = lower[i % lower.size()], b = lower[(i + 1) % lower.size()], c = upper[(first + j) % upper.size()],
                d = upper[(first + j + 1) % upper.size()];
      if (j == above || (i < below && distance(b, c) <= distance(d, a))) faces.emplace_back(a, b, c), ++i;
      else faces.emplace_back(a, d, c), ++j;
    }
  }
  Points3 allPoints(static_cast<Eigen::Index>(points.size()), 3);
  for (std::size_t v = 0; v < points.size(); ++v) allPoints.row(static_cast<Eigen::Index>(v)) = points[v];
  Faces allFaces(static_cast<Eigen::Index>(faces.size()), 3);
  for (std::size_t f = 0; f < faces.size(); ++f) allFaces.row(static_cast<Eigen::Index>(f)) = faces[f];
  return TriangleMesh(allPoints, allFaces);
}

}  // namespace authalic::testing
