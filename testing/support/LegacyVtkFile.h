/// @file
/// Reads triangles from a legacy VTK file in ASCII for tests that must not depend on VTK.
#pragma once

#include <fstream>
#include <stdexcept>
#include <string>

#include "Core/mesh/TriangleMesh.h"

namespace authalic::testing {

/// @param spacing  mm per unit of the file's coordinates
inline TriangleMesh readLegacyVtk(const std::string& path, const Eigen::RowVector3d& spacing) {
  std::ifstream file(path);
  Points3 points;
  Faces faces;
  for (std::string word; file >> word;) {
    if (word == "POINTS") {
      int count = 0;
      std::string type;
      file >> count >> type;
      points.resize(count, 3);
      for (Eigen::Index i = 0; i < points.size(); ++i) file >> points.data()[i];
    } else if (word == "POLYGONS") {
      int count = 0, size = 0;
      file >> count >> size;
      faces.resize(count, 3);
      for (int f = 0, corners = 0; f < count; ++f) {
        file >> corners >> faces(f, 0) >> faces(f, 1) >> faces(f, 2);
        if (corners != 3) throw std::runtime_error(path + ": not a triangle mesh");
      }
    }
  }
  if (faces.rows() == 0) throw std::runtime_error(path + ": no triangles");
  return TriangleMesh(Points3(points.array().rowwise() * spacing.array()), faces);
}

}  // namespace authalic::testing
