/// @file
/// Compression of what is written. Private to Formats/.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace authalic {

/// A gzip stream without a time stamp, so that the same bytes give the same file.
/// @throws FormatError naming `path` when there is no memory left
[[nodiscard]] std::vector<std::uint8_t> gzipped(const std::string& path, const std::vector<std::uint8_t>& bytes);

}  // namespace authalic
