#include "VtpBlocks.h"

#include <algorithm>
#include <array>

#include <vtkDataCompressor.h>

#include "Core/base/Error.h"

namespace authalic {

namespace {

std::array<std::int8_t, 256> decodingTable() {
  constexpr std::string_view digits("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/");
  std::array<std::int8_t, 256> table{};
  table.fill(-1);
  for (std::size_t i = 0; i < digits.size(); ++i) {
    table[static_cast<unsigned char>(digits[i])] = static_cast<std::int8_t>(i);
  }
  return table;
}

/// Reads bytes off the front of a text, base64 or raw; base64 begins anew with restart().
class Stream {
 public:
  Stream(const std::string& path, std::string_view text, bool base64) : path_(path), rest_(text), base64_(base64) {}

  [[nodiscard]] std::vector<std::uint8_t> read(std::uint64_t count) {
    if (count > rest_.size()) {  // a byte takes at least one character
      fail();
    }
    std::vector<std::uint8_t> bytes;
    bytes.reserve(static_cast<std::size_t>(count));
    if (!base64_) {
      bytes.assign(rest_.begin(), rest_.begin() + static_cast<std::ptrdiff_t>(count));
      rest_.remove_prefix(static_cast<std::size_t>(count));
      return bytes;
    }
    while (bytes.size() < count) {
      bytes.push_back(nextByte());
    }
    return bytes;
  }
  [[nodiscard]] std::uint64_t word(const VtpLayout& layout) {
    const auto bytes = read(layout.words64 ? 8 : 4);
    return layout.words64 ? decode<std::uint64_t>(bytes.data(), layout.order)
                          : decode<std::uint32_t>(bytes.data(), layout.order);
  }
  /// To the end of the group of four characters, where the next piece of base64 begins.
  void restart() {
    while (base64_ && used_ % 4 != 0 && !rest_.empty()) {
      rest_.remove_prefix(1);
      ++used_;
    }
    bits_ = 0;
    used_ = 0;
  }
  [[nodiscard]] std::uint64_t remaining() const { return rest_.size(); }
  [[noreturn]] void fail() const {
    throw FormatError(path_, "The binary data of an array are damaged or shorter than they claim.");
  }

 private:
  std::uint8_t nextByte() {
    static const auto table = decodingTable();
    while (bits_ < 8) {
      const int value = rest_.empty() ? -1 : table[static_cast<unsigned char>(rest_.front())];
      if (value < 0) {
        fail();
      }
      rest_.remove_prefix(1);
      ++used_;
      group_ = (group_ << 6U | static_cast<std::uint32_t>(value)) & 0xFFFFU;
      bits_ += 6;
    }
    bits_ -= 8;
    return static_cast<std::uint8_t>(group_ >> static_cast<unsigned>(bits_));
  }

  const std::string& path_;
  std::string_view rest_;
  bool base64_;
  std::uint32_t group_ = 0;
  int bits_ = 0;
  std::size_t used_ = 0;
};

[[noreturn]] void failSize(const std::string& path, std::uint64_t expected, std::uint64_t found) {
  throw FormatError(path, "An array should have " + std::to_string(expected) + " bytes, but holds " +
                              std::to_string(found) + "; the file is damaged.");
}

/// The parts that an array was compressed in.
struct Parts {
  std::vector<std::uint64_t> packed;  ///< lengths
  std::uint64_t size = 0;             ///< of each part, unpacked
  std::uint64_t last = 0;             ///< of the last when it is shorter, else 0
  std::uint64_t total = 0;
};

Parts readParts(Stream& stream, const VtpLayout& layout) {
  Parts parts;
  const std::uint64_t count = stream.word(layout);
  if (count == 0) {
    return parts;
  }
  parts.size = stream.word(layout);
  parts.last = stream.word(layout);
  constexpr std::uint64_t most = 1032;
  if (count > stream.remaining() || parts.last > parts.size || parts.size > most * stream.remaining() / count + most) {
    stream.fail();
  }
  for (std::uint64_t i = 0; i < count; ++i) {
    parts.packed.push_back(stream.word(layout));
  }
  parts.total = parts.size * (count - (parts.last > 0 ? 1 : 0)) + parts.last;
  stream.restart();
  return parts;
}

}  // namespace

std::vector<std::uint8_t> vtpBytes(const std::string& path, std::string_view text, bool base64,
                                   const VtpLayout& layout, std::uint64_t expected) {
  if (expected == 0) {
    return {};
  }
  Stream stream(path, text, base64);
  if (!layout.compressor) {
    const std::uint64_t length = stream.word(layout);
    if (length != expected) {
      failSize(path, expected, length);
    }
    return stream.read(expected);
  }
  const Parts parts = readParts(stream, layout);
  if (parts.total != expected) {
    failSize(path, expected, parts.total);
  }
  std::vector<std::uint8_t> bytes(static_cast<std::size_t>(expected));
  std::size_t at = 0;
  for (const std::uint64_t length : parts.packed) {
    const auto packed = stream.read(length);
    const std::size_t wanted = std::min<std::size_t>(static_cast<std::size_t>(parts.size), bytes.size() - at);
    if (layout.compressor->Uncompress(packed.data(), packed.size(), bytes.data() + at, wanted) != wanted) {
      stream.fail();
    }
    at += wanted;
  }
  return bytes;
}

std::uint64_t vtpLength(const std::string& path, std::string_view text, bool base64, const VtpLayout& layout) {
  Stream stream(path, text, base64);
  const std::uint64_t length = layout.compressor ? readParts(stream, layout).total : stream.word(layout);
  if (!layout.compressor && length > stream.remaining()) {
    stream.fail();
  }
  return length;
}

}  // namespace authalic
