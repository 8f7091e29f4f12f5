/// @file
/// The payload of a GIFTI array: base64, zlib, text, number types, order of indices. Private to Formats/.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "Formats/ByteCursor.h"

namespace authalic {

enum class GiftiEncoding { Ascii, Base64, GzipBase64, External };

/// What the attributes of a `DataArray` say about its payload.
struct GiftiPayload {
  GiftiEncoding encoding = GiftiEncoding::GzipBase64;
  ByteOrder order = ByteOrder::Little;
  bool columnMajor = false;
  int type = 0;
  std::vector<std::int64_t> dimensions;
  std::string externalFile;
  std::uint64_t externalOffset = 0;
};

/// Bytes of one number, 0 for a type that is not read.
[[nodiscard]] int giftiTypeSize(int type) noexcept;

/// The values in row-major order.
/// @throws FormatError when the payload does not hold exactly the product of the dimensions
[[nodiscard]] std::vector<double> decodeGiftiPayload(const std::string& path, const GiftiPayload& payload,
                                                     std::string_view text);

/// The values as GZipBase64Binary, little endian; type UINT8, INT32 or FLOAT32.
[[nodiscard]] std::string encodeGiftiPayload(const std::vector<double>& values, int type);

}  // namespace authalic
