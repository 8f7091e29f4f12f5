#include <algorithm>
#include <cmath>

#include "Formats/AtomicFile.h"
#include "Formats/ByteCursor.h"
#include "Formats/InputFile.h"
#include "Formats/Morphometry.h"
#include "Formats/SurfaceParsers.h"
#include "Formats/TextNumbers.h"

namespace authalic {

SparseScalars readLabel(const std::string& path) {
  const FileBytes bytes = readBytes(path);
  ByteCursor cursor(path, bytes);
  if (bytes[0] != '#') {
    cursor.fail("A FreeSurfer label begins with a line \"#!ascii label\", but this file does not.");
  }
  static_cast<void>(cursor.line());
  const std::string countLine = cursor.line();
  std::string_view countText = countLine;
  const auto count = parseNumber<std::int64_t>(nextToken(countText));
  if (!count || *count < 0) {
    cursor.fail("The second line of a FreeSurfer label is its number of entries, but reads \"" +
                countLine.substr(0, 40) + "\".");
  }
  cursor.need(static_cast<std::uint64_t>(*count), 9, "the list of entries");
  SparseScalars label;
  for (std::int64_t i = 0; i < *count; ++i) {
    const std::string line = cursor.line();
    std::string_view rest = line;
    const auto vertex = parseNumber<int>(nextToken(rest));
    int numbers = 0;
    float value = 0;
    for (; numbers < 4; ++numbers) {
      const auto number = parseNumber<double>(nextToken(rest));
      if (!number) {
        break;
      }
      value = numbers == 3 ? static_cast<float>(*number) : value;
    }
    if (!vertex || *vertex < -1 || numbers < 4) {
      cursor.fail("An entry of a FreeSurfer label is a vertex, three coordinates and a value, but entry " +
                  std::to_string(i) + " reads \"" + line.substr(0, 60) + "\".");
    }
    if (*vertex >= 0) {
      label.vertices.push_back(*vertex);
      label.values.push_back(value);
    }
  }
  return label;
}

void writeLabel(const std::string& path, const std::vector<int>& vertices, const std::vector<double>& points,
                const std::vector<float>& values, CoordinateSpace space) {
  if (points.size() != 3 * vertices.size() || values.size() != vertices.size()) {
    throw FormatError(path, "A label needs a point and a value for each of its " + std::to_string(vertices.size()) +
                                " vertices, but has " + std::to_string(points.size() / 3) + " and " +
                                std::to_string(values.size()) + ".");
  }
  std::string text = "#!ascii label  , from subject";
  if (space != CoordinateSpace::Unknown) {
    text += space == CoordinateSpace::TkRAS ? " vox2ras=TkReg" : " coords=scanner";
  }
  text += "\n" + std::to_string(vertices.size()) + "\n";
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    text += std::to_string(vertices[i]);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      text += "  ";
      appendNumber(text, points[3 * i + axis]);
    }
    text += " ";
    appendNumber(text, values[i]);
    text += "\n";
  }
  writeFileAtomically(path, text);
}

SparseScalars readPaint(const std::string& path) {
  const FileBytes bytes = readBytes(path);
  ByteCursor cursor(path, bytes);
  static_cast<void>(cursor.next<std::int16_t>("the latency"));
  const auto count = static_cast<std::size_t>(cursor.next24("the number of values"));
  if (cursor.remaining() != 7 * count) {
    cursor.fail("The header claims " + std::to_string(count) + " values of 7 bytes, but " +
                std::to_string(cursor.remaining()) + " bytes follow; this is not a FreeSurfer w file or is damaged.");
  }
  SparseScalars paint;
  paint.vertices.reserve(count);
  paint.values.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    paint.vertices.push_back(cursor.next24("a vertex"));
    paint.values.push_back(cursor.next<float>("a value"));
  }
  std::vector<int> sorted = paint.vertices;
  std::sort(sorted.begin(), sorted.end());
  const auto twice = std::adjacent_find(sorted.begin(), sorted.end());
  if (twice != sorted.end()) {
    cursor.fail("One value per vertex is needed, but vertex " + std::to_string(*twice) + " comes twice.");
  }
  return paint;
}

void writePaint(const std::string& path, const std::vector<float>& values) {
  if (values.size() >= 1U << 24U) {
    throw FormatError(path, "A w file counts up to 16777215 vertices, but there are " + std::to_string(values.size()) +
                                "; write another format.");
  }
  const auto put24 = [](FileBytes& bytes, std::size_t number) {
    for (const unsigned shift : {16U, 8U, 0U}) {
      bytes.push_back(static_cast<std::uint8_t>(number >> shift & 255U));
    }
  };
  FileBytes entries;
  std::size_t count = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!std::isnan(values[i])) {
      put24(entries, i);
      encode(entries, values[i], ByteOrder::Big);
      ++count;
    }
  }
  FileBytes bytes{0, 0};
  put24(bytes, count);
  bytes.insert(bytes.end(), entries.begin(), entries.end());
  writeFileAtomically(path, bytes);
}

}  // namespace authalic
