#include "VtpGate.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <string_view>

#include "Core/base/Error.h"
#include "Formats/ByteCursor.h"

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

/// The attribute of a tag, or nothing.
std::string_view attribute(std::string_view tag, std::string_view name) {
  for (std::size_t at = tag.find(name); at != std::string_view::npos; at = tag.find(name, at + 1)) {
    if (at > 0 && blanks.find(tag[at - 1]) != std::string_view::npos) {
      return quotedValue(tag, at + name.size());
    }
  }
  return {};
}

int base64Digit(char c) {
  constexpr std::string_view digits("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/");
  const std::size_t at = digits.find(c);
  return at == std::string_view::npos ? -1 : static_cast<int>(at);
}

/// How the blocks of binary arrays are written in this file.
struct BlockLayout {
  bool compressed = false;
  bool words64 = false;
  ByteOrder order = ByteOrder::Little;
  bool base64 = true;
  std::uint64_t most = 0;  ///< bytes that the file can hold when unpacked
};

/// The numbers before a block of values: its length, or how many parts it was compressed in and their lengths.
class BlockHeader {
 public:
  BlockHeader(std::string_view text, const BlockLayout& layout) : text_(text), layout_(layout) {}

  /// The word at `index`; nothing where the text ends or is no base64.
  [[nodiscard]] std::optional<std::uint64_t> word(std::uint64_t index) const {
    const std::size_t size = layout_.words64 ? 8 : 4;
    std::uint8_t bytes[8] = {};
    for (std::size_t i = 0; i < size; ++i) {
      const int value = byte(index * size + i);
      if (value < 0) {
        return std::nullopt;
      }
      bytes[i] = static_cast<std::uint8_t>(value);
    }
    return layout_.words64 ? decode<std::uint64_t>(bytes, layout_.order) : decode<std::uint32_t>(bytes, layout_.order);
  }

 private:
  [[nodiscard]] int byte(std::uint64_t index) const {
    if (!layout_.base64) {
      return index < text_.size() ? static_cast<std::uint8_t>(text_[static_cast<std::size_t>(index)]) : -1;
    }
    const std::uint64_t at = index / 3 * 4 + index % 3;
    if (at + 1 >= text_.size()) {
      return -1;
    }
    const int high = base64Digit(text_[static_cast<std::size_t>(at)]);
    const int low = base64Digit(text_[static_cast<std::size_t>(at) + 1]);
    const auto shift = 2 * (index % 3 + 1);
    return high < 0 || low < 0 ? -1 : ((high << shift) | (low >> (6 - shift))) & 0xFF;
  }

  std::string_view text_;
  const BlockLayout& layout_;
};

/// Whether the numbers before a block can be true; a header that is cut off is left to VTK, which refuses it.
/// @param parts  how many parts all blocks may have together; those of this one are taken off
bool isPossible(std::string_view text, const BlockLayout& layout, std::uint64_t& parts) {
  const BlockHeader header(text, layout);
  const auto first = header.word(0);
  if (!first || !layout.compressed) {
    return !first || *first <= layout.most;
  }
  const auto size = header.word(1);
  if (!size) {
    return true;
  }
  if (*first > parts || (*first > 0 && *size > layout.most / *first)) {
    return false;
  }
  parts -= *first;
  for (std::uint64_t part = 0; part < *first; ++part) {
    const auto packed = header.word(3 + part);
    if (!packed || *packed > text.size()) {
      return false;
    }
  }
  return true;
}

BlockLayout layoutOf(std::string_view text, std::uint64_t most) {
  const std::size_t root = text.find("<VTKFile");
  const std::string_view tag = text.substr(root, text.find('>', root) - root);
  BlockLayout layout;
  layout.compressed = !attribute(tag, "compressor").empty();
  layout.words64 = attribute(tag, "header_type") == "UInt64";
  layout.order = attribute(tag, "byte_order") == "BigEndian" ? ByteOrder::Big : ByteOrder::Little;
  layout.most = most;
  return layout;
}

/// Where the values of arrays with an offset begin, and whether they are base64.
std::string_view appendedPart(std::string_view text, bool& base64) {
  const std::size_t at = text.find("<AppendedData");
  if (at == std::string_view::npos) {
    return {};
  }
  const std::size_t end = text.find('>', at);
  base64 = attribute(text.substr(at, end - at), "encoding") != "raw";
  const std::size_t mark = text.find('_', end);
  return mark == std::string_view::npos ? std::string_view() : text.substr(mark + 1);
}

void checkBlocks(const std::string& path, std::string_view text, std::string_view header, std::uint64_t most) {
  const BlockLayout inlined = layoutOf(text, most);
  BlockLayout appended = inlined;
  const std::string_view far = appendedPart(text, appended.base64);
  std::uint64_t parts = text.size();
  for (std::size_t at = header.find("Array"); at != std::string_view::npos; at = header.find("Array", at + 5)) {
    const std::size_t end = std::min(header.find('>', at), header.size());
    const std::string_view tag = header.substr(at, end - at);
    const std::string_view format = attribute(tag, "format");
    const std::string_view offset = attribute(tag, "offset");
    std::uint64_t begin = 0;
    std::from_chars(offset.data(), offset.data() + offset.size(), begin);
    const std::size_t values = header.find_first_not_of(blanks, std::min(end + 1, header.size()));
    const bool possible = format == "appended" ? begin >= far.size() || isPossible(far.substr(begin), appended, parts)
                          : format == "binary" ? values >= header.size() || isPossible(header.substr(values), inlined, parts)
                                               : true;
    if (!possible) {
      throw FormatError(path, "The array \"" + std::string(attribute(tag, "Name").substr(0, 40)) +
                                  "\" claims more bytes than the file can hold; the file is damaged.");
    }
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
  checkBlocks(path, text, header, most);
}

}  // namespace authalic
