/// @file
/// The gate before VTK's XML reader, which does not survive counts that are negative or beyond the file.
/// Private to IOSurface/.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace authalic {

/// Sees that a .vtp file is closed by its last tag, says that it holds poly data, and claims no count (NumberOfPoints,
/// NumberOfPolys …) and no length of a binary array that is negative or more than its bytes can hold when compressed as
/// far as deflate goes.
/// @throws FormatError
void checkVtp(const std::string& path, const std::vector<std::uint8_t>& bytes);

}  // namespace authalic
