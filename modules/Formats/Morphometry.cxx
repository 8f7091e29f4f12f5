#include "Formats/Morphometry.h"

#include <algorithm>
#include <climits>
#include <limits>

#include "Formats/AtomicFile.h"
#include "Formats/ByteCursor.h"
#include "Formats/Gifti.h"
#include "Formats/InputFile.h"
#include "Formats/SurfaceParsers.h"
#include "Formats/TextNumbers.h"
#include "Formats/VolumeFile.h"

namespace authalic {

namespace {

bool endsWith(const std::string& text, const std::string& end) {
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

std::vector<float> parseNewMorphometry(const std::string& path, const FileBytes& bytes) {
  ByteCursor cursor(path, bytes);
  cursor.seek(3);
  const auto vertices = cursor.next<std::int32_t>("the number of vertices");
  static_cast<void>(cursor.next<std::int32_t>("the number of faces"));
  const auto each = cursor.next<std::int32_t>("the number of values per vertex");
  if (vertices < 1 || each != 1) {
    cursor.fail("One value for each of some vertices is needed, but the header claims " +
                std::to_string(each) + " values for each of " + std::to_string(vertices) + " vertices.");
  }
  cursor.need(static_cast<std::uint64_t>(vertices), 4, "the list of values");
  std::vector<float> values(static_cast<std::size_t>(vertices));
  for (float& value : values) {
    value = cursor.next<float>("a value");
  }
  return values;
}

/// Old layout: 24-bit counts and hundredths in 16 bits. It has no magic number; its length must fit exactly.
bool isOldMorphometry(const FileBytes& bytes) {
  if (bytes.size() < 8) {
    return false;
  }
  const std::size_t vertices =
      static_cast<std::size_t>(bytes[0]) << 16U | static_cast<std::size_t>(bytes[1]) << 8U | bytes[2];
  return vertices > 0 && bytes.size() == 6 + 2 * vertices;
}

std::vector<float> parseOldMorphometry(const std::string& path, const FileBytes& bytes) {
  ByteCursor cursor(path, bytes);
  std::vector<float> values(static_cast<std::size_t>(cursor.next24("the number of vertices")));
  static_cast<void>(cursor.next24("the number of faces"));
  for (float& value : values) {
    value = static_cast<float>(cursor.next<std::int16_t>("a value") / 100.0);
  }
  return values;
}

bool isMetric(const GiftiArray& array) {
  const bool flat =
      array.dimensions.size() == 1 || (array.dimensions.size() == 2 && array.dimensions[1] == 1);
  return flat && array.intent != GiftiIntent::Label && array.intent != GiftiIntent::NodeIndex;
}

std::vector<float> giftiScalars(const std::string& path) {
  const GiftiFile file = readGifti(path);
  for (const GiftiArray& array : file.arrays) {
    if (array.intent == GiftiIntent::NodeIndex) {
      throw FormatError(path,
                        "One value per vertex is needed, but this file lists values for some vertices only "
                        "(NODE_INDEX), which is not read.");
    }
    if (isMetric(array)) {
      return {array.values.begin(), array.values.end()};
    }
  }
  throw FormatError(path, "One number per vertex is needed, but no array of the GIFTI file has that shape.");
}

std::vector<float> mghScalars(const std::string& path) {
  const VolumeFile file = readVolume(path);
  const auto& d = file.dimensions();
  const auto wide = std::count_if(d.begin(), d.end(), [](int extent) { return extent > 1; });
  if (wide > 1) {
    throw FormatError(path, "One number per vertex (n × 1 × 1) is needed, but this is a volume of " +
                                std::to_string(d[0]) + " × " + std::to_string(d[1]) + " × " +
                                std::to_string(d[2]) + " voxels.");
  }
  return file.scalars().values;
}

std::vector<float> parseTextScalars(const std::string& path, const FileBytes& bytes) {
  ByteCursor cursor(path, bytes);
  std::vector<float> values;
  for (int number = 1; cursor.remaining() > 0; ++number) {
    const std::size_t start = cursor.position();
    const std::string line = cursor.line();
    std::string_view rest = line;
    const auto token = nextToken(rest);
    if (token.empty() || token.front() == '#') {
      continue;
    }
    const auto value = token == "n/a" ? std::optional<double>(std::numeric_limits<double>::quiet_NaN())
                                      : parseNumber<double>(token);
    if (!value || !nextToken(rest).empty()) {
      const bool printable =
          std::all_of(line.begin(), line.end(), [](char c) { return c >= ' ' || c == '\t' || c == '\r'; });
      cursor.seek(start);
      cursor.fail(
          "One number per line is needed" +
          (printable ? ", but line " + std::to_string(number) + " reads \"" + line.substr(0, 40) + "\"."
                     : std::string(", but this is not a text file, nor a morphometry, MGH or GIFTI file.")));
    }
    values.push_back(static_cast<float>(*value));
  }
  if (values.empty()) {
    throw FormatError(path, "One number per line is needed, but the file holds none.");
  }
  return values;
}

}  // namespace

std::vector<float> readVertexScalars(const std::string& path) {
  if (endsWith(path, ".mgh") || endsWith(path, ".mgz") || endsWith(path, ".mgh.gz")) {
    return mghScalars(path);
  }
  const FileBytes bytes = readBytes(path);
  switch (const FileKind kind = recognise(bytes)) {
    case FileKind::FreeSurferMorphometry:
      return parseNewMorphometry(path, bytes);
    case FileKind::Gifti:
      return giftiScalars(path);
    case FileKind::Other:
      break;
    default:
      throw FormatError(
          path, std::string("One number per vertex is needed, but the file is ") + fileKindName(kind) + ".");
  }
  return isOldMorphometry(bytes) ? parseOldMorphometry(path, bytes) : parseTextScalars(path, bytes);
}

std::vector<int> readLabel(const std::string& path) {
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
  std::vector<int> vertices;
  vertices.reserve(static_cast<std::size_t>(*count));
  for (std::int64_t i = 0; i < *count; ++i) {
    const std::string line = cursor.line();
    std::string_view rest = line;
    const auto vertex = parseNumber<int>(nextToken(rest));
    int numbers = 0;
    for (; numbers < 4 && parseNumber<double>(nextToken(rest)); ++numbers) {
    }
    if (!vertex || *vertex < -1 || numbers < 3) {
      cursor.fail("An entry of a FreeSurfer label is a vertex, three coordinates and a value, but entry " +
                  std::to_string(i) + " reads \"" + line.substr(0, 60) + "\".");
    }
    if (*vertex >= 0) {
      vertices.push_back(*vertex);
    }
  }
  return vertices;
}

void writeMorphometry(const std::string& path, const std::vector<float>& values, int faceCount) {
  FileBytes bytes{0xFF, 0xFF, 0xFF};
  bytes.reserve(15 + 4 * values.size());
  encode(bytes, static_cast<std::int32_t>(values.size()), ByteOrder::Big);
  encode(bytes, static_cast<std::int32_t>(faceCount), ByteOrder::Big);
  encode(bytes, std::int32_t{1}, ByteOrder::Big);
  for (const float value : values) {
    encode(bytes, value, ByteOrder::Big);
  }
  writeFileAtomically(path, bytes);
}

}  // namespace authalic
