/// @file
/// Small meshes with several boundary loops.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "Core/mesh/SurfaceTopology.h"
#include "support/TestMeshes.h"

namespace authalic::testing {

/// `around` × (`along` + 1) vertices on a surface of revolution: radius(t), height(t) for t in [0, 1], every other
/// ring turned by half a step. Faces look outwards when the height grows; the loop of t = 0 has the smaller ids.
template <class Radius, class Height>
TriangleMesh revolutionMesh(int around, int along, const Radius& radius, const Height& height) {
  Points3 points(around * (along + 1), 3);
  Faces faces(2 * around * along, 3);
  for (int j = 0; j <= along; ++j) {
    const double t = static_cast<double>(j) / along;
    for (int i = 0; i < around; ++i) {
      const double angle = 2 * M_PI * (i + 0.5 * (j % 2)) / around;
      points.row(j * around + i) << radius(t) * std::cos(angle), radius(t) * std::sin(angle), height(t);
    }
  }
  for (int j = 0, f = 0; j < along; ++j) {
    for (int i = 0; i < around; ++i, f += 2) {
      const int a = j * around + i, b = j * around + (i + 1) % around, c = (j + 1) * around + i,
                d = (j + 1) * around + (i + 1) % around;
      if (j % 2 == 0) {
        faces.row(f) << a, b, c;
        faces.row(f + 1) << b, d, c;
      } else {
        faces.row(f) << a, b, d;
        faces.row(f + 1) << a, d, c;
      }
    }
  }
  return TriangleMesh(points, faces);
}

struct RoundHole {
  Eigen::RowVector2d centre;
  double radius;
};

/// The faces of a mesh without the vertices that none uses.
inline TriangleMesh packed(const Points3& points, const std::vector<Eigen::RowVector3i>& kept) {
  std::vector<int> number(static_cast<std::size_t>(points.rows()), -1);
  for (const auto& face : kept) {
    for (int k = 0; k < 3; ++k) number[static_cast<std::size_t>(face[k])] = 0;
  }
  Points3 used(std::count(number.begin(), number.end(), 0), 3);
  int next = 0;
  for (std::size_t v = 0; v < number.size(); ++v) {
    if (number[v] < 0) continue;
    used.row(next) = points.row(static_cast<Eigen::Index>(v));
    number[v] = next++;
  }
  Faces faces(static_cast<Eigen::Index>(kept.size()), 3);
  for (std::size_t f = 0; f < kept.size(); ++f) {
    for (int k = 0; k < 3; ++k) faces(static_cast<Eigen::Index>(f), k) = number[static_cast<std::size_t>(kept[f][k])];
  }
  return TriangleMesh(used, faces);
}

/// The flat unit disk of `rings` rings without round holes: faces that reach into a hole are dropped, so are ears
/// (three corners on a loop), and the loops are moved onto the circles.
inline TriangleMesh holedDisk(int rings, const std::vector<RoundHole>& holes) {
  const TriangleMesh disk = diskMesh(rings);
  std::vector<Eigen::RowVector3i> kept;
  for (Eigen::Index f = 0; f < disk.faces().rows(); ++f) {
    const Eigen::RowVector3i face = disk.faces().row(f);
    bool outside = true;
    for (int k = 0; k < 3; ++k) {
      for (const RoundHole& hole : holes) {
        outside = outside && (disk.points().row(face[k]).head(2) - hole.centre).norm() >= hole.radius;
      }
    }
    if (outside) kept.push_back(face);
  }
  for (std::size_t before = 0; before != kept.size();) {
    before = kept.size();
    Faces faces(static_cast<Eigen::Index>(kept.size()), 3);
    for (std::size_t f = 0; f < kept.size(); ++f) faces.row(static_cast<Eigen::Index>(f)) = kept[f];
    const SurfaceTopology topology(faces, disk.vertexCount());
    const auto onLoop = [&topology](int v) { return topology.onBoundary()[static_cast<std::size_t>(v)] != 0; };
    kept.erase(std::remove_if(kept.begin(), kept.end(),
                              [&](const auto& t) { return onLoop(t[0]) && onLoop(t[1]) && onLoop(t[2]); }),
               kept.end());
  }
  const TriangleMesh rough = packed(disk.points(), kept);
  const SurfaceTopology topology(rough.faces(), rough.vertexCount());
  Points3 points = rough.points();
  for (const std::vector<int>& loop : topology.boundaryLoops()) {
    for (const int v : loop) {
      if (points.row(v).norm() > 1 - 1e-9) continue;
      const RoundHole& hole = *std::min_element(holes.begin(), holes.end(), [&](const RoundHole& a, const RoundHole& b) {
        return (points.row(v).head(2) - a.centre).norm() - a.radius < (points.row(v).head(2) - b.centre).norm() - b.radius;
      });
      const Eigen::RowVector2d arm = points.row(v).head(2) - hole.centre;
      points.row(v).head(2) = hole.centre + arm * (hole.radius / arm.norm());
    }
  }
  return TriangleMesh(points, rough.faces());
}

}  // namespace authalic::testing
