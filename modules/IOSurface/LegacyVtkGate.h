/// @file
/// The gate before VTK's legacy reader, which does not survive files that end early. Private to IOSurface/.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace authalic {

/// Walks through a legacy VTK file of poly data, text or binary, versions 1.0 to 5.1, and sees that every section is
/// there in full.
/// @throws FormatError when the file is another data set, a section is incomplete or of an unknown kind
void checkLegacyVtk(const std::string& path, const std::vector<std::uint8_t>& bytes);

}  // namespace authalic
