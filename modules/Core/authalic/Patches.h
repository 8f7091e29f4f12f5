/// @file
/// Patches around some faces of a surface, whose inner vertices move while all others are held. Private to authalic/.
#pragma once

#include <vector>

#include "Core/authalic/AreaFunctional.h"
#include "Core/base/Arrays.h"

namespace authalic {

/// m flags.
using FaceFlags = Eigen::Array<bool, Eigen::Dynamic, 1>;

/// Parts of a surface that know nothing of each other: the patches of free vertices between held ones.
struct Parts {
  std::vector<int> ofVertex, ofFace;  ///< −1: held
  int count = 0;
};

/// n flags: all vertices farther than `rings` edges from the chosen faces, and those that are held anyway.
[[nodiscard]] std::vector<char> heldAround(const Faces& faces, const std::vector<char>& heldAnyway,
                                           const FaceFlags& chosen, int rings);

/// Free vertices of one face belong to one part, and so does the face.
[[nodiscard]] Parts partsBetween(const std::vector<char>& held, const Faces& faces);

/// The faces of one part, numbered by themselves.
struct Patch {
  std::vector<int> faces, vertices;  ///< of the whole
  Faces corners;                     ///< into `vertices`
  std::vector<char> freedom;         ///< of `vertices`: 2, or 0 where held
};

/// The patches of `rings` rings around the chosen faces in which vertices that move in two directions are free.
[[nodiscard]] std::vector<Patch> patchesAround(const FaceFlags& chosen, int rings, const AreaFunctional& areas);

}  // namespace authalic
