#include "Formats/GiftiData.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>

#include "Core/base/Error.h"
#include "Formats/Gifti.h"
#include "Formats/InputFile.h"
#include "Formats/TextNumbers.h"

namespace authalic {

namespace {

constexpr const char* kAlphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

std::array<std::int8_t, 256> decodingTable() {
  std::array<std::int8_t, 256> table{};
  table.fill(-1);
  for (int i = 0; i < 64; ++i) {
    table[static_cast<unsigned char>(kAlphabet[i])] = static_cast<std::int8_t>(i);
  }
  return table;
}

std::vector<std::uint8_t> decodeBase64(const std::string& path, std::string_view text) {
  static const auto table = decodingTable();
  std::vector<std::uint8_t> bytes;
  bytes.reserve(text.size() / 4 * 3 + 3);
  std::uint32_t group = 0;
  int bits = 0;
  for (const char c : text) {
    if (c == '=') {
      break;
    }
    if (c == '\n' || c == '\r' || c == ' ' || c == '\t') {
      continue;
    }
    const int value = table[static_cast<unsigned char>(c)];
    if (value < 0) {
      throw FormatError(
          path, "The binary data of an array hold a character that is not base64; the file is damaged.");
    }
    group = (group << 6U | static_cast<std::uint32_t>(value)) & 0xFFFFFFU;
    bits += 6;
    if (bits >= 8) {
      bits -= 8;
      bytes.push_back(static_cast<std::uint8_t>(group >> static_cast<unsigned>(bits)));
    }
  }
  return bytes;
}

[[noreturn]] void failSize(const std::string& path, std::uint64_t expected, const std::string& found) {
  throw FormatError(path, "The dimensions of an array ask for " + std::to_string(expected) +
                              " bytes, but its data hold " + found + "; the file is damaged or truncated.");
}

/// Unpacks at most `expected` bytes, growing with what really comes out.
std::vector<std::uint8_t> inflateBytes(const std::string& path, std::vector<std::uint8_t> packed,
                                       std::uint64_t expected) {
  z_stream stream{};
  // 15 + 32: zlib and gzip wrappers both occur.
  if (inflateInit2(&stream, 15 + 32) != Z_OK) {
    throw FormatError(path, "There is no memory left to unpack an array.");
  }
  stream.next_in = packed.data();
  stream.avail_in = static_cast<uInt>(packed.size());
  std::vector<std::uint8_t> bytes;
  int code = Z_OK;
  while (code == Z_OK && bytes.size() <= expected) {
    const std::size_t have = bytes.size();
    const auto chunk = static_cast<std::size_t>(std::min<std::uint64_t>(expected - have + 1, 1U << 22));
    bytes.resize(have + chunk);
    stream.next_out = bytes.data() + have;
    stream.avail_out = static_cast<uInt>(chunk);
    code = inflate(&stream, Z_NO_FLUSH);
    bytes.resize(have + chunk - stream.avail_out);
  }
  inflateEnd(&stream);
  if (code != Z_STREAM_END && bytes.size() <= expected) {
    throw FormatError(path, "The compressed data of an array are damaged or truncated.");
  }
  if (bytes.size() != expected) {
    failSize(path, expected, bytes.size() > expected ? "more" : std::to_string(bytes.size()));
  }
  return bytes;
}

std::vector<std::uint8_t> readExternal(const std::string& path, const GiftiPayload& payload,
                                       std::uint64_t size) {
  namespace fs = std::filesystem;
  if (payload.externalFile.empty()) {
    throw FormatError(path, "An array is said to be in an external file, but none is named.");
  }
  const fs::path name(payload.externalFile);
  InputFile file((name.is_absolute() ? name : fs::path(path).parent_path() / name).string());
  file.skip(payload.externalOffset, "the part of the external file before the data");
  return file.read(size, "the data of a GIFTI array");
}

template <class T>
void decodeAll(const std::vector<std::uint8_t>& bytes, ByteOrder order, std::vector<double>& values) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    values[i] = static_cast<double>(decode<T>(bytes.data() + i * sizeof(T), order));
  }
}

std::vector<double> numbersOf(const std::vector<std::uint8_t>& bytes, int type, ByteOrder order) {
  std::vector<double> values(bytes.size() / static_cast<std::size_t>(giftiTypeSize(type)));
  switch (type) {
    case GiftiType::Uint8:
      decodeAll<std::uint8_t>(bytes, order, values);
      break;
    case GiftiType::Int8:
      decodeAll<std::int8_t>(bytes, order, values);
      break;
    case GiftiType::Int16:
      decodeAll<std::int16_t>(bytes, order, values);
      break;
    case GiftiType::Uint16:
      decodeAll<std::uint16_t>(bytes, order, values);
      break;
    case GiftiType::Int32:
      decodeAll<std::int32_t>(bytes, order, values);
      break;
    case GiftiType::Uint32:
      decodeAll<std::uint32_t>(bytes, order, values);
      break;
    case GiftiType::Int64:
      decodeAll<std::int64_t>(bytes, order, values);
      break;
    case GiftiType::Uint64:
      decodeAll<std::uint64_t>(bytes, order, values);
      break;
    case GiftiType::Float64:
      decodeAll<double>(bytes, order, values);
      break;
    default:
      decodeAll<float>(bytes, order, values);
      break;
  }
  return values;
}

std::vector<double> parseAscii(const std::string& path, std::string_view text, int type,
                               std::uint64_t count) {
  std::vector<double> values;
  values.reserve(static_cast<std::size_t>(std::min<std::uint64_t>(count, text.size() / 2 + 1)));
  for (auto token = nextToken(text); !token.empty(); token = nextToken(text)) {
    const auto value = parseNumber<double>(token);
    if (!value) {
      throw FormatError(path, "The text data of an array hold \"" + std::string(token.substr(0, 30)) +
                                  "\", which is not a number.");
    }
    // 32-bit numbers are rounded as the binary encodings of the same array would be.
    values.push_back(type == GiftiType::Float32 ? static_cast<double>(static_cast<float>(*value)) : *value);
  }
  if (values.size() != count) {
    throw FormatError(path, "The dimensions of an array ask for " + std::to_string(count) +
                                " numbers, but its text holds " + std::to_string(values.size()) +
                                "; the file is damaged or truncated.");
  }
  return values;
}

/// The product of the dimensions, checked.
std::uint64_t countOf(const std::string& path, const GiftiPayload& payload) {
  std::uint64_t count = 1;
  for (const std::int64_t d : payload.dimensions) {
    if (d < 0 || (d > 0 && count > (1ULL << 40) / static_cast<std::uint64_t>(d))) {
      throw FormatError(path, "An array claims a dimension of " + std::to_string(d) +
                                  ", which is negative or larger than any surface.");
    }
    count *= static_cast<std::uint64_t>(d);
  }
  return payload.dimensions.empty() ? 0 : count;
}

/// First index fastest → last index fastest.
std::vector<double> toRowMajor(const std::vector<double>& values,
                               const std::vector<std::int64_t>& dimensions) {
  std::vector<double> sorted(values.size());
  std::vector<std::int64_t> index(dimensions.size(), 0);
  for (const double value : values) {
    std::size_t place = 0;
    for (std::size_t d = 0; d < dimensions.size(); ++d) {
      place = place * static_cast<std::size_t>(dimensions[d]) + static_cast<std::size_t>(index[d]);
    }
    sorted[place] = value;
    for (std::size_t d = 0; d < dimensions.size() && ++index[d] == dimensions[d]; ++d) {
      index[d] = 0;
    }
  }
  return sorted;
}

std::vector<std::uint8_t> binaryPayload(const std::string& path, const GiftiPayload& payload,
                                        std::string_view text, std::uint64_t size) {
  if (payload.encoding == GiftiEncoding::External) {
    return readExternal(path, payload, size);
  }
  auto bytes = decodeBase64(path, text);
  if (payload.encoding == GiftiEncoding::GzipBase64) {
    return inflateBytes(path, std::move(bytes), size);
  }
  if (bytes.size() != size) {
    failSize(path, size, std::to_string(bytes.size()));
  }
  return bytes;
}

}  // namespace

int giftiTypeSize(int type) noexcept {
  switch (type) {
    case GiftiType::Uint8:
    case GiftiType::Int8:
      return 1;
    case GiftiType::Int16:
    case GiftiType::Uint16:
      return 2;
    case GiftiType::Int32:
    case GiftiType::Uint32:
    case GiftiType::Float32:
      return 4;
    case GiftiType::Int64:
    case GiftiType::Uint64:
    case GiftiType::Float64:
      return 8;
    default:
      return 0;
  }
}

std::vector<double> decodeGiftiPayload(const std::string& path, const GiftiPayload& payload,
                                       std::string_view text) {
  const int bytesEach = giftiTypeSize(payload.type);
  if (bytesEach == 0) {
    throw FormatError(path, "An array of type code " + std::to_string(payload.type) +
                                " is not read; integers and floating-point numbers of 8 to 64 bits are.");
  }
  const std::uint64_t count = countOf(path, payload);
  if (count == 0) {
    return {};
  }
  const auto values =
      payload.encoding == GiftiEncoding::Ascii
          ? parseAscii(path, text, payload.type, count)
          : numbersOf(binaryPayload(path, payload, text, count * static_cast<std::uint64_t>(bytesEach)),
                      payload.type, payload.order);
  const auto wide =
      std::count_if(payload.dimensions.begin(), payload.dimensions.end(), [](auto d) { return d > 1; });
  return payload.columnMajor && wide > 1 ? toRowMajor(values, payload.dimensions) : values;
}

std::string encodeGiftiPayload(const std::vector<double>& values, int type) {
  std::vector<std::uint8_t> bytes;
  bytes.reserve(values.size() * 4);
  for (const double value : values) {
    switch (type) {
      case GiftiType::Uint8:
        bytes.push_back(static_cast<std::uint8_t>(value));
        break;
      case GiftiType::Int32:
        encode(bytes, static_cast<std::int32_t>(value), ByteOrder::Little);
        break;
      default:
        encode(bytes, static_cast<float>(value), ByteOrder::Little);
        break;
    }
  }
  uLongf length = compressBound(static_cast<uLong>(bytes.size()));
  std::vector<std::uint8_t> packed(length);
  compress2(packed.data(), &length, bytes.data(), static_cast<uLong>(bytes.size()), 6);
  packed.resize(length);
  std::string text;
  text.reserve(packed.size() / 3 * 4 + 4);
  for (std::size_t i = 0; i < packed.size(); i += 3) {
    const std::size_t left = std::min<std::size_t>(3, packed.size() - i);
    std::uint32_t group = static_cast<std::uint32_t>(packed[i]) << 16U;
    group |= left > 1 ? static_cast<std::uint32_t>(packed[i + 1]) << 8U : 0U;
    group |= left > 2 ? packed[i + 2] : 0U;
    for (std::size_t k = 0; k < 4; ++k) {
      text += k <= left ? kAlphabet[group >> (18U - 6U * static_cast<unsigned>(k)) & 63U] : '=';
    }
  }
  return text;
}

}  // namespace authalic
