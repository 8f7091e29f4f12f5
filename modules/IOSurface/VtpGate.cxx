#include "VtpGate.h"

#include <charconv>
#include <string_view>

#include "Core/base/Error.h"

namespace authalic {

namespace {

constexpr std::string_view blanks(" \t\r\n\0", 5);

/// The value of the attribute whose name ends at `position`, or nothing when no quoted value follows.
std::string_view quotedValue(std::string_view text, std::size_t position) {
  const std::size_t equals = text.find_first_not_of(blanks, position);
  if (equals == std::string_view::npos || text[equals] != '=') {
    return {};
  }
  const std::size_t open = text.find_first_not_of(blanks, equals + 1);
  if (open == std::string_view::npos || (text[open] != '"' && text[open] != '\'')) {
    return {};
  }
  const std::size_t close = text.find(text[open], open + 1);
  return close == std::string_view::npos ? std::string_view() : text.substr(open + 1, close - open - 1);
}

void checkCount(const std::string& path, std::string_view name, std::string_view value, std::uint64_t most) {
  const std::size_t begin = value.find_first_not_of(blanks);
  const std::string_view digits = begin == std::string_view::npos ? std::string_view() : value.substr(begin);
  std::uint64_t count = 0;
  const auto parsed = std::from_chars(digits.data(), digits.data() + digits.size(), count);
  const std::string_view rest = digits.substr(static_cast<std::size_t>(parsed.ptr - digits.data()));
  const bool isCount = parsed.ec == std::errc() && rest.find_first_not_of(blanks) == std::string_view::npos;
  if (!isCount || count > most) {
    throw FormatError(path, std::string(name) + " should be a count that the file can hold, but it is \"" +
                                std::string(value.substr(0, 40)) + "\"; the file is damaged.");
  }
}

void checkRoot(const std::string& path, std::string_view text) {
  const std::size_t root = text.find("<VTKFile");
  if (root == std::string_view::npos) {
    throw FormatError(path, "A .vtp file has an element VTKFile, but this one does not.");
  }
  const std::string_view tag = text.substr(root, text.find('>', root) - root);
  const std::size_t type = tag.find(" type");
  const std::string_view kind = type == std::string_view::npos ? std::string_view() : quotedValue(tag, type + 5);
  if (kind != "PolyData") {
    throw FormatError(path, "A VTK file of type PolyData is needed, but this one is of type \"" +
                                std::string(kind.substr(0, 40)) + "\".");
  }
}

void checkEnd(const std::string& path, std::string_view text) {
  constexpr std::string_view end = "</VTKFile>";
  const std::size_t last = text.find_last_not_of(blanks);
  const std::string_view trimmed = text.substr(0, last + 1);
  if (trimmed.size() < end.size() || trimmed.substr(trimmed.size() - end.size()) != end) {
    throw FormatError(path, "A .vtp file ends with </VTKFile>, but this one does not; it is truncated.");
  }
}

}  // namespace

void checkVtp(const std::string& path, const std::vector<std::uint8_t>& bytes) {
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  checkRoot(path, text);
  checkEnd(path, text);
  // Deflate makes at most 1032 bytes of one, and a point, a cell or a tuple takes at least one byte.
  const std::uint64_t most = 1032 * static_cast<std::uint64_t>(bytes.size());
  const std::string_view header = text.substr(0, text.find("<AppendedData"));
  for (std::size_t at = header.find("NumberOf"); at != std::string_view::npos; at = header.find("NumberOf", at + 8)) {
    const std::size_t end = header.find_first_of("= \t\r\n<>\"'", at);
    const std::string_view value = end == std::string_view::npos ? std::string_view() : quotedValue(header, end);
    if (value.data() != nullptr) {
      checkCount(path, header.substr(at, end - at), value, most);
    }
  }
}

}  // namespace authalic
