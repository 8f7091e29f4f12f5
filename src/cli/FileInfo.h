/// @file
/// What `info` says of files that are no surfaces: volumes, per-vertex data, patches.
#pragma once

#include <string>

#include "Files.h"

namespace authalic::cli {

/// Voxels, values, axes, space and how it was decided, doubts about it.
[[nodiscard]] OrderedJson volumeInfo(const std::string& path, const VolumeOption& option, const Session& session);

/// Arrays with their range, regions, structures of a CIFTI file; lists of some vertices as they are.
[[nodiscard]] OrderedJson vertexDataInfo(const std::string& path, const Session& session);

/// Vertices of a FreeSurfer patch whose surface was not given.
[[nodiscard]] OrderedJson patchInfo(const std::string& path);

/// One line per member, lists and tables over several.
void printInfo(const OrderedJson& info);

}  // namespace authalic::cli
