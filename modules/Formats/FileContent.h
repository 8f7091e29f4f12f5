/// @file
/// What kind of thing a file holds, found from its first bytes and, where these say nothing, from its name.
#pragma once

#include <string>

namespace authalic {

enum class FileContent {
  Surface,     ///< vertices and faces; also what is recognised as nothing else
  Patch,       ///< FreeSurfer's part of a surface, without faces
  VertexData,  ///< numbers, regions or lists of vertices that belong to a surface
  Volume,
};

/// Images of n × 1 × 1 and CIFTI files are per-vertex data. Only the beginning of a file is looked at, except
/// where its length decides (FreeSurfer's FF FF FF).
/// @throws FormatError when the file is missing, empty or cannot be read
[[nodiscard]] FileContent contentOf(const std::string& path);

}  // namespace authalic
