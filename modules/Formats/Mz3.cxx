#include "Formats/Mz3.h"

#include <climits>

#include "Formats/AtomicFile.h"
#include "Formats/ByteCursor.h"
#include "Formats/Gzip.h"
#include "Formats/InputFile.h"
#include "Formats/SurfaceParsers.h"

namespace authalic {

namespace {

constexpr unsigned kFaces = 1, kVertices = 2, kColors = 4, kFloats = 8, kDoubles = 16, kKnown = 127;
constexpr std::size_t kHeaderSize = 16;

/// What is left after geometry and colours are overlays; their number is found from the size.
void parseLayers(ByteCursor& cursor, unsigned attributes, Mz3File& file) {
  if ((attributes & (kFloats | kDoubles)) == 0) {
    return;
  }
  const bool doubles = (attributes & kDoubles) != 0;
  const std::uint64_t each = static_cast<std::uint64_t>(file.vertexCount) * (doubles ? 8 : 4);
  if (each == 0 || cursor.remaining() < each || cursor.remaining() % each != 0) {
    cursor.fail("The overlays need a whole number of times " + std::to_string(each) + " bytes, but " +
                std::to_string(cursor.remaining()) + " are left; the file is truncated or damaged.");
  }
  for (std::uint64_t left = cursor.remaining() / each; left > 0; --left) {
    std::vector<float> layer(static_cast<std::size_t>(file.vertexCount));
    for (float& value : layer) {
      value = doubles ? static_cast<float>(cursor.next<double>("an overlay")) : cursor.next<float>("an overlay");
    }
    file.layers.push_back(std::move(layer));
  }
}

void parseGeometry(ByteCursor& cursor, unsigned attributes, std::uint64_t faces, Mz3File& file) {
  const auto vertices = static_cast<std::uint64_t>(file.vertexCount);
  if ((attributes & kFaces) != 0) {
    cursor.need(faces, 12, "the list of faces");
    file.faces.resize(static_cast<std::size_t>(3 * faces));
    for (int& index : file.faces) {
      index = cursor.next<std::int32_t>("a face");
    }
  }
  if ((attributes & kVertices) != 0) {
    cursor.need(vertices, 12, "the list of vertices");
    file.points.resize(static_cast<std::size_t>(3 * vertices));
    for (double& x : file.points) {
      x = cursor.next<float>("a vertex");
    }
  }
  if ((attributes & kColors) != 0) {
    cursor.need(vertices, 4, "the list of colours");
    file.colors.resize(static_cast<std::size_t>(vertices));
    for (auto& color : file.colors) {
      for (std::uint8_t& part : color) {
        part = cursor.next<std::uint8_t>("a colour");
      }
    }
  }
}

}  // namespace

Mz3File parseMz3(const std::string& path, const std::vector<std::uint8_t>& bytes) {
  ByteCursor cursor(path, bytes, ByteOrder::Little);
  if (cursor.next<std::uint16_t>("the magic number") != 0x5A4D) {
    cursor.seek(0);
    cursor.fail("An MZ3 file begins with the letters MZ, but this one does not; it is of another kind.");
  }
  const unsigned attributes = cursor.next<std::uint16_t>("the attributes");
  const auto faces = cursor.next<std::uint32_t>("the number of faces");
  const auto vertices = cursor.next<std::uint32_t>("the number of vertices");
  const auto skip = cursor.next<std::uint32_t>("the bytes to pass over");
  if (attributes == 0 || attributes > kKnown || faces > INT_MAX / 3 || vertices > INT_MAX / 3) {
    cursor.fail("The header claims attributes " + std::to_string(attributes) + ", " + std::to_string(faces) +
                " faces and " + std::to_string(vertices) + " vertices, which is not MZ3 or damaged.");
  }
  cursor.need(skip, 1, "the part before the data");
  cursor.seek(kHeaderSize + skip);
  Mz3File file;
  file.vertexCount = vertices;
  parseGeometry(cursor, attributes, faces, file);
  parseLayers(cursor, attributes, file);
  return file;
}

SurfaceFile parseMz3Surface(const std::string& path, const std::vector<std::uint8_t>& bytes) {
  Mz3File file = parseMz3(path, bytes);
  if (file.points.empty() || file.faces.empty()) {
    throw FormatError(path, "A surface is needed, but this MZ3 file holds an overlay that belongs to one.");
  }
  SurfaceFile surface;
  surface.points = std::move(file.points);
  surface.faces = std::move(file.faces);
  surface.spaceReason = "MZ3 file, which does not say which space its coordinates live in";
  return surface;
}

Mz3File readMz3(const std::string& path) { return parseMz3(path, readBytes(path)); }

void writeMz3(const std::string& path, const SurfaceFile& surface, const std::vector<NamedScalars>& layers) {
  const std::size_t n = surface.vertexCount();
  for (const NamedScalars& layer : layers) {
    if (layer.values.size() != n) {
      throw FormatError(path, "Overlay \"" + layer.name + "\" has " + std::to_string(layer.values.size()) +
                                  " values for " + std::to_string(n) + " vertices; one for each is needed.");
    }
  }
  std::vector<std::uint8_t> bytes;
  bytes.reserve(kHeaderSize + 4 * (surface.faces.size() + surface.points.size() + n * layers.size()));
  encode(bytes, std::uint16_t{0x5A4D}, ByteOrder::Little);
  encode(bytes, static_cast<std::uint16_t>(kFaces | kVertices | (layers.empty() ? 0U : kFloats)), ByteOrder::Little);
  encode(bytes, static_cast<std::uint32_t>(surface.faceCount()), ByteOrder::Little);
  encode(bytes, static_cast<std::uint32_t>(n), ByteOrder::Little);
  encode(bytes, std::uint32_t{0}, ByteOrder::Little);
  for (const int index : surface.faces) {
    encode(bytes, static_cast<std::int32_t>(index), ByteOrder::Little);
  }
  for (const double x : surface.points) {
    encode(bytes, static_cast<float>(x), ByteOrder::Little);
  }
  for (const NamedScalars& layer : layers) {
    for (const float value : layer.values) {
      encode(bytes, value, ByteOrder::Little);
    }
  }
  writeFileAtomically(path, gzipped(path, bytes));
}

}  // namespace authalic
