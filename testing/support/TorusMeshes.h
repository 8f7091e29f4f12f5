/// @file
/// Closed surfaces with one and two handles.
#pragma once

#include <cmath>
#include <vector>

#include "Core/mesh/TriangleMesh.h"

namespace authalic::testing {

/// Torus of revolution: radius of the ring 2, of the tube 1; `ring` × `tube` vertices, faces outwards.
inline TriangleMesh torusMesh(int ring, int tube) {
  Points3 points(ring * tube, 3);
  Faces faces(2 * ring * tube, 3);
  const auto id = [&](int i, int j) { return (i % ring) * tube + j % tube; };
  for (int i = 0; i < ring; ++i) {
    for (int j = 0; j < tube; ++j) {
      const double u = 2 * M_PI * i / ring, v = 2 * M_PI * j / tube, r = 2 + std::cos(v);
      points.row(id(i, j)) << r * std::cos(u), r * std::sin(u), std::sin(v);
      faces.row(2 * id(i, j)) << id(i, j), id(i + 1, j), id(i + 1, j + 1);
      faces.row(2 * id(i, j) + 1) << id(i, j), id(i + 1, j + 1), id(i, j + 1);
    }
  }
  return TriangleMesh(points, faces);
}

/// Two tori of revolution, joined where one face of each was taken out.
inline TriangleMesh doubleTorusMesh(int size) {
  const TriangleMesh one = torusMesh(2 * size, size);
  const int n = one.vertexCount(), m = one.faceCount();
  // The outermost face of the first, mirrored (x → 7 − x) for the second: corner k of one touches corner k of the
  // other.
  const Eigen::RowVector3i gate = one.faces().row(0);
  Points3 points(2 * n, 3);
  points << one.points(), one.points();
  points.bottomRows(n).col(0) = 7.0 - points.bottomRows(n).col(0).array();
  std::vector<int> number(static_cast<std::size_t>(2 * n));
  for (int v = 0; v < 2 * n; ++v) number[static_cast<std::size_t>(v)] = v;
  for (int k = 0; k < 3; ++k) number[static_cast<std::size_t>(n + gate[k])] = gate[k];
  std::vector<int> compact(static_cast<std::size_t>(2 * n), -1);
  int used = 0;
  Faces faces(2 * m - 2, 3);
  for (int f = 1; f < m; ++f) {
    for (int k = 0; k < 3; ++k) {
      faces(f - 1, k) = number[static_cast<std::size_t>(one.faces()(f, k))];
      faces(m + f - 2, 2 - k) = number[static_cast<std::size_t>(n + one.faces()(f, k))];
    }
  }
  for (Eigen::Index c = 0; c < faces.size(); ++c) {
    int& id = compact[static_cast<std::size_t>(faces.data()[c])];
    if (id < 0) id = used++;
  }
  Points3 kept(used, 3);
  for (int v = 0; v < 2 * n; ++v) {
    if (compact[static_cast<std::size_t>(v)] >= 0) kept.row(compact[static_cast<std::size_t>(v)]) = points.row(v);
  }
  for (Eigen::Index c = 0; c < faces.size(); ++c) {
    faces.data()[c] = compact[static_cast<std::size_t>(faces.data()[c])];
  }
  return TriangleMesh(kept, faces);
}

}  // namespace authalic::testing
