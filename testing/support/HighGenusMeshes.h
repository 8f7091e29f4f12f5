/// @file
/// Closed surfaces with any number of handles.
#pragma once

#include <array>
#include <map>
#include <vector>

#include "Core/mesh/TriangleMesh.h"

namespace authalic::testing {

/// The smoothed surface of a slab with square holes in a row, of genus `holes`; `size` voxels to a hole and between.
inline TriangleMesh slabMesh(int holes, int size) {
  using Place = std::array<int, 3>;
  const Place extent{(2 * holes + 1) * size, 3 * size, size};
  const auto solid = [&](const Place& p) {
    for (std::size_t a = 0; a < 3; ++a) {
      if (p[a] < 0 || p[a] >= extent[a]) return false;
    }
    return p[0] / size % 2 == 0 || p[1] / size != 1;
  };
  std::map<Place, int> number;
  std::vector<std::array<int, 3>> triangles;
  const auto addSide = [&](Place corner, std::size_t axis, bool upper) {
    if (upper) ++corner[axis];
    std::array<int, 4> id{};
    for (int k = 0; k < 4; ++k) {
      Place p = corner;
      p[(axis + 1) % 3] += k == 1 || k == 2;
      p[(axis + 2) % 3] += k >= 2;
      id[static_cast<std::size_t>(k)] = number.emplace(p, static_cast<int>(number.size())).first->second;
    }
    if (!upper) std::swap(id[1], id[3]);
    triangles.push_back({id[0], id[1], id[2]});
    triangles.push_back({id[0], id[2], id[3]});
  };
  for (int x = 0; x < extent[0]; ++x) {
    for (int y = 0; y < extent[1]; ++y) {
      for (int z = 0; z < extent[2]; ++z) {
        const Place here{x, y, z};
        for (std::size_t axis = 0; axis < 3 && solid(here); ++axis) {
          for (const int step : {-1, 1}) {
            Place there = here;
            there[axis] += step;
            if (!solid(there)) addSide(here, axis, step > 0);
          }
        }
      }
    }
  }
  Points3 points(static_cast<Eigen::Index>(number.size()), 3);
  for (const auto& [p, id] : number) points.row(id) << p[0], p[1], p[2];
  Faces faces(static_cast<Eigen::Index>(triangles.size()), 3);
  for (Eigen::Index f = 0; f < faces.rows(); ++f) {
    for (int k = 0; k < 3; ++k) faces(f, k) = triangles[static_cast<std::size_t>(f)][static_cast<std::size_t>(k)];
  }
  for (int pass = 0; pass < 6; ++pass) {
    Points3 total = Points3::Zero(points.rows(), 3);
    Eigen::VectorXd count = Eigen::VectorXd::Zero(points.rows());
    for (Eigen::Index c = 0; c < faces.size(); ++c) {
      const Eigen::Index next = c % 3 == 2 ? c - 2 : c + 1;
      total.row(faces.data()[c]) += points.row(faces.data()[next]);
      count[faces.data()[c]] += 1;
    }
    points = 0.5 * (points + (total.array().colwise() / count.array()).matrix());
  }
  return TriangleMesh(points, faces);
}

}  // namespace authalic::testing
