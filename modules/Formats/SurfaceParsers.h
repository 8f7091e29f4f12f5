/// @file
/// The readers behind readSurface(), one per kind of file, on bytes in memory. Private to Formats/.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "Formats/SurfaceFile.h"

namespace authalic {

struct Mz3File;

using FileBytes = std::vector<std::uint8_t>;

/// What the first bytes say a file is.
enum class FileKind {
  FreeSurferTriangles,
  FreeSurferQuads,
  FreeSurferMorphometry,
  FreeSurferPatch,
  Gifti,
  Off,
  Ply,
  Mz3,
  Other
};

/// FF FF FF begins old quadrangle surfaces, morphometry files and patches: the size tells them apart.
[[nodiscard]] FileKind recognise(const FileBytes& bytes);
/// "a FreeSurfer morphometry file", for messages.
[[nodiscard]] const char* fileKindName(FileKind kind) noexcept;

[[nodiscard]] SurfaceFile parseFreeSurferTriangles(const std::string& path, const FileBytes& bytes);
[[nodiscard]] SurfaceFile parseFreeSurferQuads(const std::string& path, const FileBytes& bytes);
[[nodiscard]] SurfaceFile parseGiftiSurface(const std::string& path, const FileBytes& bytes);
[[nodiscard]] SurfaceFile parseMz3Surface(const std::string& path, const FileBytes& bytes);
[[nodiscard]] Mz3File parseMz3(const std::string& path, const FileBytes& bytes);
[[nodiscard]] SurfaceFile parseOff(const std::string& path, const FileBytes& bytes);
[[nodiscard]] SurfaceFile parsePly(const std::string& path, const FileBytes& bytes);
[[nodiscard]] SurfaceFile parseObj(const std::string& path, const FileBytes& bytes);

/// @throws FormatError naming the first face with an index outside [0, n), or when there is no vertex
void checkFaceIndices(const std::string& path, const SurfaceFile& surface);

}  // namespace authalic
