#include "LegacyVtkGate.h"

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <map>

#include "Core/base/Error.h"
#include "Formats/ByteCursor.h"
#include "Formats/TextNumbers.h"

namespace authalic {

namespace {

std::string upper(std::string_view word) {
  std::string result(word);
  std::transform(result.begin(), result.end(), result.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return result;
}

class LegacyWalker {
 public:
  LegacyWalker(const std::string& path, const std::vector<std::uint8_t>& bytes)
      : cursor_(path, bytes), text_(reinterpret_cast<const char*>(bytes.data()), bytes.size()) {}

  void walk() {
    walkHeader();
    for (std::string word = token(); !word.empty(); word = token()) {
      walkSection(upper(word));
    }
  }

 private:
  /// The next word, over line ends; empty at the end.
  std::string token() {
    std::string_view rest = text_.substr(cursor_.position());
    const std::string word(nextToken(rest));
    cursor_.seek(text_.size() - rest.size());
    return word;
  }
  std::string need(const char* what) {
    std::string word = token();
    if (word.empty()) {
      cursor_.fail(std::string("The VTK file ends where ") + what + " should follow; it is truncated.");
    }
    return word;
  }
  std::uint64_t count(const char* what) {
    const std::string word = need(what);
    const auto number = parseNumber<std::uint64_t>(word);
    if (!number || *number > text_.size()) {
      cursor_.fail(std::string("The VTK file should give ") + what + ", but \"" + word.substr(0, 24) +
                   "\" is no number or more than the file can hold.");
    }
    return *number;
  }

  void walkHeader() {
    const std::string first = cursor_.line();
    if (first.compare(0, 5, "# vtk") != 0) {
      cursor_.seek(0);
      cursor_.fail("A legacy VTK file begins with \"# vtk DataFile\", but this one does not.");
    }
    walkVersion(first);
    static_cast<void>(cursor_.line());
    const std::string mode = upper(need("ASCII or BINARY"));
    binary_ = mode == "BINARY";
    if (!binary_ && mode != "ASCII") {
      cursor_.fail("The third line of a legacy VTK file is ASCII or BINARY, but this one is \"" +
                   mode.substr(0, 24) + "\".");
    }
    std::string word = upper(need("DATASET"));
    if (word == "FIELD") {
      walkField();
      word = upper(need("DATASET"));
    }
    const std::string kind = upper(need("the kind of data set"));
    if (word != "DATASET" || kind != "POLYDATA") {
      cursor_.fail("A surface (DATASET POLYDATA) is needed, but the VTK file says \"" + word.substr(0, 24) +
                   " " + kind.substr(0, 24) + "\".");
    }
  }

  /// Since 5.0 cells are offsets and corners. VTK's reader goes by the version alone.
  void walkVersion(const std::string& line) {
    constexpr std::string_view words = "# vtk DataFile Version ";
    const std::string_view version = std::string_view(line).substr(std::min(words.size(), line.size()));
    const std::size_t dot = std::min(version.find('.'), version.size());
    const auto major = parseNumber<int>(version.substr(0, dot));
    std::string_view rest = version.substr(std::min(dot + 1, version.size()));
    const auto minor = parseNumber<int>(nextToken(rest));
    if (line.compare(0, words.size(), words) != 0 || !major || !minor || *major < 1 || *major > 5 || *minor < 0) {
      cursor_.fail("The first line of a legacy VTK file ends with its version, 1.0 to 5.1, but this one is \"" +
                   line.substr(0, 40) + "\".");
    }
    offsets_ = *major >= 5;
  }

  void walkSection(const std::string& word) {
    if (word == "POINTS") {
      const auto points = count("the number of points");
      walkNumbers(3 * points, need("the type of the points"));
    } else if (word == "POLYGONS" || word == "LINES" || word == "VERTICES" || word == "TRIANGLE_STRIPS") {
      walkCells();
    } else if (word == "POINT_DATA" || word == "CELL_DATA") {
      tuples_ = count("the number of values");
    } else if (word == "METADATA") {
      walkMetadata();
    } else if (word == "FIELD") {
      walkField();
    } else {
      walkAttribute(word);
    }
  }

  void walkCells() {
    const auto cells = count("the number of cells");
    const auto size = count("the number of cell entries");
    const std::size_t before = cursor_.position();
    const std::string word = upper(token());
    if ((word == "OFFSETS") != offsets_) {
      cursor_.fail("The layout of the cells of the VTK file is not that of its version; it is damaged.");
    }
    if (!offsets_) {  // size and corners of each cell in one list
      cursor_.seek(before);
      walkCellList(cells, size);
      return;
    }
    walkOffsets(cells, size, need("the type of the offsets"));
    if (upper(need("CONNECTIVITY")) != "CONNECTIVITY") {
      cursor_.fail("The offsets of cells should be followed by CONNECTIVITY; the VTK file is damaged.");
    }
    walkNumbers(size, need("the type of the connectivity"));
  }

  /// The next whole number of an array of the given width in bytes.
  std::int64_t nextInteger(int width) {
    if (binary_) {
      return width == 8 ? cursor_.next<std::int64_t>("cells") : cursor_.next<std::int32_t>("cells");
    }
    const auto number = parseNumber<std::int64_t>(need("cells"));
    const bool fits = number && (width == 8 || (*number >= INT32_MIN && *number <= INT32_MAX));
    if (!fits) {  // VTK's reader would stop here and leave the rest as it was
      failCells();
    }
    return *number;
  }
  [[noreturn]] void failCells() const {
    cursor_.fail("The list of cells of the VTK file contradicts its own sizes; it is damaged.");
  }

  /// Each cell is its size and as many corners; together they must fill the list.
  void walkCellList(std::uint64_t cells, std::uint64_t size) {
    if (binary_) {
      static_cast<void>(cursor_.line());
    }
    std::uint64_t used = 0;
    for (std::uint64_t i = 0; i < cells; ++i) {
      const std::int64_t corners = nextInteger(4);
      if (corners < 0 || used + 1 + static_cast<std::uint64_t>(corners) > size) {
        failCells();
      }
      for (std::int64_t k = 0; k < corners; ++k) {
        static_cast<void>(nextInteger(4));
      }
      used += 1 + static_cast<std::uint64_t>(corners);
    }
    if (used != size) {
      failCells();
    }
  }

  /// Offsets rise from 0 to the length of the list of corners.
  void walkOffsets(std::uint64_t offsets, std::uint64_t size, const std::string& type) {
    if (binary_) {
      static_cast<void>(cursor_.line());
    }
    static const std::map<std::string, int> widths{
        {"VTKTYPEINT64", 8}, {"LONG", 8}, {"VTKTYPEINT32", 4}, {"INT", 4}, {"VTKIDTYPE", 4}};
    const auto known = widths.find(upper(type));
    if (known == widths.end()) {
      cursor_.fail("Offsets of cells should be whole numbers, but are of type \"" + type.substr(0, 24) + "\".");
    }
    const int width = known->second;
    std::int64_t last = 0;
    for (std::uint64_t i = 0; i < offsets; ++i) {
      const std::int64_t offset = nextInteger(width);
      if (offset < last || (i == 0 && offset != 0)) {
        failCells();
      }
      last = offset;
    }
    if (static_cast<std::uint64_t>(last) != size) {
      failCells();
    }
  }

  void walkAttribute(const std::string& word) {
    static const std::map<std::string, std::uint64_t> components{{"VECTORS", 3},    {"NORMALS", 3},
                                                                 {"TENSORS", 9},    {"TENSORS6", 6},
                                                                 {"GLOBAL_IDS", 1}, {"PEDIGREE_IDS", 1}};
    const auto known = components.find(word);
    const std::string name = need("the name of an array");
    if (known != components.end()) {
      walkNumbers(known->second * tuples_, need("the type of an array"));
    } else if (word == "SCALARS") {
      walkScalars();
    } else if (word == "TEXTURE_COORDINATES") {
      const auto each = count("the number of components");
      walkNumbers(each * tuples_, need("the type of an array"));
    } else if (word == "COLOR_SCALARS") {
      walkNumbers(count("the number of components") * tuples_, binary_ ? "unsigned_char" : "float");
    } else if (word == "LOOKUP_TABLE") {
      walkNumbers(4 * count("the number of colours"), binary_ ? "unsigned_char" : "float");
    } else {
      cursor_.fail("The VTK file has a section \"" + word.substr(0, 24) +
                   "\", which is not known; it is damaged.");
    }
  }

  void walkScalars() {
    const std::string type = need("the type of scalars");
    const std::size_t before = cursor_.position();
    const auto components = parseNumber<std::uint64_t>(need("LOOKUP_TABLE"));
    if (!components) {
      cursor_.seek(before);
    }
    if (upper(need("LOOKUP_TABLE")) != "LOOKUP_TABLE") {
      cursor_.fail("Scalars should be followed by LOOKUP_TABLE; the VTK file is damaged.");
    }
    static_cast<void>(need("the name of a lookup table"));
    walkNumbers(std::min<std::uint64_t>(components.value_or(1), 64) * tuples_, type);
  }

  void walkField() {
    static_cast<void>(need("the name of a field"));
    const auto arrays = count("the number of arrays");
    for (std::uint64_t i = 0; i < arrays; ++i) {
      std::string name = need("the name of an array");
      if (name == "METADATA") {
        walkMetadata();
        name = need("the name of an array");
      }
      const auto components = count("the number of components");
      const auto tuples = count("the number of values");
      const std::string type = need("the type of an array");
      if (tuples > 0 && components > text_.size() / tuples) {
        cursor_.fail("The VTK file claims an array larger than itself; it is damaged.");
      }
      walkNumbers(components * tuples, type);
    }
  }

  /// Everything up to an empty line.
  void walkMetadata() {
    static_cast<void>(cursor_.line());
    while (cursor_.remaining() > 0 && cursor_.line().find_first_not_of(" \t\r") != std::string::npos) {
    }
  }

  void walkNumbers(std::uint64_t number, const std::string& typeName) {
    static const std::map<std::string, std::uint64_t> sizes{
        {"bit", 1},       {"char", 1},           {"signed_char", 1},   {"unsigned_char", 1},
        {"short", 2},     {"unsigned_short", 2}, {"int", 4},           {"unsigned_int", 4},
        {"long", 8},      {"unsigned_long", 8},  {"float", 4},         {"double", 8},
        {"vtkidtype", 4}, {"vtktypeint64", 8},   {"vtktypeuint64", 8}, {"vtktypeint32", 4},
        {"string", 0}};
    std::string type = typeName;
    std::transform(type.begin(), type.end(), type.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    const auto found = sizes.find(type);
    if (found == sizes.end()) {
      cursor_.fail("The VTK file names a type \"" + typeName.substr(0, 24) + "\", which does not exist.");
    }
    if (type == "string") {
      walkStrings(number);
    } else if (binary_) {
      static_cast<void>(cursor_.line());
      cursor_.need(number, found->second, "an array");
      cursor_.seek(cursor_.position() + static_cast<std::size_t>(number * found->second));
    } else {
      for (std::uint64_t i = 0; i < number; ++i) {
        if (!parseNumber<double>(need("a number"))) {
          cursor_.fail("The VTK file should hold a number here, but does not; it is damaged.");
        }
      }
    }
  }

  /// Text of a field: one line each, or with its length in front (two bits say how many bytes the length
  /// has).
  void walkStrings(std::uint64_t number) {
    static_cast<void>(cursor_.line());
    for (std::uint64_t i = 0; i < number; ++i) {
      if (!binary_) {
        static_cast<void>(cursor_.line());
        continue;
      }
      const auto first = cursor_.next<std::uint8_t>("the length of a text");
      std::uint64_t length = first & 63U;
      static constexpr int more[] = {7, 3, 1, 0};
      for (int k = 0; k < more[first >> 6U]; ++k) {
        length = length << 8U | cursor_.next<std::uint8_t>("the length of a text");
      }
      cursor_.need(length, 1, "a text");
      cursor_.seek(cursor_.position() + static_cast<std::size_t>(length));
    }
  }

  ByteCursor cursor_;
  std::string_view text_;
  bool binary_ = false;
  bool offsets_ = false;  ///< cells as offsets and corners
  std::uint64_t tuples_ = 0;
};

}  // namespace

void checkLegacyVtk(const std::string& path, const std::vector<std::uint8_t>& bytes) {
  LegacyWalker(path, bytes).walk();
}

}  // namespace authalic
