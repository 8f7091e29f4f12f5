/// @file
/// Reads a mesh in OFF for tests and benchmarks that must not depend on the file formats under test.
#pragma once

#include <fstream>
#include <stdexcept>
#include <string>

#include "Core/mesh/TriangleMesh.h"

namespace authalic::testing {

inline TriangleMesh readOff(const std::string& path) {
  std::ifstream file(path);
  std::string magic;
  int vertices = 0, faces = 0, edges = 0;
  if (!(file >> magic >> vertices >> faces >> edges) || magic != "OFF") throw std::runtime_error(path + ": not OFF");
  Points3 points(vertices, 3);
  Faces triangles(faces, 3);
  for (Eigen::Index i = 0; i < points.size(); ++i) file >> points.data()[i];
  for (int f = 0, corners = 0; f < faces; ++f) {
    file >> corners >> triangles(f, 0) >> triangles(f, 1) >> triangles(f, 2);
    if (corners != 3) throw std::runtime_error(path + ": not a triangle mesh");
  }
  if (!file) throw std::runtime_error(path + ": ends too early");
  return TriangleMesh(points, triangles);
}

}  // namespace authalic::testing
