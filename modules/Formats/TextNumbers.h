/// @file
/// Numbers in text, independent of the locale.
#pragma once

#include <charconv>
#include <optional>
#include <string>
#include <string_view>

namespace authalic {

/// The part of `text` up to the next blank, which is cut from it; empty at the end.
[[nodiscard]] inline std::string_view nextToken(std::string_view& text) noexcept {
  constexpr std::string_view blanks = " \t\r\n\f\v,";
  const auto begin = text.find_first_not_of(blanks);
  if (begin == std::string_view::npos) {
    text = {};
    return {};
  }
  const auto end = text.find_first_of(blanks, begin);
  const auto token = text.substr(begin, end == std::string_view::npos ? end : end - begin);
  text.remove_prefix(begin + token.size());
  return token;
}

/// The number a whole token spells ("+1", "nan" and "inf" included), or nothing.
template <class T>
[[nodiscard]] std::optional<T> parseNumber(std::string_view token) noexcept {
  if (token.size() > 1 && token.front() == '+') {
    token.remove_prefix(1);
  }
  T value{};
  const auto [end, code] = std::from_chars(token.data(), token.data() + token.size(), value);
  if (code != std::errc() || end != token.data() + token.size() || token.empty()) {
    return std::nullopt;
  }
  return value;
}

/// The shortest digits that give back the same double.
inline void appendNumber(std::string& text, double value) {
  char digits[32];
  const auto result = std::to_chars(digits, digits + sizeof(digits), value);
  text.append(digits, result.ptr);
}

}  // namespace authalic
