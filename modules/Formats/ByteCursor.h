/// @file
/// Bounds-checked reading and writing of numbers in either byte order.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "Core/base/Error.h"

namespace authalic {

enum class ByteOrder { Little, Big };

/// The number whose bytes lie at `bytes` in the given order; T is an integer or a floating-point type.
template <class T>
[[nodiscard]] T decode(const std::uint8_t* bytes, ByteOrder order) noexcept {
  static_assert(std::is_arithmetic_v<T>);
  using Word = std::conditional_t<sizeof(T) == 8, std::uint64_t, std::uint32_t>;
  Word word = 0;
  for (std::size_t i = 0; i < sizeof(T); ++i) {
    const std::size_t place = order == ByteOrder::Little ? sizeof(T) - 1 - i : i;
    word = static_cast<Word>(word << 8U) | bytes[place];
  }
  T value;
  if constexpr (sizeof(T) >= 4) {
    std::memcpy(&value, &word, sizeof(T));
  } else {
    value = static_cast<T>(word);
  }
  return value;
}

/// Appends the bytes of a number in the given order.
template <class T>
void encode(std::vector<std::uint8_t>& bytes, T value, ByteOrder order) {
  std::uint8_t native[sizeof(T)];
  std::memcpy(native, &value, sizeof(T));
  for (std::size_t i = 0; i < sizeof(T); ++i) {
    bytes.push_back(native[order == ByteOrder::Little ? i : sizeof(T) - 1 - i]);
  }
}

/// Walks over bytes in memory. Reading past the end is a FormatError with the offset, never undefined.
class ByteCursor {
 public:
  ByteCursor(const std::string& path, const std::vector<std::uint8_t>& bytes,
             ByteOrder order = ByteOrder::Big)
      : path_(path), bytes_(bytes), order_(order) {}

  [[nodiscard]] std::size_t position() const noexcept { return position_; }
  [[nodiscard]] std::size_t remaining() const noexcept { return bytes_.size() - position_; }
  void seek(std::size_t position) noexcept {
    position_ = position < bytes_.size() ? position : bytes_.size();
  }

  /// @throws FormatError unless `count` items of `size` bytes are left
  void need(std::uint64_t count, std::uint64_t size, const char* what) const {
    if (count > remaining() / size) {
      fail(std::string("The file ends before ") + what + " is complete (" + std::to_string(count) + " × " +
           std::to_string(size) + " bytes needed, " + std::to_string(remaining()) +
           " left); it is truncated or damaged.");
    }
  }
  template <class T>
  [[nodiscard]] T next(const char* what) {
    need(1, sizeof(T), what);
    const T value = decode<T>(bytes_.data() + position_, order_);
    position_ += sizeof(T);
    return value;
  }
  /// Three bytes, most significant first.
  [[nodiscard]] int next24(const char* what) {
    need(3, 1, what);
    const auto* b = bytes_.data() + position_;
    position_ += 3;
    return b[0] << 16 | b[1] << 8 | b[2];
  }
  /// `length` bytes as text, cut at the first NUL.
  [[nodiscard]] std::string text(std::uint64_t length, const char* what) {
    need(length, 1, what);
    std::string words(reinterpret_cast<const char*>(bytes_.data()) + position_,
                      static_cast<std::size_t>(length));
    position_ += static_cast<std::size_t>(length);
    return words.substr(0, words.find('\0'));
  }
  /// Up to and without the next line feed, which is passed over.
  [[nodiscard]] std::string line() {
    const std::string_view all(reinterpret_cast<const char*>(bytes_.data()), bytes_.size());
    const auto end = std::min(all.find('\n', position_), all.size());
    std::string words(all.substr(position_, end - position_));
    position_ = std::min(end + 1, all.size());
    return words;
  }
  /// Whether the last line that was read ended, and not the file in its middle.
  [[nodiscard]] bool afterLineFeed() const { return position_ > 0 && bytes_[position_ - 1] == '\n'; }
  /// What is quoted from a file must not break the sentence or steer a terminal: control characters become blanks.
  [[noreturn]] void fail(std::string what) const {
    std::replace_if(
        what.begin(), what.end(), [](char c) { return static_cast<unsigned char>(c) < 32 || c == 127; }, ' ');
    throw FormatError(path_, what, static_cast<std::int64_t>(position_));
  }

 private:
  const std::string& path_;
  const std::vector<std::uint8_t>& bytes_;
  ByteOrder order_;
  std::size_t position_ = 0;
};

}  // namespace authalic
