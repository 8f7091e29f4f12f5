#include "Formats/Morphometry.h"

#include <algorithm>
#include <climits>
#include <limits>

#include "Formats/AtomicFile.h"
#include "Formats/ByteCursor.h"
#include "Formats/Gifti.h"
#include "Formats/InputFile.h"
#include "Formats/Mz3.h"
#include "Formats/SurfaceParsers.h"
#include "Formats/TextNumbers.h"
#include "Formats/VolumeData.h"

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

std::vector<float> giftiScalars(const std::string& path, std::size_t vertexCount) {
  GiftiFile file = readGifti(path);
  spreadNodeIndex(path, file, vertexCount);
  for (const GiftiArray& array : file.arrays) {
    if (isMetric(array)) {
      return {array.values.begin(), array.values.end()};
    }
  }
  throw FormatError(path, "One number per vertex is needed, but no array of the GIFTI file has that shape.");
}

std::vector<float> paintScalars(const std::string& path, std::size_t vertexCount) {
  const SparseScalars paint = readPaint(path);
  if (vertexCount == 0) {
    throw FormatError(path, "One value per vertex is needed, but this file lists some vertices only; give the "
                            "surface it belongs to.");
  }
  std::vector<float> values(vertexCount, std::numeric_limits<float>::quiet_NaN());
  for (std::size_t i = 0; i < paint.vertices.size(); ++i) {
    const auto vertex = static_cast<std::size_t>(paint.vertices[i]);
    if (vertex >= vertexCount) {
      throw FormatError(path, "The file names vertex " + std::to_string(vertex) + ", but the surface has " +
                                  std::to_string(vertexCount) + " vertices; it belongs to another surface.");
    }
    values[vertex] = paint.values[i];
  }
  return values;
}

std::vector<float> firstOverlay(const std::string& path, const FileBytes& bytes) {
  Mz3File file = parseMz3(path, bytes);
  if (file.layers.empty()) {
    throw FormatError(path, "One number per vertex is needed, but the MZ3 file holds no overlay.");
  }
  return std::move(file.layers.front());
}

bool isVolumeName(const std::string& path) {
  return isMghName(path) || endsWith(path, ".nii") || endsWith(path, ".nii.gz");
}

/// One frame; `frames` becomes the number there are.
std::vector<float> frameScalars(const std::string& path, int frame, int& frames) {
  const VolumeFile file = readVolume(path, frame);
  frames = file.frames;
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

std::vector<std::vector<float>> readVertexFrames(const std::string& path) {
  std::vector<std::vector<float>> all;
  int frames = 1;
  for (int frame = 0; frame < frames; ++frame) {
    all.push_back(frameScalars(path, frame, frames));
  }
  return all;
}

std::vector<float> readVertexScalars(const std::string& path, std::size_t vertexCount) {
  if (endsWith(path, ".w")) {
    return paintScalars(path, vertexCount);
  }
  if (isVolumeName(path)) {
    int frames = 1;
    return frameScalars(path, 0, frames);
  }
  const FileBytes bytes = readBytes(path);
  switch (const FileKind kind = recognise(bytes)) {
    case FileKind::FreeSurferMorphometry:
      return parseNewMorphometry(path, bytes);
    case FileKind::Gifti:
      return giftiScalars(path, vertexCount);
    case FileKind::Mz3:
      return firstOverlay(path, bytes);
    case FileKind::Other:
      break;
    default:
      throw FormatError(
          path, std::string("One number per vertex is needed, but the file is ") + fileKindName(kind) + ".");
  }
  return isOldMorphometry(bytes) ? parseOldMorphometry(path, bytes) : parseTextScalars(path, bytes);
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
