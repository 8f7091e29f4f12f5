#include <array>
#include <climits>
#include <cmath>
#include <map>

#include "Core/base/Error.h"
#include "Formats/AtomicFile.h"
#include "Formats/ByteCursor.h"
#include "Formats/SurfaceParsers.h"
#include "Formats/TextNumbers.h"

namespace authalic {

namespace {

enum class PlyType { Int8, Uint8, Int16, Uint16, Int32, Uint32, Float32, Float64 };

struct PlyProperty {
  std::string name;
  PlyType type = PlyType::Float32;
  bool list = false;
  PlyType countType = PlyType::Uint8;
};

struct PlyElement {
  std::string name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;
};

struct PlyHeader {
  bool ascii = false;
  ByteOrder order = ByteOrder::Little;
  std::vector<PlyElement> elements;
};

PlyType typeNamed(const ByteCursor& cursor, std::string_view name) {
  static const std::map<std::string, PlyType, std::less<>> types{
      {"char", PlyType::Int8},      {"int8", PlyType::Int8},       {"uchar", PlyType::Uint8},
      {"uint8", PlyType::Uint8},    {"short", PlyType::Int16},     {"int16", PlyType::Int16},
      {"ushort", PlyType::Uint16},  {"uint16", PlyType::Uint16},   {"int", PlyType::Int32},
      {"int32", PlyType::Int32},    {"uint", PlyType::Uint32},     {"uint32", PlyType::Uint32},
      {"float", PlyType::Float32},  {"float32", PlyType::Float32}, {"double", PlyType::Float64},
      {"float64", PlyType::Float64}};
  const auto found = types.find(name);
  if (found == types.end()) {
    cursor.fail("The PLY header names a type \"" + std::string(name.substr(0, 20)) +
                "\", which does not exist.");
  }
  return found->second;
}

void parseFormat(const ByteCursor& cursor, std::string_view rest, PlyHeader& header) {
  const auto format = nextToken(rest);
  header.ascii = format == "ascii";
  header.order = format == "binary_big_endian" ? ByteOrder::Big : ByteOrder::Little;
  if (!header.ascii && format != "binary_big_endian" && format != "binary_little_endian") {
    cursor.fail(
        "The format of a PLY file is ascii, binary_little_endian or binary_big_endian, but this one says \"" +
        std::string(format.substr(0, 20)) + "\".");
  }
}

PlyElement parseElement(const ByteCursor& cursor, std::string_view rest) {
  PlyElement element;
  element.name = nextToken(rest);
  const auto count = parseNumber<std::uint64_t>(nextToken(rest));
  if (!count || *count > static_cast<std::uint64_t>(INT_MAX) / 3) {
    cursor.fail("The PLY header claims a number of \"" + element.name.substr(0, 20) +
                "\" that no surface has.");
  }
  element.count = *count;
  return element;
}

PlyProperty parseProperty(const ByteCursor& cursor, std::string_view rest) {
  PlyProperty property;
  auto type = nextToken(rest);
  property.list = type == "list";
  if (property.list) {
    property.countType = typeNamed(cursor, nextToken(rest));
    type = nextToken(rest);
  }
  property.type = typeNamed(cursor, type);
  property.name = nextToken(rest);
  return property;
}

PlyHeader parsePlyHeader(ByteCursor& cursor) {
  PlyHeader header;
  static_cast<void>(cursor.line());
  while (cursor.remaining() > 0) {
    const std::string line = cursor.line();
    std::string_view rest = line;
    const auto word = nextToken(rest);
    if (word == "end_header") {
      return header;
    }
    if (word == "format") {
      parseFormat(cursor, rest, header);
    } else if (word == "element") {
      header.elements.push_back(parseElement(cursor, rest));
    } else if (word == "property" && !header.elements.empty()) {
      header.elements.back().properties.push_back(parseProperty(cursor, rest));
    }
  }
  cursor.fail("The PLY header does not end; the file is truncated.");
}

/// Numbers one after the other, in text or binary.
class PlyNumbers {
 public:
  PlyNumbers(ByteCursor& cursor, const FileBytes& bytes, const PlyHeader& header)
      : cursor_(cursor), ascii_(header.ascii) {
    if (ascii_) {
      text_ = std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size())
                  .substr(cursor.position());
    }
  }
  double next(PlyType type) {
    if (ascii_) {
      const auto value = parseNumber<double>(nextToken(text_));
      if (!value) {
        cursor_.fail("The numbers of the PLY file end early or are no numbers; it is damaged or truncated.");
      }
      return *value;
    }
    switch (type) {
      case PlyType::Int8:
        return cursor_.next<std::int8_t>("a number");
      case PlyType::Uint8:
        return cursor_.next<std::uint8_t>("a number");
      case PlyType::Int16:
        return cursor_.next<std::int16_t>("a number");
      case PlyType::Uint16:
        return cursor_.next<std::uint16_t>("a number");
      case PlyType::Int32:
        return cursor_.next<std::int32_t>("a number");
      case PlyType::Uint32:
        return cursor_.next<std::uint32_t>("a number");
      case PlyType::Float32:
        return cursor_.next<float>("a number");
      case PlyType::Float64:
        break;
    }
    return cursor_.next<double>("a number");
  }
  [[noreturn]] void fail(const std::string& what) const { cursor_.fail(what); }

 private:
  ByteCursor& cursor_;
  bool ascii_;
  std::string_view text_;
};

int wholeNumber(const PlyNumbers& numbers, double value) {
  if (!(value >= 0 && value < INT_MAX) || value != std::floor(value)) {
    numbers.fail("The corners of a face should be whole numbers from 0, but one is " + std::to_string(value) +
                 ".");
  }
  return static_cast<int>(value);
}

/// A polygon as a fan of triangles from its first corner when `faces` is given; passed over otherwise.
void parseList(PlyNumbers& numbers, const PlyProperty& property, std::vector<int>* faces) {
  const int count = wholeNumber(numbers, numbers.next(property.countType));
  int first = 0;
  int previous = 0;
  for (int k = 0; k < count; ++k) {
    const double value = numbers.next(property.type);
    if (!faces) {
      continue;
    }
    const int index = wholeNumber(numbers, value);
    if (k == 0) {
      first = index;
    } else if (k >= 2) {
      faces->insert(faces->end(), {first, previous, index});
    }
    previous = index;
  }
}

void parseElementData(PlyNumbers& numbers, const PlyElement& element, SurfaceFile& surface) {
  const bool vertex = element.name == "vertex";
  for (std::uint64_t i = 0; i < element.count && !element.properties.empty(); ++i) {
    std::array<double, 3> point{};
    for (const PlyProperty& property : element.properties) {
      if (property.list) {
        const bool corners = property.name == "vertex_indices" || property.name == "vertex_index";
        parseList(numbers, property, element.name == "face" && corners ? &surface.faces : nullptr);
        continue;
      }
      const double value = numbers.next(property.type);
      if (property.name.size() == 1 && property.name[0] >= 'x' && property.name[0] <= 'z') {
        point[static_cast<std::size_t>(property.name[0] - 'x')] = value;
      }
    }
    if (vertex) {
      surface.points.insert(surface.points.end(), point.begin(), point.end());
    }
  }
}

}  // namespace

SurfaceFile parsePly(const std::string& path, const FileBytes& bytes) {
  ByteCursor probe(path, bytes);
  const PlyHeader header = parsePlyHeader(probe);
  ByteCursor cursor(path, bytes, header.order);
  cursor.seek(probe.position());
  PlyNumbers numbers(cursor, bytes, header);
  SurfaceFile surface;
  for (const PlyElement& element : header.elements) {
    parseElementData(numbers, element, surface);
  }
  surface.spaceReason = "PLY files state no space";
  return surface;
}

void writePly(const std::string& path, const SurfaceFile& surface) {
  const std::string comment = spaceComment(surface.space);
  const std::string header =
      "ply\nformat binary_little_endian 1.0\n" + (comment.empty() ? "" : "comment " + comment + "\n") +
      "element vertex " + std::to_string(surface.vertexCount()) +
      "\nproperty double x\nproperty double y\nproperty double z\nelement face " +
      std::to_string(surface.faceCount()) + "\nproperty list uchar int vertex_indices\nend_header\n";
  FileBytes bytes(header.begin(), header.end());
  bytes.reserve(header.size() + 8 * surface.points.size() + 13 * surface.faceCount());
  for (const double x : surface.points) {
    encode(bytes, x, ByteOrder::Little);
  }
  for (std::size_t i = 0; i < surface.faces.size(); ++i) {
    if (i % 3 == 0) {
      bytes.push_back(3);
    }
    encode(bytes, static_cast<std::int32_t>(surface.faces[i]), ByteOrder::Little);
  }
  writeFileAtomically(path, bytes);
}

}  // namespace authalic
