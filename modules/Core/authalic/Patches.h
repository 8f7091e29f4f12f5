/// @file
/// Patches around some faces of a disk, whose inner vertices move while all others are held. Private to authalic/.
#pragma once

#include <vector>

#include "Core/mesh/DiskMesh.h"

namespace authalic {

/// Parts of a surface that know nothing of each other: the patches of free vertices between held ones.
struct Parts {
  std::vector<int> ofVertex, ofFace;  ///< −1: held
  int count = 0;
};

/// n flags: all vertices farther than `rings` edges from the faces, and those of the boundary.
[[nodiscard]] std::vector<char> heldAround(const DiskMesh& disk, const Eigen::Array<bool, Eigen::Dynamic, 1>& faces,
                                           int rings);

/// Free vertices of one face belong to one part, and so does the face.
[[nodiscard]] Parts partsBetween(const std::vector<char>& held, const Faces& faces);

}  // namespace authalic
