/// @file
/// What names of files say. Private to IOSurface/.
#pragma once

#include <string>

namespace authalic {

/// The last part of a name from its dot, in small letters, without .gz.
[[nodiscard]] std::string extensionOf(const std::string& path);

/// Whether the name has a part ".patch.", as lh.cortex.patch.flat and lh.flat.patch.3d do.
[[nodiscard]] bool isPatchName(const std::string& path);

/// Name of an array: lh.aparc.annot.gz → aparc
[[nodiscard]] std::string arrayNameOf(const std::string& path);

/// @throws InvalidArgument when the name ends in .gz, which only volumes are written as
void requireUncompressedName(const std::string& path);

}  // namespace authalic
