/// @file
/// FreeSurfer patches: the part of a surface that a cut leaves, in space or flattened.
#pragma once

#include <string>
#include <vector>

#include "Formats/SurfaceFile.h"

namespace authalic {

/// A patch as its file holds it: vertices of another surface, and no faces.
struct PatchFile {
  std::vector<int> vertices;   ///< n, numbers in the whole surface, 0-based, each once
  std::vector<bool> border;    ///< n, whether the vertex lies on the edge of the patch
  std::vector<double> points;  ///< 3n
};

/// Reads FreeSurfer patches (`lh.NAME.patch.3d`, `lh.NAME.patch.flat`), the present layout (32-bit floats) and the
/// one before 2003 (hundredths in 16 bits). A negative number in the file marks a vertex of the border.
/// @throws FormatError when the file is missing, of another kind, truncated or names a vertex twice
[[nodiscard]] PatchFile readPatch(const std::string& path);

/// The patch as a surface: those faces of `whole` whose three vertices are all in the patch, in their order.
///
/// A patch in space is taken to be in the space of `whole`; one with every z = 0 is flat, of unknown space and
/// of GeometricType Flat. Vertices keep the order of the file: vertex i is patch.vertices[i] of `whole`.
/// @throws FormatError when the patch names a vertex that `whole` does not have
[[nodiscard]] SurfaceFile patchSurface(const std::string& path, const PatchFile& patch, const SurfaceFile& whole);

/// Writes the present layout. Faces are lost: a reader takes them from the whole surface. Coordinates become
/// 32-bit. Written whole or not at all.
/// @throws FormatError when a vertex comes twice (a surface torn along seams) or the file cannot be written
void writePatch(const std::string& path, const PatchFile& patch);

}  // namespace authalic
