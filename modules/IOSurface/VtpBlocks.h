/// @file
/// The binary arrays of VTK's XML files: base64 or raw, compressed in parts or not. Private to IOSurface/.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "Formats/ByteCursor.h"

class vtkDataCompressor;

namespace authalic {

/// How the root element says that binary arrays are written.
struct VtpLayout {
  ByteOrder order = ByteOrder::Little;
  bool words64 = false;                     ///< of the numbers before a block
  vtkDataCompressor* compressor = nullptr;  ///< none: not compressed
};

/// The bytes of one array.
///
/// Memory grows with the bytes that are there: what a header claims is held against the text before anything is
/// allocated, at most 1032 bytes (the most that deflate reaches) for each.
/// @param text   base64 or raw bytes from the first of the array on; what follows it is not looked at
/// @throws FormatError when they are not exactly `expected` bytes, or damaged
[[nodiscard]] std::vector<std::uint8_t> vtpBytes(const std::string& path, std::string_view text, bool base64,
                                                 const VtpLayout& layout, std::uint64_t expected);

/// How many bytes an array claims to be; no more than its text can hold.
/// @throws FormatError
[[nodiscard]] std::uint64_t vtpLength(const std::string& path, std::string_view text, bool base64,
                                      const VtpLayout& layout);

}  // namespace authalic
